//! A style sheet without its at-rules, of which `usvg` knows none: the rules within those that hold stand by themselves.
//!
//! It holds what does for a light screen of a usual size, and whatever a browser has to support. That rules in layers give
//! way to all others is left out.

use std::borrow::Cow;
use std::mem::replace;

use super::text::{enclosed, parts, unquoted};

/// Width and height of the screen's window, in pixels, and the size of its letters.
const WINDOW_PX: [(&str, f64); 2] = [("width", 1024.0), ("height", 768.0)];
const LETTER_PX: f64 = 16.0;

/// What such a screen is like.
const FEATURES: [(&str, &str); 8] = [
    ("prefers-color-scheme", "light"),
    ("prefers-reduced-motion", "no-preference"),
    ("prefers-contrast", "no-preference"),
    ("forced-colors", "none"),
    ("inverted-colors", "none"),
    ("orientation", "landscape"),
    ("hover", "hover"),
    ("pointer", "fine"),
];

/// Signs between a side and a length, and what stands before the side's name where there is a colon.
const BOUNDS: [(&str, &str); 4] = [(">=", "min-"), ("<=", "max-"), (">", "min-"), ("<", "max-")];

/// A sheet of plain rules alone, in one pass. Comments are to be taken out before.
pub(crate) fn plain(sheet: &str) -> Cow<'_, str> {
    if !sheet.contains('@') {
        return Cow::Borrowed(sheet);
    }
    let plain = rules(sheet).into_iter().filter(|rule| !is_at_rule(rule));
    Cow::Owned(plain.collect())
}

/// The rules that are in no other, or in one whose content holds as if it were not there. A last one may have no end.
fn rules(sheet: &str) -> Vec<&str> {
    let mut rules = Vec::new();
    let (mut start, mut depth) = (0, 0_usize);
    for (at, byte) in unquoted(sheet) {
        match byte {
            b'{' if depth == 0 && is_transparent(&sheet[start..at]) => start = at + 1,
            b'{' => depth += 1,
            b'}' | b';' if depth == 0 => start = at + 1,
            b'}' => {
                depth -= 1;
                rules.extend((depth == 0).then(|| &sheet[replace(&mut start, at + 1)..=at]));
            }
            _ => {}
        }
    }
    rules.extend((depth > 0).then(|| &sheet[start..]));
    rules
}

fn is_at_rule(rule: &str) -> bool {
    rule.trim_start().starts_with('@')
}

/// Whether a text begins a rule whose content holds as it stands.
fn is_transparent(text: &str) -> bool {
    let Some(rule) = text.trim_start().strip_prefix('@') else { return false };
    let end = rule.find(|c: char| c != '-' && !c.is_ascii_alphanumeric()).unwrap_or(rule.len());
    let (name, condition) = rule.split_at(end);
    match &*name.to_ascii_lowercase() {
        "media" => is_shown(condition),
        "supports" => !starts_with_not(condition),
        "layer" => true,
        _ => false,
    }
}

fn starts_with_not(condition: &str) -> bool {
    condition.trim_start().get(..3).is_some_and(|word| word.eq_ignore_ascii_case("not"))
}

/// Whether a list of media has the screen in it. What is not known of one is not so.
pub(crate) fn is_shown(media: &str) -> bool {
    media.trim().is_empty() || parts(media, |b| b == b',').any(is_screen)
}

fn is_screen(medium: &str) -> bool {
    let words = parts(medium, |b| b.is_ascii_whitespace()).map(str::trim).filter(|word| !word.is_empty());
    let words: Vec<_> = words.map(str::to_ascii_lowercase).collect();
    match words.split_first() {
        Some((first, rest)) if first == "not" => !are_true(rest),
        Some(_) => are_true(&words),
        None => false,
    }
}

fn are_true(words: &[String]) -> bool {
    let is_true = |word: &String| match &**word {
        "all" | "screen" | "and" | "only" => true,
        word => enclosed(word).is_some_and(|(feature, after)| after.is_empty() && has(feature)),
    };
    words.iter().all(is_true)
}

/// Whether the screen has a feature, as `name: value` or `name > value`.
fn has(feature: &str) -> bool {
    let bound = |(sign, bound): &(&str, &str)| {
        feature.split_once(sign).map(|(name, value)| ([bound, name.trim()].concat(), value.trim()))
    };
    if let Some((name, value)) = BOUNDS.iter().find_map(bound) {
        return is_as(&name, value);
    }
    match feature.split_once(':') {
        Some((name, value)) => is_as(name.trim(), value.trim()),
        None => {
            is_as(feature, "") || FEATURES.iter().any(|&(name, value)| name == feature && !is_lacking(value))
        }
    }
}

/// Whether a screen that has a feature so does not have it.
fn is_lacking(value: &str) -> bool {
    matches!(value, "none" | "no-preference")
}

fn is_as(name: &str, value: &str) -> bool {
    let fits = |&(side, window_px): &(&str, f64)| match name.strip_suffix(side) {
        Some("min-") => length_px(value).is_some_and(|least| least <= window_px),
        Some("max-") => length_px(value).is_some_and(|most| most >= window_px),
        _ => false,
    };
    name == "color" || FEATURES.contains(&(name, value)) || WINDOW_PX.iter().any(fits)
}

fn length_px(text: &str) -> Option<f64> {
    let number = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let unit_px = match &text[number.len()..] {
        "px" | "" => 1.0,
        "em" | "rem" => LETTER_PX,
        _ => return None,
    };
    number.parse::<f64>().ok().map(|number| number * unit_px)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_within_those_that_hold_stand_by_themselves() {
        for (sheet, expected) in [
            ("a{b:c} d{}", "a{b:c} d{}"),
            ("@import url('x;y');a{b:c}", "a{b:c}"),
            ("@import url(x;y);@charset \"}\";a{b:c}", "a{b:c}"),
            ("@media screen{a{b:c}d{e:f}}g{h:i}", "a{b:c}d{e:f}g{h:i}"),
            ("@MEDIA Print{a{b:c}d{e:f}}g{h:i}", "g{h:i}"),
            ("@supports (fill:color(srgb 0 0 0)){a{b:c}} @supports not (x:y){d{e:f}}", "a{b:c}"),
            ("@layer x,y; @layer x{a{b:c}} @layer{@media all{d{e:f}}}", "a{b:c}d{e:f}"),
            ("@font-face{x:y}@keyframes k{0%{x:y}}a{b:c}", "a{b:c}"),
            ("@media print{@media all{a{b:c}}}d{e:f}", "d{e:f}"),
            ("a{b:c;@media all{d:e}}f{g:'@'}", "a{b:c;@media all{d:e}}f{g:'@'}"),
            ("@media all{a{b:c}", "a{b:c}"),
            ("}@media all{}}}a{b:c}@", "a{b:c}"),
            ("@media all{a{b:c", "a{b:c"),
            ("@media print{a{b:c", ""),
            ("@{a{b:c}}@ü{d{e:f}}g{h:i}", "g{h:i}"),
        ] {
            assert_eq!(plain(sheet), expected, "{sheet}");
        }
    }

    #[test]
    fn a_light_screen_is_meant() {
        for media in [
            "",
            "all",
            "only screen",
            "print, screen",
            "(prefers-color-scheme: light)",
            "not print",
            "not all and (prefers-color-scheme: dark)",
            "screen and (min-width:600px) and (max-width:90em)",
            "(min-height: 0)",
            "(color)",
            "(hover)",
            "(prefers-color-scheme)",
            "(width > 10px) and (width<=1024px)",
        ] {
            assert!(is_shown(media), "{media}");
        }
        for media in [
            "print",
            "not screen",
            "(prefers-color-scheme:dark)",
            "screen and (max-width: 600px)",
            "(min-width: 3000px)",
            "(min-width: 1üpx)",
            "(min-width: nan)",
            "(width < 10px)",
            "(10px <= width <= 20px)",
            "(unknown: 1)",
            "(forced-colors)",
            "(",
            "()",
            ",",
        ] {
            assert!(!is_shown(media), "{media}");
        }
    }

    #[test]
    fn a_sheet_of_rules_within_rules_is_read_once() {
        let deep = "@media all{".repeat(500_000);
        assert_eq!(plain(&[&deep, "a{b:c}"].concat()), "a{b:c}");
        assert_eq!(plain(&"@media ".repeat(1_000_000)), "");
    }
}

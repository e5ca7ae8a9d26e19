//! Colours as CSS writes them, as `usvg` reads them.
//!
//! What lies outside sRGB is clamped channel by channel. Colours are mixed in sRGB, whichever space is asked for, and the
//! widest spaces are taken for sRGB: it is lines that are looked for here, not their exact hue.

use std::borrow::Cow;

use scumble_core::Rgba8;
use svgtypes::Color;

use super::property::Property;
use super::spaces::{Space, rgba8};
use super::text::{call, enclosed, parts};
use super::variables::Variables;

/// A value as `usvg` reads it: as it is, if possible; `None` where it is no colour that is known.
pub(crate) fn readable<'v>(
    property: Property,
    value: &'v str,
    variables: &Variables,
) -> Option<Cow<'v, str>> {
    if property.reads(value) {
        return Some(Cow::Borrowed(value));
    }
    let value = variables.put_in(value)?;
    let value = without_profile(value.trim());
    if let Some(keyword) = property.keyword(value) {
        return Some(Cow::Borrowed(keyword));
    }
    if let Some(server) = value.strip_prefix("url") {
        return paint_server(property, server, variables).map(Cow::Owned);
    }
    let is_of_line = matches!(property, Property::Stroke | Property::Color);
    let mixes_with_current = || (is_of_line && has_current(value)).then_some(Cow::Borrowed("currentColor"));
    color(value).map(|color| Cow::Owned(written(color))).or_else(mixes_with_current)
}

/// A colour without its twin for printing, which SVG 1.1 has behind it.
fn without_profile(value: &str) -> &str {
    value.split_once("icc-color(").map_or(value, |(color, _)| color.trim_end())
}

/// A gradient or pattern, with the colour that stands behind it where there is none.
fn paint_server(property: Property, server: &str, variables: &Variables) -> Option<String> {
    let (id, fallback) = enclosed(server)?;
    let server = ["url(", id, ")"].concat();
    let fallback = readable(property, fallback.trim(), variables).filter(|_| !fallback.trim().is_empty());
    let whole = fallback.map(|fallback| [&server, " ", &fallback].concat());
    [whole, Some(server)].into_iter().flatten().find(|value| property.reads(value))
}

/// Whether a colour is made of the one that is inherited, which is not known here.
fn has_current(value: &str) -> bool {
    call(value).is_some_and(|(_, arguments)| {
        parts(arguments, |b| b == b',').flat_map(words).any(|word| word.eq_ignore_ascii_case("currentcolor"))
    })
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    parts(text, |b| b.is_ascii_whitespace()).filter(|word| !word.is_empty())
}

fn written(Rgba8([r, g, b, alpha]): Rgba8) -> String {
    let digits = format!("#{r:02x}{g:02x}{b:02x}");
    if alpha == 255 { digits } else { format!("{digits}{alpha:02x}") }
}

fn color(text: &str) -> Option<Rgba8> {
    let text = text.trim();
    if let Ok(Color { red, green, blue, alpha }) = text.parse() {
        return Some(Rgba8([red, green, blue, alpha]));
    }
    let Some((name, arguments)) = call(text) else { return named(text) };
    let mut colors = parts(arguments, |b| b == b',');
    match &*name.to_ascii_lowercase() {
        "light-dark" => color(colors.next()?),
        "color-mix" => mixed(colors.nth(1)?, colors.next()?),
        _ if arguments.trim_start().starts_with("from ") => {
            color(words(arguments).nth(1)?).map(|color| with_alpha(color, arguments))
        }
        "color" => {
            let (space, channels) = arguments.trim_start().split_once(' ')?;
            in_space(Space::of_profile(&space.to_ascii_lowercase())?, channels)
        }
        name => in_space(Space::of_function(name)?, arguments),
    }
}

/// A colour with the opacity behind a slash, if it is a number.
fn with_alpha(Rgba8([r, g, b, own]): Rgba8, arguments: &str) -> Rgba8 {
    let alpha = arguments.rsplit_once('/').and_then(|(_, alpha)| channel(alpha.trim(), 1.0));
    Rgba8([r, g, b, alpha.map_or(own, |alpha| (alpha.clamp(0.0, 1.0) * 255.0).round() as u8)])
}

/// Colours that are not known to `usvg`: one of a person's name, and those of a system with dark writing on white.
fn named(word: &str) -> Option<Rgba8> {
    let rgb = match &*word.to_ascii_lowercase() {
        "rebeccapurple" => [0x66, 0x33, 0x99],
        "canvastext" | "buttontext" | "fieldtext" | "marktext" | "accentcolortext" | "windowtext"
        | "text" | "menutext" | "infotext" | "captiontext" | "buttonborder" => [0; 3],
        "canvas" | "field" | "window" | "buttonface" | "selecteditemtext" | "highlighttext" => [255; 3],
        "graytext" => [0x80; 3],
        "linktext" | "activetext" | "highlight" | "selecteditem" | "accentcolor" => [0, 0, 0xee],
        "visitedtext" => [0x55, 0x1a, 0x8b],
        "mark" => [255, 255, 0],
        _ => return None,
    };
    let [r, g, b] = rgb;
    Some(Rgba8([r, g, b, 255]))
}

/// Channels in a space, and the opacity behind a slash or as the fourth number.
fn in_space(space: Space, arguments: &str) -> Option<Rgba8> {
    let (channels, alpha) = arguments.split_once('/').map_or((arguments, None), |(c, a)| (c, Some(a.trim())));
    let mut channels = channels.split([',', ' ', '\t', '\n', '\r']).filter(|word| !word.is_empty());
    let mut numbers = [0.0; 3];
    for (number, whole) in numbers.iter_mut().zip(space.wholes()) {
        *number = channel(channels.next()?, whole)?;
    }
    let alpha = alpha.or_else(|| channels.next()).map_or(Some(1.0), |alpha| channel(alpha, 1.0))?;
    channels.next().is_none().then(|| rgba8(space.srgb(numbers), alpha))
}

/// A number, a percentage of what is the whole, or an angle in degrees.
pub(super) fn channel(word: &str, whole: f64) -> Option<f64> {
    if word.eq_ignore_ascii_case("none") {
        return Some(0.0);
    }
    const HALF_TURN: f64 = std::f64::consts::PI;
    let units = [
        ("%", whole, 100.0),
        ("deg", 1.0, 1.0),
        ("grad", 0.9, 1.0),
        ("rad", 180.0, HALF_TURN),
        ("turn", 360.0, 1.0),
    ];
    let given = units.iter().find_map(|(name, unit, per)| Some((word.strip_suffix(name)?, *unit, *per)));
    let (number, unit, per) = given.unwrap_or((word, 1.0, 1.0));
    number.parse::<f64>().ok().map(|number| number * unit / per).filter(|number| number.is_finite())
}

/// Two colours in their parts, each with its opacity.
fn mixed(one: &str, other: &str) -> Option<Rgba8> {
    let [(one, part), (other, other_part)] = [with_part(one)?, with_part(other)?];
    let part = match (part, other_part) {
        (Some(part), Some(other)) => part / (part + other).max(f64::EPSILON),
        (Some(part), None) => part,
        (None, other) => 1.0 - other.unwrap_or(0.5),
    };
    let [weight, other_weight] = [(one, part), (other, 1.0 - part)].map(|(c, part)| part * f64::from(c.0[3]));
    let alpha = weight + other_weight;
    let [r, g, b] = [0, 1, 2].map(|i| {
        let sum = f64::from(one.0[i]) * weight + f64::from(other.0[i]) * other_weight;
        sum / alpha.max(f64::EPSILON) / 255.0
    });
    Some(rgba8([r, g, b], alpha / 255.0))
}

/// A colour, and the part of it that a mixture has, if it is said.
fn with_part(text: &str) -> Option<(Rgba8, Option<f64>)> {
    let is_part = |word: &&str| word.ends_with('%');
    let part =
        words(text).find(is_part).map(|word| channel(word, 1.0).filter(|part| (0.0..=1.0).contains(part)));
    let color = color(words(text).find(|word| !is_part(word))?)?;
    part.map_or(Some((color, None)), |part| Some((color, Some(part?))))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(value: &str) -> Option<String> {
        readable(Property::Stroke, value, &Variables::default()).map(Cow::into_owned)
    }

    #[test]
    fn what_is_read_anyway_stays() {
        for value in ["#123", "none", "currentColor", "url(#a) red", " rgb(1, 2, 3)", "hsl(120, 100%, 75%)"] {
            assert_eq!(read(value).as_deref(), Some(value));
        }
    }

    #[test]
    fn words_are_read_in_capitals_and_without() {
        for (value, expected) in [
            ("currentcolor", "currentColor"),
            ("CURRENTCOLOR", "currentColor"),
            ("NONE", "none"),
            ("", "inherit"),
            ("unset", "inherit"),
            ("initial", "none"),
            ("RebeccaPurple", "#663399"),
            ("CanvasText", "#000000"),
            ("Canvas", "#ffffff"),
        ] {
            assert_eq!(read(value).as_deref(), Some(expected), "{value}");
        }
        let of_color = readable(Property::Color, "currentcolor", &Variables::default());
        assert_eq!(of_color.as_deref(), Some("inherit"), "the colour of a colour is that of the parent");
    }

    #[test]
    fn colours_of_all_spaces_are_read() {
        // What browsers show for them.
        for (value, expected) in [
            ("rgba(0,0,0,50%)", "#00000080"),
            ("rgb(0 0 0 / 50%)", "#00000080"),
            ("rgb(50%, 128, none)", "#808000"),
            ("hsl(none 100% 50%)", "#ff0000"),
            ("hsl(0.5turn none 50% / 50%)", "#80808080"),
            ("hwb(120deg none 0%)", "#00ff00"),
            ("oklch(0.628 0.2577 29.23)", "#ff0000"),
            ("oklch(62.8% 64.4% 29.23deg / 1)", "#ff0000"),
            ("oklab(0.452 -0.0325 -0.3116)", "#0000ff"),
            ("lab(54.29 80.8 69.89)", "#ff0000"),
            ("lch(29.57% 131.2 301.36)", "#0000ff"),
            ("color(srgb 1 0.5 0)", "#ff8000"),
            ("color(srgb-linear 1 0.2158605 0 / 0.5)", "#ff800080"),
            ("color(display-p3 .1176 .1176 .1176)", "#1e1e1e"),
            ("color(display-p3 0 0 0 / 50%)", "#00000080"),
            ("color(display-p3 1 0 0)", "#ff0000"),
            ("color(xyz 0.9505 1 1.089)", "#ffffff"),
            ("color(xyz-d50 0.9643 1 0.8251)", "#ffffff"),
            ("light-dark(#ffffff, #121212)", "#ffffff"),
            ("light-dark(rgb(0,0,0), rgb(255,255,255))", "#000000"),
            ("color-mix(in srgb, red, blue)", "#800080"),
            ("color-mix(in oklch shorter hue, red 25%, rgb(0 0 255))", "#4000bf"),
            ("color-mix(in srgb, red 50%, transparent)", "#ff000080"),
            ("color-mix(in srgb, currentColor 50%, transparent)", "currentColor"),
            ("rgb(from #123456 r g b / 50%)", "#12345680"),
            ("#CD853F icc-color(acmecmyk, 0.11, 0.48, 0.83, 0.00)", "#cd853f"),
            ("url(#a) currentcolor", "url(#a) currentColor"),
            ("url('#a') rgb(0 0 0 / 50%)", "url('#a') #00000080"),
            ("url(#a) nothing", "url(#a)"),
            ("var(--stroke-0, black)", "#000000"),
            ("var(--a, var(--b, color(display-p3 0 0 0)))", "#000000"),
        ] {
            assert_eq!(read(value).as_deref(), Some(expected), "{value}");
        }
    }

    #[test]
    fn what_is_no_colour_is_none() {
        for value in [
            "nothing",
            "#12",
            "rgb()",
            "rgb(1 2)",
            "rgb(1 2 3 4 5)",
            "rgb(inf 0 0)",
            "rgb(calc(1) 0 0)",
            "color(other 1 1 1)",
            "color(srgb)",
            "light-dark(",
            "color-mix(in srgb, red)",
            "color-mix(in srgb, red 120%, blue)",
            "var(--a)",
            "var(--a,",
            "url(data:image/png)",
            "oklch(1 1 1",
        ] {
            assert_eq!(read(value), None, "{value}");
        }
    }
}

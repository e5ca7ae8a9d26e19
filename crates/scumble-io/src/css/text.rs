//! CSS as text: what lies between brackets, quotes and semicolons. Nothing is known of what it means.
//!
//! Comments are to be taken out before.

use std::ops::Range;

/// The bytes of a text that are in no quotes, and where.
pub(crate) fn unquoted(text: &str) -> impl Iterator<Item = (usize, u8)> {
    let mut quote = None;
    let mut is_escaped = false;
    text.bytes().enumerate().filter(move |&(_, byte)| {
        let is_plain = !is_escaped;
        is_escaped = is_plain && byte == b'\\';
        match quote {
            Some(open) => {
                quote = quote.filter(|_| !(is_plain && byte == open));
                false
            }
            None => {
                quote = Some(byte).filter(|byte| is_plain && matches!(byte, b'"' | b'\''));
                quote.is_none()
            }
        }
    })
}

/// The parts between separators that are in no parentheses and no quotes.
pub(crate) fn parts(text: &str, is_separator: fn(u8) -> bool) -> impl Iterator<Item = &str> {
    let mut depth = 0_usize;
    let ends = unquoted(text).filter(move |&(_, byte)| {
        match byte {
            b'(' => depth += 1,
            b')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0 && is_separator(byte)
    });
    let mut start = 0;
    let ends = ends.map(|(at, _)| at).chain([text.len()]);
    ends.map(move |end| text.get(std::mem::replace(&mut start, end + 1)..end).unwrap_or_default())
}

/// What is in the parentheses that a text begins with, and what is behind them.
pub(crate) fn enclosed(text: &str) -> Option<(&str, &str)> {
    let inner = text.strip_prefix('(')?;
    let mut depth = 1;
    let close = unquoted(inner).find(|&(_, byte)| {
        depth += i32::from(byte == b'(') - i32::from(byte == b')');
        depth == 0
    });
    close.map(|(at, _)| (&inner[..at], &inner[at + 1..]))
}

/// The name of the function that a text is a call of, and its arguments.
pub(crate) fn call(text: &str) -> Option<(&str, &str)> {
    let (name, arguments) = text.split_at(text.find('(')?);
    let (arguments, after) = enclosed(arguments)?;
    after.trim().is_empty().then_some((name, arguments))
}

/// Where the declarations of a style sheet's rules are. Those with others in them `usvg` passes over.
pub(crate) fn blocks(sheet: &str) -> Vec<Range<usize>> {
    let mut blocks = Vec::new();
    let (mut open, mut depth, mut is_flat) = (0, 0_usize, true);
    for (at, byte) in unquoted(sheet) {
        match byte {
            b'{' => {
                (open, is_flat) = (at + 1, depth == 0);
                depth += 1;
            }
            b'}' => {
                blocks.extend((depth == 1 && is_flat).then_some(open..at));
                depth = depth.saturating_sub(1);
            }
            _ => {}
        }
    }
    blocks
}

/// The property and the value of a declaration.
pub(crate) fn declared(declaration: &str) -> Option<(&str, &str)> {
    declaration.split_once(':').map(|(name, value)| (name.trim(), value.trim()))
}

/// Whether `usvg` reads a declaration to its end. Where it does not, it passes over all behind it, too: it knows no
/// variables, nothing within two pairs of parentheses, no slash, and no end of a value without one.
pub(crate) fn is_plain(name: &str, value: &str) -> bool {
    let is_word = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_');
    let starts_word =
        name.trim_start_matches(['*', '-']).starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    let is_name = starts_word && !name.starts_with("--") && name.trim_start_matches('*').bytes().all(is_word);
    is_name && !value.is_empty() && is_plain_value(value)
}

fn is_plain_value(value: &str) -> bool {
    let mut depth = 0;
    let is_plain = |(_, byte): (usize, u8)| match byte {
        b'(' => std::mem::replace(&mut depth, 1) == 0,
        b')' => std::mem::replace(&mut depth, 0) == 1,
        b'#' | b'.' | b',' | b'%' | b'+' | b'-' | b'_' | b'!' => true,
        byte => depth == 1 || byte.is_ascii_alphanumeric() || byte.is_ascii_whitespace(),
    };
    unquoted(value).all(is_plain) && depth == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brackets_and_quotes_hold_together() {
        let texts: Vec<_> = parts(r#"a(b,c(d,e)),"f,\",g",'(',h"#, |b| b == b',').collect();
        assert_eq!(texts, ["a(b,c(d,e))", r#""f,\",g""#, "'('", "h"]);
        assert_eq!(enclosed("(a(b)')')c"), Some(("a(b)')'", "c")));
        assert_eq!(enclosed("(a(b)"), None);
        assert_eq!(call("var(--a, f(x)) "), Some(("var", "--a, f(x)")));
        assert_eq!(call("var(--a) b"), None);
    }

    #[test]
    fn blocks_are_those_of_plain_rules() {
        let sheet = r#".a { x:1 } .c { x:3; & d { x:4 } } e{x:5}"#;
        let found: Vec<_> = blocks(sheet).into_iter().map(|block| &sheet[block]).collect();
        assert_eq!(found, [" x:1 ", "x:5"]);
        assert_eq!(blocks("}} a{ {"), []);
    }

    #[test]
    fn plain_is_what_the_reader_of_styles_knows() {
        for (name, value) in [
            ("fill", "#00f"),
            ("stroke", "url(#a) none"),
            ("font-family", "'A/B', sans-serif"),
            ("-inkscape-x", "1px"),
            ("*zoom", "1"),
            ("fill", "red !important"),
            ("transform", "rotate(1 / 2)"),
        ] {
            assert!(is_plain(name, value), "{name}: {value}");
        }
        for (name, value) in [
            ("--a", "1"),
            ("fill", ""),
            ("a", "f(g(x))"),
            ("font", "1px/2 A"),
            ("", "1"),
            ("9", "1"),
            ("a", "f("),
        ] {
            assert!(!is_plain(name, value), "{name}: {value}");
        }
    }
}

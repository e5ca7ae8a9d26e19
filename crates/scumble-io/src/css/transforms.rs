//! Transforms as CSS writes them, as `usvg` reads them: in pixels and degrees, without units. Those that it reads as they are
//! stay, though browsers want units.
//!
//! What is said in parts of a size or in letters cannot be followed, nor what leaves the plane otherwise than along the line of
//! sight.

use std::borrow::Cow;

use kurbo::Affine;
use svgtypes::Transform;

use super::text::{call, parts};
use super::values::channel;
use crate::page_size::length;

/// A matrix, column by column; it moves by pixels.
type Matrix = [f64; 6];

/// A value as `usvg` reads it: as it is, if possible; `None` where it cannot be followed.
pub(crate) fn readable(value: &str) -> Option<Cow<'_, str>> {
    if value.parse::<Transform>().is_ok() {
        return Some(Cow::Borrowed(value));
    }
    if matches!(&*value.to_ascii_lowercase(), "none" | "initial" | "unset" | "revert" | "revert-layer") {
        return Some(Cow::Borrowed("scale(1)"));
    }
    let calls = value.split_inclusive(')').map(str::trim).filter(|text| !text.is_empty());
    // One for all of them: a list of matrices may be many times as long as what it stands for.
    let mut matrices = calls.map(|text| matrix(call(text)?).map(Affine::new));
    let whole = matrices.try_fold(Affine::IDENTITY, |whole, next| Some(whole * next?))?;
    whole.is_finite().then(|| Cow::Owned(written(whole.as_coeffs())))
}

/// Whether a transform that `usvg` reads moves alone, so that it does not matter around which point it is.
pub(crate) fn only_moves(value: &str) -> bool {
    value.parse::<Transform>().is_ok_and(|t| [t.a, t.b, t.c, t.d] == [1.0, 0.0, 0.0, 1.0])
}

/// With exponents: numbers may have hundreds of digits without.
fn written(matrix: Matrix) -> String {
    ["matrix(", &matrix.map(|number| format!("{number:e}")).join(" "), ")"].concat()
}

fn matrix((name, arguments): (&str, &str)) -> Option<Matrix> {
    let [name, arguments] = [name, arguments].map(str::to_ascii_lowercase);
    let arguments: Vec<_> = parts(&arguments, |b| b == b',').map(str::trim).collect();
    Some(match (&*name, &arguments[..]) {
        ("translate" | "translatex", [x]) => moved(px(x)?, 0.0),
        ("translatey", [y]) => moved(0.0, px(y)?),
        ("translatez", [_]) => moved(0.0, 0.0),
        ("translate", [x, y]) | ("translate3d", [x, y, _]) => moved(px(x)?, px(y)?),
        ("scale", [both]) => scaled(factor(both)?, factor(both)?),
        ("scalex", [x]) => scaled(factor(x)?, 1.0),
        ("scaley", [y]) => scaled(1.0, factor(y)?),
        ("scale", [x, y]) | ("scale3d", [x, y, _]) => scaled(factor(x)?, factor(y)?),
        ("rotate" | "rotatez", [angle]) => {
            let (sin, cos) = radians(angle)?.sin_cos();
            [cos, sin, -sin, cos, 0.0, 0.0]
        }
        ("skew" | "skewx", [x]) => skewed(radians(x)?, 0.0),
        ("skewy", [y]) => skewed(0.0, radians(y)?),
        ("skew", [x, y]) => skewed(radians(x)?, radians(y)?),
        ("matrix", &[a, b, c, d, e, f]) => {
            let [a, b, c, d, e, f] = [a, b, c, d, e, f].map(factor);
            [a?, b?, c?, d?, e?, f?]
        }
        _ => return None,
    })
}

fn moved(x_px: f64, y_px: f64) -> Matrix {
    [1.0, 0.0, 0.0, 1.0, x_px, y_px]
}

fn scaled(x: f64, y: f64) -> Matrix {
    [x, 0.0, 0.0, y, 0.0, 0.0]
}

fn skewed(x: f64, y: f64) -> Matrix {
    [1.0, y.tan(), x.tan(), 1.0, 0.0, 0.0]
}

fn px(text: &str) -> Option<f64> {
    length(text).map(|(_, length_px)| length_px)
}

/// A number or a percentage; colours may also have angles there.
fn factor(text: &str) -> Option<f64> {
    let is_number = text.ends_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | '%'));
    channel(text, 1.0).filter(|_| is_number)
}

/// An angle; colours may also have none there.
fn radians(text: &str) -> Option<f64> {
    channel(text, f64::NAN).filter(|_| text != "none").map(f64::to_radians)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_is(value: &str, expected: &str) {
        let read = |text: &str| text.parse::<Transform>().expect("a transform");
        let anew = readable(value).unwrap_or_else(|| panic!("{value} can be followed"));
        let [found, expected] = [&anew, expected].map(read).map(|t| [t.a, t.b, t.c, t.d, t.e, t.f]);
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{value}: {found:?}");
    }

    #[test]
    fn what_css_writes_is_what_browsers_show() {
        for (value, expected) in [
            ("rotate(45deg)", "rotate(45)"),
            ("rotate(.25turn)", "rotate(90)"),
            ("rotateZ(100grad)", "rotate(90)"),
            ("rotate(3.141592653589793rad)", "rotate(180)"),
            ("translate(10px, 2pc)", "translate(10 32)"),
            ("translate(10px)", "translate(10)"),
            ("translateX(1in) translateY(-3pt)", "translate(96 -4)"),
            ("translate3d(1px, 2px, 0)", "translate(1 2)"),
            ("TRANSLATEX(1PX)scaleX(50%)scaley(2)", "translate(1) scale(.5 2)"),
            ("scale(200%)", "scale(2)"),
            ("scale3d(2, 3, 1) translateZ(0)", "scale(2 3)"),
            ("skew(30deg, 0deg) skewY(10deg)", "skewX(30) skewY(10)"),
            ("rotate(90deg) matrix(1, 0, 0, 1, 5, 6)", "rotate(90) translate(5 6)"),
            ("none", "scale(1)"),
        ] {
            assert_is(value, expected);
        }
    }

    #[test]
    fn what_is_read_anyway_stays() {
        for value in ["rotate(45)", "matrix(1 0 0 1 10 20)", "translate(10,20) scale(2)"] {
            assert_eq!(readable(value), Some(Cow::Borrowed(value)));
        }
    }

    #[test]
    fn what_cannot_be_followed_is_none() {
        for value in [
            "translate(50%)",
            "translate(1em, 0)",
            "translate(calc(1px + 2px))",
            "rotate(10%)",
            "rotate(none)",
            "scale(none)",
            "scale(1turn)",
            "translate(1e308in)",
            "scaleX(1e200) scaleX(1e200)",
            "rotateX(10deg)",
            "perspective(10px)",
            "translate(1px",
            "rotate(infdeg)",
            "scale()",
            "matrix(1, 2, 3)",
            "nothing",
        ] {
            assert_eq!(readable(value), None, "{value}");
        }
    }
}

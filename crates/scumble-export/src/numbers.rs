//! Numbers and paths as text, with three digits after the point and no exponent.

use kurbo::{BezPath, PathEl, Point};

/// Steps of numbers in one.
const PER_UNIT: u64 = 1000;

/// Adds a number.
pub(crate) fn push_number(text: &mut String, number: f64) {
    scumble_io::push_number(text, number, PER_UNIT);
}

/// Adds numbers, with spaces between.
pub(crate) fn push_numbers(text: &mut String, numbers: &[f64]) {
    for (i, number) in numbers.iter().enumerate() {
        text.push_str(if i > 0 { " " } else { "" });
        push_number(text, *number);
    }
}

/// A number as text.
pub(crate) fn number(number: f64) -> String {
    let mut text = String::new();
    push_number(&mut text, number);
    text
}

/// Path data of SVG.
pub(crate) fn svg_path(path: &BezPath) -> String {
    let mut text = String::new();
    for element in path {
        let (command, coordinates) = parts(element);
        text.push(command);
        push_numbers(&mut text, &coordinates);
    }
    text
}

/// Operators of PDF that make a path.
pub(crate) fn pdf_path(path: &BezPath) -> String {
    let mut text = String::new();
    let mut at = Point::ORIGIN;
    for element in path {
        let (command, coordinates) = parts(as_cubic(at, element));
        push_numbers(&mut text, &coordinates);
        text.push_str(match command {
            'M' => " m\n",
            'L' => " l\n",
            'C' => " c\n",
            _ => "h\n",
        });
        at = element.end_point().unwrap_or(at);
    }
    text
}

/// PDF has no quadratics.
fn as_cubic(start: Point, element: PathEl) -> PathEl {
    match element {
        PathEl::QuadTo(a, end) => PathEl::CurveTo(start.lerp(a, 2.0 / 3.0), end.lerp(a, 2.0 / 3.0), end),
        other => other,
    }
}

fn parts(element: PathEl) -> (char, Vec<f64>) {
    let of = |points: &[Point]| points.iter().flat_map(|p| [p.x, p.y]).collect();
    match element {
        PathEl::MoveTo(p) => ('M', of(&[p])),
        PathEl::LineTo(p) => ('L', of(&[p])),
        PathEl::QuadTo(a, p) => ('Q', of(&[a, p])),
        PathEl::CurveTo(a, b, p) => ('C', of(&[a, b, p])),
        PathEl::ClosePath => ('Z', Vec::new()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_at_most_three_digits_and_no_exponent() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0004, "0"),
            (1.5, "1.5"),
            (-2.0625, "-2.063"),
            (0.001, "0.001"),
            (1024.0, "1024"),
            (1e300, "1000000000"),
            (f64::NAN, "0"),
        ] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn paths_are_the_same_in_both_languages() {
        let path = BezPath::from_svg("M 1 2 L 3.5 4 Q 6.5 7 9.5 4 C 1 2 3 4 5 6 Z").expect("a sound path");
        assert_eq!(svg_path(&path), "M1 2L3.5 4Q6.5 7 9.5 4C1 2 3 4 5 6Z");
        let operators = "1 2 m\n3.5 4 l\n5.5 6 7.5 6 9.5 4 c\n1 2 3 4 5 6 c\nh\n";
        assert_eq!(pdf_path(&path), operators);
    }
}

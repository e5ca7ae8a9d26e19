//! A text as a QR code (ISO/IEC 18004), for cameras.

use qrcodegen::{QrCode, QrCodeEcc};

/// Blank modules around the code, which readers need.
const QUIET: i32 = 4;

/// The code of a text that is not too long for one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Code {
    /// Modules of a side, with the blank ones around.
    pub size: u32,
    /// SVG path data of the dark modules, one unit each.
    pub path: String,
}

/// The code of a text, or `None` where it holds more than a code can. With the least correction: it is for screens.
pub fn code(text: &str) -> Option<Code> {
    let code = QrCode::encode_text(text, QrCodeEcc::Low).ok()?;
    let mut path = String::new();
    for y in 0..code.size() {
        let mut x = 0;
        while x < code.size() {
            let run = (x..code.size()).take_while(|x| code.get_module(*x, y)).count() as i32;
            if run > 0 {
                let [x, y, run] = [x + QUIET, y + QUIET, run].map(|n| n.to_string());
                path.extend(["M", &x, " ", &y, "h", &run, "v1h-", &run, "z"]);
            }
            x += run.max(1);
        }
    }
    Some(Code { size: (code.size() + 2 * QUIET) as u32, path })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Modules that path data of runs makes dark.
    fn dark(path: &str) -> Vec<(i32, i32)> {
        let number = |text: &str| text.parse::<i32>().expect("a number");
        let runs = path.split('M').skip(1).flat_map(|run| {
            let (place, rest) = run.split_once('h').expect("a run");
            let (x, y) = place.split_once(' ').expect("a place");
            let (length, _) = rest.split_once('v').expect("a length");
            (0..number(length)).map(move |i| (number(x) + i, number(y)))
        });
        runs.collect()
    }

    #[test]
    fn the_path_is_of_the_dark_modules_within_a_quiet_zone() {
        let text = "https://example.org/#1.abc_-";
        let code = code(text).expect("a code");
        let expected = QrCode::encode_text(text, QrCodeEcc::Low).expect("a code");
        assert_eq!(code.size as i32, expected.size() + 8);
        let all = (0..expected.size()).flat_map(|y| (0..expected.size()).map(move |x| (x, y)));
        let modules: Vec<_> =
            all.filter(|(x, y)| expected.get_module(*x, *y)).map(|(x, y)| (x + 4, y + 4)).collect();
        assert_eq!(dark(&code.path), modules);
    }

    #[test]
    fn what_is_too_long_has_no_code() {
        assert!(code(&"a".repeat(2000)).is_some_and(|code| code.size <= 177 + 8));
        assert_eq!(code(&"a".repeat(3000)), None);
    }
}

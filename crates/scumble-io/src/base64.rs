//! Bytes as text of 64 digits (RFC 4648), as files and links have it.

/// The digits of an alphabet that differ from one to the other: those of 62 and 63.
pub(crate) type LastDigits = [u8; 2];

/// Section 4 of the RFC, as most programs write it.
pub(crate) const PLAIN: LastDigits = *b"+/";

/// Section 5: for addresses.
pub(crate) const URL: LastDigits = *b"-_";

/// The digits of some bytes, without padding.
pub(crate) fn text(bytes: &[u8], last: LastDigits) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let byte = |i: usize| group.get(i).copied().map_or(0, u32::from);
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for i in 0..=group.len() {
            text.push(char::from(digit((bits >> (18 - 6 * i) & 63) as u8, last)));
        }
    }
    text
}

/// The digits of some bytes as most programs read them: padded.
pub fn padded(bytes: &[u8]) -> String {
    text(bytes, PLAIN) + &"=="[..(3 - bytes.len() % 3) % 3]
}

/// The bytes of digits without padding, or `None` where there are others, or where bits are left that belong to no byte.
pub(crate) fn bytes(text: &str, last: LastDigits) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(text.len() * 3 / 4);
    let (mut bits, mut count) = (0, 0);
    for digit in text.bytes() {
        (bits, count) = ((bits << 6 | u32::from(value(digit, last)?)) & 0xfff, count + 6);
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
        }
    }
    (count < 6 && bits & ((1 << count) - 1) == 0).then_some(bytes)
}

fn digit(value: u8, last: LastDigits) -> u8 {
    match value {
        0..26 => b'A' + value,
        26..52 => b'a' + value - 26,
        52..62 => b'0' + value - 52,
        _ => last[usize::from(value == 63)],
    }
}

fn value(digit: u8, last: LastDigits) -> Option<u8> {
    match digit {
        b'A'..=b'Z' => Some(digit - b'A'),
        b'a'..=b'z' => Some(digit - b'a' + 26),
        b'0'..=b'9' => Some(digit - b'0' + 52),
        _ => last.iter().zip(62..).find(|(known, _)| **known == digit).map(|(_, value)| value),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_examples_of_the_rfc() {
        for (given, expected) in
            [("", ""), ("f", "Zg"), ("fo", "Zm8"), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")]
        {
            assert_eq!(text(given.as_bytes(), PLAIN), expected);
            assert_eq!(bytes(expected, PLAIN).as_deref(), Some(given.as_bytes()));
            assert_eq!(
                padded(given.as_bytes()),
                format!("{expected:=<0$}", expected.len().next_multiple_of(4))
            );
        }
    }

    #[test]
    fn alphabets_differ_in_their_last_digits() {
        let all = [0xfb, 0xff, 0xfe];
        assert_eq!([text(&all, PLAIN), text(&all, URL)], ["+//+", "-__-"]);
        assert_eq!([bytes("+//+", PLAIN), bytes("-__-", URL)], [Some(all.to_vec()), Some(all.to_vec())]);
        assert_eq!([bytes("+//+", URL), bytes("-__-", PLAIN)], [None, None]);
    }

    #[test]
    fn what_is_cut_off_or_has_bits_too_many_is_none() {
        for bad in ["Z", "Zm9vZ", "Zh", "Zm9", "Zg==", "Zm 8", "é"] {
            assert_eq!(bytes(bad, PLAIN), None, "{bad}");
        }
    }
}

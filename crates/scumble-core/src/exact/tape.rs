//! Bytes that are written or read by the same calls: each takes the value to write, and leaves or returns the one read.
//!
//! What is called from many places is not inlined there: that would be a kilobyte more for every visitor of the page.

/// Steps of numbers that take few bytes, in one.
const PER_UNIT: f64 = 1000.0;

/// Numbers of more steps than this take all their bytes.
const MAX_STEPS: f64 = 1e12;

/// Stands before a number with all its bytes.
const IN_FULL: u64 = 0;

/// A row of bytes under the head that writes or reads it.
#[derive(Debug)]
pub(super) struct Tape {
    bytes: Vec<u8>,
    /// Where it is read; `None` where it is written.
    at: Option<usize>,
    is_sound: bool,
}

impl Tape {
    /// A tape to be written.
    pub(super) fn blank() -> Self {
        Self { bytes: Vec::new(), at: None, is_sound: true }
    }

    /// A tape to be read.
    pub(super) fn of(bytes: &[u8]) -> Self {
        Self { bytes: bytes.to_vec(), at: Some(0), is_sound: true }
    }

    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }

    /// Whether all was as it should be, and nothing is left.
    pub(super) fn is_read_to_its_end(&self) -> bool {
        self.is_sound && self.at == Some(self.bytes.len())
    }

    /// What is read makes sense only where this holds.
    pub(super) fn check(&mut self, holds: bool) {
        self.is_sound &= holds;
    }

    #[inline(never)]
    pub(super) fn byte(&mut self, value: u8) -> u8 {
        let Some(at) = &mut self.at else {
            self.bytes.push(value);
            return value;
        };
        let byte = self.bytes.get(*at).copied();
        *at += 1;
        self.is_sound &= byte.is_some();
        byte.unwrap_or_default()
    }

    pub(super) fn bytes(&mut self, values: &mut [u8]) {
        for value in values {
            *value = self.byte(*value);
        }
    }

    #[inline(never)]
    pub(super) fn flag(&mut self, value: bool) -> bool {
        let byte = self.byte(value.into());
        self.check(byte <= 1);
        byte == 1
    }

    /// A whole number, seven bits a byte, the lowest first; all but the last byte have their highest bit set.
    #[inline(never)]
    pub(super) fn int(&mut self, value: u64) -> u64 {
        let (mut rest, mut read) = (value, 0);
        for shift in (0..u64::BITS).step_by(7) {
            let more = if rest > 0x7f { 0x80 } else { 0 };
            let byte = self.byte(rest as u8 & 0x7f | more);
            read |= u64::from(byte & 0x7f) << shift;
            rest >>= 7;
            if byte & 0x80 == 0 {
                return read;
            }
        }
        self.check(false);
        0
    }

    /// A finite number.
    pub(super) fn number(&mut self, value: &mut f64) {
        let code = self.int(steps(*value).map_or(IN_FULL, |steps| zigzag(steps) + 1));
        *value = if code == IN_FULL {
            let mut bytes = value.to_le_bytes();
            self.bytes(&mut bytes);
            f64::from_le_bytes(bytes)
        } else {
            unzigzag(code - 1) as f64 / PER_UNIT
        };
        self.check(value.is_finite());
    }

    /// One of a few values.
    #[inline(never)]
    pub(super) fn one_of<T: Copy + PartialEq>(&mut self, value: &mut T, all: &[T]) {
        let index = all.iter().position(|known| known == value).unwrap_or_default();
        let read = all.get(usize::from(self.byte(index as u8)));
        self.check(read.is_some());
        *value = *read.unwrap_or(value);
    }

    pub(super) fn text(&mut self, text: &mut String) {
        let mut bytes = std::mem::take(text).into_bytes();
        self.list(&mut bytes, &0, &mut |tape, byte| *byte = tape.byte(*byte));
        match String::from_utf8(bytes) {
            Ok(read) => *text = read,
            Err(_) => self.check(false),
        }
    }

    /// A list; a blank item is what each one is read into.
    pub(super) fn list<T: Clone>(
        &mut self,
        items: &mut Vec<T>,
        blank: &T,
        each: &mut dyn FnMut(&mut Self, &mut T),
    ) {
        let count = self.int(items.len() as u64);
        if self.at.is_none() {
            return items.iter_mut().for_each(|item| each(self, item));
        }
        items.clear();
        for _ in 0..count {
            if !self.is_sound {
                return;
            }
            let mut item = blank.clone();
            each(self, &mut item);
            items.push(item);
        }
    }
}

/// How many steps a number is, if that tells all of it: the zero below zero it does not.
fn steps(value: f64) -> Option<i64> {
    let steps = (value * PER_UNIT).round().clamp(-MAX_STEPS, MAX_STEPS) as i64;
    ((steps as f64 / PER_UNIT).to_bits() == value.to_bits()).then_some(steps)
}

/// Numbers near zero, of either sign, as small ones.
fn zigzag(number: i64) -> u64 {
    (number << 1 ^ number >> 63) as u64
}

fn unzigzag(code: u64) -> i64 {
    (code >> 1) as i64 ^ -((code & 1) as i64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_back_bit_by_bit() {
        let numbers =
            [0.0, -0.0, 0.001, -0.001, 12.345, -1023.999, 1.0 / 3.0, 1e9, -1e9, 1e9 + 0.001, 1e300, 5e-324];
        let mut tape = Tape::blank();
        numbers.iter().for_each(|&number| tape.number(&mut { number }));
        let mut tape = Tape::of(&tape.into_bytes());
        let read = numbers.map(|_| {
            let mut number = 7.0;
            tape.number(&mut number);
            number
        });
        assert_eq!(read.map(f64::to_bits), numbers.map(f64::to_bits));
        assert!(tape.is_read_to_its_end());
    }

    #[test]
    fn numbers_of_files_take_three_bytes_at_most_on_the_page() {
        for mut number in [0.125, 512.0, 1023.999, -1023.999] {
            let mut tape = Tape::blank();
            tape.number(&mut number);
            assert!(tape.into_bytes().len() <= 3, "{number}");
        }
    }

    #[test]
    fn what_is_no_finite_number_is_not_read() {
        for bad in [f64::NAN, f64::INFINITY] {
            let bytes = [&[0], &bad.to_le_bytes()[..]].concat();
            let mut tape = Tape::of(&bytes);
            tape.number(&mut 0.0);
            assert!(!tape.is_read_to_its_end());
        }
    }
}

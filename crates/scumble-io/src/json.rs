//! JSON, read as it is asked for: no tree, so that a large file takes no more memory than what it stands for, and
//! what nobody knows can be kept as it was written.

use std::borrow::Cow;

/// What is wrong with a text, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Fault {
    /// Index of the byte.
    pub(crate) at: usize,
    /// What should be there.
    pub(crate) expected: &'static str,
}

/// Deepest nesting.
const MAX_DEPTH: u32 = 100;

/// Largest number.
const MAX_NUMBER: f64 = 1e9;

/// A text, and how far it has been read.
#[derive(Clone, Debug)]
pub(crate) struct Json<'a> {
    text: &'a str,
    at: usize,
    depth: u32,
}

impl<'a> Json<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        Self::within(text, 0)
    }

    /// A text that is part of another one, at a depth of nesting there.
    pub(crate) fn within(text: &'a str, depth: u32) -> Self {
        Self { text, at: 0, depth }
    }

    /// Something else should be here.
    pub(crate) fn fault<T>(&self, expected: &'static str) -> Result<T, Fault> {
        Err(Fault { at: self.at, expected })
    }

    /// Calls `each` with the names of an object's members and their source texts; it reads the value.
    pub(crate) fn members(
        &mut self,
        each: &mut dyn FnMut(&mut Self, Member<'a>) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        self.expect(b'{', "an object {…}")?;
        self.each(b'}', &mut |json| {
            json.space();
            let start = json.at;
            let name = json.string()?;
            json.expect(b':', "a colon")?;
            each(json, Member { name, start })
        })
    }

    /// Calls `each`, which reads one item, for all items of a list.
    pub(crate) fn items(
        &mut self,
        each: &mut dyn FnMut(&mut Self) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        self.expect(b'[', "a list […]")?;
        self.each(b']', each)
    }

    fn each(&mut self, end: u8, each: &mut dyn FnMut(&mut Self) -> Result<(), Fault>) -> Result<(), Fault> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return self.fault("less nesting");
        }
        if !self.take(end) {
            each(self)?;
            while !self.take(end) {
                self.expect(b',', "a comma, or the end of the list")?;
                each(self)?;
            }
        }
        self.depth -= 1;
        Ok(())
    }

    /// Reads so many numbers as a list.
    pub(crate) fn numbers<const N: usize>(&mut self) -> Result<[f64; N], Fault> {
        let (mut numbers, mut count) = ([0.0; N], 0);
        self.items(&mut |json| {
            let Some(place) = numbers.get_mut(count) else { return json.fault("fewer numbers") };
            *place = json.number()?;
            count += 1;
            Ok(())
        })?;
        if count == N { Ok(numbers) } else { self.fault("more numbers before this") }
    }

    /// A number of at most a milliard.
    pub(crate) fn number(&mut self) -> Result<f64, Fault> {
        let mut peek = self.clone();
        let number: f64 = peek.number_text()?.parse().unwrap_or(f64::NAN);
        if number.is_nan() || number.abs() > MAX_NUMBER {
            return self.fault("a number between −1e9 and 1e9");
        }
        *self = peek;
        Ok(number)
    }

    pub(crate) fn boolean(&mut self) -> Result<bool, Fault> {
        match (self.word("true"), self.word("false")) {
            (true, _) => Ok(true),
            (_, true) => Ok(false),
            _ => self.fault("true or false"),
        }
    }

    pub(crate) fn string(&mut self) -> Result<Cow<'a, str>, Fault> {
        self.expect(b'"', "a text in quotes")?;
        let start = self.at;
        let is_special = |b: u8| b == b'"' || b == b'\\' || b < b' ';
        self.at += self.rest().bytes().position(is_special).unwrap_or(self.rest().len());
        let plain = &self.text[start..self.at];
        if self.rest().starts_with('"') {
            self.at += 1;
            return Ok(Cow::Borrowed(plain));
        }
        self.escaped(plain.to_owned()).map(Cow::Owned)
    }

    /// The rest of a string that has escapes.
    fn escaped(&mut self, mut text: String) -> Result<String, Fault> {
        loop {
            let Some(next) = self.rest().chars().next() else {
                return self.fault("a quote at the end of a text");
            };
            match next {
                '\0'..=' ' if next != ' ' => return self.fault("no control character"),
                '"' => {
                    self.at += 1;
                    return Ok(text);
                }
                '\\' => text.push(self.escape()?),
                next => {
                    self.at += next.len_utf8();
                    text.push(next);
                }
            }
        }
    }

    fn escape(&mut self) -> Result<char, Fault> {
        let escape = self.rest().as_bytes().get(1).copied().unwrap_or_default();
        let plain = match escape {
            b'"' | b'\\' | b'/' => escape,
            b'b' => 8,
            b'f' => 12,
            b'n' => b'\n',
            b'r' => b'\r',
            b't' => b'\t',
            b'u' => return self.unicode(),
            _ => return self.fault("a known escape after the backslash"),
        };
        self.at += 2;
        Ok(char::from(plain))
    }

    /// `\u` and four hexadecimal digits, or two of these for one character.
    fn unicode(&mut self) -> Result<char, Fault> {
        let unit = |text: &str| {
            let digits = text.strip_prefix("\\u")?.get(..4)?;
            let is_hex = digits.bytes().all(|digit| digit.is_ascii_hexdigit());
            if is_hex { u16::from_str_radix(digits, 16).ok() } else { None }
        };
        let units = [self.rest().get(..6), self.rest().get(6..12)].map(|text| text.and_then(unit));
        let units = units.into_iter().map_while(|unit| unit);
        let Some(Ok(character)) = char::decode_utf16(units).next() else {
            return self.fault("four hexadecimal digits that make a character");
        };
        self.at += 6 * character.len_utf16();
        Ok(character)
    }

    /// Passes over a value of any kind.
    pub(crate) fn skip(&mut self) -> Result<(), Fault> {
        self.space();
        match self.rest().as_bytes().first() {
            Some(b'{') => self.members(&mut |json, _| json.skip()),
            Some(b'[') => self.items(&mut Self::skip),
            Some(b'"') => self.string().map(|_| ()),
            Some(b'-' | b'0'..=b'9') => self.number_text().map(|_| ()),
            _ if self.word("null") => Ok(()),
            _ => self.boolean().map(|_| ()),
        }
    }

    /// The source from the beginning of a member to here, once its value was passed over.
    pub(crate) fn source(&self, member: &Member) -> &'a str {
        &self.text[member.start..self.at]
    }

    /// Nothing is left but white space.
    pub(crate) fn end(&mut self) -> Result<(), Fault> {
        self.space();
        if self.rest().is_empty() { Ok(()) } else { self.fault("nothing more") }
    }

    fn number_text(&mut self) -> Result<&'a str, Fault> {
        self.space();
        let text = self.rest();
        let is_part = |b: u8| matches!(b, b'+' | b'-' | b'.' | b'0'..=b'9' | b'e' | b'E');
        let text = &text[..text.bytes().position(|b| !is_part(b)).unwrap_or(text.len())];
        if !is_number(text) {
            return self.fault("a number");
        }
        self.at += text.len();
        Ok(text)
    }

    fn word(&mut self, word: &str) -> bool {
        self.space();
        let is_here = self.rest().starts_with(word);
        self.at += if is_here { word.len() } else { 0 };
        is_here
    }

    fn expect(&mut self, byte: u8, expected: &'static str) -> Result<(), Fault> {
        if self.take(byte) { Ok(()) } else { self.fault(expected) }
    }

    fn take(&mut self, byte: u8) -> bool {
        self.space();
        let is_here = self.rest().as_bytes().first() == Some(&byte);
        self.at += usize::from(is_here);
        is_here
    }

    fn space(&mut self) {
        let is_space = |b: &u8| matches!(b, b' ' | b'\t' | b'\n' | b'\r');
        self.at += self.rest().bytes().take_while(is_space).count();
    }

    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or_default()
    }
}

/// A member of an object, before its value.
#[derive(Clone, Debug)]
pub(crate) struct Member<'a> {
    pub(crate) name: Cow<'a, str>,
    start: usize,
}

/// Whether a text is `-1.5e+7` or the like: digits before a point and behind it, no zeros ahead.
fn is_number(text: &str) -> bool {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|digit| digit.is_ascii_digit());
    let text = text.strip_prefix('-').unwrap_or(text);
    let (text, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, part) = text.split_once('.').unwrap_or((text, "0"));
    let has_no_lead = whole == "0" || !whole.starts_with('0');
    digits(whole)
        && has_no_lead
        && digits(part)
        && digits(exponent.strip_prefix(['-', '+']).unwrap_or(exponent))
}

/// Writes a number with as many digits after the point as it needs, on a lattice of `per_unit`, a power of ten.
/// What no reader would take becomes the nearest that it does, and what is no number 0.
pub fn push_number(text: &mut String, number: f64, per_unit: u64) {
    let scaled = (number.abs().clamp(0.0, MAX_NUMBER) * per_unit as f64).round() as u64;
    if number < 0.0 && scaled > 0 {
        text.push('-');
    }
    text.push_str(&(scaled / per_unit).to_string());
    let (mut rest, mut place) = (scaled % per_unit, per_unit / 10);
    if rest > 0 {
        text.push('.');
    }
    while rest > 0 {
        text.push(char::from(b'0' + (rest / place) as u8));
        (rest, place) = (rest % place, place / 10);
    }
}

/// Writes a text in quotes.
pub(crate) fn push_string(text: &mut String, string: &str) {
    text.push('"');
    for character in string.chars() {
        match character {
            '"' | '\\' => text.extend(['\\', character]),
            '\0'..='\u{1f}' => {
                text.push_str("\\u00");
                let digit = |of: u32| char::from_digit(of, 16).unwrap_or_default();
                text.extend([digit(character as u32 >> 4), digit(character as u32 & 15)]);
            }
            _ => text.push(character),
        }
    }
    text.push('"');
}

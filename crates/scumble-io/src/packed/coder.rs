//! Whole numbers as few bits as they are surprising: a binary arithmetic coder whose every bit is foretold by a mix of
//! adaptive models, each under a context of its own (the approach of Matt Mahoney's PAQ, with integers alone, so that
//! the same bytes come out everywhere).
//!
//! Writing and reading are one walk: what is given is written, or is replaced by what is read. A walk that cannot go on
//! is marked as failed and gives zeros from there on.

use super::List;

/// Most contexts of one number.
pub(crate) const MAX_CONTEXTS: usize = 5;

/// Kinds of numbers; each learns for itself which of its contexts tell most.
pub(crate) const KINDS: usize = 32;

/// Parts of a number: its sign, its length, and the bits after the leading one.
const PARTS: usize = 3;

/// What a document may take in memory; with the models it stays below 4 MiB.
const MAX_BYTES: usize = 3 << 20;

/// Longest number, in bits.
const MAX_LENGTH: u32 = 40;

/// Bits behind the leading one that are foretold; those after them are as good as random.
const FORETOLD: u32 = 7;

/// Models, as a power of two. Two that fall together disturb each other, and do no other harm.
const SLOT_BITS: u32 = 18;

/// Sightings after which a model does not get any slower.
const MAX_SEEN: u16 = 255;

/// Share of each model in the beginning, of 65,536.
const FIRST_WEIGHT: i32 = 20_000;

/// Largest share; with more of it sums would not fit.
const MAX_WEIGHT: i32 = 1 << 19;

/// The logistic function at -8, -7.5, … 8, of 4096.
const LOGISTIC: [i32; 33] = [
    1, 2, 4, 6, 10, 17, 27, 45, 74, 120, 194, 311, 488, 747, 1102, 1546, 2048, 2550, 2994, 3349, 3608, 3785,
    3902, 3976, 4022, 4051, 4069, 4079, 4086, 4090, 4092, 4094, 4095,
];

/// How likely a bit is to be set, of 65,536, and how often it was seen.
#[derive(Clone, Copy, Debug)]
struct Model {
    set: u16,
    seen: u16,
}

#[derive(Debug)]
enum Way<'a> {
    Write(Vec<u8>),
    Read { bytes: &'a [u8], code: u32 },
}

/// One walk, to write or to read.
#[derive(Debug)]
pub(crate) struct Coder<'a> {
    way: Way<'a>,
    low: u32,
    high: u32,
    models: Vec<Model>,
    /// Share of each model in a mix, for each kind of number and each part of it.
    weights: [[i32; MAX_CONTEXTS]; KINDS * PARTS],
    /// The logistic function's inverse, in 1/256, by 1/4096.
    stretch: Vec<i32>,
    bytes_left: usize,
    has_failed: bool,
}

/// Where the models of a number are, one for each context.
struct Place {
    kind: usize,
    count: usize,
    hashes: [u32; MAX_CONTEXTS],
}

impl<'a> Coder<'a> {
    pub(crate) fn writer() -> Self {
        Self::new(Way::Write(Vec::new()))
    }

    pub(crate) fn reader(bytes: &'a [u8]) -> Self {
        let mut coder = Self::new(Way::Read { bytes, code: 0 });
        (0..4).for_each(|_| coder.shift());
        coder
    }

    fn new(way: Way<'a>) -> Self {
        Self {
            way,
            low: 0,
            high: u32::MAX,
            models: vec![Model { set: 1 << 15, seen: 0 }; 1 << SLOT_BITS],
            weights: [[FIRST_WEIGHT; MAX_CONTEXTS]; KINDS * PARTS],
            stretch: stretch(),
            bytes_left: MAX_BYTES,
            has_failed: false,
        }
    }

    /// The walk cannot go on.
    pub(crate) fn fail(&mut self) {
        self.has_failed = true;
    }

    /// Bytes written so far.
    pub(crate) fn written(&self) -> usize {
        if let Way::Write(bytes) = &self.way { bytes.len() } else { 0 }
    }

    /// Ends the walk: the bytes written, none where they were read, or `None` where it failed.
    pub(crate) fn finish(self) -> Option<Vec<u8>> {
        let Way::Write(mut bytes) = self.way else { return (!self.has_failed).then(Vec::new) };
        // The reader goes on with zeros: the fewest bytes that lie between low and high with these behind.
        for length in 0..=4 {
            let mask = u32::MAX.checked_shr(8 * length).unwrap_or(0);
            let end = self.high & !mask;
            if end >= self.low {
                bytes.extend(end.to_be_bytes().iter().take(length as usize));
                break;
            }
        }
        (!self.has_failed).then_some(bytes)
    }

    /// How many items of a list follow; none where they would be too many.
    pub(crate) fn count(&mut self, kind: usize, list: List, count: usize) -> usize {
        let count = self.magnitude(&place(kind, &[list.number]), count as u64) as usize;
        if self.take(list, count) { count } else { 0 }
    }

    /// Makes room for so many items of a list; fails where there is none.
    pub(crate) fn take(&mut self, list: List, count: usize) -> bool {
        let left = count.checked_mul(list.item_bytes).and_then(|bytes| self.bytes_left.checked_sub(bytes));
        self.bytes_left = left.unwrap_or_default();
        self.has_failed |= left.is_none();
        !self.has_failed
    }

    /// A number of at most 40 bits, foretold from at most five others.
    pub(crate) fn int(&mut self, kind: usize, contexts: &[i64], value: i64) -> i64 {
        let place = place(kind, contexts);
        let magnitude = self.magnitude(&place, value.unsigned_abs()) as i64;
        let is_negative = magnitude > 0 && self.bit(&place, 0, value < 0);
        if is_negative { -magnitude } else { magnitude }
    }

    pub(crate) fn flag(&mut self, kind: usize, contexts: &[i64], value: bool) -> bool {
        self.bit(&place(kind, contexts), 1, value)
    }

    /// Length in bits, one by one, then the bits after the leading one.
    fn magnitude(&mut self, place: &Place, value: u64) -> u64 {
        let given = 64 - value.leading_zeros();
        let mut length = 0;
        while self.bit(place, 1 + length, length < given) {
            length += 1;
            if length > MAX_LENGTH || self.has_failed {
                self.fail();
                return 0;
            }
        }
        let mut read = u64::from(length > 0);
        for i in (0..length.saturating_sub(1)).rev() {
            let bit = value >> i & 1 == 1;
            let bit = if read < 1 << FORETOLD {
                self.bit(place, (length << FORETOLD << 1) + read as u32, bit)
            } else {
                self.code(1 << 15, bit)
            };
            read = read << 1 | u64::from(bit);
        }
        read
    }

    fn bit(&mut self, place: &Place, node: u32, bit: bool) -> bool {
        let mix = PARTS * place.kind + part(node);
        let (mut slots, mut told) = ([0; MAX_CONTEXTS], [0; MAX_CONTEXTS]);
        let mut sum = 0;
        for i in 0..place.count {
            slots[i] = (mixed(place.hashes[i] ^ node.wrapping_mul(0x9e37_79b1)) >> (32 - SLOT_BITS)) as usize;
            told[i] = self.stretch[usize::from(self.models[slots[i]].set >> 4)];
            sum += (told[i] * self.weights[mix][i]) >> 8;
        }
        let set = squash(sum >> 8);
        let bit = self.code(set << 4, bit);
        let error = (i32::from(bit) << 12) - set as i32;
        for i in 0..place.count {
            let weight = &mut self.weights[mix][i];
            *weight = (*weight + ((told[i] * error) >> 10)).clamp(-MAX_WEIGHT, MAX_WEIGHT);
            self.models[slots[i]].learn(bit);
        }
        bit
    }

    /// Codes a bit that is set with a likelihood of `set` in 65,536, strictly between none and all.
    fn code(&mut self, set: u32, bit: bool) -> bool {
        let middle = self.low + ((u64::from(self.high - self.low) * u64::from(set)) >> 16) as u32;
        let bit = if let Way::Read { code, .. } = self.way { code <= middle } else { bit };
        if bit {
            self.high = middle;
        } else {
            self.low = middle + 1;
        }
        while (self.low ^ self.high) >> 24 == 0 {
            self.shift();
            self.low <<= 8;
            self.high = self.high << 8 | 0xff;
        }
        bit
    }

    /// One byte is settled, or taken in; behind the last there are zeros.
    fn shift(&mut self) {
        match &mut self.way {
            Way::Write(bytes) => bytes.push((self.high >> 24) as u8),
            Way::Read { bytes, code } => {
                let (next, rest) = bytes.split_first().unwrap_or((&0, &[]));
                (*code, *bytes) = (*code << 8 | u32::from(*next), rest);
            }
        }
    }
}

impl Model {
    fn learn(&mut self, bit: bool) {
        let target = if bit { 65_535 } else { 0 };
        let change = 2 * (target - i32::from(self.set)) / (2 * i32::from(self.seen) + 3);
        self.set = (i32::from(self.set) + change) as u16;
        self.seen = (self.seen + 1).min(MAX_SEEN);
    }
}

fn part(node: u32) -> usize {
    if node == 0 { 0 } else { 1 + usize::from(node > 1 + MAX_LENGTH) }
}

fn place(kind: usize, contexts: &[i64]) -> Place {
    let mut hashes = [0; MAX_CONTEXTS];
    for (i, (hash, context)) in hashes.iter_mut().zip(contexts).enumerate() {
        *hash = mixed(*context as u32 ^ mixed((kind * MAX_CONTEXTS + i) as u32));
    }
    Place { kind, count: contexts.len().min(MAX_CONTEXTS), hashes }
}

/// Spreads the bits of a number over all of it.
fn mixed(bits: u32) -> u32 {
    let bits = (bits ^ bits >> 15).wrapping_mul(0x85eb_ca6b).wrapping_add(0x9e37_79b1);
    (bits ^ bits >> 13).wrapping_mul(0xc2b2_ae35)
}

/// The logistic function of 1/256, of 4096.
fn squash(x: i32) -> u32 {
    let x = x.clamp(-2047, 2047) + 2048;
    let [below, above] = [x >> 7, (x >> 7) + 1].map(|i| LOGISTIC[i as usize]);
    (below + (((above - below) * (x & 127)) >> 7)) as u32
}

fn stretch() -> Vec<i32> {
    let mut stretch = vec![2047; 4096];
    let mut from = 0;
    for x in -2047..=2047 {
        let to = squash(x) as usize;
        (from..=to).for_each(|i| stretch[i] = x);
        from = from.max(to + 1);
    }
    stretch
}

//! Work as few bytes: points on a lattice of 1/4 du, each number told from those before it.
//!
//! Writing and reading are one walk over the work, which leaves it as a reader will find it: numbers are put on their
//! lattices in passing. `docs/format.md` lists the walk, for others to follow.

use kurbo::Rect;
use scumble_core::work::{Unknown, Work, are_too_long, is_page, is_sample_name};
use scumble_core::{
    Blend, ColorPoint, EngineKind, Line, Paint, PenPressure, Rgba8, Scribble, ScribbleKind, Srgb8,
};

use crate::work_file::{put_by, take_up};
use coder::Coder;
use pen::Pen;

mod coder;
mod lines;
mod pen;

/// Steps of lengths that are no coordinates, and of other numbers, in one.
const PER_UNIT: f64 = 1000.0;

/// Largest number, in thousandths.
const MAX_STEPS: i64 = 1_000_000_000_000;

/// Most styles and colours that are told by their number.
const MAX_SEEN: usize = 256;

/// Numbers of a page are below this without their point.
const MAX_WHOLE: f64 = 1e12;

/// Most digits after the point of a page's coordinates.
const MAX_DIGITS: i64 = 9;

/// What numbers mean. The first ones are points', in `pen`.
mod kind {
    pub(super) const LENGTH: usize = 16;
    pub(super) const TEXT: usize = 17;
    pub(super) const PAGE: usize = 18;
    pub(super) const SETTING: usize = 19;
    pub(super) const SEEN: usize = 20;
    pub(super) const COLOR: usize = 21;
    pub(super) const STYLE: usize = 22;
    pub(super) const SCRIBBLE: usize = 23;
    pub(super) const COLOR_POINT: usize = 24;
    pub(super) const FIELDS: usize = 25;
    pub(super) const FILL: usize = 26;
}

/// A list by its number, and what one of its items may take in memory, in bytes, on any machine.
#[derive(Clone, Copy, Debug)]
struct List {
    number: i64,
    item_bytes: usize,
}

const PALETTE: List = List { number: 0, item_bytes: 32 };
const CURVES: List = List { number: 1, item_bytes: 200 };
const FILLS: List = List { number: 2, item_bytes: 64 };
const SUBPATHS: List = List { number: 3, item_bytes: 56 };
const SEGMENTS: List = List { number: 4, item_bytes: 56 };
const DASHES: List = List { number: 5, item_bytes: 16 };
const SCRIBBLES: List = List { number: 6, item_bytes: 64 };
const POINTS: List = List { number: 7, item_bytes: 16 };
const COLOR_POINTS: List = List { number: 8, item_bytes: 32 };
const FIELDS: List = List { number: 9, item_bytes: 48 };
const TEXT: List = List { number: 10, item_bytes: 2 };

/// How many bytes each part of a drawing takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PackedSizes {
    /// Page, settings, palette, name of the sample.
    pub head: usize,
    /// Curves and solid ink.
    pub lines: usize,
    /// Scribbles, and colours set by hand.
    pub colors: usize,
    /// All, with unknown fields and what is left in the coder.
    pub all: usize,
}

/// The bytes of some work, or `None` where it is too large to be read again.
pub(crate) fn pack(work: &Work) -> Option<(Vec<u8>, PackedSizes)> {
    let mut work = put_by(work);
    // Once everything is on its lattice, what has become the same is seen to be so.
    let mut coder = Coder::writer();
    walk(&mut coder, &mut work);
    coder.finish()?;
    let mut coder = Coder::writer();
    let mut sizes = walk(&mut coder, &mut work);
    let bytes = coder.finish()?;
    sizes.all = bytes.len();
    Some((bytes, sizes))
}

/// The work in some bytes, or `None` where they are damaged or stand for more than may be read.
pub(crate) fn unpack(bytes: &[u8]) -> Option<Work> {
    let mut coder = Coder::reader(bytes);
    let mut work = Work::blank();
    walk(&mut coder, &mut work);
    coder.finish()?;
    take_up(&mut work)?;
    Some(work)
}

fn walk(c: &mut Coder, work: &mut Work) -> PackedSizes {
    let mut seen = Seen::default();
    let mut sizes = PackedSizes::default();
    head(c, work, &mut seen);
    sizes.head = c.written();
    if work.sample.is_none() {
        lines::lines(c, &mut work.document.drawing, &mut seen);
    } else {
        work.document.drawing.curves.clear();
        work.document.drawing.fills.clear();
    }
    sizes.lines = c.written() - sizes.head;
    let mut pen = Pen::default();
    list(c, SCRIBBLES, &mut work.document.scribbles, &blank_scribble(), |c, s| {
        scribble(c, s, &mut seen, &mut pen);
    });
    list(c, COLOR_POINTS, &mut work.document.color_points, &BLANK_COLOR_POINT, |c, point| {
        color_point(c, point, &mut seen);
    });
    if are_too_long(&work.document.scribbles) {
        c.fail();
    }
    sizes.colors = c.written() - sizes.head - sizes.lines;
    unknown(c, &mut work.unknown);
    sizes
}

/// Values that have come before; each is told by its number when it comes again.
#[derive(Default)]
struct Seen {
    paints: Vec<Paint>,
    last_paint: i64,
    /// As given, and as read.
    lines: Vec<[Option<Line>; 2]>,
    last_line: i64,
}

fn head(c: &mut Coder, work: &mut Work, seen: &mut Seen) {
    let minor = c.int(kind::LENGTH, &[-1], i64::from(work.unknown.minor));
    work.unknown.minor = u32::try_from(minor).unwrap_or_default();
    let has_sample = c.flag(kind::LENGTH, &[-2], work.sample.is_some());
    let mut name = work.sample.take().unwrap_or_default();
    if has_sample {
        text(c, &mut name);
        if !is_sample_name(&name) {
            c.fail();
        }
        work.sample = Some(name);
    }
    page(c, &mut work.document.drawing.page);
    let settings = &mut work.document.settings;
    let is_srgb = c.flag(kind::SETTING, &[0], settings.blend == Blend::Srgb);
    settings.blend = if is_srgb { Blend::Srgb } else { Blend::Oklab };
    let is_progressive = c.flag(kind::SETTING, &[1], settings.engine == EngineKind::Progressive);
    settings.engine = if is_progressive { EngineKind::Progressive } else { EngineKind::Global };
    settings.spread = c.flag(kind::SETTING, &[2], settings.spread);
    unit(c, kind::SETTING, &[3], &mut settings.gap_closing);
    *settings = settings.clamped();
    list(c, PALETTE, &mut work.document.palette, &Paint::Clear.into(), |c, swatch| {
        paint(c, &mut swatch.color, seen);
    });
}

/// The page as whole numbers with as many digits after the point as they need, or as there is room for.
fn page(c: &mut Coder, page: &mut Rect) {
    let given = [page.x0, page.y0, page.width(), page.height()];
    let whole = |digits: i64| given.map(|x| (x * ten_to(digits)).round());
    let has_room = |digits: &i64| whole(*digits).iter().all(|x| x.abs() < MAX_WHOLE);
    let tells_all = |digits: i64| whole(digits).iter().zip(given).all(|(x, of)| x / ten_to(digits) == of);
    let room = (0..=MAX_DIGITS).rev().find(has_room).unwrap_or_default();
    let needed = (0..room).find(|digits| tells_all(*digits)).unwrap_or(room);
    let digits = c.int(kind::PAGE, &[-1], needed).clamp(0, MAX_DIGITS);
    let mut numbers = whole(digits);
    for (i, x) in numbers.iter_mut().enumerate() {
        *x = c.int(kind::PAGE, &[i as i64], *x as i64) as f64 / ten_to(digits);
    }
    let [x, y, width, height] = numbers;
    if !is_page(numbers) {
        c.fail();
        return;
    }
    *page = Rect::new(x, y, x + width, y + height);
}

fn ten_to(digits: i64) -> f64 {
    (0..digits).fold(1.0, |power, _| 10.0 * power)
}

fn scribble(c: &mut Coder, scribble: &mut Scribble, seen: &mut Seen, pen: &mut Pen) {
    paint(c, &mut scribble.color, seen);
    let mut shading = scribble.shading().cloned().unwrap_or_default();
    if c.flag(kind::SCRIBBLE, &[0], !scribble.is_fill()) {
        unit(c, kind::SCRIBBLE, &[2], &mut shading.strength);
        shading.crosses = c.flag(kind::SCRIBBLE, &[3], shading.crosses);
        if !(0.0..=1.0).contains(&shading.strength) {
            c.fail();
        }
        shading.pressure = PenPressure::Even;
        scribble.kind = ScribbleKind::Shade(shading);
    }
    let last = (pen.width_du * PER_UNIT) as i64;
    positive(c, kind::SCRIBBLE, &[1, last], &mut scribble.width_du);
    pen.width_du = scribble.width_du;
    pen.stroke(c, &mut scribble.points);
}

fn blank_scribble() -> Scribble {
    Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 1.0, points: Vec::new() }
}

const BLANK_COLOR_POINT: ColorPoint =
    ColorPoint { curve: 0, is_left: false, at_du: 0.0, color: Paint::Clear };

fn color_point(c: &mut Coder, point: &mut ColorPoint, seen: &mut Seen) {
    let curve = c.int(kind::COLOR_POINT, &[0], i64::from(point.curve));
    point.curve = u32::try_from(curve).unwrap_or_default();
    point.is_left = c.flag(kind::COLOR_POINT, &[1], point.is_left);
    unit(c, kind::COLOR_POINT, &[2], &mut point.at_du);
    paint(c, &mut point.color, seen);
}

fn paint(c: &mut Coder, paint: &mut Paint, seen: &mut Seen) {
    let known = seen.paints.iter().position(|seen| seen == paint).map_or(0, |i| i as i64 + 1);
    let number = c.int(kind::SEEN, &[1, seen.last_paint], known);
    seen.last_paint = number;
    if let Some(known) = usize::try_from(number - 1).ok().and_then(|number| seen.paints.get(number)) {
        *paint = *known;
        return;
    }
    let mut rgb = if let Paint::Color(Srgb8(rgb)) = *paint { rgb } else { [0; 3] };
    let is_clear = c.flag(kind::COLOR, &[3], *paint == Paint::Clear);
    if !is_clear {
        channels(c, &mut rgb, kind::COLOR);
    }
    *paint = if is_clear { Paint::Clear } else { Srgb8(rgb).into() };
    if seen.paints.len() < MAX_SEEN {
        seen.paints.push(*paint);
        seen.last_paint = seen.paints.len() as i64;
    }
}

fn rgba(c: &mut Coder, color: &mut Rgba8, kind: usize) {
    channels(c, &mut color.0, kind);
}

fn channels(c: &mut Coder, channels: &mut [u8], kind: usize) {
    for (i, channel) in channels.iter_mut().enumerate() {
        // Opaque is 0.
        let value = c.int(kind, &[8 + i as i64], 255 - i64::from(*channel));
        *channel = u8::try_from(255 - value).unwrap_or_default();
    }
}

fn unknown(c: &mut Coder, unknown: &mut Unknown) {
    for (item, fields) in unknown.fields.iter_mut().enumerate() {
        let item = item as i64;
        let mut last = -1;
        list(c, FIELDS, fields, &(0, String::new()), |c, (index, fields)| {
            last += 1 + c.int(kind::FIELDS, &[item], i64::from(*index) - last - 1).max(0);
            *index = u32::try_from(last).unwrap_or_default();
            text(c, fields);
        });
    }
}

fn text(c: &mut Coder, text: &mut String) {
    let mut bytes = std::mem::take(text).into_bytes();
    let mut last = 0;
    list(c, TEXT, &mut bytes, &0, |c, byte| {
        *byte = c.int(kind::TEXT, &[0, last], i64::from(*byte)) as u8;
        last = i64::from(*byte);
    });
    match String::from_utf8(bytes) {
        Ok(read) => *text = read,
        Err(_) => c.fail(),
    }
}

fn list<T: Clone>(
    c: &mut Coder,
    list: List,
    items: &mut Vec<T>,
    blank: &T,
    mut each: impl FnMut(&mut Coder, &mut T),
) {
    let count = c.count(kind::LENGTH, list, items.len());
    items.resize(count, blank.clone());
    items.iter_mut().for_each(|item| each(c, item));
}

/// A number in thousandths.
fn unit(c: &mut Coder, kind: usize, contexts: &[i64], value: &mut f64) {
    let given = ((*value * PER_UNIT).round() as i64).clamp(-MAX_STEPS, MAX_STEPS);
    let steps = c.int(kind, contexts, given);
    if steps.abs() > MAX_STEPS {
        c.fail();
        return;
    }
    *value = steps as f64 / PER_UNIT;
}

/// A number above zero, in thousandths.
fn positive(c: &mut Coder, kind: usize, contexts: &[i64], value: &mut f64) {
    *value = value.max(1.0 / PER_UNIT);
    unit(c, kind, contexts, value);
    if *value <= 0.0 {
        c.fail();
    }
}

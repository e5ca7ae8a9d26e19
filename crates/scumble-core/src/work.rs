//! What is kept of somebody's work: the source of a picture, and nothing that can be derived from it.

use kurbo::Rect;

use crate::drawing::{Drawing, LONGER_SIDE_DU};
use crate::edit::Document;
use crate::scribble::Scribble;

/// Longest way of all scribbles together, in longer sides of the page: an hour and more of scribbling.
pub const MAX_PAGES: u32 = 5000;

/// Most curves of a drawing.
pub const MAX_CURVES: usize = 200_000;

/// Most scribbles that shade: each takes memory of its own, some megabytes if it is large.
pub const MAX_SHADES: usize = 1000;

/// Largest coordinate of a page, in page units.
const MAX_PAGE: f64 = 1e9;

/// A document, and what belongs to it without being edited.
#[derive(Clone, Debug)]
pub struct Work {
    /// What a person works on.
    pub document: Document,
    /// The file name of the sample that the lines are, unchanged. A link names it in place of the lines: what was read
    /// from one has a page without curves, until the sample's drawing is put there.
    pub sample: Option<String>,
    /// The file of the picture under the lines, as it was brought in. Empty where there is none, or where somebody else
    /// keeps it.
    pub image: Vec<u8>,
    /// What a newer version wrote and this one does not know.
    pub unknown: Unknown,
}

/// Fields that this version does not know, kept as they were written for a version that does.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Unknown {
    /// The minor version that wrote them.
    pub minor: u32,
    /// For each kind of item the fields of the items that have some, in order: the item's index, and its fields as
    /// JSON, separated by commas.
    pub fields: [Vec<(u32, String)>; Item::KINDS],
}

/// Kinds of items that may have fields. There is one work with one set of settings, of index 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item {
    /// The whole.
    Work,
    /// Its settings.
    Settings,
    /// A curve.
    Curve,
    /// An area of solid ink.
    Fill,
    /// A scribble.
    Scribble,
    /// A colour set by hand.
    ColorPoint,
}

impl Item {
    /// All kinds, in the order of their numbers.
    pub const ALL: [Self; 6] =
        [Self::Work, Self::Settings, Self::Curve, Self::Fill, Self::Scribble, Self::ColorPoint];
    /// How many there are.
    pub const KINDS: usize = Self::ALL.len();
}

impl Work {
    /// A document alone.
    pub fn new(document: Document) -> Self {
        Self { document, sample: None, image: Vec::new(), unknown: Unknown::default() }
    }

    /// Work without anything on a page of no account, to be filled by a reader.
    pub fn blank() -> Self {
        Self::new(Document::new(Drawing::new(Rect::new(0.0, 0.0, 1.0, 1.0))))
    }

    /// The same work with its document edited. Fields of a scribble that are not known go where its way goes: they stay
    /// with it when it is recoloured or moved in the order.
    pub fn edited(&self, document: Document) -> Self {
        let mut unknown = self.unknown.clone();
        unknown.follow(&self.document.scribbles, &document.scribbles);
        Self { document, sample: self.sample.clone(), image: self.image.clone(), unknown }
    }
}

/// Whether scribbles are longer in all than a file or a link may have them.
pub fn are_too_long(scribbles: &[Scribble]) -> bool {
    let length_du = |scribble: &Scribble| -> f64 {
        scribble.points.windows(2).map(|ends| (ends[1] - ends[0]).hypot()).sum()
    };
    scribbles.iter().map(length_du).sum::<f64>() > f64::from(MAX_PAGES) * LONGER_SIDE_DU
}

/// Whether more scribbles shade than in a file or a link may.
// By itself it would take more room in the page than where it is called.
#[inline]
pub fn are_too_many_shades(scribbles: &[Scribble]) -> bool {
    scribbles.iter().filter(|scribble| !scribble.is_fill()).count() > MAX_SHADES
}

/// Whether a page may lie there, and be as wide and as high, in page units.
pub fn is_page([x, y, width, height]: [f64; 4]) -> bool {
    let is_side = |side: f64| (1e-6..=1e8).contains(&side);
    x.abs() <= MAX_PAGE && y.abs() <= MAX_PAGE && is_side(width) && is_side(height)
}

/// Whether a name is a plain file name, which can lead nowhere but into the folder of samples.
pub fn is_sample_name(name: &str) -> bool {
    let is_plain = |b: u8| b.is_ascii_alphanumeric() || matches!(b, b'-' | b'_' | b'.');
    (1..=64).contains(&name.len()) && !name.starts_with('.') && name.bytes().all(is_plain)
}

impl Unknown {
    /// The unknown fields of an item, or nothing.
    pub fn of(&self, item: Item, index: usize) -> &str {
        let fields = &self.fields[item as usize];
        let place = fields.binary_search_by_key(&index, |(index, _)| *index as usize);
        place.map_or("", |place| &fields[place].1)
    }

    /// Keeps one more field of an item; items come in order.
    pub fn keep(&mut self, item: Item, index: usize, field: &str) {
        let fields = &mut self.fields[item as usize];
        match fields.last_mut() {
            Some((last, text)) if *last as usize == index => {
                text.push(',');
                text.push_str(field);
            }
            _ => fields.push((index as u32, field.to_owned())),
        }
    }

    /// Drops the fields of all items of a kind.
    pub fn forget(&mut self, item: Item) {
        self.fields[item as usize].clear();
    }

    fn follow(&mut self, before: &[Scribble], after: &[Scribble]) {
        let fields = std::mem::take(&mut self.fields[Item::Scribble as usize]);
        for (index, scribble) in after.iter().enumerate() {
            let is_its_own = |(index, _): &&(u32, String)| {
                before.get(*index as usize).is_some_and(|before| before.points == scribble.points)
            };
            if let Some((_, text)) = fields.iter().find(is_its_own) {
                self.keep(Item::Scribble, index, text);
            }
        }
    }
}

//! Work as a `.scumble` file: readable JSON, one line for each curve and scribble. `docs/format.md` tells what it says.
//!
//! Lengths are in du with three digits after the point. Fields that are not known are kept as they are.

use std::borrow::Cow;

use kurbo::Rect;
use scumble_core::{Blend, Document, EngineKind, Settings};

use crate::MAX_FILE_BYTES;
use crate::error::FileError;
use crate::json::{Fault, Json, Member, push_number, push_string};
use crate::packed;
use crate::work::{Item, MAX_PAGES, Unknown, Work, are_too_long, is_sample_name};
use items::Items;

mod items;

/// The version that is written. A file of a higher first number is refused.
const VERSION: [u32; 2] = [1, 0];

/// Steps of numbers in one, and of page coordinates.
const PER_UNIT: u64 = 1000;
const PAGE_PER_UNIT: u64 = 1_000_000_000;

/// Most curves.
const MAX_CURVES: usize = 100_000;

/// The file that keeps some work.
///
/// # Errors
/// When it could not be read again.
pub fn write_file(work: &Work) -> Result<Vec<u8>, FileError> {
    let Document { drawing, scribbles, .. } = &work.document;
    if drawing.curves.len() > MAX_CURVES {
        return Err(FileError::TooManyCurves);
    }
    if are_too_long(scribbles) {
        return Err(FileError::TooLong { limit_pages: MAX_PAGES });
    }
    let text = written(work);
    if text.len() > MAX_FILE_BYTES { Err(FileError::TooLarge) } else { Ok(text.into_bytes()) }
}

fn written(work: &Work) -> String {
    let mut text = String::from("{\n\"format\": \"scumble\",\n\"version\": \"");
    let minor = VERSION[1].max(work.unknown.minor);
    text.extend([&VERSION[0].to_string(), ".", &minor.to_string(), "\""]);
    let Document { drawing, settings, .. } = &work.document;
    if let Some(name) = &work.sample {
        text.push_str(",\n\"sample\": ");
        push_string(&mut text, name);
    }
    text.push_str(",\n\"canvas\": [");
    let page = drawing.page;
    for (i, number) in [page.x0, page.y0, page.width(), page.height()].into_iter().enumerate() {
        text.push_str(if i > 0 { ", " } else { "" });
        push_number(&mut text, number, PAGE_PER_UNIT);
    }
    text.push_str("],\n\"settings\": ");
    push_settings(&mut text, settings, work.unknown.of(Item::Settings, 0));
    items::push_all(&mut text, work);
    push_unknown(&mut text, ",\n", work.unknown.of(Item::Work, 0));
    text.push_str("\n}\n");
    text
}

fn push_settings(text: &mut String, settings: &Settings, unknown: &str) {
    let [blend, engine] = [blend_name(settings.blend), engine_name(settings.engine)];
    text.extend(["{\"blend\": \"", blend, "\", \"engine\": \"", engine, "\", \"gap_closing\": "]);
    push_number(text, settings.gap_closing, PER_UNIT);
    text.extend([", \"spread\": ", if settings.spread { "true" } else { "false" }]);
    push_unknown(text, ", ", unknown);
    text.push('}');
}

fn push_unknown(text: &mut String, comma: &str, unknown: &str) {
    if !unknown.is_empty() {
        text.extend([comma, unknown]);
    }
}

fn blend_name(blend: Blend) -> &'static str {
    match blend {
        Blend::Oklab => "oklab",
        Blend::Srgb => "srgb",
    }
}

fn engine_name(engine: EngineKind) -> &'static str {
    match engine {
        EngineKind::Global => "global",
        EngineKind::Progressive => "progressive",
    }
}

/// Reads the work that a file keeps.
///
/// # Errors
/// When the bytes are no such file, or damaged, or of a newer version, or beyond the limits.
pub fn read_file(bytes: &[u8]) -> Result<Work, FileError> {
    if bytes.trim_ascii().is_empty() {
        return Err(FileError::Empty);
    }
    if bytes.len() > MAX_FILE_BYTES {
        return Err(FileError::TooLarge);
    }
    let text = str::from_utf8(bytes).map_err(|_| FileError::NotText)?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let damaged = |fault: Fault| {
        if fault.expected == items::NO_MORE_CURVES {
            return FileError::TooManyCurves;
        }
        let before = text.get(..fault.at).unwrap_or(text);
        FileError::Damaged { line: 1 + before.matches('\n').count(), expected: fault.expected }
    };
    let minor = minor_version(text, damaged)?;
    let work = Reader::read(text, minor).map_err(damaged)?;
    if are_too_long(&work.document.scribbles) {
        Err(FileError::TooLong { limit_pages: MAX_PAGES })
    } else {
        Ok(work)
    }
}

/// The minor version of a file whose version can be read.
fn minor_version(text: &str, damaged: impl Fn(Fault) -> FileError) -> Result<u32, FileError> {
    let mut json = Json::new(text);
    let [mut format, mut version] = [const { Cow::Borrowed("") }; 2];
    let read = json.members(&mut |json, member| {
        match &*member.name {
            "format" => format = json.string()?,
            "version" => version = json.string()?,
            _ => json.skip()?,
        }
        Ok(())
    });
    if format != "scumble" {
        return Err(FileError::NotWork);
    }
    let (major, minor) = version.split_once('.').unwrap_or((&version, "0"));
    match (major.parse::<u32>(), minor.parse()) {
        (Ok(1), Ok(minor)) => read.and_then(|()| json.end()).map(|()| minor).map_err(damaged),
        (Ok(2..), _) => Err(FileError::Newer(version.chars().take(16).collect())),
        _ => Err(FileError::NotWork),
    }
}

struct Reader {
    work: Work,
    items: Items,
}

impl Reader {
    fn read(text: &str, minor: u32) -> Result<Work, Fault> {
        let mut work = Work::blank();
        work.unknown.minor = minor;
        let mut reader = Self { work, items: Items::default() };
        let mut json = Json::new(text);
        let mut has_canvas = false;
        json.members(&mut |json, member| {
            has_canvas |= member.name == "canvas";
            reader.member(json, &member)
        })?;
        if !has_canvas { json.fault("a canvas in the file") } else { Ok(reader.items.into_work(reader.work)) }
    }

    fn member(&mut self, json: &mut Json, member: &Member) -> Result<(), Fault> {
        let Document { drawing, settings, .. } = &mut self.work.document;
        match &*member.name {
            "format" | "version" => json.skip(),
            "sample" => sample(json).map(|name| self.work.sample = Some(name)),
            "canvas" => canvas(json).map(|page| drawing.page = page),
            "settings" => read_settings(json, &mut self.work.unknown).map(|read| *settings = read),
            _ => self.items.member(json, member, &mut self.work.unknown),
        }
    }
}

fn sample(json: &mut Json) -> Result<String, Fault> {
    let name = json.string()?;
    if is_sample_name(&name) { Ok(name.into_owned()) } else { json.fault("a plain file name before this") }
}

fn canvas(json: &mut Json) -> Result<Rect, Fault> {
    let numbers @ [x, y, width, height] = json.numbers()?;
    if packed::is_page(numbers) {
        Ok(Rect::new(x, y, x + width, y + height))
    } else {
        json.fault("a canvas [x, y, width, height] with sides from 1e-6 to 1e8 before this")
    }
}

fn read_settings(json: &mut Json, unknown: &mut Unknown) -> Result<Settings, Fault> {
    let mut settings = Settings::default();
    json.members(&mut |json, member| {
        match &*member.name {
            "blend" => {
                let blends = [Blend::Oklab, Blend::Srgb].map(|blend| (blend_name(blend), blend));
                settings.blend = named(json, &blends)?;
            }
            "engine" => {
                let engines = [EngineKind::Global, EngineKind::Progressive];
                let engines = engines.map(|engine| (engine_name(engine), engine));
                settings.engine = named(json, &engines)?;
            }
            "gap_closing" => settings.gap_closing = json.number()?,
            "spread" => settings.spread = json.boolean()?,
            _ => keep(json, &member, unknown, Item::Settings, 0)?,
        }
        Ok(())
    })?;
    Ok(settings.clamped())
}

/// One of a few names.
fn named<T: Copy>(json: &mut Json, names: &[(&str, T)]) -> Result<T, Fault> {
    let name = json.string()?;
    match names.iter().find(|(known, _)| *known == name) {
        Some((_, value)) => Ok(*value),
        None => {
            json.fault("a name that this version knows before this; update it to open what a newer one saved")
        }
    }
}

/// Keeps a field that is not known.
fn keep(
    json: &mut Json,
    member: &Member,
    unknown: &mut Unknown,
    item: Item,
    index: usize,
) -> Result<(), Fault> {
    json.skip()?;
    unknown.keep(item, index, json.source(member));
    Ok(())
}

/// Whether a text is one or more members of an object, and nothing else.
pub(crate) fn are_members(text: &str) -> bool {
    let text = ["{", text, "}"].concat();
    let mut json = Json::new(&text);
    let mut count = 0;
    let read = json.members(&mut |json, _| {
        count += 1;
        json.skip()
    });
    read.and_then(|()| json.end()).is_ok() && count > 0
}

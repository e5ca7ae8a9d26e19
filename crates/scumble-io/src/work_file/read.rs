//! Work out of a text whose version is known.

use kurbo::Rect;
use scumble_core::work::{Item, Unknown, Work, is_page, is_sample_name};
use scumble_core::{Document, Settings, Tracing};

use super::items::{Items, keep, named};
use super::names::{BLENDS, ENGINES};
use super::{FILE_IMAGE, VERSION};
use crate::base64;
use crate::image_file::{MAX_IMAGE_BYTES, check_image};
use crate::json::{Fault, Json, Member};

/// Work, as far as it has been read.
pub(super) struct Reader {
    work: Work,
    items: Items,
    tracing: Tracing,
}

impl Reader {
    pub(super) fn read(text: &str, minor: u32) -> Result<Work, Fault> {
        let mut work = Work::blank();
        // Of fields that it has, nobody needs to be told again.
        work.unknown.minor = if minor > VERSION[1] { minor } else { 0 };
        let mut reader = Self { work, items: Items::default(), tracing: Tracing::faded(FILE_IMAGE) };
        let mut json = Json::new(text);
        let mut has_canvas = false;
        json.members(&mut |json, member| {
            has_canvas |= member.name == "canvas";
            reader.member(json, &member)
        })?;
        if !has_canvas { json.fault("a canvas in the file") } else { Ok(reader.into_work()) }
    }

    fn into_work(self) -> Work {
        let mut work = self.items.into_work(self.work);
        work.document.tracing = (!work.image.is_empty()).then(|| self.tracing.clamped());
        work
    }

    fn member(&mut self, json: &mut Json, member: &Member) -> Result<(), Fault> {
        let Document { drawing, settings, .. } = &mut self.work.document;
        match &*member.name {
            "format" | "version" => json.skip(),
            "sample" => sample(json).map(|name| self.work.sample = Some(name)),
            "canvas" => canvas(json).map(|page| drawing.page = page),
            "tracing_image" => image(json).map(|image| self.work.image = image),
            "tracing_opacity" => json.number().map(|opacity| self.tracing.opacity = opacity),
            "settings" => read_settings(json, &mut self.work.unknown).map(|read| *settings = read),
            _ => self.items.member(json, member, &mut self.work.unknown),
        }
    }
}

fn sample(json: &mut Json) -> Result<String, Fault> {
    let name = json.string()?;
    if is_sample_name(&name) { Ok(name.into_owned()) } else { json.fault("a plain file name before this") }
}

fn image(json: &mut Json) -> Result<Vec<u8>, Fault> {
    const EXPECTED: &str =
        "a whole PNG or JPEG picture in base64, of at most 8 MiB and 64 million pixels, before this";
    let text = json.string()?;
    let digits = text.trim_end_matches('=');
    let is_padded = text.len() % 4 == 0 && text.len() - digits.len() < 3;
    if !is_padded || text.len() > MAX_IMAGE_BYTES.div_ceil(3) * 4 {
        return json.fault(EXPECTED);
    }
    let image = base64::bytes(digits, base64::PLAIN).filter(|image| check_image(image).is_ok());
    image.map_or_else(|| json.fault(EXPECTED), Ok)
}

fn canvas(json: &mut Json) -> Result<Rect, Fault> {
    let numbers @ [x, y, width, height] = json.numbers()?;
    if is_page(numbers) {
        Ok(Rect::new(x, y, x + width, y + height))
    } else {
        json.fault("a canvas [x, y, width, height] with sides from 1e-6 to 1e8 before this")
    }
}

fn read_settings(json: &mut Json, unknown: &mut Unknown) -> Result<Settings, Fault> {
    let mut settings = Settings::default();
    json.members(&mut |json, member| {
        match &*member.name {
            "blend" => settings.blend = named(json, &BLENDS)?,
            "engine" => settings.engine = named(json, &ENGINES)?,
            "gap_closing" => settings.gap_closing = json.number()?,
            "spread" => settings.spread = json.boolean()?,
            _ => keep(json, &member, unknown, Item::Settings, 0)?,
        }
        Ok(())
    })?;
    Ok(settings.clamped())
}

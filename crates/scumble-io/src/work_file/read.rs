//! Work out of a text whose version is known.

use kurbo::Rect;
use scumble_core::work::{Item, Unknown, Work, is_page, is_sample_name};
use scumble_core::{Document, Settings};

use super::items::{Items, keep, named};
use super::names::{BLENDS, ENGINES};
use crate::json::{Fault, Json, Member};

/// Work, as far as it has been read.
pub(super) struct Reader {
    work: Work,
    items: Items,
}

impl Reader {
    pub(super) fn read(text: &str, minor: u32) -> Result<Work, Fault> {
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

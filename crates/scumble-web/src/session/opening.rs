//! A drawing on its way: made ready in slices, so that the page goes on meanwhile, can show that it takes long, and stop it.
//! Of a large one the lines are shown at once: its picture is made afterwards.

use scumble_core::pace::{Slices, pause};
use scumble_core::{Drawing, MapError, Work, exact};
use scumble_solve::Picture;

use super::Session;
use super::making::{self, Part};
use super::sheet::Sheet;
use crate::effect::Effect;

/// Path elements of a drawing, more of which are shown before there is a picture.
const LARGE: usize = 10_000;

const DAMAGED: &str = "what the browser kept of the drawing is damaged; open it from a file";

/// A drawing that is made ready.
#[derive(Debug)]
pub(super) struct Coming {
    /// Its exact bytes.
    work: Vec<u8>,
    step: Step,
}

/// How far it is.
#[derive(Debug)]
enum Step {
    OnItsWay(Slices<'static, Result<Box<Sheet>, MapError>>),
    /// What it is, or why it is none.
    Ready(Result<Box<Sheet>, MapError>),
}

async fn sheet_of(
    number: u32,
    mut work: Work,
    is_meshed: impl Fn(&Picture) -> bool,
) -> Result<Box<Sheet>, MapError> {
    work.document = work.document.kept();
    pause().await;
    if is_large(&work.document.drawing) {
        return Ok(Box::new(Sheet::unmade(number, work)?));
    }
    let mut picture = Picture::mapping(&work.document.drawing).await?;
    let is_meshed = is_meshed(&picture);
    making::make(&mut picture, &work.document, is_meshed, &Part::default()).await;
    Ok(Box::new(Sheet::new(number, work, picture)))
}

/// Whether it takes longer to make the picture of a drawing than people wait for the lines.
fn is_large(drawing: &Drawing) -> bool {
    drawing.curves.iter().map(|curve| curve.path.elements().len()).sum::<usize>() > LARGE
}

impl Session {
    /// Begins to make work ready to be opened, by its exact bytes, in the place of other work that is on its way.
    pub fn prepare(&mut self, work: &[u8]) {
        self.coming = exact::read(work).map(|read| {
            let slices = Slices::new(sheet_of(self.opened + 1, read, self.is_meshed(false)));
            Coming { work: work.to_vec(), step: Step::OnItsWay(slices) }
        });
    }

    /// Goes on with it by one slice, and tells whether there are more.
    pub fn prepare_on(&mut self) -> bool {
        let Some(Coming { work, step: Step::OnItsWay(slices) }) =
            self.coming.take_if(|coming| matches!(coming.step, Step::OnItsWay(_)))
        else {
            return false;
        };
        let step = slices.go_on().map_or_else(Step::OnItsWay, Step::Ready);
        let is_more = matches!(step, Step::OnItsWay(_));
        self.coming = Some(Coming { work, step });
        is_more
    }

    /// Leaves what is on its way.
    pub(super) fn stop_preparing(&mut self) {
        self.coming = None;
    }

    /// Opens work, which may be ready.
    pub(super) fn open(&mut self, work: &[u8], notes: String) {
        if self.coming.as_ref().is_none_or(|coming| coming.work != work) {
            self.prepare(work);
        }
        while self.prepare_on() {}
        match self.coming.take().map(|coming| coming.step) {
            Some(Step::Ready(Ok(sheet))) => {
                // What the pen has done so far is not lost with the drawing that goes.
                self.end(&[]);
                self.lay_over(*sheet);
                self.stale.boundary = !self.sheet.is_made();
                self.opened += 1;
                // Where they are hidden, a drawing without colours would be a blank page.
                self.show_lines(true);
                self.tell(Effect::Opened { notes });
            }
            Some(Step::Ready(Err(error))) => self.tell(Effect::Failed(error.to_string())),
            _ => self.tell(Effect::Failed(DAMAGED.into())),
        }
    }
}

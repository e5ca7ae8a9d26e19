//! A drawing on its way: made ready in slices, so that the page goes on meanwhile, can show that it takes long, and stop it.
//! Of a large one the lines are shown at once: its picture is made afterwards.

use scumble_core::pace::{Slices, pause};
use scumble_core::{Drawing, MapError, Work, exact};
use scumble_solve::{Field, Picture};

use super::Session;
use super::making;
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
    OnItsWay(Slices<'static, Result<Box<Ready>, MapError>>),
    /// What it is, or why it is none.
    Ready(Result<Box<Ready>, MapError>),
}

/// A sheet, and what is shown of it first where that takes no time.
#[derive(Debug)]
struct Ready {
    sheet: Sheet,
    field: Option<Field>,
}

impl Ready {
    async fn making(
        number: u32,
        mut work: Work,
        is_meshed: impl Fn(&Picture) -> bool,
    ) -> Result<Box<Self>, MapError> {
        work.document = work.document.kept();
        pause().await;
        if is_large(&work.document.drawing) {
            return Ok(Box::new(Self { sheet: Sheet::unmade(number, work)?, field: None }));
        }
        let mut picture = Picture::mapping(&work.document.drawing).await?;
        let is_meshed = is_meshed(&picture);
        let field = making::make(&mut picture, &work.document, is_meshed).await.cloned();
        Ok(Box::new(Self { sheet: Sheet::new(number, work, picture), field }))
    }
}

/// Whether it takes longer to make the picture of a drawing than people wait for the lines.
fn is_large(drawing: &Drawing) -> bool {
    drawing.curves.iter().map(|curve| curve.path.elements().len()).sum::<usize>() > LARGE
}

impl Session {
    /// Begins to make work ready to be opened, by its exact bytes, in the place of other work that is on its way.
    pub fn prepare(&mut self, work: &[u8]) {
        self.coming = exact::read(work).map(|read| {
            let slices = Slices::new(Ready::making(self.opened + 1, read, self.is_meshed(false)));
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
            Some(Step::Ready(Ok(ready))) => {
                // What the pen has done so far is not lost with the drawing that goes.
                self.end(&[]);
                let Ready { sheet, field } = *ready;
                self.lay_over(sheet);
                self.show_ready(field);
                self.opened += 1;
                self.tell(Effect::Opened { notes });
            }
            Some(Step::Ready(Err(error))) => self.tell(Effect::Failed(error.to_string())),
            _ => self.tell(Effect::Failed(DAMAGED.into())),
        }
    }

    /// Shows what was made of the drawing that was just laid over.
    fn show_ready(&mut self, field: Option<Field>) {
        if self.sheet.is_made() {
            self.stale.boundary = false;
        }
        if let Some(field) = field {
            self.show_field(field);
        }
    }
}

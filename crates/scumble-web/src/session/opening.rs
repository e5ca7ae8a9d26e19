//! A drawing on its way: made ready step by step, so that the page can show that it takes long, and stop it.

use scumble_core::{MapError, Work, exact};

use super::Session;
use super::making::STEPS;
use super::sheet::Sheet;
use crate::effect::Effect;
use crate::solver::{Moment, Source};

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
    Read(Box<Work>),
    /// So many of [`STEPS`] are done.
    Mapped(Box<Sheet>, usize),
    /// What it is, or why it is none.
    Ready(Result<Box<Sheet>, MapError>),
}

impl Session {
    /// Begins to make work ready to be opened, by its exact bytes, in the place of other work that is on its way.
    pub fn prepare(&mut self, work: &[u8]) {
        let read = exact::read(work).map(|work| Step::Read(Box::new(work)));
        self.coming = read.map(|step| Coming { work: work.to_vec(), step });
    }

    /// Takes the next step, and tells whether there are more.
    pub fn prepare_on(&mut self) -> bool {
        let Some(Coming { work, step }) = self.coming.take() else { return false };
        let step = self.after(step);
        let is_ready = matches!(step, Step::Ready(_));
        self.coming = Some(Coming { work, step });
        !is_ready
    }

    /// Leaves what is on its way.
    pub(super) fn stop_preparing(&mut self) {
        self.coming = None;
    }

    fn after(&self, step: Step) -> Step {
        match step {
            Step::Read(work) => match Sheet::new(self.opened + 1, *work) {
                Ok(sheet) => Step::Mapped(Box::new(sheet), 0),
                Err(error) => Step::Ready(Err(error)),
            },
            Step::Mapped(mut sheet, done) if done < self.first_step_count(&sheet) => {
                let Sheet { picture, editor, .. } = &mut *sheet;
                let document = editor.document();
                STEPS[done](picture, document, &document.settings);
                Step::Mapped(sheet, done + 1)
            }
            Step::Mapped(sheet, _) => Step::Ready(Ok(sheet)),
            Step::Ready(sheet) => Step::Ready(sheet),
        }
    }

    /// How many of [`STEPS`] the first picture of a drawing takes: where the grid solver makes it, the first alone.
    pub(super) fn first_step_count(&self, sheet: &Sheet) -> usize {
        let pieces = sheet.picture.map().pieces().len();
        match self.solver.source(&Moment { pieces, is_mesh_due: false, ..self.moment() }) {
            Source::Grid => 1,
            _ => STEPS.len(),
        }
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
                self.opened += 1;
                self.tell(Effect::Opened { notes });
            }
            Some(Step::Ready(Err(error))) => self.tell(Effect::Failed(error.to_string())),
            _ => self.tell(Effect::Failed(DAMAGED.into())),
        }
    }
}

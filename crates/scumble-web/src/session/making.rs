//! Another picture of the drawing in work, for other lines, another map or another engine. Where that takes long it is made step by
//! step, beside the one that is shown: the page goes on, and can go back to what was.

use scumble_core::{Document, MapError, Settings};
use scumble_solve::Picture;

use super::Session;
use super::sheet::Sheet;
use crate::effect::Effect;
use crate::solver::PIECES_IN_HAND;

/// What is made of a map, each from what is before it: the labels say which gaps are closed in the mesh.
pub(super) const STEPS: [fn(&mut Picture, &Document, &Settings); 3] = [
    |picture, document, settings| {
        picture.label(&document.scribbles, settings);
    },
    |picture, _, _| {
        picture.mesh();
    },
    |picture, Document { scribbles, color_points, .. }, settings| {
        let boundary = picture.color(scribbles, color_points, settings);
        // What fails is told of when the picture is shown, with the lines.
        let _ = picture.mesh().solve(&boundary, settings.blend);
    },
];

/// A picture on its way.
#[derive(Debug)]
pub(super) struct Making {
    /// The revision of the lines that it is for.
    lines: u32,
    settings: Settings,
    /// Once there is a map.
    picture: Option<Picture>,
    /// How many of [`STEPS`] are.
    done: usize,
}

impl Making {
    fn new(sheet: &Sheet) -> Self {
        let picture = (!sheet.has_stale_map()).then(|| sheet.picture.again());
        let settings = sheet.editor.document().settings;
        Self { lines: sheet.editor.lines_revision(), settings, picture, done: 0 }
    }

    /// Takes a step, of so many, and tells whether there are more.
    fn go_on(&mut self, document: &Document, step_count: usize) -> Result<bool, MapError> {
        if let Some(picture) = &mut self.picture {
            STEPS[self.done](picture, document, &self.settings);
            self.done += 1;
        } else {
            self.picture = Some(Picture::new(&document.drawing)?);
        }
        Ok(self.done < step_count)
    }
}

impl Session {
    /// Whether another picture is wanted than the one that is shown, and takes steps.
    pub(super) fn lacks_picture(&self) -> bool {
        let Sheet { editor, picture, .. } = &self.sheet;
        let is_at_rest = !editor.is_changing_lines();
        picture.map().pieces().len() > PIECES_IN_HAND && is_at_rest && !self.sheet.is_suited()
    }

    /// Whether the drawing has other lines than the picture that is shown, which is not changed before another is there.
    pub(super) fn lacks_map(&self) -> bool {
        self.sheet.has_stale_map() && self.lacks_picture()
    }

    /// The settings of the picture: those of the document, but while another one is wanted.
    pub(super) fn settings_shown(&self) -> Settings {
        let settings = self.document().settings;
        if self.lacks_picture() {
            Settings { blend: settings.blend, ..*self.sheet.picture.settings() }
        } else {
            settings
        }
    }

    /// Whether another picture is on its way.
    pub(super) fn is_making(&self) -> bool {
        self.making.is_some()
    }

    /// Takes a step towards the picture that is wanted.
    pub(super) fn make_on(&mut self) {
        let is_wanted = self.lacks_picture();
        let lines = self.sheet.editor.lines_revision();
        let begun = self.making.take().filter(|making| is_wanted && making.lines == lines);
        let step_count = self.first_step_count(&self.sheet);
        match begun {
            None => self.making = is_wanted.then(|| Making::new(&self.sheet)),
            Some(mut making) => match making.go_on(self.sheet.editor.document(), step_count) {
                Ok(true) => self.making = Some(making),
                Ok(false) => self.show_made(making),
                Err(error) => self.take_back_lines(&error),
            },
        }
    }

    /// Makes at once what is wanted, for what cannot wait.
    pub(super) fn finish_making(&mut self) {
        while self.lacks_picture() {
            self.make_on();
        }
    }

    /// Goes back to where the picture that is shown is the right one.
    pub(super) fn stop_making(&mut self) {
        if !self.is_making() {
            return;
        }
        while self.lacks_picture() && self.sheet.editor.undo() {}
        (self.held, self.making) = (None, None);
        self.scribbles_changed();
        self.forget_missing();
        self.tell(Effect::MakingStopped);
    }

    fn show_made(&mut self, making: Making) {
        if let Some(picture) = making.picture {
            self.sheet.take_picture(picture, making.lines);
        }
        self.scribbles_changed();
        self.stale.lines = true;
    }
}

//! Another picture of the drawing in work, for other lines, another map or another engine. Where that takes long it is made in
//! slices, beside the one that is shown: the page goes on, and can go back to what was.

use std::cell::Cell;
use std::rc::Rc;

use kurbo::Rect;
use scumble_core::pace::Slices;
use scumble_core::{Document, MapError, Settings};
use scumble_solve::Picture;

use super::Session;
use super::sheet::Sheet;
use crate::effect::{Effect, Wanted};
use crate::solver::{Moment, PIECES_IN_HAND, Source};

/// The picture of a drawing with more pieces takes so long that others are shown before it.
const MANY_PIECES: usize = 30_000;

/// The part of the plane that is to be made first of very many pieces, if any is, in du.
pub(super) type Part = Cell<Option<Rect>>;

/// Makes all that the first picture of a document takes, from a map: its boundary, and where it comes from a mesh, its field, or
/// a preview of that. What fails is told of when the picture is shown, with the lines.
pub(super) async fn make(picture: &mut Picture, document: &Document, is_meshed: bool, part: &Part) {
    let Document { scribbles, color_points, settings, .. } = document;
    picture.coloring(scribbles, color_points, settings).await;
    if is_meshed {
        if picture.part_du().is_none() && !picture.has_mesh() && has_many_pieces(picture) {
            picture.narrow(part.get());
        }
        let _ = picture.solving().await;
    }
}

fn has_many_pieces(picture: &Picture) -> bool {
    picture.map().pieces().len() > MANY_PIECES
}

pub(super) fn has_colors(document: &Document) -> bool {
    !(document.scribbles.is_empty() && document.color_points.is_empty())
}

/// A picture on its way.
#[derive(Debug)]
pub(super) struct Making {
    /// The revisions of the lines, and of the document, that it is for.
    lines: u32,
    revision: u32,
    /// Whether a gesture was in hand then, whose states have no revisions.
    is_in_hand: bool,
    /// How often colours had changed.
    pub(super) colorings: u32,
    part: Rc<Part>,
    picture: Slices<'static, Result<Picture, MapError>>,
}

impl Making {
    /// From a picture of the same lines, if there is one; the first one of very many pieces is to be rough.
    fn new(
        sheet: &Sheet,
        colorings: u32,
        known: Option<Picture>,
        is_meshed: impl Fn(&Picture) -> bool + 'static,
    ) -> Self {
        let document = sheet.editor.document().clone();
        let is_first = known.is_none() && !sheet.is_made() && has_colors(&document);
        let part = Rc::<Part>::default();
        let first = part.clone();
        let picture = Slices::new(async move {
            let mut picture = match known {
                Some(picture) => picture,
                None => Picture::mapping(&document.drawing).await?,
            };
            if is_first && has_many_pieces(&picture) {
                picture.roughen();
            }
            let is_meshed = picture.map().is_rough() || is_meshed(&picture);
            make(&mut picture, &document, is_meshed, &first).await;
            Ok(picture)
        });
        let editor = &sheet.editor;
        let (lines, revision) = (editor.lines_revision(), editor.revision());
        Self { lines, revision, is_in_hand: editor.is_in_hand(), colorings, part, picture }
    }
}

impl Session {
    /// What is wanted beside what is shown, and takes steps.
    pub(super) fn wanted(&self) -> Wanted {
        if self.lacks_picture() {
            Wanted::Picture
        } else if self.lacks_mesh() {
            Wanted::Mesh
        } else {
            Wanted::Nothing
        }
    }

    /// Whether another picture is wanted than the one that is shown.
    pub(super) fn lacks_picture(&self) -> bool {
        self.is_large_at_rest() && !self.sheet.is_suited()
    }

    /// Whether the picture that is shown, on pixels, is to be one on a mesh.
    pub(super) fn lacks_mesh(&self) -> bool {
        let at_last = Moment { has_mesh: true, ..self.moment() };
        let is_without = !self.sheet.picture.has_mesh();
        is_without && self.is_large_at_rest() && self.solver.source(&at_last) != Source::Grid
    }

    fn is_large_at_rest(&self) -> bool {
        let Sheet { editor, picture, most_pieces, .. } = &self.sheet;
        // Lines that were deleted from a large drawing may be coming back.
        let pieces = if self.sheet.has_stale_map() { *most_pieces } else { picture.map().pieces().len() };
        let is_large = !self.sheet.is_made() || pieces > PIECES_IN_HAND;
        is_large && !editor.is_changing_lines()
    }

    /// Whether the drawing has other lines than the picture that is shown, which is not changed before another is there.
    pub(super) fn lacks_map(&self) -> bool {
        !self.sheet.is_made() || self.sheet.has_stale_map() && self.lacks_picture()
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

    /// Goes on by one slice with what is wanted, and tells whether there are more.
    pub fn make_on(&mut self) -> bool {
        self.ask_for_part(self.part_first());
        self.make_further();
        self.making.is_some()
    }

    fn ask_for_part(&self, part_du: Option<Rect>) {
        if let Some(making) = &self.making {
            making.part.set(part_du);
        }
    }

    fn make_further(&mut self) {
        let is_wanted = self.wanted() != Wanted::Nothing;
        let lines = self.sheet.editor.lines_revision();
        match self.making.take().filter(|making| is_wanted && making.lines == lines) {
            None if is_wanted => {
                let known = (!self.sheet.has_stale_map()).then(|| self.sheet.picture.again());
                self.make_from(known);
            }
            None => {}
            Some(Making { picture, part, revision, is_in_hand, colorings, .. }) => match picture.go_on() {
                Err(picture) => {
                    self.making = Some(Making { lines, revision, is_in_hand, colorings, part, picture });
                }
                Ok(Ok(mut picture)) if picture.part_du().is_some() => {
                    self.take_preview(&mut picture, colorings);
                    self.make_from(Some(picture));
                }
                Ok(picture) => self.end_making(picture, revision, is_in_hand),
            },
        }
    }

    /// Begins with a picture of the same lines, if there is one.
    fn make_from(&mut self, known: Option<Picture>) {
        let is_meshed = self.is_meshed(!self.sheet.has_stale_map());
        self.making = Some(Making::new(&self.sheet, self.colorings, known, is_meshed));
    }

    fn end_making(&mut self, picture: Result<Picture, MapError>, revision: u32, is_in_hand: bool) {
        match picture {
            // What was done meanwhile may take as long.
            Ok(picture) if revision != self.sheet.editor.revision() => self.make_from(Some(picture)),
            Ok(picture) => self.show_made(picture, is_in_hand),
            Err(error) => self.take_back(&error),
        }
    }

    /// Whether a picture comes from the mesh solver, as of now: the first one of a drawing, or another after it.
    pub(super) fn is_meshed(&self, is_another: bool) -> impl Fn(&Picture) -> bool + use<> {
        let (solver, moment) = (self.solver, self.moment());
        move |picture| {
            let pieces = picture.map().pieces().len();
            solver.source(&Moment { pieces, has_mesh: is_another, ..moment }) != Source::Grid
        }
    }

    /// Makes at once what is wanted, for what cannot wait.
    pub(super) fn finish_making(&mut self) {
        self.ask_for_part(None);
        while self.wanted() != Wanted::Nothing {
            self.make_further();
        }
    }

    /// Goes back to where the picture that is shown is the right one.
    pub(super) fn stop_making(&mut self) {
        if !self.lacks_picture() {
            return;
        }
        if !self.sheet.is_made() {
            if !self.take_off() {
                return;
            }
        } else {
            self.find_pictured();
        }
        (self.held, self.making) = (None, None);
        self.scribbles_changed();
        self.forget_missing();
        self.tell(Effect::MakingStopped);
    }

    /// Goes to where in the history the picture is the right one: back, or where undo has asked for another, forth.
    fn find_pictured(&mut self) {
        let place = self.sheet.editor.place();
        while self.lacks_picture() && self.sheet.editor.undo() {}
        while self.lacks_picture() && self.sheet.editor.redo() {}
        if self.lacks_picture() {
            self.sheet.editor.go_to(place);
        }
    }

    /// Shows a picture, which is that of the document as it is but for a gesture that is in hand or was.
    fn show_made(&mut self, mut picture: Picture, was_in_hand: bool) {
        let lines = self.sheet.editor.lines_revision();
        let is_solved = picture.take_change().is_any();
        self.sheet.take_picture(picture, lines);
        self.show_other();
        self.scribbles_changed();
        if !was_in_hand && !self.sheet.editor.is_in_hand() {
            (self.stale.boundary, self.stale.field) = (false, !is_solved);
        }
        // Solid ink is drawn by the map.
        self.stale.lines |= !self.document().drawing.fills.is_empty();
    }
}

//! The colour at a place of the picture: under the pen for tones, and as the canvas shows it for the tool that picks it.

use kurbo::{Affine, Line, Point, Vec2};
use scumble_core::{Document, Paint, Scribble, Srgb8};
use scumble_solve::{Field, Scene, View, paint};

use super::Session;
use super::sheet::Sheet;
use crate::brush::Ink;
use crate::effect::Effect;
use crate::layers::drawn_width_du;
use crate::painting::PAPER;

/// Pixels of a du where the colour of a place is looked up.
const CLOSE: f64 = 64.0;

/// What covers a place to this part at least is what is seen there.
const HALF: u8 = 128;

impl Session {
    /// Takes the colour that the canvas shows at a place in du for the next scribbles. Beside the page there is none.
    pub(super) fn pick(&mut self, place: Point) {
        if self.document().drawing.frame().contains(place) {
            let color = self.color_shown(place);
            self.take_ink(Ink::Paint(color), false);
            self.tell(Effect::Picked(color));
        }
    }

    /// The colour of the picture at a place in du, under lines and scribbles.
    pub(super) fn color_under(&mut self, place: Point) -> Srgb8 {
        if !self.sheet.is_made() {
            self.finish_making();
        }
        self.refresh_field();
        self.refresh_close_up();
        let blank = Field::default();
        let field = self.field_shown().unwrap_or(&blank);
        color_at(place, &Scene { paper: Some(PAPER), field, shapes: &[] }).0
    }

    /// The colours under the first points of some scribbles, by their indices in ascending order, in the picture without all
    /// of these.
    pub(super) fn colors_under(&mut self, scribbles: &[usize]) -> Vec<(usize, Srgb8)> {
        if scribbles.is_empty() {
            return Vec::new();
        }
        self.finish_making();
        self.refresh_map();
        self.stale.colors();
        let Sheet { editor, picture, .. } = &mut self.sheet;
        let Document { scribbles: all, color_points, settings, .. } = editor.document();
        let rest = all
            .iter()
            .enumerate()
            .filter(|(i, _)| scribbles.binary_search(i).is_err())
            .map(|(_, scribble)| scribble.clone());
        picture.color(&rest.collect::<Vec<_>>(), color_points, settings);
        let colors = picture.solve().map(|field| {
            let scene = Scene { paper: Some(PAPER), field, shapes: &[] };
            scribbles.iter().map(|i| (*i, color_at(all[*i].points[0], &scene).0)).collect()
        });
        // While a picture of other lines is made, this one keeps its boundary.
        picture.color(all, color_points, settings);
        colors.unwrap_or_default()
    }

    /// That of the scribble there, which has a rim that is not its own, or else what is painted, without the scribbles.
    fn color_shown(&mut self, place: Point) -> Paint {
        self.refresh_field();
        self.refresh_close_up();
        self.refresh_ink();
        let (shapes, blank) = (self.layers.ink(), Field::default());
        let (_, ink) = color_at(place, &Scene { paper: None, field: &blank, shapes });
        let field = self.field_shown().filter(|_| self.result_shown).unwrap_or(&blank);
        let (painted, _) = color_at(place, &Scene { paper: Some(PAPER), field, shapes });
        self.scribble_shown(place).filter(|_| ink < HALF).unwrap_or(painted.into())
    }

    /// The colour of the uppermost scribble at a place in du, if they are shown.
    fn scribble_shown(&self, place: Point) -> Option<Paint> {
        let is_there = |scribble: &&Scribble| {
            let rest_du = 0.5 * (drawn_width_du(scribble) - scribble.width_du);
            scribble.is_touched(Line::new(place, place), rest_du)
        };
        let uppermost =
            self.document().scribbles.iter().rev().filter(|_| self.scribbles_shown).find(is_there);
        uppermost.map(|scribble| scribble.color)
    }
}

/// The colour of a scene at a place in du, and its opacity.
fn color_at(place: Point, scene: &Scene<'_>) -> (Srgb8, u8) {
    let middle_px = Vec2::new(0.5, 0.5);
    let px_from_du =
        Affine::translate(middle_px) * Affine::scale(CLOSE) * Affine::translate(-place.to_vec2());
    let pixel = paint(scene, &View { px_from_du, width_px: 1, height_px: 1 });
    pixel.rgba.first_chunk().map_or((PAPER, 0), |&[r, g, b, a]| (Srgb8([r, g, b]), a))
}

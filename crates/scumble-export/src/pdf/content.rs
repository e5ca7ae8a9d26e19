//! What a page shows: operators in du, in painting order.

use kurbo::{Cap, Join, Stroke};
use scumble_core::{Rgba8, Srgb8};

use super::Page;
use crate::export::Export;
use crate::ink::{Ink, Manner, ink};
use crate::numbers::{number, pdf_path, push_number, push_numbers};
use crate::regions::{Flat, SEAM_DU};

/// The operators, with those for the shades given. What they name of states is added to the resources.
pub(super) fn of(export: &Export, page: &Page, shades: &str, states: &mut String) -> String {
    let mut pen = Pen::new(page, states);
    if let Some(paper) = export.look.paper {
        pen.color(paper, "rg");
        pen.operator(&[0.0, 0.0, page.size_du[0], page.size_du[1]], "re f");
    }
    export.regions.flats.iter().for_each(|flat| pen.seams(flat));
    pen.text.push_str(shades);
    export.regions.flats.iter().for_each(|flat| pen.flat(flat));
    if export.look.lines {
        ink(&export.work.document.drawing).for_each(|ink| pen.ink(&ink));
    }
    pen.text
}

struct Pen<'a> {
    text: String,
    /// The opacity that is set, of 255.
    alpha: u8,
    /// Resources.
    states: &'a mut String,
}

impl<'a> Pen<'a> {
    /// A pen whose units are du, with y down.
    fn new(page: &Page, states: &'a mut String) -> Self {
        let mut pen = Self { text: String::new(), alpha: 255, states };
        let scale = page.pt_per_du;
        let matrix = [format!("{scale:.9}"), "0 0".into(), format!("{:.9}", -scale), "0".into()].join(" ");
        pen.text.extend([&matrix, " ", &number(page.size_pt[1]), " cm\n"]);
        pen
    }

    fn operator(&mut self, operands: &[f64], name: &str) {
        push_numbers(&mut self.text, operands);
        self.text.extend([" ", name, "\n"]);
    }

    fn color(&mut self, Srgb8(rgb): Srgb8, name: &str) {
        // Four digits tell the 256 levels apart with room for rounding in other programs.
        let levels = rgb.map(|c| format!("{:.4}", f64::from(c) / 255.0));
        self.text.extend([&levels.join(" "), " ", name, "\n"]);
    }

    fn seams(&mut self, flat: &Flat) {
        if !flat.seams.is_empty() {
            self.color(flat.color, "RG");
            self.operator(&[SEAM_DU], "w");
            self.text.extend([&pdf_path(&flat.seams), "S\n"]);
        }
    }

    fn flat(&mut self, flat: &Flat) {
        self.color(flat.color, "rg");
        self.text.extend([&pdf_path(&flat.path), "f*\n"]);
    }

    fn ink(&mut self, Ink { path, color: Rgba8([r, g, b, alpha]), manner }: &Ink) {
        self.set_alpha(*alpha);
        let (color, path) = (Srgb8([*r, *g, *b]), pdf_path(path));
        match manner {
            Manner::Fill { even_odd } => {
                self.color(color, "rg");
                self.text.extend([&*path, if *even_odd { "f*\n" } else { "f\n" }]);
            }
            Manner::Line(stroke) => {
                self.color(color, "RG");
                self.stroke(stroke);
                self.text.extend([&path, "S\n"]);
            }
        }
    }

    fn set_alpha(&mut self, alpha: u8) {
        if alpha == self.alpha {
            return;
        }
        self.alpha = alpha;
        let (name, opacity) = (format!("/A{alpha} "), number(f64::from(alpha) / 255.0));
        self.text.extend([&name, "gs\n"]);
        if !self.states.contains(&name) {
            self.states.extend([" ", &name, "<</CA ", &opacity, " /ca ", &opacity, ">>"]);
        }
    }

    fn stroke(&mut self, stroke: &Stroke) {
        let cap = match stroke.end_cap {
            Cap::Butt => "0 J",
            Cap::Round => "1 J",
            Cap::Square => "2 J",
        };
        let join = match stroke.join {
            Join::Miter => "0 j",
            Join::Round => "1 j",
            Join::Bevel => "2 j",
        };
        self.text.extend([cap, " ", join, " "]);
        self.operator(&[stroke.miter_limit.max(1.0)], "M");
        self.operator(&[stroke.width], "w");
        self.text.push('[');
        push_numbers(&mut self.text, &stroke.dash_pattern);
        self.text.push_str("] ");
        push_number(&mut self.text, dash_phase(stroke));
        self.text.push_str(" d\n");
    }
}

/// Where in the pattern a line begins: PDF wants no negative numbers.
fn dash_phase(stroke: &Stroke) -> f64 {
    // A pattern of an odd length goes on with dashes and gaps exchanged.
    let period = 2.0 * stroke.dash_pattern.iter().sum::<f64>();
    if period > 0.0 { stroke.dash_offset.rem_euclid(period) } else { 0.0 }
}

//! Each scribble alone, without spreading: does it stay in the area that it was drawn in, and does it fill it?
//!
//! The area that a scribble means is what it touches of its true colour, and all of that colour that hangs together
//! with it by the edges of pixels. Unscored pixels count for that: truth pictures have colours under the lines
//! too, so that an area stays one where lines cross it.

use scumble_core::Settings;

use super::Method;
use super::score::{self, Class};
use super::subject::Subject;
use super::truth::{Mark, Truth, palette_index};
use crate::rivals::SketchPixel;

/// How one scribble did; parts from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct SingleScore {
    /// Of the scored pixels that it colours, those whose true colour is its own; 0 if it colours none.
    pub(crate) precision: f64,
    /// Of the scored pixels of the area that it means, those that it colours; 0 if there are none.
    pub(crate) recall: f64,
}

/// Scores of many scribbles by one method.
#[derive(Debug)]
pub(crate) struct Singles {
    method: Method,
    scores: Vec<SingleScore>,
}

impl Singles {
    pub(crate) fn new(method: Method) -> Self {
        Self { method, scores: Vec::new() }
    }

    /// Scores each scribble of a drawing alone.
    ///
    /// # Errors
    /// When the solver fails.
    pub(crate) fn add(&mut self, subject: &mut Subject, settings: Settings) -> anyhow::Result<()> {
        let settings = Settings { spread: false, ..settings };
        for i in 0..subject.scribbles.len() {
            let alone = [subject.scribbles[i].clone()];
            let color = palette_index(&alone[0])?;
            let picture = subject.paint(self.method, settings, &alone)?;
            let classes = score::classes(&picture, &[color]);
            let meant = meant_area(&subject.truth, &subject.sketch(&alone).seeds);
            self.scores.push(SingleScore::new(&subject.truth, color, &classes, &meant));
        }
        Ok(())
    }

    /// Prints the means, and for how many scribbles each figure is below one half.
    pub(crate) fn print(&self) {
        let [precision, recall] = [self.summary(|score| score.precision), self.summary(|score| score.recall)];
        let (name, count) = (self.method.name, self.scores.len());
        println!("{name:<12} alone, {count} scribbles: precision {precision}, recall {recall}");
    }

    fn summary(&self, of: fn(&SingleScore) -> f64) -> String {
        let mean = self.scores.iter().map(of).sum::<f64>() / self.scores.len().max(1) as f64;
        let below = self.scores.iter().filter(|score| of(score) < 0.5).count();
        format!("{mean:.4} ({below} below 0.5)")
    }
}

impl SingleScore {
    /// Scores the picture of one scribble by the classes of its pixels; `meant` has an entry for each pixel.
    pub(crate) fn new(truth: &Truth, color: u8, classes: &[Class], meant: &[bool]) -> Self {
        let (mut colored, mut right, mut expected, mut reached) = (0_u32, 0_u32, 0_u32, 0_u32);
        for pixel in (0..classes.len()).filter(|&pixel| truth.marks[pixel] != Mark::Unscored) {
            let is_colored = classes[pixel].is_some();
            colored += u32::from(is_colored);
            right += u32::from(is_colored && truth.colors[pixel] == color);
            expected += u32::from(meant[pixel]);
            reached += u32::from(meant[pixel] && is_colored);
        }
        let part = |part: u32, whole: u32| f64::from(part) / f64::from(whole.max(1));
        Self { precision: part(right, colored), recall: part(reached, expected) }
    }
}

/// The pixels of the area that a scribble means, from the pixels that it covers.
fn meant_area(truth: &Truth, scribble: &[SketchPixel]) -> Vec<bool> {
    let covered = scribble.iter().zip(&truth.colors);
    let mut meant: Vec<bool> = covered.map(|(label, color)| *label == Some(*color)).collect();
    let mut front: Vec<usize> = (0..meant.len()).filter(|&pixel| meant[pixel]).collect();
    while let Some(pixel) = front.pop() {
        for neighbor in truth.neighbors(pixel) {
            if !meant[neighbor] && truth.colors[neighbor] == truth.colors[pixel] {
                meant[neighbor] = true;
                front.push(neighbor);
            }
        }
    }
    meant
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One row: an area of colour 0 that a line (unscored) crosses, one of colour 1, and another of colour 0.
    fn truth() -> Truth {
        let marks = [1, 1, 0, 1, 1, 1, 1, 1].map(|scored| [Mark::Unscored, Mark::Area][scored]);
        Truth { width_px: 8, height_px: 1, colors: vec![0, 0, 0, 0, 1, 1, 0, 0], marks: marks.to_vec() }
    }

    #[test]
    fn an_area_goes_on_across_lines_but_not_across_another_colour() {
        let mut scribble = [None; 8];
        scribble[1] = Some(0);
        let meant = meant_area(&truth(), &scribble);
        assert_eq!(meant, [true, true, true, true, false, false, false, false]);
        scribble[5] = Some(0);
        assert_eq!(meant_area(&truth(), &scribble), meant, "what it covers of other colours means nothing");
        scribble[7] = Some(0);
        assert_eq!(meant_area(&truth(), &scribble)[6..], [true, true]);
    }

    #[test]
    fn precision_and_recall_are_parts_of_scored_pixels() {
        let meant = [true, true, true, true, false, false, false, false];
        let score = |colored: [u8; 8]| {
            let classes = colored.map(|colored| (colored == 1).then_some(0));
            let SingleScore { precision, recall } = SingleScore::new(&truth(), 0, &classes, &meant);
            (precision, recall)
        };
        assert_eq!(score([1, 1, 1, 1, 0, 0, 0, 0]), (1.0, 1.0));
        assert_eq!(score([1, 1, 1, 0, 0, 0, 0, 0]), (1.0, 2.0 / 3.0));
        assert_eq!(score([0, 1, 1, 1, 1, 1, 0, 0]), (0.5, 2.0 / 3.0));
        assert_eq!(score([0, 0, 0, 0, 0, 0, 1, 1]), (1.0, 0.0), "the right colour of another area");
        assert_eq!(score([0; 8]), (0.0, 0.0));
    }
}

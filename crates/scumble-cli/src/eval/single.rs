//! Each scribble alone, without spreading: does it stay in the area that it was drawn in, and does it fill it?
//!
//! The area that a scribble means is what it touches of its true colour, and all of that colour that hangs together
//! with it by the edges of pixels. Unscored pixels count for that: truth pictures have colours under the lines
//! too, so that an area stays one where lines cross it.

use super::score::{self, Class};
use super::subject::Subject;
use super::truth::{Mark, Truth, palette_index};
use super::{Manner, Method};
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
    pub(crate) fn add(&mut self, subject: &mut Subject, gap_closing: f64) -> anyhow::Result<()> {
        let manner = Manner { gap_closing, spread: false };
        for i in 0..subject.scribbles.len() {
            let alone = [subject.scribbles[i].clone()];
            let color = palette_index(&alone[0])?;
            let picture = subject.paint(self.method, manner, &alone)?;
            let classes = score::classes(&picture, &[color]);
            let meant = meant_area(&subject.truth, &subject.sketch(&alone).seeds);
            self.scores.push(SingleScore::new(&subject.truth, color, &classes, &meant));
        }
        Ok(())
    }

    /// Prints the means, and how many scribbles ran out or stopped short badly.
    pub(crate) fn print(&self) {
        let count = self.scores.len();
        let mean =
            |of: fn(&SingleScore) -> f64| self.scores.iter().map(of).sum::<f64>() / count.max(1) as f64;
        let below = |of: fn(&SingleScore) -> f64| self.scores.iter().filter(|score| of(score) < 0.5).count();
        let (precision, recall): (fn(&SingleScore) -> f64, fn(&SingleScore) -> f64) =
            (|score| score.precision, |score| score.recall);
        println!(
            "{:<12} alone: {count} scribbles: precision {:.4} recall {:.4}; below one half {} and {}",
            self.method.name,
            mean(precision),
            mean(recall),
            below(precision),
            below(recall)
        );
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

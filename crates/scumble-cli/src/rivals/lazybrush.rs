//! LazyBrush: D. Sýkora, J. Dingliana, S. Collins, *LazyBrush: Flexible Painting Tool for Hand-drawn Cartoons*, Computer
//! Graphics Forum 28 (2009), 599–608.
//!
//! A labelling of all pixels of least energy: two neighbours of different labels cost their brightness, so that
//! borders follow the lines, and a scribble's pixel costs less with its own label than with another. Scribbles are
//! soft: a border may run through them. More than two labels by the paper's greedy sequence of binary cuts: each
//! label against all that are left, and what it wins is taken out. All scribbles of one colour are one label. What the
//! paper does to find lines in scanned pencil is left out: these lines are clean.

use super::grid_cut::GridCut;
use super::sketch::{Sketch, SketchPixel};

/// What a soft scribble's pixel costs with another label, in parts of the paper's K; the paper's 1 - λ.
const SOFT: f64 = 0.05;

/// Labels every pixel; `None` everywhere if there is no scribble.
pub(crate) fn lazybrush(sketch: &Sketch) -> Vec<SketchPixel> {
    let mut used: Vec<u8> = sketch.seeds.iter().copied().flatten().collect();
    used.sort_unstable();
    used.dedup();
    let Some(last) = used.pop() else { return sketch.seeds.clone() };
    let mut labels = vec![None; sketch.seeds.len()];
    for label in used {
        let cut = cut(sketch, &labels, label);
        for (found, is_won) in labels.iter_mut().zip(cut) {
            if is_won && found.is_none() {
                *found = Some(label);
            }
        }
    }
    labels.into_iter().map(|label| label.or(Some(last))).collect()
}

/// The pixels that a label wins against all others, of those that have none.
fn cut(sketch: &Sketch, labels: &[SketchPixel], label: u8) -> Vec<bool> {
    // K of the paper: the circumference, so that a border through the paper's white never pays.
    let k = 2 * (sketch.width_px + sketch.height_px) as i32;
    let soft = (SOFT * f64::from(k)) as i32;
    let mut grid = GridCut::new(sketch.width_px, sketch.height_px);
    for pixel in (0..labels.len()).filter(|&pixel| labels[pixel].is_none()) {
        match sketch.seeds[pixel] {
            Some(seed) if seed == label => grid.pull(pixel, soft),
            Some(_) => grid.pull(pixel, -soft),
            None => {}
        }
        for neighbor in sketch.neighbors(pixel).filter(|&n| n > pixel && labels[n].is_none()) {
            let darkness = sketch.darkness[pixel].max(sketch.darkness[neighbor]);
            grid.join(pixel, neighbor, 1 + k * i32::from(255 - darkness) / 255);
        }
    }
    grid.cut()
}

//! Flood fill without gap closing: what a paint program's bucket does on the drawn lines.
//!
//! All scribbles flow at once, pixel by pixel, so that where two meet in one area each keeps what is nearer to it.

use std::collections::VecDeque;

use super::nearest;
use super::sketch::{Sketch, SketchPixel};

/// From this darkness on a pixel is a line.
const LINE: u8 = 128;

/// Fills from the scribbles up to the lines. With spreading, pixels that nothing reached take the nearest label.
pub(crate) fn flood(sketch: &Sketch, spread: bool) -> Vec<SketchPixel> {
    let mut labels = sketch.seeds.clone();
    let mut front: VecDeque<usize> = (0..labels.len()).filter(|&pixel| labels[pixel].is_some()).collect();
    while let Some(pixel) = front.pop_front() {
        if sketch.darkness[pixel] >= LINE {
            continue;
        }
        for neighbor in sketch.neighbors(pixel) {
            if labels[neighbor].is_none() && sketch.darkness[neighbor] < LINE {
                labels[neighbor] = labels[pixel];
                front.push_back(neighbor);
            }
        }
    }
    if spread { nearest::spread(&labels, sketch.width_px) } else { labels }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    /// A row of paper (0), grey (100) and line (255), with a scribble on the first pixel.
    fn row(darkness: &[u8]) -> Sketch {
        let mut sketch = Sketch::new(darkness.len(), 1, darkness.to_vec());
        sketch.seeds[0] = Some(5);
        sketch
    }

    #[test]
    fn colour_flows_up_to_the_first_line() {
        let labels = flood(&row(&[0, 0, 100, 255, 0]), false);
        assert_eq!(labels, [Some(5), Some(5), Some(5), None, None]);
    }

    #[test]
    fn spreading_goes_on_across_lines() {
        assert_eq!(flood(&row(&[0, 255, 0, 255]), true), [Some(5); 4]);
    }

    #[test]
    fn a_scribble_on_a_line_colours_itself_alone() {
        assert_eq!(flood(&row(&[255, 0, 0]), false), [Some(5), None, None]);
    }
}

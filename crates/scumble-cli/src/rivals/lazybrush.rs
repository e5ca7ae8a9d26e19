//! LazyBrush: D. Sýkora, J. Dingliana, S. Collins, *LazyBrush: Flexible Painting Tool for Hand-drawn Cartoons*, Computer
//! Graphics Forum 28 (2009), 599–608.
//!
//! A labelling of all pixels of least energy: two neighbours of different labels cost their brightness, here squared,
//! which does a little better, so that borders follow the lines; and a scribble's pixel costs something with another
//! label than its own. Scribbles are soft or hard. More than two labels by the paper's greedy sequence of binary cuts: each
//! label against all that are left, and what it wins is taken out. All scribbles of one colour are one label. What the
//! paper does to find lines in scanned pencil is left out: these lines are clean.

use super::grid_cut::GridCut;
use super::sketch::{Sketch, SketchPixel};

/// What a scribble's pixel costs with another label, in parts of the paper's K.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weight(f64);

/// The paper's 1 - λ: borders run freely through scribbles, also through all of a thin one.
pub(crate) const SOFT: Weight = Weight(0.05);

/// As much as the brightest border: scribbles hold.
pub(crate) const HARD: Weight = Weight(1.0);

/// Labels every pixel; `None` everywhere if there is no scribble.
pub(crate) fn lazybrush(sketch: &Sketch, weight: Weight) -> Vec<SketchPixel> {
    let mut used: Vec<u8> = sketch.seeds.iter().copied().flatten().collect();
    used.sort_unstable();
    used.dedup();
    let Some(last) = used.pop() else { return sketch.seeds.clone() };
    let mut labels = vec![None; sketch.seeds.len()];
    for label in used {
        let cut = cut(sketch, &labels, label, weight);
        for (found, is_won) in labels.iter_mut().zip(cut) {
            if is_won && found.is_none() {
                *found = Some(label);
            }
        }
    }
    labels.into_iter().map(|label| label.or(Some(last))).collect()
}

/// The pixels that a label wins against all others, of those that have none.
fn cut(sketch: &Sketch, labels: &[SketchPixel], label: u8, weight: Weight) -> Vec<bool> {
    // K of the paper: the circumference, so that a border through the paper's white never pays.
    let k = 2 * (sketch.width_px + sketch.height_px) as i32;
    let weight = (weight.0 * f64::from(k)) as i32;
    let mut grid = GridCut::new(sketch.width_px, sketch.height_px);
    for pixel in (0..labels.len()).filter(|&pixel| labels[pixel].is_none()) {
        match sketch.seeds[pixel] {
            Some(seed) if seed == label => grid.pull(pixel, weight),
            Some(_) => grid.pull(pixel, -weight),
            None => {}
        }
        for neighbor in sketch.neighbors(pixel).filter(|&n| n > pixel && labels[n].is_none()) {
            let darkness = sketch.darkness[pixel].max(sketch.darkness[neighbor]);
            grid.join(pixel, neighbor, 1 + k * i32::from(255 - darkness).pow(2) / (255 * 255));
        }
    }
    grid.cut()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two rooms of 7 × 9 pixels beside each other, with a door of so many pixels, and a scribble in each.
    fn rooms(door: usize) -> Sketch {
        let mut darkness = vec![0; 15 * 9];
        for row in 0..9 - door {
            darkness[15 * row + 7] = 255;
        }
        let mut sketch = Sketch::new(15, 9, darkness);
        for row in 2..7 {
            sketch.seeds[15 * row + 2] = Some(4);
            sketch.seeds[15 * row + 12] = Some(1);
        }
        sketch
    }

    #[test]
    fn a_border_follows_the_line_and_closes_its_gap() {
        for door in 0..4 {
            let labels = lazybrush(&rooms(door), HARD);
            for row in 0..9 {
                assert_eq!(labels[15 * row..][..7], [Some(4); 7], "door of {door}, row {row}");
                assert_eq!(labels[15 * row + 8..][..7], [Some(1); 7], "door of {door}, row {row}");
            }
        }
    }

    #[test]
    fn a_soft_scribble_gives_way_where_the_border_would_be_long() {
        let labels = lazybrush(&rooms(4), SOFT);
        assert!(labels.iter().all(|label| *label == labels[0] && label.is_some()));
    }

    #[test]
    fn without_scribbles_there_is_no_colour() {
        assert_eq!(lazybrush(&Sketch::new(2, 1, vec![0; 2]), HARD), [None; 2]);
    }
}

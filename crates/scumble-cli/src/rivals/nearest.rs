//! Each pixel takes the label of the nearest labelled one, whatever lines lie between.
//!
//! Exact Euclidean distances, row by row and then column by column, by lower envelopes of parabolas: P. F. Felzenszwalb,
//! D. P. Huttenlocher, *Distance Transforms of Sampled Functions*, Theory of Computing 8 (2012), 415–428. The index of
//! the nearest pixel is carried along.

use super::sketch::{Sketch, SketchPixel};

/// The label of the scribble nearest to each pixel; `None` everywhere if there is no scribble.
pub(crate) fn nearest(sketch: &Sketch) -> Vec<SketchPixel> {
    spread(&sketch.seeds, sketch.width_px)
}

/// Gives each pixel the label of the nearest labelled pixel.
pub(super) fn spread(labels: &[SketchPixel], width_px: usize) -> Vec<SketchPixel> {
    let sites = labels.iter().map(|label| label.map(|label| Site { distance2: 0.0, label }));
    let mut sites: Vec<_> = sites.collect();
    for row in sites.chunks_exact_mut(width_px) {
        let nearest = envelope(row);
        row.copy_from_slice(&nearest);
    }
    for column in 0..width_px {
        let down: Vec<_> = sites.iter().skip(column).step_by(width_px).copied().collect();
        for (site, nearest) in sites.iter_mut().skip(column).step_by(width_px).zip(envelope(&down)) {
            *site = nearest;
        }
    }
    sites.into_iter().map(|site| site.map(|site| site.label)).collect()
}

/// The nearest labelled pixel, as far as known.
#[derive(Clone, Copy, Debug)]
struct Site {
    /// In px².
    distance2: f64,
    label: u8,
}

/// A parabola over a line of pixels, and where it begins to be the lowest.
struct Parabola {
    apex: usize,
    site: Site,
    from: f64,
}

/// For each pixel of a line the site of least distance by way of any pixel of the line.
fn envelope(line: &[Option<Site>]) -> Vec<Option<Site>> {
    let mut lowest: Vec<Parabola> = Vec::new();
    for (apex, site) in line.iter().enumerate().filter_map(|(apex, site)| Some((apex, (*site)?))) {
        let mut from = f64::NEG_INFINITY;
        while let Some(last) = lowest.last() {
            from = crossing(last, apex, &site);
            if from > last.from {
                break;
            }
            lowest.pop();
            from = f64::NEG_INFINITY;
        }
        lowest.push(Parabola { apex, site, from });
    }
    let mut k = 0;
    let at = |x: usize| {
        while lowest.get(k + 1).is_some_and(|next| next.from <= x as f64) {
            k += 1;
        }
        let Parabola { apex, site, .. } = lowest.get(k)?;
        let away = x as f64 - *apex as f64;
        Some(Site { distance2: site.distance2 + away * away, label: site.label })
    };
    (0..line.len()).map(at).collect()
}

/// Where a parabola with a later apex falls below one.
fn crossing(first: &Parabola, apex: usize, site: &Site) -> f64 {
    let (p, q) = (first.apex as f64, apex as f64);
    0.5 * (p + q + (site.distance2 - first.site.distance2) / (q - p))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_takes_a_label_at_the_least_distance() {
        let (width, height) = (19_usize, 13_usize);
        let mut labels = vec![None; width * height];
        for (label, pixel) in [3, 47, 48, 101, 140, 171, 230].into_iter().enumerate() {
            labels[pixel] = Some(label as u8);
        }
        let distance2 = |a: usize, b: usize| {
            (a % width).abs_diff(b % width).pow(2) + (a / width).abs_diff(b / width).pow(2)
        };
        let sites = || (0..labels.len()).filter(|&site| labels[site].is_some());
        for (pixel, found) in spread(&labels, width).into_iter().enumerate() {
            let least = sites().map(|site| distance2(pixel, site)).min();
            let to_found = sites().filter(|&site| labels[site] == found).map(|site| distance2(pixel, site));
            assert_eq!(to_found.min(), least, "pixel {pixel}");
        }
    }

    #[test]
    fn without_labels_there_are_none() {
        assert_eq!(spread(&[None; 6], 3), [None; 6]);
    }
}

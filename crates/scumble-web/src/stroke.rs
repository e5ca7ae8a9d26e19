//! The way of a pen: a smooth one through its samples, and the same in few points.

use kurbo::{CubicBez, ParamCurve, Point, Vec2};

/// Where a pen was, in du, and how hard it pressed there, within `0..=1`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Where.
    pub place: Point,
    /// How hard.
    pub pressure: f64,
}

/// Hands tremble, and a mouse counts whole pixels: samples this near to each other take the middle, in CSS pixels.
const TREMBLE_CSS: f64 = 2.0;

/// What nobody sees, in CSS pixels.
const TOLERANCE_CSS: f64 = 0.25;

/// The cosine of 60°: where a way turns by more it was meant to have a corner.
const CORNER: f64 = 0.5;

/// One piece of curve is no more parts than these, however large.
const MOST_PARTS: f64 = 32.0;

/// So much of a way is made simpler at a time, in points.
const STRETCH: usize = 256;

/// The way through samples: a curve that is smooth but for corners, in parts that look like one.
///
/// It passes through all samples that lie more than two CSS pixels apart, and begins and ends where they do.
pub fn smooth(samples: &[Sample], du_from_css: f64) -> Vec<Sample> {
    let calm = calm(&apart(samples), TREMBLE_CSS * du_from_css);
    let mut way: Vec<_> = calm.first().copied().into_iter().collect();
    for end in 1..calm.len() {
        let curve = piece(&calm, end);
        let [from, to] = [calm[end - 1].pressure, calm[end].pressure];
        let parts = parts(&curve, TOLERANCE_CSS * du_from_css);
        way.extend((1..=parts).map(|part| {
            let t = f64::from(part) / f64::from(parts);
            Sample { place: curve.eval(t), pressure: from + t * (to - from) }
        }));
    }
    way
}

/// The same way in fewer points: what is left out lies within a quarter of a CSS pixel of what is left (D. Douglas and
/// T. Peucker, *Algorithms for the reduction of the number of points*, 1973), where a whole pressure counts as a distance.
pub fn simplified(way: &[Sample], pressure_du: f64, du_from_css: f64) -> Vec<Sample> {
    let spots: Vec<_> = way.iter().map(|s| [s.place.x, s.place.y, pressure_du * s.pressure]).collect();
    let mut kept = vec![0];
    for from in (0..way.len()).step_by(STRETCH) {
        let to = (from + STRETCH).min(way.len() - 1);
        keep(&spots, [from, to], TOLERANCE_CSS * du_from_css, &mut kept);
    }
    kept.into_iter().filter_map(|i| way.get(i).copied()).collect()
}

/// Without those that lie where the one before does: of these the hardest pressure counts.
fn apart(samples: &[Sample]) -> Vec<Sample> {
    let mut apart: Vec<Sample> = Vec::with_capacity(samples.len());
    for sample in samples {
        match apart.last_mut() {
            Some(last) if last.place == sample.place => last.pressure = last.pressure.max(sample.pressure),
            _ => apart.push(*sample),
        }
    }
    apart
}

/// Those that lie between near ones, half way to the middle of these.
fn calm(samples: &[Sample], tremble_du: f64) -> Vec<Sample> {
    let mut calm = samples.to_vec();
    for (i, around) in samples.windows(3).enumerate() {
        let [before, at, after] = [around[0].place, around[1].place, around[2].place];
        if before.distance(at).max(at.distance(after)) <= tremble_du {
            calm[i + 1].place = at.lerp(before.midpoint(after), 0.5);
        }
    }
    calm
}

/// The curve that ends at a sample.
fn piece(samples: &[Sample], end: usize) -> CubicBez {
    let [from, to] = [samples[end - 1].place, samples[end].place];
    let third = (to - from) / 3.0;
    let handle = |i| direction(samples, i).map_or(third, |along| along * third.hypot());
    CubicBez::new(from, from + handle(end - 1), to - handle(end), to)
}

/// That of a circle through a sample and its neighbours, of length one; none at corners and ends.
fn direction(samples: &[Sample], i: usize) -> Option<Vec2> {
    let at = samples[i].place;
    let back = at - samples.get(i.checked_sub(1)?)?.place;
    let on = samples.get(i + 1)?.place - at;
    let along = (back / back.hypot2() + on / on.hypot2()).normalize();
    let is_corner = back.dot(on) < CORNER * back.hypot() * on.hypot();
    (!is_corner && along.is_finite()).then_some(along)
}

/// So many that chords stay within a tolerance of a curve.
fn parts(curve: &CubicBez, tolerance_du: f64) -> u32 {
    let bend = |a: Point, b: Point, c: Point| (a.to_vec2() - 2.0 * b.to_vec2() + c.to_vec2()).hypot();
    let most = bend(curve.p0, curve.p1, curve.p2).max(bend(curve.p1, curve.p2, curve.p3));
    (0.75 * most / tolerance_du).sqrt().ceil().clamp(1.0, MOST_PARTS) as u32
}

/// Adds the numbers of the spots that a way between two of them cannot do without, and of the second.
fn keep(spots: &[[f64; 3]], [from, to]: [usize; 2], tolerance_du: f64, kept: &mut Vec<usize>) {
    let off = |i| distance(spots[i], spots[from], spots[to]);
    match (from + 1..to).map(|i| (off(i), i)).max_by(|a, b| a.0.total_cmp(&b.0)) {
        Some((off_du, farthest)) if off_du > tolerance_du => {
            keep(spots, [from, farthest], tolerance_du, kept);
            keep(spots, [farthest, to], tolerance_du, kept);
        }
        _ if to > from => kept.push(to),
        _ => {}
    }
}

/// From a spot to the line between two.
fn distance(spot: [f64; 3], from: [f64; 3], to: [f64; 3]) -> f64 {
    let way = |to: [f64; 3]| [0, 1, 2].map(|i| to[i] - from[i]);
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let [line, here] = [way(to), way(spot)];
    let part = (dot(line, here) / dot(line, line)).clamp(0.0, 1.0);
    let off = [0, 1, 2].map(|i| here[i] - if part.is_finite() { part * line[i] } else { 0.0 });
    dot(off, off).sqrt()
}

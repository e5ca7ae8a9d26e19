//! How a scribble sees one side, gathered view by view: how often, how far and from where.

use kurbo::Point;

use super::view::Glimpse;
use crate::angle::angle_part;
use crate::stroke::SAMPLE_SPACING_DU;
use crate::triangulation::SideId;

/// Rays that a side sends out to look for scribbles: one every 5°, as in section 4.2.
const RAYS: u32 = 36;

/// Samples nearer to a side than this count as being at this distance, in du.
const NEAREST_DU: f64 = 0.5;

/// How a scribble sees one side. Sums are over its samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sighting {
    pub(super) side: SideId,
    /// Number of samples that see it: κ.
    pub(super) kappa: u32,
    pub(super) distance_du: f64,
    /// Sum of 1 / distance.
    nearness: f64,
    /// Angle that it covers, as a part of the full turn.
    pub(super) angle: f64,
    /// The rays of the side that hit the scribble, one bit each.
    rays: u64,
    /// Whether a sample sees the next side of the outline right after it.
    pub(super) joined: bool,
}

impl Sighting {
    pub(super) fn none(side: SideId) -> Self {
        Self { side, kappa: 0, distance_du: 0.0, nearness: 0.0, angle: 0.0, rays: 0, joined: false }
    }

    /// Adds what is seen from a place that stands for some samples.
    pub(super) fn add(&mut self, eye: Point, glimpse: &Glimpse, samples: u32) {
        let [a, b] = glimpse.line;
        let weight = f64::from(samples);
        let distance_du = glimpse.distance_du.max(NEAREST_DU);
        let nearness = distance_du.recip();
        self.kappa += samples;
        self.distance_du += weight * distance_du;
        self.nearness += weight * nearness;
        self.angle += weight * angle_of((a - eye).cross(b - eye), distance_du, (b - a).hypot2());
        self.rays |= rays_that_hit(angle_part(b - a, glimpse.to_eye), weight * nearness);
        self.joined |= glimpse.joined;
    }

    /// What speaks for the scribble at this side (equation 5).
    pub(super) fn evidence(&self) -> Evidence {
        Evidence {
            hits: f64::from(self.rays.count_ones()),
            distance_du: f64::from(self.kappa) / self.nearness,
        }
    }
}

/// What the rays from a side find of one scribble: n(Q) and d(Q) of equation 5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Evidence {
    /// Number of rays that hit the scribble.
    pub(super) hits: f64,
    /// Mean length of these rays.
    pub(super) distance_du: f64,
}

/// Roughly the angle that a piece covers, as a part of the full turn: exact where it is small.
fn angle_of(double_area: f64, distance_du: f64, length2_du2: f64) -> f64 {
    double_area.abs() / (distance_du * distance_du + 0.25 * length2_du2) / std::f64::consts::TAU
}

/// The rays that hit some samples in a row: they hide what they are wide, and lie at `direction` (a part of the half
/// turn). `nearness` is their number / their distance.
fn rays_that_hit(direction: f64, nearness: f64) -> u64 {
    let half_width = 0.5 * SAMPLE_SPACING_DU * std::f64::consts::FRAC_1_PI * nearness;
    let ray = |part: f64| ((part * f64::from(RAYS)) as u32).min(RAYS - 1);
    let [first, last] = [ray((direction - half_width).max(0.0)), ray(direction + half_width)];
    (2 << last) - (1 << first)
}

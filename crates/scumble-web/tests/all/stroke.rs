//! The way of a pen is smooth where its hand was, has corners where they were meant, and is kept in few points.

use kurbo::{Line, ParamCurveNearest, Point, Vec2};
use proptest::prelude::*;
use scumble_web::stroke::{Sample, simplified, smooth};

/// What nobody sees, in CSS pixels.
const UNSEEN_CSS: f64 = 0.25;

fn sample(x: f64, y: f64) -> Sample {
    Sample { place: Point::new(x, y), pressure: 1.0 }
}

fn on_circle(radius: f64, samples: u32, turns: f64) -> Vec<Sample> {
    let angle = |i: u32| turns * std::f64::consts::TAU * f64::from(i) / f64::from(samples - 1);
    (0..samples).map(|i| Vec2::from_angle(angle(i)) * radius).map(|at| sample(at.x, at.y)).collect()
}

fn kept(samples: &[Sample]) -> Vec<Sample> {
    simplified(&smooth(samples, 1.0), 0.0, 1.0)
}

/// From a place to a way.
fn off(place: Point, way: &[Sample]) -> f64 {
    let lines = way.windows(2).map(|ends| Line::new(ends[0].place, ends[1].place));
    lines.map(|line| line.nearest(place, 1e-9).distance_sq.sqrt()).fold(f64::INFINITY, f64::min)
}

#[test]
fn a_fast_turn_is_round_between_its_samples() {
    for way in [smooth(&on_circle(100.0, 12, 0.75), 1.0), kept(&on_circle(100.0, 12, 0.75))] {
        // But for the first piece and the last, which nobody knows the bend of before or after them.
        let within = way.iter().filter(|s| (0.6..4.0).contains(&s.place.to_vec2().angle().rem_euclid(6.3)));
        let radii: Vec<_> = within.map(|s| s.place.to_vec2().hypot()).collect();
        assert!(radii.len() > 12, "{}", radii.len());
        assert!(radii.iter().all(|radius| (radius - 100.0).abs() < 0.5), "{radii:?}");
    }
}

#[test]
fn a_corner_that_was_meant_stays_one() {
    let corner = [sample(0.0, 0.0), sample(50.0, 0.0), sample(0.0, 30.0)];
    assert_eq!(smooth(&corner, 1.0), corner);
    assert_eq!(kept(&corner), corner);
}

#[test]
fn a_slow_line_of_whole_pixels_is_straight_in_few_points() {
    let steps: Vec<_> = (0..90).map(|i| sample(f64::from(i), f64::from(i / 3))).collect();
    let ends = [steps[0].place, steps[89].place];
    let kept = kept(&steps);
    assert!(kept.len() <= 8, "{} points", kept.len());
    let line = Line::new(ends[0], ends[1]);
    assert!(kept.iter().all(|s| line.nearest(s.place, 1e-9).distance_sq.sqrt() < 0.75));
    assert_eq!([kept[0].place, kept[kept.len() - 1].place], ends);
}

#[test]
fn every_sample_of_a_pen_at_240_hz_shapes_the_way() {
    // Writing: 3 loops a second, 60 px high.
    let at = |i: u32| {
        let t = f64::from(i) / 240.0;
        sample(120.0 * t + 20.0 * (19.0 * t).sin(), 30.0 * (19.0 * t).cos())
    };
    let samples: Vec<_> = (0..480).map(at).collect();
    let kept = kept(&samples);
    let worst = samples.iter().map(|s| off(s.place, &kept)).fold(0.0, f64::max);
    assert!(worst <= 2.0 * UNSEEN_CSS, "{worst} px");
    assert!(kept.len() < samples.len() / 2, "{} points", kept.len());
}

#[test]
fn samples_on_one_spot_are_a_dab_as_hard_as_the_hardest() {
    let press = |pressure| Sample { pressure, ..sample(3.0, 4.0) };
    let dab = [press(0.2), press(0.9), press(0.4)];
    assert_eq!(kept(&dab), [press(0.9)]);
    assert_eq!(kept(&[]), []);
}

#[test]
fn a_way_keeps_what_pressure_makes_of_it() {
    let way: Vec<_> = (0..=100)
        .map(|i| Sample { pressure: (f64::from(i) * 0.06).sin().abs(), ..sample(f64::from(i), 0.0) })
        .collect();
    assert_eq!(simplified(&way, 0.0, 1.0).len(), 2);
    let kept = simplified(&way, 32.0, 1.0);
    assert!((5..60).contains(&kept.len()), "{}", kept.len());
    let at = |x: f64| {
        let i = kept.windows(2).position(|ends| ends[1].place.x >= x).expect("on the way");
        let [from, to] = [kept[i], kept[i + 1]];
        from.pressure + (x - from.place.x) / (to.place.x - from.place.x) * (to.pressure - from.pressure)
    };
    assert!(way.iter().all(|s| 32.0 * (at(s.place.x) - s.pressure).abs() < 0.5));
}

proptest! {
    #[test]
    fn any_way_is_finite_ends_where_the_pen_did_and_is_kept_as_it_is_seen(
        places in prop::collection::vec((-4000.0..4000.0_f64, -4000.0..4000.0_f64, 0.0..=1.0_f64), 1..700),
        zoom in 0.05..64.0_f64,
    ) {
        let samples: Vec<_> = places.iter().map(|&(x, y, pressure)| Sample { pressure, ..sample(x, y) }).collect();
        let way = smooth(&samples, 1.0 / zoom);
        let kept = simplified(&way, 32.0, 1.0 / zoom);
        prop_assert!(way.iter().all(|s| s.place.is_finite() && (0.0..=1.0).contains(&s.pressure)));
        for way in [&way, &kept] {
            prop_assert_eq!(way[0].place, samples[0].place);
            prop_assert_eq!(way[way.len() - 1].place, samples[samples.len() - 1].place);
        }
        for s in way.iter().step_by(97) {
            prop_assert!(off(s.place, &kept) <= UNSEEN_CSS / zoom + 1e-9 || kept.len() == 1);
        }
    }
}

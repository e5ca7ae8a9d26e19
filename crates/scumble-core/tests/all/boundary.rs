//! A boundary that is kept is the one that is made anew, whatever changed in between.

use kurbo::{BezPath, Circle, Rect, Shape};
use proptest::collection::vec;
use proptest::prelude::*;
use scumble_core::pace::now;
use scumble_core::{
    Blend, ColorPoint, Curve, Drawing, KnownBoundary, Labels, Paint, PlanarMap, Sampling, Scribble,
    ScribbleKind, Srgb8, Step, boundary,
};

const SCRIBBLES: usize = 3;

/// Closed and open curves with gaps between them; two that run along the same pieces, and one that turns back on itself.
fn map() -> PlanarMap {
    let line = |path: &str| BezPath::from_svg(path).expect("a path");
    let circle = Circle::new((300.0, 300.0), 90.0).to_path(0.01);
    let paths = [
        circle,
        line("M 100 600 H 700 V 700 H 300"),
        line("M 200 600 H 500 V 500"),
        line("M 600 100 H 800 H 650"),
        line("M 420 300 H 700"),
        line("M 300 230 V 380"),
    ];
    let curves = paths.into_iter().map(|path| Curve { path, line: None }).collect();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 768.0)) };
    let sampling = Sampling { spacing_du: 20.0, tip_du: 4.0, chord_du: 1.0 };
    PlanarMap::build(&drawing, &sampling).expect("a map").with_gaps_closed(1.0)
}

/// What may change between two calls.
#[derive(Clone, Debug)]
enum Change {
    /// From one of the sides on, so many get the label of a scribble, or none.
    Label(usize, usize, Option<u32>),
    Gap(usize),
    Color(usize, Paint),
    ByHand(Vec<ColorPoint>),
    Blend(Blend),
}

fn paints() -> impl Strategy<Value = Paint> {
    prop_oneof![Just(Paint::Clear), Just(Srgb8([200, 0, 0]).into()), Just(Srgb8([0, 0, 200]).into())]
}

fn changes() -> impl Strategy<Value = Change> {
    let point = (0..7_u32, any::<bool>(), -20.0..700.0_f64, paints())
        .prop_map(|(curve, is_left, at_du, color)| ColorPoint { curve, is_left, at_du, color });
    prop_oneof![
        4 => (0..400_usize, 1..80_usize, proptest::option::of(0..SCRIBBLES as u32))
            .prop_map(|(first, count, label)| Change::Label(first, count, label)),
        2 => (0..40_usize).prop_map(Change::Gap),
        2 => (0..SCRIBBLES, paints()).prop_map(|(scribble, paint)| Change::Color(scribble, paint)),
        1 => vec(point, 0..4).prop_map(Change::ByHand),
        1 => prop_oneof![Just(Blend::Srgb), Just(Blend::Oklab)].prop_map(Change::Blend),
    ]
}

proptest! {
    #[test]
    fn what_is_kept_is_what_is_made_anew(changes in vec(changes(), 1..30)) {
        let map = map();
        let mut labels = Labels::none(&map);
        let blank = Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 8.0, points: Vec::new() };
        let mut scribbles = vec![blank; SCRIBBLES];
        let (mut by_hand, mut blend) = (Vec::new(), Blend::Oklab);
        let mut known = KnownBoundary::default();
        for change in changes {
            match change {
                Change::Label(first, count, label) => {
                    let end = labels.sides.len().min(first + count);
                    labels.sides[first.min(end)..end].fill(label);
                }
                Change::Gap(gap) => {
                    let count = labels.closed_gaps.len();
                    labels.closed_gaps[gap % count] ^= true;
                }
                Change::Color(scribble, paint) => scribbles[scribble].color = paint,
                Change::ByHand(points) => by_hand = points,
                Change::Blend(other) => blend = other,
            }
            now(known.following(&map, &labels, &scribbles, &by_hand, blend));
            prop_assert!(*known.get() == boundary(&map, &labels, &scribbles, &by_hand, blend));
        }
    }
}

/// Also where a curve runs back along itself, so that its other side lies there as well.
#[test]
fn a_side_with_colours_set_by_hand_has_no_others() {
    let map = map();
    let [red, blue] = [[200, 0, 0], [0, 0, 200]].map(|rgb| Paint::from(Srgb8(rgb)));
    let scribble = Scribble { color: blue, kind: ScribbleKind::Fill, width_du: 8.0, points: Vec::new() };
    let labels = Labels { sides: vec![Some(0); map.side_count()], ..Labels::none(&map) };
    let point = ColorPoint { curve: 3, is_left: false, at_du: 10.0, color: red };
    let boundary = boundary(&map, &labels, &[scribble], &[point], Blend::Srgb);
    let color = |paint| Some([Blend::Srgb.from_paint(paint); 3]);
    let steps = map.steps(3);
    assert!(steps.iter().all(|step| boundary.sides[step.left.index()] == color(red)));
    let is_once = |step: &&Step| !steps.iter().any(|other| other.left == step.left.opposite());
    let once: Vec<_> = steps.iter().filter(is_once).collect();
    assert!(!once.is_empty() && once.len() < steps.len());
    assert!(once.iter().all(|step| boundary.sides[step.left.opposite().index()] == color(blue)));
}

/// The drawing is one on which the above can fail.
#[test]
fn the_map_has_sides_gaps_and_pieces_that_curves_share() {
    let map = map();
    assert!(map.gaps().len() > 2 && map.side_count() > 200, "{} {}", map.gaps().len(), map.side_count());
    let steps: Vec<_> = (0..map.curve_count()).flat_map(|curve| map.steps(curve)).collect();
    let pieces = map.pieces().iter().filter(|piece| piece.curve.is_some()).count();
    assert!(steps.len() > pieces + 10, "{} {pieces}", steps.len());
}

//! What the `Global` engine promises, on random drawings with random scribbles: the order of scribbles and all that
//! was there before leave no trace, a stroke that grows within a room only takes, and nothing is too odd.

use std::collections::BTreeSet;
use std::ops::Range;

use kurbo::{Affine, Arc, BezPath, Circle, ParamCurveNearest, Point, Rect, Shape, Stroke, Vec2};
use proptest::collection::vec;
use proptest::prelude::*;
use scumble_core::{
    Curve, Drawing, Engine, Global, HalfEdge, Labels, Line, Paint, PlanarMap, Rgba8, Sampling, Scribble,
    ScribbleKind, SideId, Srgb8,
};

#[path = "../../../scumble-cli/src/made.rs"]
mod made;

const CASES: u32 = 40;

/// What scribbles colour on a map: the labels of a fresh engine.
fn fresh(map: &PlanarMap, spread: bool, scribbles: &[Scribble]) -> Labels {
    Global::new(spread).label(map, scribbles)
}

fn build(curves: Vec<(BezPath, f64)>, gap_closing: f64) -> PlanarMap {
    sampled(curves, gap_closing, &Sampling { spacing_du: 8.0, tip_du: 1.0, chord_du: 0.2 })
}

fn sampled(curves: Vec<(BezPath, f64)>, gap_closing: f64, sampling: &Sampling) -> PlanarMap {
    let line = |width_du| Line { stroke: Stroke::new(width_du), color: Rgba8([0, 0, 0, 255]) };
    let curves =
        curves.into_iter().map(|(path, width_du)| Curve { path, line: Some(line(width_du)) }).collect();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 768.0)) };
    PlanarMap::build(&drawing, sampling).expect("a map").with_gaps_closed(gap_closing)
}

fn polyline(points: &[Point]) -> BezPath {
    let mut path = BezPath::new();
    path.move_to(points[0]);
    points[1..].iter().for_each(|&p| path.line_to(p));
    path
}

fn place() -> impl Strategy<Value = Point> {
    (0.0..1024.0_f64, 0.0..768.0_f64).prop_map(Point::from)
}

/// Lines, angles, circles and circles with an opening, of all widths.
fn curves() -> impl Strategy<Value = Vec<(BezPath, f64)>> {
    let angle = vec(place(), 2..5).prop_map(|points| polyline(&points));
    let circle = (place(), 30.0..300.0_f64).prop_map(|(center, r)| Circle::new(center, r).to_path(0.01));
    let open =
        (place(), 60.0..300.0_f64, 0.0..6.3_f64, 0.1..0.7_f64).prop_map(|(center, r, start, opening)| {
            Arc::new(center, (r, r), start, std::f64::consts::TAU - opening, 0.0).to_path(0.01)
        });
    let curve = (prop_oneof![angle, circle, open], prop_oneof![Just(0.0), 0.5..14.0_f64]);
    vec(curve, 1..7)
}

/// The same, some of them drawn twice, as in a sketch.
fn sketches() -> impl Strategy<Value = Vec<(BezPath, f64)>> {
    let again = vec((-6.0..6.0_f64, -6.0..6.0_f64).prop_map(Affine::translate), 0..4);
    (curves(), again).prop_map(|(mut curves, again)| {
        let twins =
            curves.iter().zip(again).map(|((path, width_du), shift)| (shift * path.clone(), *width_du));
        let twins: Vec<_> = twins.collect();
        curves.extend(twins);
        curves
    })
}

fn gap_closings() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), Just(0.3), Just(0.5), Just(1.0)]
}

/// With gaps closed or not.
fn maps() -> impl Strategy<Value = PlanarMap> {
    (sketches(), gap_closings()).prop_map(|(curves, closing)| build(curves, closing))
}

/// The same where each line is drawn once.
fn neat_maps() -> impl Strategy<Value = PlanarMap> {
    (curves(), gap_closings()).prop_map(|(curves, closing)| build(curves, closing))
}

/// A pen's way in small steps, sometimes a dab, sometimes leaving the page.
fn ways() -> impl Strategy<Value = Vec<Point>> {
    (place(), vec((-60.0..60.0_f64, -60.0..60.0_f64), 0..12)).prop_map(|(start, steps)| {
        let mut points = vec![start];
        points.extend(steps.into_iter().scan(start, |at, step| {
            *at += Vec2::from(step);
            Some(*at)
        }));
        points
    })
}

fn paints() -> impl Strategy<Value = Paint> {
    prop_oneof![Just(Paint::Clear), any::<[u8; 3]>().prop_map(|rgb| Srgb8(rgb).into())]
}

fn scribble() -> impl Strategy<Value = Scribble> {
    (paints(), ways()).prop_map(|(color, points)| Scribble {
        color,
        kind: ScribbleKind::Fill,
        width_du: 8.0,
        points,
    })
}

/// Labels with the scribbles themselves in place of their numbers.
fn contents(labels: &Labels, scribbles: &[Scribble]) -> (Vec<Option<Scribble>>, Vec<bool>) {
    let content = |label: u32| scribbles[label as usize].clone();
    (labels.sides.iter().map(|label| label.map(content)).collect(), labels.closed_gaps.clone())
}

/// How many points a stroke has before it comes onto a line, or crosses a gap or the border of the page.
fn points_within_a_room(map: &PlanarMap, points: &[Point]) -> usize {
    let nodes = map.triangulation().points();
    let gaps: Vec<_> = map.gaps().iter().map(|gap| gap.nodes.map(|node| nodes[node as usize])).collect();
    let crosses = |step: [Point; 2]| gaps.iter().any(|&gap| meet(step, gap)) || is_on_lines(map, step);
    let steps = points.iter().zip(&points[1.min(points.len())..]);
    let is_clear = points.first().is_some_and(|&first| !is_on_lines(map, [first, first]));
    if is_clear { 1 + steps.take_while(|&(&from, &to)| !crosses([from, to])).count() } else { 0 }
}

/// Whether a step of the pen may be on a line, or on the border of the page.
fn is_on_lines(map: &PlanarMap, step: [Point; 2]) -> bool {
    const NEAR_DU: f64 = 4.1;
    let nodes = map.triangulation().points();
    let far =
        |p: Point, [a, b]: [Point; 2]| kurbo::Line::new(a, b).nearest(p, 0.0).distance_sq > NEAR_DU * NEAR_DU;
    map.pieces().iter().map(|piece| piece.nodes.map(|node| nodes[node as usize])).any(|line| {
        let ends = step.iter().all(|&p| far(p, line)) && line.iter().all(|&p| far(p, step));
        !ends || step[0] != step[1] && meet(step, line)
    })
}

/// Whether two segments have a point in common.
fn meet(one: [Point; 2], other: [Point; 2]) -> bool {
    let parts = |[a, b]: [Point; 2], [c, d]: [Point; 2]| (b - a).cross(c - a) * (b - a).cross(d - a) <= 0.0;
    parts(one, other) && parts(other, one)
}

/// All sides that bound an area of the page.
fn sides(map: &PlanarMap) -> impl Iterator<Item = SideId> + '_ {
    let mesh = map.triangulation();
    mesh.half_edges().filter_map(|h| mesh.side(h))
}

/// Whether there may be rooms that get a colour that was there already, once more of what is around them has one.
fn has_pockets(map: &PlanarMap) -> bool {
    !map.gaps().is_empty()
}

/// What a person may do to a list of scribbles; numbers count around.
#[derive(Clone, Debug)]
enum Deed {
    Draw(Scribble),
    /// The same way again, in a colour.
    DrawOver(usize, Paint),
    Extend(usize, Vec<Point>),
    Erase(usize),
    Move(usize, usize),
    Recolor(usize, Paint),
    Undo(usize),
    Clear,
}

fn deed() -> impl Strategy<Value = Deed> {
    let i = || any::<usize>();
    prop_oneof![
        5 => scribble().prop_map(Deed::Draw),
        3 => (i(), paints()).prop_map(|(i, color)| Deed::DrawOver(i, color)),
        5 => (i(), ways()).prop_map(|(i, points)| Deed::Extend(i, points)),
        3 => i().prop_map(Deed::Erase),
        2 => (i(), i()).prop_map(|(from, to)| Deed::Move(from, to)),
        2 => (i(), paints()).prop_map(|(i, color)| Deed::Recolor(i, color)),
        3 => i().prop_map(Deed::Undo),
        1 => Just(Deed::Clear),
    ]
}

/// The scribbles after a deed, given all lists that there were so far.
fn done(deed: Deed, history: &[Vec<Scribble>]) -> Vec<Scribble> {
    let mut now = history.last().expect("a beginning").clone();
    let len = now.len().max(1);
    match deed {
        Deed::Draw(scribble) => now.push(scribble),
        Deed::Undo(i) => now = history[i % history.len()].clone(),
        Deed::Clear => now.clear(),
        _ if now.is_empty() => {}
        Deed::DrawOver(i, color) => now.push(Scribble { color, ..now[i % len].clone() }),
        Deed::Extend(i, points) => now[i % len].points.extend(points),
        Deed::Erase(i) => drop(now.remove(i % len)),
        Deed::Recolor(i, color) => now[i % len].color = color,
        Deed::Move(from, to) => {
            let moved = now.remove(from % len);
            now.insert(to % len, moved);
        }
    }
    now
}

/// From one end of such a ring a passage leads straight across, and that is no gap: what ends there goes on at the other end.
#[test]
fn a_ring_that_is_not_quite_closed_is_filled_as_a_whole() {
    let path = "M64 -38 C115 47 -12 124 -64 38 S13 -124 57 -34";
    let path = BezPath::from_svg(path).expect("a path");
    for turn in 0..12 {
        let way = Affine::translate((500.0, 400.0)) * Affine::rotate(0.5 * f64::from(turn));
        let map = sampled(vec![(way * path.clone(), 3.0)], 0.5, &Sampling::default());
        let points = [(-20.0, -40.0), (20.0, -32.0)].map(|p| way * Point::from(p)).to_vec();
        let color = Srgb8([255, 0, 0]).into();
        let labels =
            fresh(&map, false, &[Scribble { color, kind: ScribbleKind::Fill, width_du: 8.0, points }]);
        let pieces = map.pieces().iter().filter(|piece| piece.curve.is_some()).count();
        let count = labels.sides.iter().flatten().count();
        assert!((pieces..=pieces + 2).contains(&count), "{count} sides of {pieces} pieces at turn {turn}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(CASES))]

    #[test]
    fn the_order_of_scribbles_does_not_matter(
        map in maps(),
        (scribbles, orders) in vec(scribble(), 1..7)
            .prop_flat_map(|s| (Just(s.clone()), vec(Just(s).prop_shuffle(), 3))),
        spread: bool,
    ) {
        let expected = contents(&fresh(&map, spread, &scribbles), &scribbles);
        for order in &orders {
            prop_assert_eq!(&contents(&fresh(&map, spread, order), order), &expected);
        }
    }

    #[test]
    fn scribbles_that_are_alike_or_begin_alike_have_no_order_either(
        map in maps(), way in ways(), longer in ways(), colors in vec(paints(), 3), spread: bool,
    ) {
        let draw = |color, points: &[Point]| Scribble { color, kind: ScribbleKind::Fill, width_du: 8.0, points: points.to_vec() };
        let all = [way.as_slice(), &[way.clone(), longer].concat(), &way[..1]];
        let scribbles: Vec<_> =
            colors.iter().flat_map(|&color| all.map(|points| draw(color, points))).collect();
        let reversed: Vec<_> = scribbles.iter().rev().cloned().collect();
        prop_assert_eq!(
            contents(&fresh(&map, spread, &scribbles), &scribbles),
            contents(&fresh(&map, spread, &reversed), &reversed)
        );
    }

    #[test]
    fn what_was_there_before_leaves_no_trace(map in maps(), deeds in vec(deed(), 1..24), spread: bool) {
        let mut engine = Global::new(spread);
        let mut history = vec![Vec::new()];
        for deed in deeds {
            let now = done(deed.clone(), &history);
            prop_assert_eq!(engine.label(&map, &now), fresh(&map, spread, &now), "after {:?}", deed);
            history.push(now);
        }
    }

    #[test]
    fn an_erased_scribble_might_never_have_been_drawn(
        map in maps(), scribbles in vec(scribble(), 1..6), extra in scribble(), at: usize, spread: bool,
    ) {
        let mut engine = Global::new(spread);
        let before = engine.label(&map, &scribbles);
        for length in 1..=extra.points.len() {
            let mut with = scribbles.clone();
            let grown = Scribble { points: extra.points[..length].to_vec(), ..extra.clone() };
            with.insert(at % (scribbles.len() + 1), grown);
            engine.label(&map, &with);
        }
        prop_assert_eq!(engine.label(&map, &scribbles), before);
    }

    #[test]
    fn a_stroke_that_grows_within_a_room_takes_sides_and_never_gives_one_away(
        map in maps(), scribbles in vec(scribble(), 0..5), mut stroke in scribble(), at: usize,
    ) {
        stroke.points.truncate(points_within_a_room(&map, &stroke.points));
        let at = at % (scribbles.len() + 1);
        let mut engine = Global::new(false);
        let mut before: Option<Labels> = None;
        for length in 1..=stroke.points.len() {
            let mut now = scribbles.clone();
            now.insert(at, Scribble { points: stroke.points[..length].to_vec(), ..stroke.clone() });
            let labels = engine.label(&map, &now);
            if let Some(before) = before {
                for (then, now) in before.sides.iter().zip(&labels.sides) {
                    let is_filled = then.is_none() && has_pockets(&map);
                    prop_assert!(is_filled || then == now || *now == Some(at as u32), "{:?} became {:?}", then, now);
                }
            }
            before = Some(labels);
        }
    }

    #[test]
    fn a_new_scribble_takes_sides_and_others_keep_theirs(
        map in maps(), scribbles in vec(scribble(), 1..6), new in scribble(),
    ) {
        let before = fresh(&map, false, &scribbles);
        let added = [scribbles.as_slice(), &[new]].concat();
        let after = fresh(&map, false, &added);
        for (before, after) in before.sides.iter().zip(&after.sides) {
            let is_filled = before.is_none() && has_pockets(&map);
            prop_assert!(is_filled || before == after || *after == Some(scribbles.len() as u32));
        }
    }

    #[test]
    fn recoloured_scribbles_are_labelled_as_if_drawn_so(
        map in maps(), scribbles in vec(scribble(), 1..4), shades in vec(vec(0..3_u8, 3), 1..4), spread: bool
    ) {
        let mut kept = Global::new(spread);
        kept.label(&map, &scribbles);
        for shades in shades {
            let recolor = |(s, shade): (&Scribble, u8)| Scribble { color: Srgb8([shade; 3]).into(), ..s.clone() };
            let recolored: Vec<_> = scribbles.iter().zip(shades).map(recolor).collect();
            prop_assert_eq!(kept.label(&map, &recolored), fresh(&map, spread, &recolored));
        }
    }

    #[test]
    fn with_spread_one_scribble_on_the_page_colours_every_side(map in maps(), scribbles in vec(scribble(), 1..4)) {
        let labels = fresh(&map, true, &scribbles);
        for side in sides(&map) {
            prop_assert!(labels.sides[side.index()].is_some(), "{:?}", side);
        }
    }

    #[test]
    fn what_is_coloured_has_a_colour_with_spreading(map in maps(), scribbles in vec(scribble(), 1..5)) {
        let [narrow, wide] = [false, true].map(|spread| fresh(&map, spread, &scribbles));
        prop_assert!(narrow.sides.iter().zip(&wide.sides).all(|(narrow, wide)| narrow.is_none() || wide.is_some()));
    }

    /// By the same scribble but in pockets, where another may come by a gap that is closed without spreading; and in slivers,
    /// which spreading takes for regions like others: lines that are drawn once leave hardly any.
    #[test]
    fn what_is_coloured_is_so_with_spreading(map in neat_maps(), scribbles in vec(scribble(), 1..5)) {
        let [narrow, wide] = [false, true].map(|spread| fresh(&map, spread, &scribbles));
        let has_pockets = has_pockets(&map);
        for (narrow, wide) in narrow.sides.iter().zip(&wide.sides) {
            prop_assert!(narrow.is_none() || wide.is_some() && (has_pockets || narrow == wide));
        }
    }

    #[test]
    fn a_clear_scribble_holds_what_a_coloured_one_would(
        map in maps(), scribbles in vec(scribble(), 1..6), color in paints(), i: usize, spread: bool,
    ) {
        let mut changed = scribbles.clone();
        changed[i % scribbles.len()].color = color;
        prop_assert_eq!(fresh(&map, spread, &scribbles), fresh(&map, spread, &changed));
    }

    #[test]
    fn a_scribble_colours_what_it_was_drawn_on(map in maps(), points in ways(), spread: bool) {
        let one = Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 8.0, points: points[..1].to_vec() };
        let mesh = map.triangulation();
        let place = one.points[0];
        if let Some(t) = mesh.locate(place, 0).filter(|_| !is_on_lines(&map, [place, place])) {
            let labels = fresh(&map, spread, std::slice::from_ref(&one));
            for side in mesh.half_edges().filter(|h| h.triangle() == t).filter_map(|h| mesh.side(h)) {
                prop_assert_eq!(labels.sides[side.index()], Some(0));
            }
        }
    }

    #[test]
    fn a_scribble_alone_colours_something(map in maps(), scribble in scribble(), spread: bool) {
        let is_on_page = |p: &Point| map.triangulation().locate(*p, 0).is_some();
        if scribble.points.iter().any(is_on_page) {
            let labels = fresh(&map, spread, std::slice::from_ref(&scribble));
            prop_assert!(labels.sides.iter().any(Option::is_some));
        }
    }

    #[test]
    fn without_scribbles_no_side_has_a_label(map in maps(), scribbles in vec(scribble(), 1..5), spread: bool) {
        let mut engine = Global::new(spread);
        prop_assert_eq!(engine.label(&map, &[]), Labels::none(&map));
        engine.label(&map, &scribbles);
        prop_assert_eq!(engine.label(&map, &[]), Labels::none(&map));
    }

    #[test]
    fn off_the_page_is_nowhere(map in maps(), points in ways(), spread: bool) {
        let points = points.into_iter().map(|p| p + Vec2::new(2000.0, 0.0)).collect();
        let far = Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 8.0, points };
        prop_assert_eq!(fresh(&map, spread, &[far]), Labels::none(&map));
    }
}

/// No berry has a third of what lies on the page around them, and all of them have more than that.
#[test]
fn a_stroke_along_a_row_of_berries_colours_them() {
    let berries: Vec<_> =
        (0..8).map(|i| (Circle::new((400.0 + 11.0 * f64::from(i), 400.0), 4.0).to_path(0.01), 1.0)).collect();
    let map = build(berries, 0.0);
    let points = vec![Point::new(381.0, 400.0), Point::new(496.0, 400.0)];
    let stroke = Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 8.0, points };
    let labels = fresh(&map, false, std::slice::from_ref(&stroke));
    let mesh = map.triangulation();
    let side_within = |h| mesh.side(h).filter(|_| mesh.segment(h).iter().all(|p| (p.y - 400.0).abs() < 5.0));
    assert!(mesh.half_edges().filter_map(side_within).any(|side| labels.sides[side.index()] == Some(0)));
}

/// Scribbles that come one by one to a drawing with many places behind gaps: some end in places that others came
/// through on their way.
#[test]
fn what_lies_behind_gaps_does_not_depend_on_what_came_through_them_before() {
    for (cells, gap_closing) in [(3, 0.9), (5, 0.5), (5, 1.0)] {
        let map = PlanarMap::build(&made::drawing(cells), &Sampling::default()).expect("a map");
        let map = map.with_gaps_closed(gap_closing);
        let scribbles = made::scribbles();
        let mut engines = [false, true].map(Global::new);
        for count in 1..=scribbles.len() {
            let now = &scribbles[..count];
            for (spread, engine) in [false, true].into_iter().zip(&mut engines) {
                let labels = engine.label(&map, now);
                assert!(labels == fresh(&map, spread, now), "{cells} cells, {count} scribbles, {spread}");
            }
        }
    }
}

/// A room between two others, with a door to each, of these widths. The ends of the lines beside the second are short lines
/// of their own, which are cut into longer pieces.
fn room_with_doors(doors_du: [f64; 2]) -> PlanarMap {
    let line = |x: f64, ys: [f64; 2]| (polyline(&ys.map(|y| Point::new(x, y))), 4.0);
    let [left, right] = doors_du.map(|door_du| [400.0 - 0.5 * door_du, 400.0 + 0.5 * door_du]);
    let curves = vec![
        (Rect::new(100.0, 250.0, 900.0, 550.0).to_path(0.1), 4.0),
        line(400.0, [250.0, left[0]]),
        line(400.0, [left[1], 550.0]),
        line(600.0, [250.0, right[0] - 6.0]),
        line(600.0, [right[0] - 6.0, right[0]]),
        line(600.0, [right[1], right[1] + 6.0]),
        line(600.0, [right[1] + 6.0, 550.0]),
    ];
    sampled(curves, 0.5, &Sampling::default())
}

#[test]
fn colours_come_through_the_wider_door_however_lines_are_cut() {
    let scribbles = [250.0, 750.0].map(|x| Scribble {
        color: Paint::Clear,
        kind: ScribbleKind::Fill,
        width_du: 8.0,
        points: vec![Point::new(x, 390.0), Point::new(x, 410.0)],
    });
    for (doors_du, wider) in [([30.0, 31.0], 1), ([31.0, 30.0], 0)] {
        let map = room_with_doors(doors_du);
        let labels = fresh(&map, true, &scribbles);
        let is_between = |node: u32| {
            let p = map.triangulation().points()[node as usize];
            p.y == 550.0 && (410.0..590.0).contains(&p.x)
        };
        let within = sides(&map).filter(|side| map.ends(*side).into_iter().all(is_between));
        let found: Vec<_> = within.map(|side| labels.sides[side.index()]).collect();
        assert!(found.len() > 40 && found.contains(&Some(wider)), "{doors_du:?}");
        assert!(!found.contains(&Some(1 - wider)), "{doors_du:?}");
    }
}

/// A sixth of a framed page is coloured with the rest of it through a hole that one sees, not through one that is hardly wider
/// than its lines.
#[test]
fn a_window_that_is_not_quite_closed_is_no_corner_of_what_is_around_it() {
    let stroke = Scribble {
        color: Paint::Clear,
        kind: ScribbleKind::Fill,
        width_du: 8.0,
        points: vec![Point::new(100.0, 100.0), Point::new(150.0, 150.0)],
    };
    for (gap_du, gap_closing, is_corner) in
        [(0.2, 0.5, false), (6.0, 0.5, false), (6.0, 1.0, false), (11.0, 0.5, false), (40.0, 0.5, true)]
    {
        let window =
            [(300.0 + gap_du, 300.0), (800.0, 300.0), (800.0, 500.0), (300.0, 500.0), (300.0, 300.0)];
        let frame = Rect::new(25.0, 25.0, 998.0, 742.0).to_path(0.1);
        let map = build(vec![(frame, 6.0), (polyline(&window.map(Point::from)), 6.0)], gap_closing);
        let labels = fresh(&map, false, std::slice::from_ref(&stroke));
        let mesh = map.triangulation();
        let is_within = |h: &HalfEdge| {
            let [a, b] = mesh.segment(*h);
            a.y == 500.0 && b.y == 500.0 && mesh.segment(h.next())[1].y < 500.0
        };
        let within: Vec<_> = mesh.half_edges().filter(is_within).filter_map(|h| mesh.side(h)).collect();
        assert!(within.len() > 20);
        let colored = within.iter().filter(|side| labels.sides[side.index()].is_some()).count();
        assert_eq!(colored, if is_corner { within.len() } else { 0 }, "{gap_du}, {gap_closing}");
    }
}

/// The rooms of a row that a stroke colours, by the edges of the rooms.
fn colored_rooms(edges_du: &[f64], points: &[(f64, f64)]) -> Vec<usize> {
    let rooms = edges_du.windows(2).map(|x| (Rect::new(x[0], 300.0, x[1], 500.0).to_path(0.1), 4.0));
    let map = build(rooms.collect(), 0.5);
    let points = points.iter().copied().map(Point::from).collect();
    let stroke = Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 8.0, points };
    let labels = fresh(&map, false, &[stroke]);
    let mesh = map.triangulation();
    let is_colored = |&room: &usize| {
        let span = edges_du[room] + 1.0..edges_du[room + 1] - 1.0;
        let is_in = |h: &HalfEdge| {
            let [a, b] = mesh.segment(*h);
            a.y == 500.0 && a.x > b.x && span.contains(&a.x) && span.contains(&b.x)
        };
        let mut sides = mesh.half_edges().filter(is_in).filter_map(|h| mesh.side(h));
        sides.any(|side| labels.sides[side.index()].is_some())
    };
    (0..edges_du.len() - 1).filter(is_colored).collect()
}

#[test]
fn what_a_stroke_goes_through_it_means_and_where_it_slips_it_does_not() {
    let edges_du = [100.0, 200.0, 600.0, 700.0];
    assert_eq!(colored_rooms(&edges_du, &[(120.0, 400.0), (680.0, 400.0)]), [0, 1, 2]);
    assert_eq!(colored_rooms(&edges_du, &[(175.0, 400.0), (625.0, 400.0)]), [1]);
    let hatching: Vec<_> =
        (0..40).map(|i| (if i % 2 == 0 { 250.0 } else { 630.0 }, 310.0 + 4.5 * f64::from(i))).collect();
    assert_eq!(colored_rooms(&edges_du, &hatching), [1], "however often it slips");
    // From a small room far into a large one.
    let edges_du = [100.0, 160.0, 920.0];
    assert_eq!(colored_rooms(&edges_du, &[(110.0, 400.0), (300.0, 400.0)]), [0, 1]);
    assert_eq!(colored_rooms(&edges_du, &[(110.0, 400.0), (190.0, 400.0)]), [0]);
    // From the large one into the small one, nearly through it.
    assert_eq!(colored_rooms(&edges_du, &[(800.0, 400.0), (110.0, 400.0)]), [0, 1]);
    assert_eq!(colored_rooms(&edges_du, &[(800.0, 400.0), (130.0, 400.0)]), [1]);
}

#[test]
fn a_stroke_across_stripes_means_them_and_one_that_slips_over_a_rim_does_not() {
    let stripes_du = [100.0, 300.0, 315.0, 330.0, 345.0, 360.0, 560.0];
    assert_eq!(colored_rooms(&stripes_du, &[(180.0, 400.0), (480.0, 400.0)]), [0, 1, 2, 3, 4, 5]);
    let turns = [(180.0, 390.0), (352.0, 400.0), (180.0, 410.0)];
    assert_eq!(colored_rooms(&stripes_du, &turns), [0, 1, 2, 3], "where it turns around it may have slipped");
    let rim_du = [100.0, 500.0, 515.0, 700.0];
    assert_eq!(colored_rooms(&rim_du, &[(300.0, 400.0), (540.0, 400.0)]), [0]);
    let rims_du = [100.0, 115.0, 500.0, 515.0, 700.0];
    let hatching: Vec<_> =
        (0..40).map(|i| (if i % 2 == 0 { 90.0 } else { 540.0 }, 310.0 + 4.5 * f64::from(i))).collect();
    assert_eq!(colored_rooms(&rims_du, &hatching), [1], "over rims on both sides");
}

/// A map of lines of one width, in du, and what a stroke colours there; lines and stroke in units of so many du.
fn stroked(paths: &[&str], width_du: f64, stroke: [(f64, f64); 2], unit_du: f64) -> (PlanarMap, Labels) {
    let du_from_units = Affine::scale(unit_du);
    let line = |path: &&str| (du_from_units * BezPath::from_svg(path).expect("a path"), width_du);
    let map = sampled(paths.iter().map(line).collect(), 0.5, &Sampling::default());
    let points = stroke.map(|p| du_from_units * Point::from(p)).into();
    let stroke = Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 16.0, points };
    let labels = fresh(&map, false, &[stroke]);
    (map, labels)
}

/// A tree beside a house, and some of a child, on 800 × 600 units: the crown ends just above the trunk.
const TREE_BESIDE_HOUSE: [&str; 10] = [
    "M179.7 300.8C179.3 313.8 177.2 352.4 177.4 379.1C177.6 405.8 179.3 437.5 180.9 461.0C182.5 484.5 185.8 510.3 186.8 520.1",
    "M184.9 523.2C197.3 522.1 234.0 516.5 259.6 516.8C285.2 517.2 315.2 525.2 338.5 525.1C361.8 525.1 389.1 518.0 399.2 516.5",
    "M401.9 512.2C401.0 500.5 396.6 465.5 396.9 441.9C397.2 418.2 402.7 392.7 403.4 370.6C404.1 348.5 401.6 319.5 401.3 309.3",
    "M297.4 177.1C306.1 187.4 328.3 217.1 349.5 239.0C370.7 261.0 412.2 297.1 424.7 308.7",
    "M567.9 286.8C570.9 288.0 580.8 290.0 585.6 293.5C590.4 297.0 593.9 302.4 596.7 307.8C599.6 313.2 602.0 320.1 602.6 326.1C603.2 332.1 602.3 338.0 600.3 343.8C598.4 349.7 594.8 356.8 590.7 361.3C586.7 365.7 581.8 368.5 576.0 370.5C570.2 372.4 561.7 372.9 555.8 373.0C549.9 373.1 545.7 373.9 540.8 371.1C536.0 368.2 530.2 361.3 526.8 356.1C523.3 350.9 521.4 346.3 520.1 340.1C518.9 333.8 518.4 325.0 519.4 318.6C520.4 312.2 522.8 306.6 526.2 301.8C529.7 297.0 534.8 292.1 540.3 289.6C545.8 287.1 556.0 287.2 559.1 286.8",
    "M583.6 398.1C590.2 403.2 616.5 423.6 623.0 428.7",
    "M578.5 503.1C579.2 512.4 582.2 549.7 582.9 559.0",
    "M119.2 540.9C118.3 527.7 112.7 484.9 113.7 461.4C114.6 438.0 123.1 410.4 124.9 400.2",
    "M119.5 406.0C115.1 406.3 101.7 409.2 93.0 407.7C84.2 406.2 74.2 402.4 67.0 396.9C59.8 391.4 53.8 383.1 49.8 374.6C45.7 366.0 43.5 355.0 42.8 345.6C42.0 336.1 42.1 326.6 45.3 317.9C48.5 309.1 55.6 300.2 61.9 293.1C68.2 286.0 75.4 278.4 83.1 275.3C90.7 272.1 98.9 273.0 107.6 274.2C116.4 275.3 128.1 277.9 135.8 282.4C143.6 287.0 148.9 293.6 154.1 301.4C159.3 309.3 165.3 320.3 167.0 329.5C168.7 338.8 166.9 347.5 164.3 356.8C161.7 366.1 157.0 377.7 151.2 385.3C145.4 392.9 133.3 399.5 129.7 402.4",
    "M7.1 558.6C39.4 557.4 131.6 551.8 200.4 551.4C269.2 551.0 347.1 556.0 420.1 556.1C493.0 556.2 575.6 552.0 638.1 552.0C700.7 551.9 769.2 555.3 795.5 555.9",
];

/// The ends of the crown and of the trunk leave a crevice between them, from which a hair of light leads into either place.
#[test]
fn a_crown_does_not_run_out_through_a_crevice_beside_its_trunk() {
    let stroke = [(90.0, 320.0), (110.0, 350.0)];
    let (map, labels) = stroked(&TREE_BESIDE_HOUSE, 6.4, stroke, 1024.0 / 800.0);
    let is_left_colored = |xs, ys| is_left_colored(&map, &labels, xs, ys);
    assert!(is_left_colored(205.0..215.0, 380.0..480.0), "the crown");
    assert!(!is_left_colored(220.0..240.0, 520.0..650.0), "beside the house");
}

/// Whether any line down a part of the page has a colour on its left.
fn is_left_colored(map: &PlanarMap, labels: &Labels, xs: Range<f64>, ys: Range<f64>) -> bool {
    let mesh = map.triangulation();
    let is_there = |h: &HalfEdge| {
        let [a, b] = mesh.segment(*h);
        a.y < b.y && [a, b].iter().all(|p| xs.contains(&p.x) && ys.contains(&p.y))
    };
    let mut sides = mesh.half_edges().filter(is_there).filter_map(|h| mesh.side(h));
    sides.any(|side| labels.sides[side.index()].is_some())
}

/// The front of a house on 300 units, with a door and two windows: no line meets another.
const HOUSE: [&str; 9] = [
    "M30 104V238",
    "M34 240H266",
    "M270 238V104",
    "M30 100H270",
    "M20 100L150 20L280 100",
    "M130 238V160H180V236",
    "M60 130V170H110V134",
    "M106 130H60",
    "M200 130H250V170H200Z",
];

#[test]
fn a_house_with_corners_open_by_a_hair_is_filled_from_beside_its_door() {
    let (map, labels) = stroked(&HOUSE, 10.0, [(45.0, 210.0), (100.0, 215.0)], 2.9);
    let is_left_colored = |xs, ys| is_left_colored(&map, &labels, xs, ys);
    assert!(is_left_colored(775.0..790.0, 330.0..680.0), "the right wall");
    assert!(!is_left_colored(718.0..732.0, 390.0..480.0), "the window");
}

/// Whether a stroke in the left part of a strip colours the right one, by how large the left one is: between them is a slight
/// gap, and another one in the outline.
fn goes_on_through_a_slight_gap(left: f64) -> bool {
    let wall_x = 100.0 + 800.0 * left;
    let outline =
        [(900.0, 321.0), (900.0, 300.0), (100.0, 300.0), (100.0, 360.0), (900.0, 360.0), (900.0, 339.0)];
    let lines = [&outline[..], &[(wall_x, 300.0), (wall_x, 336.0)]];
    let lines = lines.map(|points| {
        let points: Vec<_> = points.iter().copied().map(Point::from).collect();
        (polyline(&points), 10.0)
    });
    let map = sampled(lines.into(), 0.5, &Sampling::default());
    let points = [(150.0, 330.0), (wall_x - 50.0, 330.0)].map(Point::from).into();
    let stroke = Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 8.0, points };
    let labels = fresh(&map, false, &[stroke]);
    is_left_colored(&map, &labels, 890.0..910.0, 299.0..361.0)
}

#[test]
fn what_lies_behind_a_slight_gap_is_filled_where_there_is_more_before_it() {
    assert!(!goes_on_through_a_slight_gap(0.52));
    assert!(goes_on_through_a_slight_gap(0.6));
}

/// What the sides between the two outer of some rectangles, drawn one into the other, have of strokes at these places.
fn between(rects: &[Rect], stroke_xs: &[f64]) -> BTreeSet<Option<u32>> {
    let lines = rects.iter().map(|rect| (rect.to_path(0.1), 8.0)).collect();
    within(lines, stroke_xs, |p| rects[0].contains(p) && !rects[1].contains(p))
}

/// What the sides that face some place within lines have of strokes at these places.
fn within(
    lines: Vec<(BezPath, f64)>,
    stroke_xs: &[f64],
    is_within: impl Fn(Point) -> bool,
) -> BTreeSet<Option<u32>> {
    let map = sampled(lines, 0.5, &Sampling::default());
    let stroke = |&x: &f64| Scribble {
        color: Paint::Clear,
        kind: ScribbleKind::Fill,
        width_du: 8.0,
        points: vec![Point::new(x, 350.0), Point::new(x, 450.0)],
    };
    let labels = fresh(&map, false, &stroke_xs.iter().map(stroke).collect::<Vec<_>>());
    let mesh = map.triangulation();
    let faces = |h: &HalfEdge| {
        let [a, b, c] = mesh.corners(h.triangle()).map(Point::to_vec2);
        is_within(((a + b + c) / 3.0).to_point())
    };
    let sides = mesh.half_edges().filter(faces).filter_map(|h| mesh.side(h));
    sides.map(|side| labels.sides[side.index()]).collect()
}

#[test]
fn what_lies_around_a_hatching_does_not_run_through_it() {
    let circle = Circle::new((500.0, 400.0), 200.0);
    let square = circle.bounding_box();
    let half_chord_du = |x: f64| (circle.radius.powi(2) - x.powi(2)).sqrt();
    for spacing_du in [4.0, 5.0] {
        let xs = (1..).map(|i| spacing_du * f64::from(i) - circle.radius).take_while(|&x| x < circle.radius);
        // What is around them may have those at the edge.
        let through_square = xs.clone().map(|x| (x, circle.radius));
        assert_eq!(hatched(square.to_path(0.1), through_square, square.inset(-6.0)), BTreeSet::from([None]));
        let through_circle = xs.map(|x| (x, half_chord_du(x)));
        let inner = Circle::new(circle.center, 190.0);
        assert_eq!(hatched(circle.to_path(0.1), through_circle, inner), BTreeSet::from([None]));
    }
    let [lid, open] = [(250.0, 300.0), (300.0, 500.0)].map(|(top, end)| Rect::new(489.0, top, 511.0, end));
    let boxes = lid.to_path(0.1).into_iter().chain(open.to_path(0.1)).collect();
    let loose = [-5.5, 0.0, 5.5].map(|x| (x, 96.0));
    assert_eq!(hatched(boxes, loose.into_iter(), open), BTreeSet::from([None]), "lines that part nothing");
}

/// What there is within some place of a stroke beside a shape at (500, 400). Each line of its hatching has a place from there, and
/// half of its length.
fn hatched(
    shape: BezPath,
    hatching: impl Iterator<Item = (f64, f64)>,
    place: impl Shape,
) -> BTreeSet<Option<u32>> {
    let end = |x, y| Point::new(500.0 + x, 400.0 + y);
    let hatching = hatching.map(|(x, half_du)| polyline(&[end(x, -half_du), end(x, half_du)]));
    let lines = hatching.chain([shape]).map(|path| (path, 4.0)).collect();
    within(lines, &[900.0], |p| place.contains(p))
}

#[test]
fn a_sliver_between_lines_of_a_sketch_has_the_colour_that_it_borders_on_for_longest() {
    let outer = Rect::new(290.0, 190.0, 710.0, 610.0);
    let sketch = [outer, outer.inset(-9.0)];
    assert_eq!(between(&sketch, &[500.0, 900.0]), BTreeSet::from([Some(1)]));
    assert_eq!(between(&sketch, &[900.0]), BTreeSet::from([Some(0)]));
    assert_eq!(between(&sketch, &[500.0]), BTreeSet::from([None]), "what is around it may come later");
    assert_eq!(between(&sketch, &[900.0, 294.5]), BTreeSet::from([Some(1)]), "it has a scribble of its own");
    assert_eq!(between(&[outer, outer.inset(-11.0)], &[500.0, 900.0]), BTreeSet::from([None]), "a frame");
    assert_eq!(between(&[outer, Rect::ZERO], &[900.0]), BTreeSet::from([None]), "it is large");
    let thing = [Rect::new(300.0, 200.0, 308.0, 600.0), Rect::ZERO];
    assert_eq!(between(&thing, &[900.0]), BTreeSet::from([None]), "a thin thing");
}

/// The scribbles around the inside of a shape, one after the other.
fn around(shape: &BezPath, center: Point, strokes: &[[Point; 2]]) -> Vec<usize> {
    let map = sampled(vec![(shape.clone(), 8.0)], 0.5, &Sampling::default());
    let stroke = |points: &[Point; 2]| Scribble {
        color: Paint::Clear,
        kind: ScribbleKind::Fill,
        width_du: 8.0,
        points: points.to_vec(),
    };
    let labels = fresh(&map, false, &strokes.iter().map(stroke).collect::<Vec<_>>());
    let mesh = map.triangulation();
    let mut sides: Vec<_> = mesh
        .half_edges()
        .filter_map(|h| {
            let [a, b, c] = mesh.corners(h.triangle()).map(Point::to_vec2);
            let is_within = shape.contains(((a + b + c) / 3.0).to_point());
            let [from, to] = mesh.segment(h);
            let label = labels.sides[mesh.side(h).filter(|_| is_within)?.index()].expect("a colour");
            Some(((from.midpoint(to) - center).atan2(), label as usize))
        })
        .collect();
    sides.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut labels: Vec<_> = sides.into_iter().map(|(_, label)| label).collect();
    labels.dedup();
    if labels.len() > 1 && labels.first() == labels.last() {
        labels.pop();
    }
    labels
}

#[test]
fn strokes_side_by_side_in_a_shape_part_its_outline_without_scattered_pieces() {
    let center = Point::new(512.0, 384.0);
    let level = |half_du: f64, y_du: f64| [-half_du, half_du].map(|x_du| center + Vec2::new(x_du, y_du));
    let circle = Circle::new(center, 300.0).to_path(0.01);
    let bar = Rect::from_center_size(center, (922.0, 410.0)).to_path(0.1);
    // From the left side on, whose middle is where angles begin.
    for (shape, half_du, levels_du, expected) in [
        (&circle, 60.0, vec![10.0, -130.0], vec![0, 1]),
        (&circle, 60.0, vec![10.0, -240.0], vec![0, 1]),
        (&circle, 60.0, vec![0.0, -275.0], vec![0, 1]),
        (&circle, 150.0, vec![0.0, 150.0, -150.0], vec![0, 2, 0, 1]),
        (&bar, 307.0, vec![0.0, 107.0], vec![0, 1]),
    ] {
        let strokes: Vec<_> = levels_du.iter().map(|&y_du| level(half_du, y_du)).collect();
        assert_eq!(around(shape, center, &strokes), expected, "{levels_du:?}");
    }
}

#[test]
fn a_line_that_ends_beside_the_border_of_the_page_reaches_it() {
    // By how much lines fall short: rounding, or less than what their width covers.
    for short_du in [0.0, 0.001, 0.1, 3.0] {
        for shift_du in [0.0, 8.0] {
            let y = 377.0 + shift_du;
            let horizon = polyline(&[Point::new(short_du, y), Point::new(1024.0 - short_du, y)]);
            let map = build(vec![(horizon, 8.0)], 0.5);
            let points = [100.0, 900.0].map(|x| Point::new(x, 500.0)).to_vec();
            let ground = Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 8.0, points };
            let labels = fresh(&map, false, &[ground]);
            let mesh = map.triangulation();
            for h in mesh.half_edges() {
                let [a, b, c] = mesh.corners(h.triangle()).map(|p| p.y);
                let is_below = (a + b + c) / 3.0 > y;
                let expected = is_below.then_some(0);
                if let Some(side) = mesh.side(h) {
                    assert_eq!(labels.sides[side.index()], expected, "{short_du} du short at {y}");
                }
            }
        }
    }
}

#[test]
fn of_two_strokes_in_a_sky_the_one_that_is_nearer_has_the_horizon() {
    let horizon = polyline(&[Point::new(0.0, 650.0), Point::new(1024.0, 650.0)]);
    let map = build(vec![(horizon, 8.0)], 0.5);
    let stroke = |y: f64| Scribble {
        color: Paint::Clear,
        kind: ScribbleKind::Fill,
        width_du: 8.0,
        points: [250.0, 750.0].map(|x| Point::new(x, y)).to_vec(),
    };
    let labels = fresh(&map, false, &[80.0, 330.0, 720.0].map(stroke));
    let mesh = map.triangulation();
    for h in mesh.half_edges() {
        let is_above = mesh.corners(h.triangle()).iter().any(|p| p.y < 650.0);
        if let Some(side) = mesh.side(h).filter(|_| mesh.segment(h).iter().all(|p| p.y == 650.0)) {
            assert_eq!(labels.sides[side.index()], Some(if is_above { 1 } else { 2 }));
        }
    }
}

#[test]
fn what_hangs_from_the_border_of_the_page_parts_no_sky() {
    let horizon = polyline(&[Point::new(0.0, 650.0), Point::new(1024.0, 650.0)]);
    let sun = Circle::new((512.0, 0.0), 85.0).to_path(0.01);
    let cord = polyline(&[Point::new(512.0, 0.0), Point::new(512.0, 150.0)]);
    let lamp = polyline(&[(445.0, 250.0), (512.0, 150.0), (580.0, 250.0), (445.0, 250.0)].map(Point::from));
    let points = [150.0, 250.0].map(|x| Point::new(x, 300.0)).to_vec();
    let sky = Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 8.0, points };
    let far_ends =
        [[0.0, 60.0], [650.0, 590.0]].map(|ys| polyline(&ys.map(|y| Point::new(512.0, y)))).to_vec();
    let hangings = [(vec![sun.clone()], 7.0), (vec![cord, lamp], 7.0), (vec![sun], 40.0), (far_ends, 7.0)];
    for (hanging, width_du) in hangings {
        let curves = hanging.into_iter().chain([horizon.clone()]).map(|path| (path, width_du));
        let map = build(curves.collect(), 0.5);
        let labels = fresh(&map, false, std::slice::from_ref(&sky));
        let mesh = map.triangulation();
        let mut seen = [0; 2];
        let is_of_horizon = |h: &HalfEdge| mesh.segment(*h).iter().all(|p| p.y == 650.0);
        for h in mesh.half_edges().filter(is_of_horizon) {
            let is_above = mesh.corners(h.triangle()).iter().any(|p| p.y < 650.0);
            if let Some(side) = mesh.side(h) {
                assert_eq!(labels.sides[side.index()], is_above.then_some(0));
                seen[usize::from(is_above)] += 1;
            }
        }
        assert!(seen[0] > 0 && seen[0] == seen[1]);
    }
    // A hole in an outline beside it is one still.
    let outline = Arc::new((512.0, 100.0), (90.0, 90.0), 1.4, std::f64::consts::TAU - 0.4, 0.0).to_path(0.01);
    let map = build(vec![(outline, 7.0), (horizon, 7.0)], 0.5);
    let nodes = map.triangulation().points();
    let is_mouth = |node: u32| nodes[node as usize].distance(Point::new(544.6, 183.9)) < 30.0;
    assert!(map.gaps().iter().any(|gap| gap.nodes.into_iter().all(is_mouth)));
}

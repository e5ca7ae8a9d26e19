//! What one scribble claims by itself: the triangles that it was drawn on, each at a cost.

use kurbo::Point;

use super::flood::{Cost, Ways, cost, length};
use super::route::Route;
use crate::clearance::{OPEN_DU, distance_to_lines_du, lines_under};
use crate::planar_map::PlanarMap;
use crate::small_map::SmallMap;
use crate::stroke::Stroke;

/// A scribble holds its place like a passage that is this many times as wide as its distance from the drawn lines. With
/// less, the scribble furthest from all lines takes a room for itself (which is better on drawings whose lights and
/// shadows no line marks); with more, a hand that leaves its region takes another.
const HOLD: f64 = 3.0;

/// The same beside the border of the page, where passages count as wider, too: else the scribble furthest from all lines
/// takes all of a sky.
const HOLD_AT_BORDER: f64 = 2.0 * HOLD;

/// How long that passage is, in du.
const START_DU: f64 = 1.0;

/// What lies around a sample within this many times its distance from the drawn lines, up to [`OPEN_FROM_DU`], is at hand,
/// and [`BESIDE_DU`] more: the nearest line is, so that a careful dab near a line has its say. Where two meet, the one that
/// was drawn farther from the lines has that much of a start: that parts a room better on the quality set. What is *nearest*
/// has as much of a start as its distance from the lines. It comes last, so that hardly any dab is without effect.
const AT_HAND: f64 = 2.8;

/// What is drawn farther from all lines than this, in du, is in the open.
const OPEN_FROM_DU: f64 = 65.0;

/// How much farther what is at hand reaches for each du from there on. With 1 or more, a scribble in the middle of a large
/// shape would come first to all lines around it, and one between it and a line do nothing, or colour some pieces here and
/// there. Close to a line only what is nearest holds against it.
const AT_HAND_IN_THE_OPEN: f64 = 0.65;

/// At hand around any sample, in du: about a triangle of the refined mesh.
const BESIDE_DU: f64 = 12.0;

/// No start is longer, in du.
const LONGEST_START_DU: f64 = OPEN_DU;
const _: () = assert!(AT_HAND * OPEN_FROM_DU + AT_HAND_IN_THE_OPEN * OPEN_DU <= LONGEST_START_DU);

/// A room counts as meant where the scribble has at least this part of the samples that it has in the room where it has
/// most: less is a hand that slipped, or that set the pen down beside the shape. In rooms around the one that was drawn in
/// half of all samples must lie: running out is worse than stopping short. What it goes through, or far into, is meant
/// whatever its part.
const MEANT: f64 = 1.0 / 3.0;

/// A room is meant, too, where the scribble goes this part of its size on from where it came in, so far that no hand slips; the
/// size of a room is that of a square as large.
const THROUGH: f64 = 0.4;

/// The same in any room, however large, and around the one that was drawn in, in du.
const FAR_DU: f64 = 100.0;

/// A room lies around another, as far as one can tell, if it is at the border of the page, or so many times as large.
const AROUND: f64 = 8.0;

/// A pen on the ink of a line and this close to its middle, in du, may as well be on the other side of it.
const ON_LINE_DU: f64 = 4.0;

/// The samples of a scribble so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Claim {
    stroke: Stroke,
    /// Of the refined mesh, where the last sample lies.
    triangle: usize,
    route: Route,
    /// Per room the samples there.
    visits: SmallMap<Visit>,
}

/// Where a sample lies, and what it costs to claim it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seed {
    pub(super) triangle: usize,
    /// In the flood over all the map.
    pub(super) cost: Cost,
    /// In the flood over what is at hand; see [`at_hand_limit`].
    pub(super) at_hand: Cost,
    /// In the flood over what is nearest to it.
    pub(super) nearest: Cost,
}

impl Seed {
    fn new(triangle: usize, distance_du: f64, hold: f64) -> Self {
        let distance_du = distance_du.clamp(0.0, OPEN_DU);
        let claim = |start_du: f64| length(LONGEST_START_DU - start_du);
        Self {
            triangle,
            cost: cost(START_DU, hold * distance_du),
            at_hand: claim(start_du(distance_du)),
            nearest: claim(distance_du),
        }
    }
}

/// The start of what is at hand to a sample so far from the drawn lines, both in du.
fn start_du(distance_du: f64) -> f64 {
    let near_du = distance_du.min(OPEN_FROM_DU);
    AT_HAND * near_du + AT_HAND_IN_THE_OPEN * (distance_du - near_du)
}

/// What a seed's claim and the way from there may come to for a place to be at hand.
pub(super) fn at_hand_limit() -> Cost {
    length(LONGEST_START_DU + BESIDE_DU)
}

/// The samples in one room.
#[derive(Clone, Debug, Default)]
struct Visit {
    area_du2: f64,
    /// How far the scribble went on from where it came in, in du.
    reach_du: f64,
    /// Whether it went right through.
    is_crossed: bool,
    seeds: Vec<Seed>,
    /// How many of them have been let in.
    let_in: usize,
}

impl Claim {
    /// The points that have been followed.
    pub(super) fn points(&self) -> &[Point] {
        self.stroke.points()
    }

    /// Goes on to the end of a scribble that begins with the points followed so far.
    pub(super) fn follow(&mut self, map: &PlanarMap, ways: &Ways, points: &[Point]) {
        let Self { stroke, triangle, route, visits } = self;
        stroke.follow(map, points, |p, base| {
            let distance_du = distance_to_lines_du(map, p, base);
            *triangle = map.refined().locate(p, *triangle).unwrap_or(*triangle);
            let is_on_lines = distance_du <= 0.0;
            let place = if is_on_lines { shown_by_lines(map, ways, p, [base, *triangle]) } else { *triangle };
            let room = ways.room_of[place];
            let reach_du = route.go_on(p, room, |room| visits.entry(room).is_crossed = true);
            let visit = visits.entry(room);
            visit.area_du2 = ways.rooms.area_du2(room);
            visit.reach_du = visit.reach_du.max(reach_du);
            let is_at_border = map.is_at_border(&map.triangulation().nodes(base));
            let hold = if is_at_border { HOLD_AT_BORDER } else { HOLD };
            visit.seeds.push(Seed::new(place, distance_du, hold));
        });
    }

    /// The rooms that are meant.
    pub(super) fn rooms(&self) -> impl Iterator<Item = u32> {
        let meant = self.meant();
        self.visits.iter().filter(move |(_, visit)| meant.contains(visit)).map(|(room, _)| *room)
    }

    /// Whether what has been let in lies in a room that is not meant any more.
    pub(super) fn gives_up(&self) -> bool {
        let meant = self.meant();
        self.visits.values().any(|visit| visit.let_in > 0 && !meant.contains(visit))
    }

    /// Lets in what has not been let in yet of the rooms that are meant.
    pub(super) fn let_in(&mut self, mut reach: impl FnMut(Seed)) {
        let meant = self.meant();
        for visit in self.visits.values_mut().filter(|visit| meant.contains(visit)) {
            visit.seeds[visit.let_in..].iter().for_each(|&seed| reach(seed));
            visit.let_in = visit.seeds.len();
        }
    }

    /// Nothing has been let in.
    pub(super) fn stay_out(&mut self) {
        self.visits.values_mut().for_each(|visit| visit.let_in = 0);
    }

    fn meant(&self) -> Meant {
        let near_du2 = self.near_du2();
        let [all, near] = [f64::INFINITY, near_du2].map(|largest_du2| self.sample_count(largest_du2));
        let largest_du2 = if all >= 2 * near { f64::INFINITY } else { near_du2 };
        let counts = self.visits.values().filter(|visit| visit.area_du2 <= largest_du2);
        let most = counts.map(|visit| visit.seeds.len()).max().unwrap_or(0);
        Meant { least: (MEANT * most as f64).ceil() as usize, largest_du2 }
    }

    /// Rooms that are larger lie around the one that was drawn in, in du².
    fn near_du2(&self) -> f64 {
        let within = self.visits.values().filter(|visit| visit.area_du2.is_finite());
        let main =
            within.max_by(|a, b| a.seeds.len().cmp(&b.seeds.len()).then(b.area_du2.total_cmp(&a.area_du2)));
        main.map_or(f64::INFINITY, |main| AROUND * main.area_du2)
    }

    /// The number of samples in rooms that are no larger.
    fn sample_count(&self, largest_du2: f64) -> usize {
        let rooms = self.visits.values().filter(|visit| visit.area_du2 <= largest_du2);
        rooms.map(|visit| visit.seeds.len()).sum()
    }
}

/// The triangle of the refined mesh that a point on lines stands for: of those on either side the one in the smallest
/// room, but none that lies all under ink. A stroke over a line is for what the line shows. The point lies in these
/// triangles of the map and of the refined mesh.
fn shown_by_lines(map: &PlanarMap, ways: &Ways, p: Point, [base, triangle]: [usize; 2]) -> usize {
    let size = |triangle: usize| {
        let room = ways.room_of[triangle];
        if ways.are_clear[room as usize] { ways.rooms.area_du2(room) } else { f64::INFINITY }
    };
    let mut shown = triangle;
    for side in lines_under(map, p, base, ON_LINE_DU) {
        let beyond = ways.triangle_of_side[side.opposite().index()] as usize;
        if beyond < ways.room_of.len() && size(beyond) < size(shown) {
            shown = beyond;
        }
    }
    shown
}

/// Which rooms are meant.
#[derive(Clone, Copy, Debug)]
struct Meant {
    /// Number of samples in a room from which on it is.
    least: usize,
    /// The largest of them, in du².
    largest_du2: f64,
}

impl Meant {
    fn contains(&self, visit: &Visit) -> bool {
        let is_through = visit.reach_du >= THROUGH * visit.area_du2.sqrt();
        visit.reach_du >= FAR_DU
            || (is_through || visit.is_crossed || visit.seeds.len() >= self.least)
                && visit.area_du2 <= self.largest_du2
    }
}

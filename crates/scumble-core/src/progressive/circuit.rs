//! The boundary circuit of a scribble: the cheapest closed walk around it along what it sees (section 4.1).

use kurbo::Point;

use super::MU;
use super::costs::Costs;
use super::index::Index;
use super::outline::Outline;
use super::segments::{Place, Segments};
use super::sighting::Sighting;
use super::survey::Part;
use super::view::{Jump, JumpKind, View};
use super::walk::{Edge, cheapest_odd_walk};
use crate::planar_map::PlanarMap;
use crate::sort;

/// What a scribble influences in one region.
#[derive(Debug, Default)]
pub(super) struct Circuit {
    /// Numbers of sightings.
    pub(super) sides: Vec<usize>,
}

impl Circuit {
    /// The best circuit around the part of a scribble that lies in one region.
    pub(super) fn around(
        map: &PlanarMap,
        outline: &Outline,
        part: &Part,
        sightings: &[Sighting],
        index: &Index,
    ) -> Self {
        let segments = Segments::new(map, outline, sightings, &part.sightings, index, part.samples.len());
        let costs = Costs::new(map, outline, part);
        let Some(middle) = costs.middle() else { return Self::default() };
        let graph = Graph::new(&segments, &costs, part, middle);
        match cheapest_odd_walk(graph.places.len(), &graph.edges) {
            Some(walk) => graph.trace(&walk),
            // Nothing closes around the scribble: all that it sees is its own.
            None => Self { sides: segments.sides.clone() },
        }
    }
}

/// A jump between places of segments.
#[derive(Clone, Copy, Debug)]
struct Leap {
    kind: JumpKind,
    from: Place,
    to: Place,
}

impl Leap {
    fn line(&self, segments: &Segments) -> [Point; 2] {
        [self.from, self.to].map(|place| segments.point(place))
    }

    fn length_du(&self, segments: &Segments) -> f64 {
        let [from, to] = self.line(segments);
        (to - from).hypot()
    }
}

/// The visibility graph: the places at which jumps begin or end, joined by jumps and along segments.
struct Graph<'a> {
    segments: &'a Segments<'a>,
    places: Vec<Place>,
    edges: Vec<Edge>,
}

impl<'a> Graph<'a> {
    fn new(segments: &'a Segments<'a>, costs: &Costs, part: &Part, middle: &View) -> Self {
        let leaps = leaps(segments, part, middle);
        let mut graph = Self { segments, places: places(segments, &leaps), edges: Vec::new() };
        graph.add_leaps(&leaps, costs);
        graph.add_ways();
        graph.find_odd(middle.eye);
        graph
    }

    fn add(&mut self, from: Place, to: Place, cost: f64, is_jump: bool) {
        let [from, to] = [from, to].map(|place| self.places.partition_point(|&before| before < place) as u32);
        self.edges.push(Edge { from, to, cost, is_jump, is_odd: false });
    }

    fn add_leaps(&mut self, leaps: &[Leap], costs: &Costs) {
        let segments = self.segments;
        let longest_du = leaps.iter().map(|leap| leap.length_du(segments)).fold(0.0, f64::max);
        for leap in leaps {
            let tangents = [segments.arriving(leap.from), segments.leaving(leap.to)];
            let cost = costs.jump(leap.kind, leap.line(segments), tangents, longest_du);
            self.add(leap.from, leap.to, cost, true);
        }
    }

    /// Joins neighbouring places of each segment.
    fn add_ways(&mut self) {
        let places = self.places.clone();
        for chunk in places.chunk_by(|a, b| a.segment == b.segment) {
            let closing = [chunk[chunk.len() - 1], chunk[0]];
            let is_closed = self.segments.segments[chunk[0].segment as usize].is_closed;
            let pairs = chunk.windows(2).map(|w| [w[0], w[1]]).chain(is_closed.then_some(closing));
            for [from, to] in pairs {
                let cost: f64 =
                    self.segments.way(from, to).iter().map(|range| self.segments.cost(range)).sum();
                self.add(from, to, MU * cost, false);
            }
        }
    }

    /// Finds which edges cross a ray from the centre an odd number of times: of four rays, that with the fewest.
    fn find_odd(&mut self, center: Point) {
        let rays = (0..4).map(|ray| self.crossed(center, ray));
        let fewest = rays.min_by_key(|odd| odd.iter().filter(|&&odd| odd).count());
        for (edge, odd) in self.edges.iter_mut().zip(fewest.unwrap_or_default()) {
            edge.is_odd = odd;
        }
    }

    /// For each edge whether it crosses a ray from the centre an odd number of times.
    fn crossed(&self, center: Point, ray: usize) -> Vec<bool> {
        let sides = &self.segments.sides;
        let mut odd_before = vec![false];
        for flat in 0..sides.len() {
            odd_before.push(odd_before[flat] ^ crosses(center, ray, self.segments.side_ends(flat)));
        }
        let odd = |edge: &Edge| {
            let [from, to] = [edge.from, edge.to].map(|vertex| self.places[vertex as usize]);
            if edge.is_jump {
                crosses(center, ray, [from, to].map(|place| self.segments.point(place)))
            } else {
                let ways = self.segments.way(from, to);
                ways.iter().fold(false, |odd, way| odd ^ odd_before[way.start] ^ odd_before[way.end])
            }
        };
        self.edges.iter().map(odd).collect()
    }

    /// What lies on a circuit or within it.
    fn trace(&self, walk: &[usize]) -> Circuit {
        let mut trace = Trace::new(self.segments);
        for edge in walk.iter().map(|&edge| &self.edges[edge]) {
            let [from, to] = [edge.from, edge.to].map(|vertex| self.places[vertex as usize]);
            trace.polygon.push(self.segments.point(from));
            if edge.is_jump { trace.jump(from, to) } else { trace.follow(from, to) }
        }
        Circuit { sides: trace.inside() }
    }
}

/// A circuit, as it is drawn.
struct Trace<'a> {
    segments: &'a Segments<'a>,
    polygon: Vec<Point>,
    /// Per side of the segments.
    is_followed: Vec<bool>,
    /// Per side whether a jump begins or ends where it begins.
    is_cut: Vec<bool>,
}

impl<'a> Trace<'a> {
    fn new(segments: &'a Segments<'a>) -> Self {
        let none = vec![false; segments.sides.len() + 1];
        Self { segments, polygon: Vec::new(), is_followed: none.clone(), is_cut: none }
    }

    fn jump(&mut self, from: Place, to: Place) {
        for place in [from, to] {
            self.is_cut[self.segments.segments[place.segment as usize].first + place.at as usize] = true;
        }
    }

    fn follow(&mut self, from: Place, to: Place) {
        for flat in self.segments.way(from, to).into_iter().flatten() {
            self.polygon.push(self.segments.side_ends(flat)[1]);
            self.is_followed[flat] = true;
        }
    }

    /// The sightings on the circuit and within it. Jumps and sides do not cross: between the places at which jumps
    /// end, sides lie within or without together.
    fn inside(&self) -> Vec<usize> {
        let mut sides = Vec::new();
        for segment in &self.segments.segments {
            let flats: Vec<usize> = (segment.first..segment.first + segment.len).collect();
            let is_one =
                |&a: &usize, &b: &usize| self.is_followed[a] == self.is_followed[b] && !self.is_cut[b];
            for stretch in flats.chunk_by(is_one) {
                let middle = stretch[stretch.len() / 2];
                let beside = just_left_of(self.segments.side_ends(middle));
                if self.is_followed[middle] || encloses(&self.polygon, beside) {
                    sides.extend(stretch.iter().map(|&flat| self.segments.sides[flat]));
                }
            }
        }
        sides
    }
}

/// The jumps that a circuit may take.
fn leaps(segments: &Segments, part: &Part, middle: &View) -> Vec<Leap> {
    let leap = |jump: &Jump| {
        let (from, to) = (segments.after(jump.from)?, segments.before(jump.to)?);
        Some(Leap { kind: jump.kind, from, to })
    };
    let mut leaps = shortest(segments, part.jumps.iter().filter_map(leap).collect());
    // The way around that the middle sample sees is always there: some circuit can be found.
    let mut own = Vec::new();
    middle.jumps(&mut own);
    leaps.extend(own.iter().filter_map(leap));
    leaps
}

/// The places where jumps begin or end, and one on each closed segment, in ascending order.
fn places(segments: &Segments, leaps: &[Leap]) -> Vec<Place> {
    let mut places: Vec<Place> = leaps.iter().flat_map(|leap| [leap.from, leap.to]).collect();
    let closed = segments.segments.iter().enumerate().filter(|(_, segment)| segment.is_closed);
    places.extend(closed.map(|(i, _)| Place { segment: i as u32, at: 0 }));
    sort::sort_copies_by_key(&mut places, |place| sort::pair([place.segment, place.at]));
    places.dedup();
    places
}

/// Of all jumps from one end to the same segment, or from one segment to the same end, the shortest.
fn shortest(segments: &Segments, mut leaps: Vec<Leap>) -> Vec<Leap> {
    // Places number less than 2³⁰.
    let number = |place: Place| segments.number(place);
    let first = |place: Place| number(Place { at: 0, ..place });
    let key = |leap: &Leap| {
        let places = match leap.kind {
            JumpKind::Outward => [number(leap.from), first(leap.to)],
            JumpKind::Inward => [first(leap.from), number(leap.to)],
            JumpKind::Across => [leap.from, leap.to].map(number),
        };
        (leap.kind as u64) << 62 | sort::pair(places)
    };
    sort::sort_copies_by_key(&mut leaps, key);
    let length_du = |leap: &&Leap| leap.length_du(segments);
    let alike = leaps.chunk_by(|a, b| key(a) == key(b));
    alike
        .filter_map(|leaps| leaps.iter().min_by(|a, b| length_du(a).total_cmp(&length_du(b))))
        .copied()
        .collect()
}

/// Whether a straight line crosses a ray that leaves the centre along an axis. Nodes on the ray count as lying on
/// its one side, so that a closed walk crosses it as often as it should.
fn crosses(center: Point, ray: usize, line: [Point; 2]) -> bool {
    let [a, b] = line.map(|p| p - center).map(|v| match ray {
        0 => v,
        1 => kurbo::Vec2::new(v.y, v.x),
        2 => -v,
        _ => kurbo::Vec2::new(-v.y, -v.x),
    });
    (a.y > 0.0) != (b.y > 0.0) && (a.cross(b) > 0.0) == (b.y > a.y)
}

/// Whether a closed polygon winds around a point an odd number of times.
fn encloses(polygon: &[Point], p: Point) -> bool {
    let lines = polygon.iter().zip(polygon.iter().cycle().skip(1));
    lines.fold(false, |odd, (&a, &b)| odd ^ crosses(p, 0, [a, b]))
}

/// A point beside the middle of a side, within its region.
fn just_left_of([a, b]: [Point; 2]) -> Point {
    let along = b - a;
    a.midpoint(b) + 1e-4 * kurbo::Vec2::new(-along.y, along.x)
}

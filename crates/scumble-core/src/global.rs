//! The `Global` engine: all scribbles at once, each place taken by the one that comes to it by the widest way.
//!
//! Every scribble floods the refined mesh from where it was drawn. The way from triangle to triangle costs
//! `length · (1 / width)⁸`, through a gap as if that were half as long as it is wide: nearly the order "widest passage
//! first, then distance", but a metric, so that a scribble that grows takes places from others and never gives any away,
//! and the order of scribbles does not matter. Costs are integers, so that nothing depends on how sums are rounded. Only a
//! room that turns out not to be meant is given up, with all that was taken there: a stroke may begin on the page, just
//! beside its shape.
//!
//! A place in a passage of a certain width is as hard to leave as the passage: what is scribbled close to a line, or
//! on it, has less to say about the other end of the room than what is scribbled in the open. That makes up for the
//! hand that leaves its region a little. What is at hand is another matter: there the nearest scribble has its say,
//! however narrow its place, so that a dab near a line colours that line.
//!
//! Colours stop at the [gaps](PlanarMap::gaps) of the map, but for those that lead into `pockets`, through `halls` that they have
//! enough of, and into the corners of closed `shapes`; and at lines, but for some around `slivers`. With `spread`, they go on:
//! through all gaps, and then across lines, into each region, slivers or not, from the neighbour that shares the longest border
//! with it.
//!
//! A minimum cut on the places in doubt was not needed: on the quality set, this flood alone is ahead of cuts on
//! pixels, and of the best of three methods picked for each drawing.

mod beyond;
mod claim;
mod crossing;
mod flood;
mod halls;
mod pockets;
mod route;
mod shapes;
mod shown;
mod slivers;

use std::cmp::Ordering;

use beyond::Beyond;
use claim::Claim;
use crossing::Crossing;
use flood::{Cost, Flood, NONE, Ways};
use shown::Shown;

use crate::color::{Paint, Srgb8};
use crate::engine::{Engine, Labels};
use crate::pace::{self, Pace, Slices};
use crate::planar_map::PlanarMap;
use crate::scribble::Scribble;
use crate::sort;

/// Floods the map from all scribbles; keeps the flood of the last call, and redoes of it what scribbles had that are gone or
/// get that are new.
#[derive(Clone, Debug, Default)]
pub struct Global {
    spread: bool,
    /// What depends on the map alone.
    ground: Option<Ground>,
    /// Of the scribbles of the last call.
    claims: Vec<Claim>,
    ranks: Vec<u32>,
    /// The kinds that were drawn, each with a room that it was drawn in, in ascending order.
    drawn: Vec<[u32; 2]>,
    flood: Flood,
    /// What is at hand to a scribble.
    at_hand: Flood,
    /// What is nearest to it.
    nearest: Flood,
    beyond: Beyond,
    shown: Option<Shown>,
}

#[derive(Clone, Debug)]
struct Ground {
    ways: Ways,
    /// Where colours spread.
    crossing: Option<Crossing>,
}

impl Ground {
    async fn new(map: &PlanarMap, spread: bool) -> Self {
        map.measuring().await;
        map.refining().await;
        let ways = Ways::new(map, spread).await;
        pace::pause().await;
        let crossing = if spread { Some(Crossing::new(map).await) } else { None };
        pace::pause().await;
        Self { ways, crossing }
    }
}

impl Global {
    /// With `spread`, colours go on into areas that nobody scribbled.
    pub fn new(spread: bool) -> Self {
        Self { spread, ..Self::default() }
    }
}

impl Engine for Global {
    fn labelling<'a>(&'a mut self, map: &'a PlanarMap, scribbles: &'a [Scribble]) -> Slices<'a, Labels> {
        Slices::new(self.labels(map, scribbles))
    }
}

impl Global {
    async fn labels(&mut self, map: &PlanarMap, scribbles: &[Scribble]) -> Labels {
        let ranks = ranks(scribbles);
        let mut ground = match self.ground.take() {
            Some(ground) => ground,
            None => Ground::new(map, self.spread).await,
        };
        let mut is_known = self.is_flooded_from(scribbles, &ranks);
        if !is_known {
            self.go_on(map, &ground.ways, scribbles, ranks).await;
        }
        if !self.spread {
            let are_others_open = self.open_pockets(map, &mut ground.ways, &kinds(scribbles)).await;
            is_known &= !are_others_open;
        }
        if !is_known {
            pace::pause().await;
            let labels = self.spread_out(map, &ground).await;
            pace::pause_after(labels.len()).await;
            self.shown.get_or_insert_with(|| Shown::new(map)).show(map, &ground.ways.gaps, &labels);
        }
        self.ground = Some(ground);
        self.shown.get_or_insert_with(|| Shown::new(map)).labels().clone()
    }

    /// Whether only colours differ from the last call: labels name scribbles, so they are the same then, where the same gaps
    /// are open.
    fn is_flooded_from(&self, scribbles: &[Scribble], ranks: &[u32]) -> bool {
        let is_same = |(claim, scribble): (&Claim, &Scribble)| claim.points() == scribble.points;
        self.shown.is_some() && self.ranks == ranks && self.claims.iter().zip(scribbles).all(is_same)
    }

    /// Makes the floods of the last call those of these scribbles: what is gone of those is dried, what is new floods on.
    async fn go_on(&mut self, map: &PlanarMap, ways: &Ways, scribbles: &[Scribble], ranks: Vec<u32>) {
        let mut kept = self.kept(scribbles, &ranks);
        self.follow(map, ways, scribbles, &kept).await;
        for label in kept.iter_mut().filter(|label| **label != NONE) {
            if self.claims[*label as usize].gives_up() {
                *label = NONE;
            }
        }
        if self.flood.labels.is_empty() || !kept.iter().copied().eq(0..kept.len() as u32) {
            self.withdraw(map, &kept).await;
        }
        self.let_in(&ranks);
        let Self { flood, at_hand, nearest, .. } = self;
        for (flood, costs) in [(flood, &ways.costs), (at_hand, &ways.lengths), (nearest, &ways.lengths)] {
            flood.run(map, costs, &ranks, &ways.passages).await;
        }
        self.ranks = ranks;
    }

    /// Per claim of the last call the scribble that begins with it now, in the same order; [`NONE`] where there is none, or
    /// for all where ranks have changed among them.
    fn kept(&self, scribbles: &[Scribble], ranks: &[u32]) -> Vec<u32> {
        let mut next = 0;
        let mut kept = vec![NONE; self.claims.len()];
        for (label, claim) in kept.iter_mut().zip(&self.claims) {
            let begins = |scribble: &Scribble| scribble.points.starts_with(claim.points());
            if let Some(i) = scribbles[next..].iter().position(begins) {
                *label = (next + i) as u32;
                next += i + 1;
            }
        }
        let by_rank = self.by_rank().into_iter().map(|claim| kept[claim]).filter(|&label| label != NONE);
        if !by_rank.is_sorted_by_key(|label| ranks[label as usize]) {
            kept.fill(NONE);
        }
        kept
    }

    /// Follows the scribbles to their ends, from where the claims are that are kept.
    async fn follow(&mut self, map: &PlanarMap, ways: &Ways, scribbles: &[Scribble], kept: &[u32]) {
        let mut claims = Vec::new();
        claims.resize_with(scribbles.len(), Claim::default);
        for (claim, &label) in self.claims.iter_mut().zip(kept).filter(|(_, label)| **label != NONE) {
            std::mem::swap(&mut claims[label as usize], claim);
        }
        let mut pace = Pace::default();
        for (claim, scribble) in claims.iter_mut().zip(scribbles) {
            claim.follow(map, ways, &scribble.points);
            pace.work(scribble.points.len()).await;
        }
        self.claims = claims;
    }

    /// Dries what labels have that are not kept, and lets what is around come there. All claims are let in anew.
    async fn withdraw(&mut self, map: &PlanarMap, kept: &[u32]) {
        let Self { flood, at_hand, nearest, .. } = self;
        let near = claim::at_hand_limit();
        for (flood, limit) in [(flood, Cost::MAX), (at_hand, near), (nearest, near)] {
            flood.withdraw(map, kept, limit);
            pace::pause_after(map.side_count()).await;
        }
        self.beyond.reset(map);
        self.claims.iter_mut().for_each(Claim::stay_out);
    }

    /// Lets scribbles into the rooms that they mean, as far as they are not in yet.
    fn let_in(&mut self, ranks: &[u32]) {
        for (label, claim) in (0..).zip(&mut self.claims) {
            claim.let_in(|seed| {
                self.flood.reach(seed.triangle, seed.cost, label, ranks);
                self.at_hand.reach(seed.triangle, seed.at_hand, label, ranks);
                self.nearest.reach(seed.triangle, seed.nearest, label, ranks);
            });
        }
    }

    /// The label of each triangle, once colours have gone on from where they were flooded to.
    async fn spread_out(&mut self, map: &PlanarMap, Ground { ways, crossing }: &Ground) -> Vec<u32> {
        let mut labels = self.flood.labels.clone();
        self.beyond.follow(map, ways, &self.ranks, &self.flood, &mut labels).await;
        pace::pause().await;
        for flood in [&self.at_hand, &self.nearest] {
            for (label, &near) in labels.iter_mut().zip(&flood.labels).filter(|(_, near)| **near != NONE) {
                *label = near;
            }
        }
        if let Some(crossing) = crossing {
            pace::pause_after(labels.len()).await;
            crossing.cross(&mut labels, &self.ranks);
        }
        labels
    }

    /// Opens the gaps that the scribbles of this call, which are of these kinds, go through; tells whether others are open
    /// than before.
    async fn open_pockets(&mut self, map: &PlanarMap, ways: &mut Ways, kinds: &[u32]) -> bool {
        let mut drawn = Vec::new();
        for (claim, &kind) in self.claims.iter().zip(kinds) {
            drawn.extend(claim.rooms().map(|room| [kind, room]));
        }
        sort::sort_copies_by_key(&mut drawn, |&pair| sort::pair(pair));
        drawn.dedup();
        if drawn == self.drawn {
            return false;
        }
        let [opens, closes] = ways.open_to(&drawn).await;
        if closes {
            self.beyond.reset(map);
        }
        self.drawn = drawn;
        opens || closes
    }

    /// The scribbles of the last call in the order of their ranks.
    fn by_rank(&self) -> Vec<usize> {
        let mut by_rank = vec![0; self.ranks.len()];
        self.ranks.iter().enumerate().for_each(|(label, &rank)| by_rank[rank as usize] = label);
        by_rank
    }
}

/// Per scribble the first one of the same colour.
fn kinds(scribbles: &[Scribble]) -> Vec<u32> {
    let mut order: Vec<(u64, u32)> = scribbles.iter().map(color_key).zip(0..).collect();
    sort::sort(&mut order);
    let mut kinds = vec![0; order.len()];
    for run in order.chunk_by(|a, b| a.0 == b.0) {
        run.iter().for_each(|&(_, i)| kinds[i as usize] = run[0].1);
    }
    kinds
}

/// Another number for each colour.
fn color_key(scribble: &Scribble) -> u64 {
    match scribble.color {
        Paint::Color(Srgb8([r, g, b])) => u32::from_be_bytes([0, r, g, b]).into(),
        Paint::Clear => u64::MAX,
    }
}

/// The place of each scribble in an order that does not depend on the order in which they were drawn.
fn ranks(scribbles: &[Scribble]) -> Vec<u32> {
    let mut order: Vec<usize> = Vec::with_capacity(scribbles.len());
    for (i, scribble) in scribbles.iter().enumerate() {
        let place = order.partition_point(|&before| compare(&scribbles[before], scribble).is_le());
        order.insert(place, i);
    }
    let mut ranks = vec![0; scribbles.len()];
    (0..).zip(order).for_each(|(rank, i)| ranks[i] = rank);
    ranks
}

fn compare(a: &Scribble, b: &Scribble) -> Ordering {
    let mut pairs = a.points.iter().zip(&b.points);
    let points =
        pairs.find_map(|(p, q)| Some(p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y))).filter(|o| o.is_ne()));
    points.unwrap_or(a.points.len().cmp(&b.points.len())).then(a.color.cmp(&b.color))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Drawing;
    use crate::pace::now;
    use crate::planar_map::Sampling;
    use crate::scribble::ScribbleKind;
    use kurbo::{Point, Rect};

    fn scribble(x: f64) -> Scribble {
        let points = vec![Point::new(x, 10.0), Point::new(x, 20.0)];
        Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 4.0, points }
    }

    #[test]
    fn what_scribbles_have_that_are_still_there_is_kept() {
        let drawing = Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0));
        let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
        let [a, b, c, d] = [100.0, 300.0, 500.0, 700.0].map(scribble);
        let mut longer = b.clone();
        longer.points.push(Point::new(310.0, 30.0));
        for (scribbles, expected) in [
            (vec![a.clone(), b.clone(), c.clone()], [0, 1, 2]),
            (vec![a.clone(), b.clone()], [0, 1, NONE]),
            (vec![a.clone(), c.clone()], [0, NONE, 1]),
            (vec![a.clone(), d, longer, c.clone()], [0, 2, 3]),
            (vec![c, a, b], [1, 2, NONE]),
        ] {
            let mut engine = Global::new(false);
            engine.label(&map, &[100.0, 300.0, 500.0].map(scribble));
            assert_eq!(engine.kept(&scribbles, &ranks(&scribbles)), expected);
        }
    }

    #[test]
    fn only_what_is_gone_is_dried_and_flooded_from_around_it() {
        let drawing = Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0));
        let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
        let [mut engine, mut alone] = [(); 2].map(|()| Global::new(false));
        engine.label(&map, &[100.0, 900.0].map(scribble));
        alone.label(&map, &[scribble(100.0)]);
        let before = engine.flood.labels.clone();
        assert!(before.contains(&0) && before.contains(&1));
        engine.flood.withdraw(&map, &[0, NONE], Cost::MAX);
        let is_gone = |label: u32| if label == 1 { NONE } else { label };
        assert_eq!(engine.flood.labels, before.into_iter().map(is_gone).collect::<Vec<_>>());
        let ways = &engine.ground.as_ref().expect("ways").ways;
        now(Slices::new(engine.flood.run(&map, &ways.costs, &[0], &ways.passages)));
        assert!(!engine.flood.labels.contains(&NONE));
        assert_eq!((engine.flood.labels, engine.flood.costs), (alone.flood.labels, alone.flood.costs));
    }
}

//! The way of a scribble from room to room, and which of them it goes right through, as through the stripes of a shirt.

use kurbo::Point;

use crate::stroke::SAMPLE_SPACING_DU;

/// A scribble goes right through rooms beside each other where it goes so far in all, in at one line and out at another, in du: no
/// hand slips as far.
const CROSSED_DU: f64 = 30.0;

/// The way of a scribble from room to room.
#[derive(Clone, Debug, Default)]
pub(super) struct Route {
    /// Where it is.
    stay: Option<Stay>,
    /// The room where it was before.
    before: Option<u32>,
    /// The rooms that it has just gone through.
    crossed: Vec<u32>,
    /// Where it came into the first of them.
    crossed_from: Point,
}

/// A room, with the first and the last sample there.
#[derive(Clone, Copy, Debug)]
struct Stay {
    room: u32,
    from: Point,
    to: Point,
}

impl Stay {
    fn reach_du(&self) -> f64 {
        self.from.distance(self.to)
    }
}

impl Route {
    /// Goes on to a sample in a room; how far that is from where the scribble came in there, in du. Tells `cross` of the rooms that
    /// it has gone right through.
    pub(super) fn go_on(&mut self, p: Point, room: u32, cross: impl FnMut(u32)) -> f64 {
        // Beyond the page, there are no samples.
        let last = self.stay.filter(|stay| stay.to.distance(p) <= 2.0 * SAMPLE_SPACING_DU);
        if last.is_none() {
            *self = Self::default();
        }
        let from = last.filter(|stay| stay.room == room).map_or(p, |stay| stay.from);
        if let Some(left) = last.filter(|stay| stay.room != room) {
            self.leave(&left, p, room, cross);
        }
        let stay = Stay { room, from, to: p };
        self.stay = Some(stay);
        stay.reach_du()
    }

    /// Leaves a room for another.
    fn leave(&mut self, left: &Stay, p: Point, room: u32, cross: impl FnMut(u32)) {
        let is_through = self.before.is_some_and(|before| before != room);
        // One that is wide by itself says nothing of a rim beside it.
        let is_wide = left.reach_du() >= CROSSED_DU;
        if is_wide {
            self.begin(left.from);
        }
        if is_through {
            self.crossed.push(left.room);
            if self.crossed_from.distance(left.to) >= CROSSED_DU {
                self.crossed.drain(..).for_each(cross);
            }
        }
        if is_wide || !is_through {
            self.begin(p);
        }
        self.before = Some(left.room);
    }

    fn begin(&mut self, p: Point) {
        self.crossed.clear();
        self.crossed_from = p;
    }
}

//! How long labelling takes.

use scumble_core::{Engine, PlanarMap, Scribble};

use super::method::{Manner, Method, Way};
use super::subject::Subject;
use crate::clock::{Times, print_head, print_row, timed};

/// Times of labelling, one or more for each drawing.
#[derive(Debug, Default)]
pub(crate) struct Latency {
    /// All scribbles of a drawing at once, by an engine that knows nothing of the drawing yet.
    at_once: Times,
    /// One more scribble, from the second on.
    one_more: Times,
    /// The last scribble of a drawing, all others being there.
    last: Times,
}

impl Latency {
    /// Times the labelling of one drawing. On pixels every scribble means to begin anew.
    pub(crate) fn take(&mut self, subject: &Subject, method: Method, manner: Manner) {
        let map = subject.opened.picture.map();
        match method.way {
            Way::Engine(engine) => {
                let mut fresh = engine(manner);
                self.at_once.push(timed(|| fresh.label(map, &subject.scribbles)).1);
                self.take_one_by_one(engine(manner), map, &subject.scribbles);
            }
            Way::Pixels(label) => {
                let sketch = subject.sketch(&subject.scribbles);
                self.at_once.push(timed(|| label(&sketch, manner)).1);
            }
        }
    }

    fn take_one_by_one(&mut self, mut engine: Box<dyn Engine>, map: &PlanarMap, scribbles: &[Scribble]) {
        for count in 1..=scribbles.len() {
            let (_, ms) = timed(|| engine.label(map, &scribbles[..count]));
            if count > 1 {
                self.one_more.push(ms);
            }
            if count == scribbles.len() {
                self.last.push(ms);
            }
        }
    }

    pub(crate) fn print(&self) {
        println!();
        print_head("labels, one thread");
        print_row("all scribbles at once, the first time", &self.at_once);
        if self.last.len() > 0 {
            print_row("one more scribble, from the second on", &self.one_more);
            print_row("the last scribble, all others being there", &self.last);
        }
    }
}

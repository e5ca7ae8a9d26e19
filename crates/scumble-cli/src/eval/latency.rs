//! How long labelling takes.

use scumble_core::{Engine, Labels, Scribble, Settings, Sight};

use super::method::{Method, Way};
use super::subject::Subject;
use crate::clock::{Times, print_head, print_row, timed};

/// Times of labelling, one or more for each drawing.
#[derive(Debug, Default)]
pub(crate) struct Latency {
    /// All scribbles of a drawing at once, from none.
    at_once: Times,
    /// One more scribble, from the second on.
    one_more: Times,
    /// The last scribble of a drawing, all others being there.
    last: Times,
}

impl Latency {
    /// Times the labelling of one drawing. On pixels every scribble means to begin anew.
    pub(crate) fn take(&mut self, subject: &mut Subject, method: Method, settings: Settings) {
        match method.way {
            Way::Engine(kind) => {
                let Subject { opened, scribbles, .. } = subject;
                let settings = Settings { engine: kind, ..settings };
                self.take_labels(scribbles, |scribbles| opened.picture.label(scribbles, &settings));
            }
            Way::Sight => {
                let mut engine = Sight::default();
                let map = subject.opened.picture.map();
                self.take_labels(&subject.scribbles, |scribbles| engine.label(map, scribbles));
            }
            Way::Pixels(label) => {
                let sketch = subject.sketch(&subject.scribbles);
                self.at_once.push(timed(|| label(&sketch, settings)).1);
            }
        }
    }

    fn take_labels(&mut self, scribbles: &[Scribble], mut label: impl FnMut(&[Scribble]) -> Labels) {
        // What depends on the drawing alone is done before a person can scribble.
        label(&[]);
        self.at_once.push(timed(|| label(scribbles)).1);
        label(&[]);
        for count in 1..=scribbles.len() {
            let (_, ms) = timed(|| label(&scribbles[..count]));
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

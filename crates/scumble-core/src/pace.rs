//! Long work in slices: asynchronous functions that pause now and then, so that whoever goes on with them can do something
//! else meanwhile.
//!
//! No runtime, no thread and no clock belongs to it. Pauses come after so much work, whoever waits: what is made in slices
//! is made by the same steps as what is made at once, by [`now`].

use std::fmt;
use std::mem;
use std::pin::Pin;
use std::task::{Context, Poll, Waker};

/// Items between two pauses. One takes some ten microseconds at most.
const SLICE: usize = 1024;

/// A pause, if it is due. Written out, as it is in all loops: it takes less code than an asynchronous function.
#[derive(Debug)]
pub struct Pause {
    is_due: bool,
}

impl Future for Pause {
    type Output = ();

    fn poll(mut self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<()> {
        if mem::take(&mut self.is_due) { Poll::Pending } else { Poll::Ready(()) }
    }
}

/// Pauses once.
pub fn pause() -> Pause {
    Pause { is_due: true }
}

/// Pauses if so many items are enough for a slice.
pub fn pause_after(items: usize) -> Pause {
    Pause { is_due: items >= SLICE }
}

/// Counts what is done in one loop.
#[derive(Debug, Default)]
pub struct Pace {
    done: usize,
}

impl Pace {
    /// So many items were done: pauses where that is enough since the last time.
    pub fn work(&mut self, items: usize) -> Pause {
        self.done += items;
        let is_due = self.done >= SLICE;
        if is_due {
            self.done = 0;
        }
        Pause { is_due }
    }
}

/// Does something with each of some items.
pub async fn for_each<T>(items: impl IntoIterator<Item = T>, mut act: impl FnMut(T)) {
    let mut items = items.into_iter();
    repeat(|| items.next().map(&mut act).is_some()).await;
}

/// Does something again and again, until it tells that there is no more.
pub async fn repeat(mut act: impl FnMut() -> bool) {
    while next_slice(&mut act) {
        pause().await;
    }
}

/// Does it as often as goes without a pause, and tells whether there may be more. It is no part of the asynchronous
/// function, as a loop there takes more time and code.
fn next_slice(act: &mut impl FnMut() -> bool) -> bool {
    (0..SLICE).all(|_| act())
}

/// Work that is done in slices. It is what functions that others call give: code of an asynchronous function itself is made
/// anew in every crate that waits for it.
pub struct Slices<'a, T>(Pin<Box<dyn Future<Output = T> + 'a>>);

impl<'a, T> Slices<'a, T> {
    /// Nothing is done yet.
    pub fn new(work: impl Future<Output = T> + 'a) -> Self {
        Self(Box::pin(work))
    }

    /// Does the next slice.
    ///
    /// # Errors
    /// What is left, where that was not the last one.
    pub fn go_on(mut self) -> Result<T, Self> {
        match self.0.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
            Poll::Ready(done) => Ok(done),
            Poll::Pending => Err(self),
        }
    }
}

impl<T> Future for Slices<'_, T> {
    type Output = T;

    fn poll(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<T> {
        self.0.as_mut().poll(context)
    }
}

impl<T> fmt::Debug for Slices<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Slices")
    }
}

/// Does all at once.
pub fn now<T>(mut slices: Slices<'_, T>) -> T {
    loop {
        match slices.go_on() {
            Ok(done) => return done,
            Err(left) => slices = left,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What comes of it, and after how many pauses.
    fn with_pauses<T>(mut slices: Slices<'_, T>) -> (T, usize) {
        let mut pauses = 0;
        loop {
            match slices.go_on() {
                Ok(done) => return (done, pauses),
                Err(left) => (slices, pauses) = (left, pauses + 1),
            }
        }
    }

    #[test]
    fn work_pauses_between_slices_and_comes_to_the_same() {
        let squares = || {
            Slices::new(async {
                let mut squares = Vec::new();
                for_each(0..5 * SLICE, |i| squares.push(i * i)).await;
                squares
            })
        };
        let (done, pauses) = with_pauses(squares());
        assert_eq!(pauses, 5);
        assert_eq!(done, now(squares()));
        assert_eq!(done.len(), 5 * SLICE);
    }

    #[test]
    fn uneven_work_pauses_once_there_is_enough_of_it() {
        let slices = Slices::new(async {
            let mut pace = Pace::default();
            for items in [1, SLICE - 2, 1, SLICE - 1, 5 * SLICE] {
                pace.work(items).await;
            }
        });
        assert_eq!(with_pauses(slices).1, 2);
    }
}

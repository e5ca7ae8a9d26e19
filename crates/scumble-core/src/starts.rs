//! Paths by where they start: the same path is found among thousands without a look at each of them.

use kurbo::{BezPath, PathEl};

use crate::sort;

/// Paths of one piece each.
#[derive(Debug)]
pub struct Starts<'a>(Vec<(u64, &'a [PathEl])>);

impl<'a> Starts<'a> {
    /// Of all these paths, in whatever order.
    pub fn of(paths: impl Iterator<Item = &'a [PathEl]>) -> Self {
        let mut paths: Vec<_> = paths.map(|path| (key(path), path)).collect();
        sort::sort_copies_by_key(&mut paths, |(key, _)| *key);
        Self(paths)
    }

    /// Those that start where a path does, in the order in which they came, and maybe others.
    pub fn like(&self, path: &[PathEl]) -> impl Iterator<Item = &'a [PathEl]> {
        let key = key(path);
        let first = self.0.partition_point(|(at, _)| *at < key);
        self.0[first..].iter().take_while(move |(at, _)| *at == key).map(|(_, path)| *path)
    }
}

/// The pieces of a path: each begins with the only `MoveTo` in it.
pub fn subpaths(path: &BezPath) -> impl Iterator<Item = &[PathEl]> {
    path.elements().chunk_by(|_, next| !matches!(next, PathEl::MoveTo(_)))
}

/// The same for equal starts; hardly ever for others.
fn key(path: &[PathEl]) -> u64 {
    let start = path.first().and_then(PathEl::end_point).unwrap_or_default();
    // There are two zeros, which are equal.
    let [x, y] = [start.x, start.y].map(|at| (at + 0.0).to_bits());
    x.rotate_left(32) ^ y
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(svg: &str) -> BezPath {
        BezPath::from_svg(svg).expect("a path")
    }

    #[test]
    fn paths_are_found_by_their_start() {
        let all = path("M1 2L3 4M0 0H9M1 2L5 6ZM2 1L3 4");
        let starts = Starts::of(subpaths(&all));
        let found = |svg: &str| starts.like(path(svg).elements()).map(<[PathEl]>::len).collect::<Vec<_>>();
        assert_eq!(found("M1 2H7"), [2, 3]);
        assert_eq!(found("M2 1H7"), [2]);
        assert_eq!(found("M-0 -0H7"), [2], "either zero");
        assert_eq!(found("M5 5H7"), [0; 0]);
    }
}

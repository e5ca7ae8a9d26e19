//! Which unknowns a sparse factor eliminates together, and what each elimination touches.
//!
//! The multifrontal method (I. Duff, J. Reid, *The multifrontal solution of indefinite sparse symmetric linear
//! equations*, 1983): a *front* is a small dense matrix of a few successive unknowns, its *pivots*, and of its
//! *boundary*, the later ones that those are coupled to. What the elimination of the pivots leaves on the boundary is
//! added to the parent, the front that eliminates the first of these.

use std::ops::Range;
use std::{iter, mem};

use scumble_core::pace::Pace;
use scumble_core::sort;

/// End of a list of fronts, and what else is not there.
pub(super) const NONE: u32 = u32::MAX;

/// A front takes in a child where no more than one of so many entries is a zero then: fewer and larger fronts are faster,
/// though they have more entries.
const ENTRIES_PER_ZERO: usize = 6;

/// So many rows are sorted in the time that a front takes besides.
const KEYS: usize = 8;

/// The fronts of a factor, children before parents.
#[derive(Debug)]
pub(super) struct Fronts {
    pub(super) list: Vec<Front>,
    boundaries: Vec<u32>,
    elements: Vec<u32>,
}

/// One of them.
#[derive(Clone, Debug)]
pub(super) struct Front {
    /// The rows that it eliminates.
    pub(super) pivots: Range<u32>,
    /// The row that its parent eliminates first of its boundary, or [`NONE`].
    parent_row: u32,
    boundary: Range<usize>,
    elements: Range<usize>,
    /// How many entries of it are zeros that elimination by smaller fronts would leave out.
    zeros: usize,
    /// Its first child and its next sibling, or [`NONE`].
    pub(super) child: u32,
    pub(super) sibling: u32,
}

impl Front {
    /// Number of its rows.
    pub(super) fn size(&self) -> usize {
        self.pivots.len() + self.boundary.len()
    }

    /// Number of entries of its pivots' columns, each from the diagonal on.
    fn entry_count(&self) -> usize {
        let count = |size: usize| size * (size + 1) / 2;
        count(self.size()) - count(self.boundary.len())
    }

    /// Itself with a child that comes right before it, where that makes few zeros.
    fn with(&self, child: &Self) -> Option<Self> {
        if !self.pivots.contains(&child.parent_row) {
            return None;
        }
        let more_zeros = child.pivots.len() * (self.size() - child.boundary.len());
        let merged = Self {
            pivots: child.pivots.start..self.pivots.end,
            elements: child.elements.start..self.elements.end,
            zeros: self.zeros + child.zeros + more_zeros,
            ..self.clone()
        };
        Some(merged).filter(|merged| merged.zeros * ENTRIES_PER_ZERO <= merged.entry_count())
    }
}

impl Fronts {
    /// The fronts of elements with so many rows each; those beyond the last row are of fixed unknowns. Rows that end before each of
    /// some ascending numbers are pivots of one front; the last of these is the number of rows.
    pub(super) async fn new(rows: &[[u32; 6]], ends: &[u32]) -> Self {
        let group_of = group_of(ends);
        let (starts, elements) = by_group(rows, &group_of, ends.len());
        let mut fronts = Self { list: Vec::with_capacity(ends.len()), boundaries: Vec::new(), elements };
        let mut child_of = vec![NONE; ends.len()];
        let mut rows_from = RowsFrom::of(group_of.len());
        let mut pace = Pace::default();
        for (group, &end) in ends.iter().enumerate() {
            let elements = starts[group] as usize..starts[group + 1] as usize;
            let boundaries = || fronts.siblings(child_of[group]).map(|child| fronts.boundary(child));
            rows_from.start(end, boundaries().max_by_key(|boundary| boundary.len()).unwrap_or_default());
            for &element in &fronts.elements[elements.clone()] {
                rows_from.add(&rows[element as usize]);
            }
            boundaries().for_each(|boundary| rows_from.add(boundary));
            let start = fronts.boundaries.len();
            rows_from.append_to(&mut fronts.boundaries);
            pace.work(1 + (fronts.boundaries.len() - start) / KEYS).await;
            let parent_row = fronts.boundaries.get(start).copied().unwrap_or(NONE);
            let parent =
                group_of.get(parent_row as usize).and_then(|&group| child_of.get_mut(group as usize));
            fronts.list.push(Front {
                pivots: if group == 0 { 0 } else { ends[group - 1] }..end,
                parent_row,
                boundary: start..fronts.boundaries.len(),
                elements,
                zeros: 0,
                child: NONE,
                sibling: parent.map_or(NONE, |child| mem::replace(child, group as u32)),
            });
        }
        fronts.merge();
        fronts.link();
        fronts
    }

    /// A front and all siblings that come after it.
    fn siblings(&self, first: u32) -> impl Iterator<Item = &Front> {
        let front = |i: u32| self.list.get(i as usize);
        iter::successors(front(first), move |before| front(before.sibling))
    }

    pub(super) fn boundary(&self, front: &Front) -> &[u32] {
        &self.boundaries[front.boundary.clone()]
    }

    /// The elements of which the first row is a pivot.
    pub(super) fn elements(&self, front: &Front) -> &[u32] {
        &self.elements[front.elements.clone()]
    }

    /// Number of rows of all of them.
    pub(super) fn row_count(&self) -> usize {
        self.list.last().map_or(0, |front| front.pivots.end as usize)
    }

    /// Lets fronts take in their last children.
    fn merge(&mut self) {
        let mut merged: Vec<Front> = Vec::with_capacity(self.list.len());
        for mut front in self.list.drain(..) {
            while let Some(larger) = merged.last().and_then(|child| front.with(child)) {
                front = larger;
                merged.pop();
            }
            merged.push(front);
        }
        self.list = merged;
    }

    /// Finds the children of all fronts.
    fn link(&mut self) {
        let ends: Vec<_> = self.list.iter().map(|front| front.pivots.end).collect();
        let group_of = group_of(&ends);
        let mut child_of = vec![NONE; self.list.len()];
        for (i, front) in self.list.iter_mut().enumerate() {
            front.child = child_of[i];
            let parent =
                group_of.get(front.parent_row as usize).map(|&parent| &mut child_of[parent as usize]);
            front.sibling = parent.map_or(NONE, |child| mem::replace(child, i as u32));
        }
    }
}

/// The group of each row.
fn group_of(ends: &[u32]) -> Vec<u32> {
    let mut group_of = Vec::with_capacity(ends.last().map_or(0, |&end| end as usize));
    for (group, &end) in (0..).zip(ends) {
        group_of.resize(end as usize, group);
    }
    group_of
}

/// The elements by the groups of their first rows: where each begins in a list, and the list.
fn by_group(rows: &[[u32; 6]], group_of: &[u32], group_count: usize) -> (Vec<u32>, Vec<u32>) {
    let groups: Vec<_> = rows.iter().map(|rows| group_of.get(first(rows) as usize).copied()).collect();
    let mut starts = vec![0; group_count + 1];
    groups.iter().flatten().for_each(|&group| starts[group as usize + 1] += 1);
    for group in 0..group_count {
        starts[group + 1] += starts[group];
    }
    let mut next = starts.clone();
    let mut elements = vec![0; starts[group_count] as usize];
    for (element, &group) in (0..).zip(&groups) {
        if let Some(group) = group {
            elements[next[group as usize] as usize] = element;
            next[group as usize] += 1;
        }
    }
    (starts, elements)
}

fn first(rows: &[u32; 6]) -> u32 {
    rows.iter().copied().fold(NONE, u32::min)
}

/// Collects the rows from one on, each of them once.
struct RowsFrom {
    end: u32,
    /// For each row the end for which it was collected last.
    seen: Vec<u32>,
    /// Those that it began with, in ascending order.
    first: Vec<u32>,
    /// The others, in no order, as keys.
    others: Vec<(u64, u32)>,
}

impl RowsFrom {
    fn of(row_count: usize) -> Self {
        Self { end: 0, seen: vec![NONE; row_count], first: Vec::new(), others: Vec::new() }
    }

    /// Begins with rows that ascend.
    fn start(&mut self, end: u32, rows: &[u32]) {
        self.end = end;
        self.others.clear();
        self.first.clear();
        self.first.extend_from_slice(&rows[rows.partition_point(|&row| row < end)..]);
        self.first.iter().for_each(|&row| self.seen[row as usize] = end);
    }

    fn add(&mut self, rows: &[u32]) {
        for &row in rows.iter().filter(|&&row| row >= self.end) {
            if let Some(seen) = self.seen.get_mut(row as usize).filter(|seen| **seen != self.end) {
                *seen = self.end;
                self.others.push((row.into(), 0));
            }
        }
    }

    /// Appends all of them to a list, in ascending order.
    fn append_to(&mut self, list: &mut Vec<u32>) {
        sort::sort(&mut self.others);
        let mut first = self.first.iter().copied().peekable();
        for row in self.others.iter().map(|&(row, _)| row as u32) {
            list.extend(iter::from_fn(|| first.next_if(|&before| before < row)));
            list.push(row);
        }
        list.extend(first);
    }
}

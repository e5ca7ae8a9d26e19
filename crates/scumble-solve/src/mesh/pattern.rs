//! Which unknowns a sparse factor eliminates together, and what each elimination touches, whichever are fixed later.
//!
//! It is found once for a mesh, or for the elements of a stroke, for all unknowns. To fix some, or to take couplings away, takes entries away from a factor and
//! adds none: so the rest of the pattern does for what is left. It has a few entries more than need be.

use std::ops::Range;
use std::{iter, mem};

use scumble_core::{pace, sort};

use super::dofs::NONE;
use super::substitution::column_count;

/// A group takes in a child where that makes at most so many columns of tiles more: what they take at each solution, a group
/// takes besides.
const COLUMNS_PER_GROUP: usize = 8;

/// So many unknowns are sorted in the time that a group takes besides.
const KEYS: usize = 8;

/// So many groups take a millisecond at most.
const WORK: usize = 2048;

/// Groups of successive unknowns that are eliminated together, children before parents.
#[derive(Debug, Default)]
pub(super) struct Pattern {
    groups: Vec<Group>,
    boundaries: Vec<u32>,
}

/// One of them. The group that has the first unknown of its boundary is its parent.
#[derive(Clone, Debug)]
struct Group {
    unknowns: Range<u32>,
    /// Where its *boundary* is in the list of all: the later unknowns that its own are coupled to by then.
    boundary: Range<u32>,
}

impl Pattern {
    /// That of elements with so many unknowns each; [`NONE`] is none. Those that end before each of some strictly ascending numbers are in
    /// one group; the last of these is the number of unknowns.
    pub(super) fn new(elements: &[[u32; 6]], ends: &[u32]) -> Self {
        let mut tree = Tree::new(elements, ends);
        while tree.go_on() {}
        tree.pattern
    }

    /// The unknowns of each group and its boundary, both in ascending order.
    pub(super) fn groups(&self) -> impl ExactSizeIterator<Item = (Range<u32>, &[u32])> {
        self.groups.iter().map(|group| (group.unknowns.clone(), self.boundary(group)))
    }

    fn boundary(&self, group: &Group) -> &[u32] {
        &self.boundaries[group.boundary.start as usize..group.boundary.end as usize]
    }

    /// Number of the unknowns of all groups.
    pub(super) fn unknown_count(&self) -> usize {
        self.groups.last().map_or(0, |last| last.unknowns.end as usize)
    }

    /// Begins another group after the last one.
    pub(super) fn begin(&mut self) {
        let (start, boundary_start) = (self.unknown_count() as u32, self.boundaries.len() as u32);
        let boundary = boundary_start..boundary_start;
        self.groups.push(Group { unknowns: start..start, boundary });
    }

    /// Adds an unknown to the last group, and says which it is.
    pub(super) fn add_unknown(&mut self) -> u32 {
        let Some(last) = self.groups.last_mut() else { return NONE };
        last.unknowns.end += 1;
        last.unknowns.end - 1
    }

    /// Adds to the boundary of the last group.
    pub(super) fn add_to_boundary(&mut self, unknown: u32) {
        if let Some(last) = self.groups.last_mut() {
            last.boundary.end += 1;
            self.boundaries.push(unknown);
        }
    }

    /// Gives other numbers to the unknowns in boundaries.
    pub(super) async fn renumber_boundaries(&mut self, number_of: impl Fn(u32) -> u32) {
        let renumber = |some: &mut [u32]| some.iter_mut().for_each(|unknown| *unknown = number_of(*unknown));
        pace::for_each(self.boundaries.chunks_mut(KEYS), renumber).await;
    }
}

/// A pattern while it is found.
pub(super) struct Tree<'a> {
    elements: &'a [[u32; 6]],
    /// Where the groups end that are not merged yet.
    ends: &'a [u32],
    group_of: Vec<u32>,
    of_group: ByGroup,
    children: Children,
    collected: Collected,
    /// How many of the groups that are not merged yet have been looked at.
    count: usize,
    pub(super) pattern: Pattern,
}

impl<'a> Tree<'a> {
    /// Of what [`Pattern::new`] takes, with no group yet.
    pub(super) fn new(elements: &'a [[u32; 6]], ends: &'a [u32]) -> Self {
        debug_assert!(ends.is_sorted_by(|before, after| before < after));
        let group_of = group_of(ends);
        Self {
            elements,
            ends,
            of_group: ByGroup::new(elements, &group_of, ends.len()),
            children: Children::of(ends.len()),
            collected: Collected::of(group_of.len()),
            group_of,
            count: 0,
            pattern: Pattern::default(),
        }
    }

    /// Finds more groups, as many as take a millisecond at most, and tells whether there may be more.
    pub(super) fn go_on(&mut self) -> bool {
        let mut work = 0;
        while work < WORK && self.count < self.ends.len() {
            work += 1 + self.add_group() / KEYS;
        }
        work >= WORK
    }

    /// Adds the next group, and says how long its boundary is.
    fn add_group(&mut self) -> usize {
        let mut group = self.next_group();
        while let Some(larger) = self.pattern.groups.last().and_then(|child| self.merged(&group, child)) {
            group = larger;
            self.pattern.groups.pop();
            self.children.take_back();
        }
        let parent = self.pattern.boundary(&group).first().map(|&first| self.group_of[first as usize]);
        self.children.add(parent);
        self.count += 1;
        self.push(group)
    }

    /// The next group; its boundary is appended to those that there are.
    fn next_group(&mut self) -> Group {
        let (start, boundary_start) =
            (self.pattern.unknown_count() as u32, self.pattern.boundaries.len() as u32);
        let end = self.ends[self.count];
        let boundary = |child: usize| self.pattern.boundary(&self.pattern.groups[child]);
        let boundaries = || self.children.of_parent(self.count).map(boundary);
        let longest = boundaries().max_by_key(|boundary| boundary.len()).unwrap_or_default();
        self.collected.start(end, longest);
        for &element in self.of_group.of(self.count) {
            self.collected.add(&self.elements[element as usize]);
        }
        boundaries().for_each(|boundary| self.collected.add(boundary));
        self.collected.append_to(&mut self.pattern.boundaries);
        let boundary = boundary_start..self.pattern.boundaries.len() as u32;
        Group { unknowns: start..end, boundary }
    }

    /// A group with a child that comes right before it, where that makes few columns more.
    fn merged(&self, group: &Group, child: &Group) -> Option<Group> {
        if !self.pattern.boundary(child).first().is_some_and(|first| group.unknowns.contains(first)) {
            return None;
        }
        let merged = Group { unknowns: child.unknowns.start..group.unknowns.end, ..group.clone() };
        let most = group.column_count() + child.column_count() + COLUMNS_PER_GROUP;
        Some(merged).filter(|merged| merged.column_count() <= most)
    }

    /// Adds a group in place of those that it took in, and says how long its boundary is.
    fn push(&mut self, group: Group) -> usize {
        let start = self.pattern.groups.last().map_or(0, |last| last.boundary.end);
        let end = start + group.boundary.len() as u32;
        let from = group.boundary.start as usize..group.boundary.end as usize;
        self.pattern.boundaries.copy_within(from, start as usize);
        self.pattern.boundaries.truncate(end as usize);
        self.pattern.groups.push(Group { boundary: start..end, ..group });
        group.boundary.len()
    }
}

impl Group {
    /// Number of columns of tiles if none of its unknowns is fixed.
    fn column_count(&self) -> usize {
        column_count(self.unknowns.len(), self.boundary.len())
    }
}

/// Which groups have which parent, each a list from the last one on.
#[derive(Debug)]
pub(super) struct Children {
    last: Vec<u32>,
    /// Of each group that has been added, the one before it in its list.
    before: Vec<u32>,
}

impl Children {
    /// Of so many groups, none of which has been added.
    pub(super) fn of(count: usize) -> Self {
        Self { last: vec![NONE; count], before: Vec::with_capacity(count) }
    }

    /// Adds the next group as a child of another, if of any.
    pub(super) fn add(&mut self, parent: Option<u32>) {
        let group = self.before.len() as u32;
        let last = parent.and_then(|parent| self.last.get_mut(parent as usize));
        self.before.push(last.map_or(NONE, |last| mem::replace(last, group)));
    }

    /// Takes the last one back that was added. Its parent is not asked for any more.
    fn take_back(&mut self) {
        self.before.pop();
    }

    pub(super) fn of_parent(&self, group: usize) -> impl Iterator<Item = usize> {
        let some = |group: u32| Some(group as usize).filter(|_| group != NONE);
        iter::successors(some(self.last[group]), move |&child| some(self.before[child]))
    }
}

/// The group of each unknown.
pub(super) fn group_of(ends: &[u32]) -> Vec<u32> {
    let mut group_of = Vec::with_capacity(ends.last().map_or(0, |&end| end as usize));
    for (group, &end) in (0..).zip(ends) {
        group_of.resize(end as usize, group);
    }
    group_of
}

/// The elements by the groups of their first unknowns.
#[derive(Debug)]
pub(super) struct ByGroup {
    /// Where those of each group begin, and where the last ones end.
    starts: Vec<u32>,
    list: Vec<u32>,
}

impl ByGroup {
    pub(super) fn new(elements: &[[u32; 6]], group_of: &[u32], group_count: usize) -> Self {
        let first = |unknowns: &[u32; 6]| unknowns.iter().copied().fold(NONE, u32::min);
        let groups: Vec<_> = elements.iter().map(|own| group_of.get(first(own) as usize).copied()).collect();
        let mut starts = vec![0; group_count + 1];
        groups.iter().flatten().for_each(|&group| starts[group as usize + 1] += 1);
        for group in 0..group_count {
            starts[group + 1] += starts[group];
        }
        let mut next = starts.clone();
        let mut list = vec![0; starts[group_count] as usize];
        for (element, &group) in (0..).zip(&groups) {
            if let Some(group) = group {
                list[next[group as usize] as usize] = element;
                next[group as usize] += 1;
            }
        }
        Self { starts, list }
    }

    pub(super) fn of(&self, group: usize) -> &[u32] {
        &self.list[self.starts[group] as usize..self.starts[group + 1] as usize]
    }
}

/// Collects the unknowns from one on, each of them once.
struct Collected {
    end: u32,
    /// For each unknown the end for which it was collected last.
    seen: Vec<u32>,
    /// Those that it began with, in ascending order.
    first: Vec<u32>,
    /// The others, in no order, as keys.
    others: Vec<(u64, u32)>,
}

impl Collected {
    fn of(unknown_count: usize) -> Self {
        Self { end: 0, seen: vec![NONE; unknown_count], first: Vec::new(), others: Vec::new() }
    }

    /// Begins with unknowns that ascend.
    fn start(&mut self, end: u32, unknowns: &[u32]) {
        self.end = end;
        self.others.clear();
        self.first.clear();
        self.first.extend_from_slice(&unknowns[unknowns.partition_point(|&unknown| unknown < end)..]);
        self.first.iter().for_each(|&unknown| self.seen[unknown as usize] = end);
    }

    fn add(&mut self, unknowns: &[u32]) {
        for &unknown in unknowns.iter().filter(|&&unknown| unknown >= self.end) {
            if let Some(seen) = self.seen.get_mut(unknown as usize).filter(|seen| **seen != self.end) {
                *seen = self.end;
                self.others.push((unknown.into(), 0));
            }
        }
    }

    /// Appends all of them to a list, in ascending order.
    fn append_to(&mut self, list: &mut Vec<u32>) {
        sort::sort(&mut self.others);
        let mut first = self.first.iter().copied().peekable();
        for unknown in self.others.iter().map(|&(unknown, _)| unknown as u32) {
            list.extend(iter::from_fn(|| first.next_if(|&before| before < unknown)));
            list.push(unknown);
        }
        list.extend(first);
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// Of each of so many unknowns of elements, the later ones that it is coupled to once those before it are eliminated.
    fn eliminated(elements: &[[u32; 6]], count: u32) -> Vec<BTreeSet<u32>> {
        let mut later: Vec<BTreeSet<u32>> = (0..count)
            .map(|unknown| {
                let own = elements.iter().filter(|own| own.contains(&unknown));
                own.flatten().copied().filter(|other| (unknown + 1..count).contains(other)).collect()
            })
            .collect();
        for unknown in 0..later.len() {
            for other in later[unknown].clone() {
                let beyond: Vec<_> = later[unknown].range(other + 1..).copied().collect();
                later[other as usize].extend(beyond);
            }
        }
        later
    }

    #[test]
    fn a_group_takes_in_a_child_where_that_makes_few_columns_more_and_only_there() {
        let side: u32 = 8;
        let corner = |x: u32, y: u32| (x * 9 + y * 37) % 81;
        let elements: Vec<_> = (0..side * side)
            .map(|i| [i % side, i / side])
            .map(|[x, y]| {
                [corner(x, y), corner(x + 1, y), corner(x, y + 1), corner(x + 1, y + 1), NONE, NONE]
            })
            .collect();
        let later = eliminated(&elements, 81);
        let ends: Vec<_> = (1..=81).collect();
        let pattern = Pattern::new(&elements, &ends);
        let groups: Vec<_> = pattern.groups().collect();
        assert!((2..81).contains(&groups.len()), "{} groups", groups.len());
        for (own, boundary) in &groups {
            assert!(later[own.end as usize - 1].iter().eq(*boundary), "{own:?}");
        }
        let columns = |own: &Range<u32>, boundary: &[u32]| column_count(own.len(), boundary.len());
        let single: usize = later.iter().map(|later| column_count(1, later.len())).sum();
        let ours: usize = groups.iter().map(|(own, boundary)| columns(own, boundary)).sum();
        assert!(
            ours <= single + COLUMNS_PER_GROUP * (81 - groups.len()),
            "{ours} columns, {single} one by one"
        );
        for both in groups.windows(2) {
            let (child, group) = (&both[0], &both[1]);
            let is_child = child.1.first().is_some_and(|first| group.0.contains(first));
            let both = columns(&child.0, child.1) + columns(&group.0, group.1);
            let merged = columns(&(child.0.start..group.0.end), group.1);
            assert!(!is_child || merged > both + COLUMNS_PER_GROUP, "{child:?} and {group:?}");
        }
    }
}

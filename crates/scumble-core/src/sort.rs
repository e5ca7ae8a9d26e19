//! Sorting by whole numbers, all with one routine: the standard library's has some 5 KB of code for each type and each
//! comparison that it is used with, which every visitor of the page would load.

/// Sorts keys, each with what comes with it; that decides between equal keys.
#[inline(never)]
pub fn sort(keys: &mut [(u64, u32)]) {
    keys.sort_unstable();
}

/// Sorts items by their keys; those with equal keys stay in their order.
pub fn sort_by_key<T>(items: &mut Vec<T>, key: impl Fn(&T) -> u64) {
    let mut order: Vec<(u64, u32)> = items.iter().map(key).zip(0..).collect();
    sort(&mut order);
    let mut unsorted: Vec<Option<T>> = items.drain(..).map(Some).collect();
    items.extend(order.iter().filter_map(|&(_, i)| unsorted[i as usize].take()));
}

/// The same for items that are cheap to copy, with less code for each type.
pub fn sort_copies_by_key<T: Copy>(items: &mut Vec<T>, key: impl Fn(&T) -> u64) {
    let mut order: Vec<(u64, u32)> = items.iter().map(key).zip(0..).collect();
    sort(&mut order);
    *items = order.iter().map(|&(_, i)| items[i as usize]).collect();
}

/// Sorts numbers and drops repeats.
pub fn sort_unique(numbers: &mut Vec<u32>) {
    sort_copies_by_key(numbers, |&number| number.into());
    numbers.dedup();
}

/// The key that sorts by the first of two numbers, then by the second.
pub fn pair([a, b]: [u32; 2]) -> u64 {
    u64::from(a) << 32 | u64::from(b)
}

/// The key that sorts as [`f64::total_cmp`] does.
pub fn float(x: f64) -> u64 {
    let bits = x.to_bits();
    if x.is_sign_negative() { !bits } else { bits | 1 << 63 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_keys_keep_their_order() {
        let mut items = vec!["bb", "a", "cc", "dd", "e"];
        sort_by_key(&mut items, |item| item.len() as u64);
        assert_eq!(items, ["a", "e", "bb", "cc", "dd"]);
    }

    #[test]
    fn pairs_sort_by_the_first_then_the_second() {
        let pairs = [[0, 1], [0, u32::MAX], [1, 0], [u32::MAX, 0]];
        assert!(pairs.map(pair).is_sorted());
    }

    #[test]
    fn floats_sort_by_total_order() {
        let floats = [f64::NEG_INFINITY, -2.0, -1.0, -0.0, 0.0, 1e-300, 2.0, f64::INFINITY, f64::NAN];
        assert!(floats.is_sorted_by(|a, b| a.total_cmp(b).is_lt()));
        assert!(floats.map(float).is_sorted_by(|a, b| a < b));
    }
}

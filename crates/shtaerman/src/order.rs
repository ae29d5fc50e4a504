//! Things in the order of a number of each.

/// Sorts by a number of each item; those with equal numbers stay as they were.
///
/// The standard library's sort is some twenty kilobytes of code for each kind of item: here one serves them all.
pub(crate) fn sort_by_number<T: Copy>(items: &mut [T], number: impl Fn(&T) -> f64) {
    let numbers: Vec<f64> = items.iter().map(number).collect();
    let sorted: Vec<T> = order(&numbers).into_iter().map(|index| items[index]).collect();
    items.copy_from_slice(&sorted);
}

/// The same numbers in their order, each once.
pub(crate) fn ascending(numbers: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let mut numbers: Vec<f64> = numbers.into_iter().collect();
    numbers.sort_by(f64::total_cmp);
    numbers.dedup();
    numbers
}

/// The parts into which places between them, from left to right, cut an interval.
pub(crate) fn parts([left, right]: [f64; 2], at: impl Iterator<Item = f64>) -> Vec<[f64; 2]> {
    let ends: Vec<f64> = [left].into_iter().chain(at).chain([right]).collect();
    ends.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// The same by places in order, of which some lie beyond it, and without pieces of rounding's length, which have no inside.
pub(crate) fn panels([left, right]: [f64; 2], breaks: &[f64]) -> Vec<[f64; 2]> {
    let apart = 1e-13 * (right - left) + 4.0 * f64::EPSILON;
    let inside = |at: &f64| *at > left + apart && *at < right - apart;
    parts([left, right], breaks.iter().copied().filter(inside))
}

/// Of items in order of their first number the one that is nearest to a place by that.
pub(crate) fn nearest(items: &[[f64; 2]], place: f64) -> Option<[f64; 2]> {
    let after = items.partition_point(|item| item[0] < place);
    let beside = items.iter().skip(after.saturating_sub(1)).take(2);
    let distance = |item: &[f64; 2]| (item[0] - place).abs();
    beside.min_by(|one, two| distance(one).total_cmp(&distance(two))).copied()
}

/// Indices of numbers, the smallest first.
fn order(numbers: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..numbers.len()).collect();
    order.sort_by(|one, two| numbers[*one].total_cmp(&numbers[*two]));
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_numbers_keep_their_order() {
        let mut items = [(2.0, 'a'), (1.0, 'b'), (2.0, 'c'), (-0.0, 'd'), (0.0, 'e'), (1.0, 'f')];
        sort_by_number(&mut items, |item| item.0);
        assert_eq!(items.map(|item| item.1), ['d', 'e', 'b', 'f', 'a', 'c']);
        sort_by_number(&mut items, |item| -item.0);
        assert_eq!(items.map(|item| item.1), ['a', 'c', 'b', 'f', 'e', 'd']);
    }
}

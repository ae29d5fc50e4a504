//! Sets of intervals.

/// Intervals shorter than this share of the longest are none (survey).
pub(crate) const SLIVER: f64 = 1e-9;

/// The union of intervals, from left to right, without slivers.
pub(crate) fn joined(mut intervals: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    crate::order::sort_by_number(&mut intervals, |one| one[0]);
    let mut joined: Vec<[f64; 2]> = Vec::new();
    for interval in intervals {
        match joined.last_mut() {
            Some(last) if interval[0] <= last[1] => last[1] = last[1].max(interval[1]),
            _ => joined.push(interval),
        }
    }
    let longest = joined.iter().fold(0.0f64, |most, [left, right]| most.max(right - left));
    joined.retain(|[left, right]| right - left > SLIVER * longest);
    joined
}

/// The middle of the longest gap of a wave that is one with its images; none where none is longer than this.
pub(crate) fn longest_gap(intervals: &[[f64; 2]], least: f64) -> Option<f64> {
    let [.., last] = intervals else { return None };
    let mut before = last[1] - 2.0;
    let gaps =
        intervals.iter().map(|[left, right]| [std::mem::replace(&mut before, *right), *left]);
    let longest = gaps.max_by(|one, two| (one[1] - one[0]).total_cmp(&(two[1] - two[0])))?;
    (longest[1] - longest[0] > least).then(|| 0.5 * (longest[0] + longest[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_meets_is_one_and_slivers_go() {
        let intervals = vec![[0.5, 1.0], [-1.0, 0.0], [0.9, 1.5], [0.2, 0.2 + 1e-12], [1.5, 2.0]];
        assert_eq!(joined(intervals), [[-1.0, 0.0], [0.5, 2.0]]);
        assert!(joined(Vec::new()).is_empty());
    }
}

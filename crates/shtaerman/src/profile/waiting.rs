//! Parts of a base in the order in which a search takes them.

use std::cmp::Ordering;

use crate::expression::Interval;

/// A part that waits for its turn, the one with the highest rank first, of equal ones the leftmost.
pub(super) struct Waiting {
    pub(super) rank: f64,
    pub(super) part: Interval,
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Waiting {}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_rank = self.rank.total_cmp(&other.rank);
        by_rank.then(other.part.lower().total_cmp(&self.part.lower()))
    }
}

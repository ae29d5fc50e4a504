//! The zones of contact.

use crate::Error;
use crate::contact::intervals::joined;

/// A zone of contact, `[left, right]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Zone {
    /// Left and right end, `xi`.
    pub(super) ends: [f64; 2],
    /// Which of them are free: the pressure vanishes there; at a wall it is singular.
    pub(super) is_free: [bool; 2],
}

impl Zone {
    pub(super) fn new(ends: [f64; 2], is_free: [bool; 2]) -> Self {
        Self { ends, is_free }
    }

    pub(super) fn left(&self) -> f64 {
        self.ends[0]
    }

    pub(super) fn right(&self) -> f64 {
        self.ends[1]
    }

    pub(super) fn length(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    /// The place next to `xi` strictly inside, where at a step the height is that of this side; of a zone that no number is inside of, an end or beside it.
    pub(super) fn inside(&self, xi: f64) -> f64 {
        xi.max(self.left().next_up()).min(self.right().next_down())
    }

    pub(super) fn contains(&self, xi: f64) -> bool {
        self.ends[0] <= xi && xi <= self.ends[1]
    }

    /// What is left of the zone without the intervals where the pressure pulls.
    fn without(&self, pulling: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let [start, right] = self.ends;
        let mut left = start;
        let mut kept = Vec::new();
        for &[from, to] in pulling.iter().filter(|[from, to]| *to > start && *from < right) {
            if from > left {
                kept.push([left, from]);
            }
            left = left.max(to);
        }
        if left < right {
            kept.push([left, right]);
        }
        kept
    }
}

/// Refuses more zones than `most`: their equations are dense.
pub(super) fn require_few(zones: &[Zone], most: usize) -> Result<(), Error> {
    let zones = zones.len();
    if zones > most { Err(Error::TooManyZones { zones, most }) } else { Ok(()) }
}

/// Intervals of contact without those where the pressure pulls, and with those where the base penetrates; from left to right, slivers left to the next check.
pub(super) fn corrected(
    zones: &[Zone],
    pulling: &[[f64; 2]],
    penetrating: &[[f64; 2]],
) -> Vec<[f64; 2]> {
    let mut intervals: Vec<[f64; 2]> = zones.iter().flat_map(|z| z.without(pulling)).collect();
    intervals.extend(penetrating);
    joined(intervals)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inside_of_a_zone_without_one_is_beside_its_ends() {
        let zone = Zone::new([0.5, 1.0], [true; 2]);
        assert_eq!(
            [0.2, 0.7, 1.5].map(|xi| zone.inside(xi)),
            [0.5f64.next_up(), 0.7, 1.0f64.next_down()]
        );
        let sliver = Zone::new([0.5, 0.5f64.next_up()], [true; 2]);
        assert!((sliver.inside(0.5) - 0.5).abs() <= f64::EPSILON);
    }

    #[test]
    fn intervals_are_split_and_joined() {
        let zones = [[-1.0, 0.0], [0.5, 1.0]].map(|ends| Zone::new(ends, [true; 2]));
        assert_eq!(
            corrected(&zones, &[[-0.5, -0.25]], &[]),
            [[-1.0, -0.5], [-0.25, 0.0], [0.5, 1.0]]
        );
        assert_eq!(corrected(&zones, &[], &[[0.0, 0.5]]), [[-1.0, 1.0]]);
        assert_eq!(corrected(&zones, &[[-1.0, 0.0]], &[[0.2, 0.3]]), [[0.2, 0.3], [0.5, 1.0]]);
    }
}

//! The zones of contact.

use crate::contact::intervals::joined;

/// One end of a zone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct End {
    /// `xi`.
    pub(super) at: f64,
    /// Whether the pressure vanishes there; at a corner it need not.
    pub(super) is_free: bool,
}

/// A zone of contact, `[left, right]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Zone {
    pub(super) ends: [End; 2],
}

impl Zone {
    pub(super) fn new(left: f64, right: f64) -> Self {
        Self { ends: [left, right].map(|at| End { at, is_free: at.abs() < 1.0 }) }
    }

    pub(super) fn left(&self) -> f64 {
        self.ends[0].at
    }

    pub(super) fn right(&self) -> f64 {
        self.ends[1].at
    }

    pub(super) fn length(&self) -> f64 {
        self.right() - self.left()
    }

    /// The panels into which breakpoints cut the zone.
    pub(super) fn panels(&self, breaks: &[f64]) -> Vec<(f64, f64)> {
        // A piece of rounding's length has no inside.
        let apart = 1e-13 * self.length() + 4.0 * f64::EPSILON;
        let inside = |at: &&f64| **at > self.left() + apart && **at < self.right() - apart;
        let mut cuts = vec![self.left()];
        cuts.extend(breaks.iter().filter(inside));
        cuts.push(self.right());
        cuts.windows(2).map(|pair| (pair[0], pair[1])).collect()
    }
}

/// A penetration this close to a zone, and this short, as shares of the zone, is that of an edge which is not quite right.
const BESIDE: f64 = 1e-3;
const SHORT: f64 = 1e-2;

/// Extends a zone over a short penetration beside it; whether there was one.
fn extended(intervals: &mut [[f64; 2]], [from, to]: [f64; 2]) -> bool {
    for interval in intervals {
        let length = interval[1] - interval[0];
        let gap = (from - interval[1]).max(interval[0] - to);
        if gap <= BESIDE * length && to - from <= SHORT * length {
            *interval = [interval[0].min(from), interval[1].max(to)];
            return true;
        }
    }
    false
}

/// The zones without the intervals where the pressure pulls, and with those where the base penetrates, both from left to right; slivers are left to the next check.
pub(super) fn corrected(
    zones: &[Zone],
    pulling: &[[f64; 2]],
    penetrating: &[[f64; 2]],
) -> Vec<Zone> {
    let mut intervals: Vec<[f64; 2]> = Vec::new();
    for zone in zones {
        let mut left = zone.left();
        for &[from, to] in
            pulling.iter().filter(|[from, to]| *to > zone.left() && *from < zone.right())
        {
            if from > left {
                intervals.push([left, from]);
            }
            left = to;
        }
        if left < zone.right() {
            intervals.push([left, zone.right()]);
        }
    }
    for interval in penetrating {
        if !extended(&mut intervals, *interval) {
            intervals.push(*interval);
        }
    }
    joined(intervals).into_iter().map(|[left, right]| Zone::new(left, right)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zones_are_split_and_joined() {
        let zones = [Zone::new(-1.0, 0.0), Zone::new(0.5, 1.0)];
        let ends = |zones: Vec<Zone>| -> Vec<[f64; 2]> {
            zones.iter().map(|zone| [zone.left(), zone.right()]).collect()
        };
        assert_eq!(
            ends(corrected(&zones, &[[-0.5, -0.25]], &[])),
            [[-1.0, -0.5], [-0.25, 0.0], [0.5, 1.0]]
        );
        assert_eq!(ends(corrected(&zones, &[], &[[0.0, 0.5]])), [[-1.0, 1.0]]);
        assert_eq!(
            ends(corrected(&zones, &[[-1.0, 0.0]], &[[0.2, 0.3]])),
            [[0.2, 0.3], [0.5, 1.0]]
        );
        // An edge that was a little off.
        let nearly = corrected(&zones, &[[-1e-4, 0.0]], &[[1e-9, 2e-4]]);
        assert_eq!(ends(nearly), [[-1.0, 2e-4], [0.5, 1.0]]);
        assert!(!Zone::new(-1.0, 0.5).ends[0].is_free && Zone::new(-1.0, 0.5).ends[1].is_free);
    }

    #[test]
    fn breakpoints_cut_zones() {
        let zone = Zone::new(-0.5, 0.5);
        assert_eq!(zone.panels(&[-0.7, 0.0, 0.5]), [(-0.5, 0.0), (0.0, 0.5)]);
    }
}

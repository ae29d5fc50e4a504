//! Where a base has to be cut so that polynomials resolve it, proved by bounds of derivatives between all samples.
//!
//! Interpolation at `n` Chebyshev points on an interval of half-length `r` is off by at most `2 (r/2)^n max |f^(n)|/n!`. The base is halved until that
//! is small enough for some `n` on every part, and parts are joined again as long as it stays so.

mod parts;
mod search;

#[cfg(test)]
mod tests;

use super::base::{Profile, Shape};
use super::resolved::{Asked, Resolution};
use crate::expression::Interval;
use parts::Partition;
use search::{Leaf, Search};

/// Most joints besides the switches.
const MOST_JOINTS: usize = 512;

/// Cuts this close are the same but for rounding.
const NEAR: f64 = 256.0 * f64::EPSILON;

impl Profile {
    /// Finds where the pieces of a base, given by their ends in `xi`, have to be cut so that polynomials of a degree (at least 4) resolve the
    /// profile of a punch of half-width `a` to a tolerance relative to the range of its heights on them.
    ///
    /// The joints of a measured profile are its points, those of a closure its breaks: of these nothing is proved. Of an expression it is proved, so that no feature between samples is missed: a narrow dent
    /// gives joints beside it, a smooth profile none. The work is bounded (2000 enclosures of Taylor coefficients, fewer for long expressions); what is
    /// not resolved with it is listed, as is all of `cos(1e7*xi)`.
    ///
    /// ```
    /// let smooth = shtaerman::Profile::expression("xi^2 + exp(xi)")?;
    /// assert_eq!(smooth.resolve(&[[-1.0, 1.0]], 1.0, 64, 1e-12), Default::default());
    ///
    /// let dent = shtaerman::Profile::expression("xi^2 + 0.01*exp(-((xi - 0.1234)/1e-5)^2)")?;
    /// let found = dent.resolve(&[[-1.0, 1.0]], 1.0, 64, 1e-12);
    /// assert!(found.is_complete() && found.singular.is_empty());
    /// let beside = |side: f64| found.joints.iter().any(|xi| (0.0..1e-3).contains(&(side * (xi - 0.1234))));
    /// assert!(beside(-1.0) && beside(1.0) && found.joints.len() < 20);
    /// # Ok::<(), shtaerman::expression::ExpressionError>(())
    /// ```
    #[must_use]
    pub fn resolve(
        &self,
        pieces: &[[f64; 2]],
        half_width: f64,
        degree: usize,
        tolerance: f64,
    ) -> Resolution {
        match &self.shape {
            Shape::Flat => Resolution::default(),
            Shape::Measured(_) | Shape::Function(_) => {
                let is_inside =
                    |xi: &f64| pieces.iter().any(|[left, right]| left < xi && xi < right);
                let joints = self.joints(half_width).into_iter().filter(is_inside).collect();
                Resolution { joints, ..Resolution::default() }
            }
            Shape::Expression(expression) => {
                let search = Search::new(self, half_width, degree.max(4), expression.length());
                let find = || self.resolve_expression(pieces, &search, tolerance);
                let asked = Asked { pieces: pieces.to_vec(), half_width, degree, tolerance };
                self.resolved.known_or(asked, find)
            }
        }
    }

    fn resolve_expression(
        &self,
        pieces: &[[f64; 2]],
        search: &Search<'_>,
        tolerance: f64,
    ) -> Resolution {
        let segments = segments(pieces, &self.breakpoints(search.half_width));
        let goal = search.goal(&segments, tolerance);
        let leaves = search.leaves(&segments, goal);
        let mut found = partition(search, &segments, &leaves, goal.allowed);
        if !found.joints.is_empty() {
            found = partition(search, &segments, &search.quartered(leaves), goal.allowed);
        }
        if found.joints.len() > MOST_JOINTS {
            found = Resolution { unresolved: pieces.to_vec(), ..Resolution::default() };
        }
        let ends: Vec<f64> = pieces.iter().flatten().copied().collect();
        let starts = segments.iter().map(|segment| segment.lower());
        let switches: Vec<f64> = starts.filter(|xi| !ends.contains(xi)).collect();
        found.keep_apart(&ends, &switches);
        found
    }
}

impl Resolution {
    /// Adds the switches to the joints; of cuts within rounding of each other one is left.
    fn keep_apart(&mut self, ends: &[f64], switches: &[f64]) {
        self.singular.sort_by(f64::total_cmp);
        self.singular.dedup();
        self.joints.sort_by(f64::total_cmp);
        let is_near = |u: f64, places: &[f64]| places.iter().any(|v| (u - v).abs() <= NEAR);
        let fixed: Vec<f64> = switches
            .iter()
            .chain(&self.singular)
            .copied()
            .filter(|&place| switches.contains(&place) || !is_near(place, switches))
            .filter(|&place| !is_near(place, ends))
            .collect();
        self.joints.retain(|&xi| !is_near(xi, ends) && !is_near(xi, &fixed));
        self.joints.dedup_by(|later, earlier| *later - *earlier <= NEAR);
        self.joints.extend(fixed);
        self.joints.sort_by(f64::total_cmp);
        self.joints.dedup();
    }
}

/// The cuts of the segments that are made of these parts.
fn partition(
    search: &Search<'_>,
    segments: &[Interval],
    leaves: &[Leaf],
    allowed: f64,
) -> Resolution {
    let mut partition = Partition::new(search, allowed);
    for segment in segments {
        let first = leaves.partition_point(|leaf| leaf.part.lower() < segment.lower());
        let end = leaves.partition_point(|leaf| leaf.part.lower() < segment.upper());
        partition.add(*segment, &leaves[first..end]);
    }
    partition.finish()
}

/// The pieces cut at the switches.
fn segments(pieces: &[[f64; 2]], switches: &[f64]) -> Vec<Interval> {
    let mut segments = Vec::new();
    for &[left, right] in pieces {
        let inside = switches.iter().copied().filter(|&xi| left < xi && xi < right);
        let cuts: Vec<f64> = [left].into_iter().chain(inside).chain([right]).collect();
        segments.extend(cuts.windows(2).filter_map(|ends| Interval::new(ends[0], ends[1])));
    }
    segments
}

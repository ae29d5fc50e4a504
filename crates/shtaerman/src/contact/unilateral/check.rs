//! Complementarity between the nodes: where the answer pulls and where the base penetrates.

use super::base::Base;
use super::solved::Solved;
use crate::contact::potential::between_nodes;

/// Points of a panel and of an interval outside the zones, at least.
const POINTS: usize = 48;
/// The outermost points, as a share of the interval: at a step of the base the height is that of this side.
const INSIDE: f64 = 1e-12;

/// What is left of tension and penetration.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Check {
    /// Largest tension over the largest pressure.
    pub(super) tension: f64,
    /// Largest penetration over the largest elastic displacement or depth.
    pub(super) penetration: f64,
    /// Intervals of tension that are too large to be rounding.
    pub(super) pulling: Vec<[f64; 2]>,
    /// The same of penetration, with the deepest place in the middle.
    deepest: Vec<[f64; 3]>,
}

impl Check {
    /// Of what was not looked at.
    pub(super) fn none() -> Self {
        Self { tension: 0.0, penetration: 0.0, pulling: Vec::new(), deepest: Vec::new() }
    }

    /// Whether nothing is beyond rounding.
    pub(super) fn is_clean(&self) -> bool {
        self.pulling.is_empty() && self.deepest.is_empty()
    }

    /// The intervals of penetration, narrowed by a factor towards the deepest places.
    pub(super) fn penetrating(&self, width: f64) -> Vec<[f64; 2]> {
        let narrowed = |[left, deepest, right]: &[f64; 3]| {
            [deepest - width * (deepest - left), deepest + width * (right - deepest)]
        };
        self.deepest.iter().map(narrowed).collect()
    }
}

/// Tension and penetration beyond `allowed`, relative to their scales, and beyond rounding are listed for correction.
pub(super) fn check(base: &Base<'_>, solved: &Solved, allowed: f64) -> Check {
    // Of the layer, which shows how far it is from touching also where pressures are small.
    let largest = solved.deepest().max(f64::MIN_POSITIVE);
    let floor = 4.0 * solved.rounding();
    let mut check = Check::none();
    for panel in &solved.panels {
        let points = points(base, panel.left, panel.right);
        let (points, values) = with_tops(&points, |xi| -solved.layer(base, xi));
        check.tension = values.iter().fold(check.tension, |most, t| most.max(t / largest));
        let found = above(&points, &values, allowed * largest + floor);
        check.pulling.extend(found.into_iter().map(|[left, _, right]| [left, right]));
    }
    let depth = |xi: f64| solved.state.settlement - solved.state.tilt * xi - base.height(xi);
    // What is compared outside is of the size of its terms.
    let scale = largest
        + solved.state.settlement.abs()
        + solved.state.tilt.abs()
        + solved.solution.parameter()
            * solved.solution.potential().iter().fold(0.0f64, |most, u| most.max(u.abs()));
    for [left, right] in outside(base, solved) {
        let points = points(base, left, right);
        let (points, values) = with_tops(&points, |xi| depth(xi) - solved.displacement_outside(xi));
        check.penetration = values.iter().fold(check.penetration, |most, g| most.max(g / scale));
        check.deepest.extend(above(&points, &values, allowed * scale + floor));
    }
    check
}

/// The intervals of the base beside the zones.
pub(super) fn outside(base: &Base<'_>, solved: &Solved) -> Vec<[f64; 2]> {
    let mut intervals = Vec::new();
    for &[from, to] in &base.pieces {
        let mut left = from;
        for zone in solved.zones.iter().filter(|zone| zone.left() >= from && zone.right() <= to) {
            if zone.left() > left {
                intervals.push([left, zone.left()]);
            }
            left = zone.right();
        }
        if left < to {
            intervals.push([left, to]);
        }
    }
    intervals
}

/// Both ends of every part and points between, closer near the ends, dense enough for the samples of the profile.
fn points(base: &Base<'_>, left: f64, right: f64) -> Vec<f64> {
    let mut cuts = vec![left];
    cuts.extend(base.breaks.iter().filter(|at| **at > left && **at < right));
    cuts.push(right);
    let mut points: Vec<f64> = Vec::new();
    for pair in cuts.windows(2) {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        let samples = (half * base.samples.len() as f64 / 2.0) as usize;
        let reach = half * (1.0 - INSIDE);
        let between = between_nodes(POINTS.max(samples));
        points.extend(between.map(|y| (middle + reach * y).clamp(pair[0], pair[1])));
    }
    points.sort_by(f64::total_cmp);
    points
}

/// Values at points, with the top of the parabola through each three of which the middle one is the largest: what exceeds little may do so between the points only.
fn with_tops(points: &[f64], value: impl Fn(f64) -> f64) -> (Vec<f64>, Vec<f64>) {
    let values: Vec<f64> = points.iter().map(|&xi| value(xi)).collect();
    let mut found: Vec<(f64, f64)> = points.iter().copied().zip(values.iter().copied()).collect();
    for (x, v) in points.windows(3).zip(values.windows(3)) {
        if v[1] < v[0] || v[1] < v[2] {
            continue;
        }
        let [before, after] = [(v[1] - v[0]) / (x[1] - x[0]), (v[2] - v[1]) / (x[2] - x[1])];
        let curvature = (after - before) / (x[2] - x[0]);
        let top = 0.5 * (x[0] + x[1]) - 0.5 * before / curvature;
        if x[0] < top && top < x[2] && top != x[1] {
            found.push((top, value(top)));
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.into_iter().unzip()
}

/// The intervals around points where the values exceed a threshold, to halfway to the nearest points where they do not, with the place of the largest
/// value in the middle.
fn above(points: &[f64], values: &[f64], threshold: f64) -> Vec<[f64; 3]> {
    let mut intervals: Vec<[f64; 3]> = Vec::new();
    let (mut inside, mut largest) = (false, threshold);
    for i in 0..points.len() {
        let exceeds = values[i] > threshold;
        if exceeds && !inside {
            let left = if i == 0 { points[0] } else { 0.5 * (points[i - 1] + points[i]) };
            intervals.push([left, points[i], points[i]]);
            largest = threshold;
        }
        if exceeds && let Some(last) = intervals.last_mut() {
            last[2] = points.get(i + 1).map_or(points[i], |next| 0.5 * (points[i] + next));
            if values[i] > largest {
                (largest, last[1]) = (values[i], points[i]);
            }
        }
        inside = exceeds;
    }
    intervals
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A narrow top between points that are all below the threshold.
    #[test]
    fn tops_between_points_are_seen() {
        let points: Vec<f64> = (0..11).map(|i| f64::from(i) * 0.1).collect();
        let value = |x: f64| 1.0 - 400.0 * (x - 0.55).powi(2);
        let (points, values) = with_tops(&points, value);
        assert_eq!(above(&points[..5], &values[..5], 0.9).len(), 0);
        let found = above(&points, &values, 0.9);
        assert_eq!(found.len(), 1);
        assert!((found[0][1] - 0.55).abs() < 1e-12);
    }

    #[test]
    fn intervals_surround_what_exceeds() {
        let points = [0.0, 1.0, 2.0, 3.0, 4.0];
        assert_eq!(
            above(&points, &[1.0, 0.0, 0.0, 2.0, 3.0], 0.5),
            [[0.0, 0.0, 0.5], [2.5, 4.0, 4.0]]
        );
        assert!(above(&points, &[0.0; 5], 0.5).is_empty());
    }
}

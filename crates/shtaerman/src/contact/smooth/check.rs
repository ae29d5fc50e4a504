//! Complementarity between the nodes: where the answer pulls and where the base penetrates.

use std::f64::consts::PI;

use super::COARSELY_ALLOWED;
use super::problem::Base;
use super::system::{Place, Solved};

/// Points of a zone and of an interval outside the zones, at least and at most.
const POINTS: usize = 48;
const MOST_POINTS: usize = 1500;

/// What is left of tension and penetration.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Check {
    /// Largest tension over the largest pressure between the singular ends.
    pub(super) tension: f64,
    /// Largest penetration over the size of the displacements compared.
    pub(super) penetration: f64,
    /// The largest pressure between the singular ends.
    pub(super) largest: f64,
    /// Intervals of each that are too large to be rounding.
    pub(super) pulling: Vec<[f64; 2]>,
    pub(super) penetrating: Vec<[f64; 2]>,
}

/// Tension and penetration beyond `allowed`, relative to their scales, are listed for correction.
pub(super) fn check(base: &Base<'_>, solved: &Solved, allowed: f64) -> Check {
    let zones: Vec<(Vec<f64>, Vec<f64>, f64)> =
        (0..solved.parts.len()).map(|j| along(base, solved, j)).collect();
    let largest = zones
        .iter()
        .flat_map(|(_, pressures, _)| pressures.iter().filter(|p| p.is_finite()))
        .fold(f64::MIN_POSITIVE, |most, p| most.max(p.abs()));
    let mut tension = 0.0f64;
    let mut pulling = Vec::new();
    for (points, pressures, floor) in &zones {
        let values: Vec<f64> = pressures.iter().map(|p| -p).collect();
        tension = values.iter().fold(tension, |most, t| most.max(t / largest));
        pulling.extend(above(points, &values, allowed * largest + floor));
    }
    extend_to_ends(&mut pulling, solved, &zones);
    let depth = |xi: f64| solved.state.settlement - solved.state.tilt * xi - base.height(xi);
    let forces: f64 = solved.parts.iter().map(|part| part.force().abs()).sum();
    let scale = forces + solved.state.settlement.abs() + solved.state.tilt.abs() + base.range();
    let (mut penetration, mut penetrating) = (0.0f64, Vec::new());
    for [left, right] in outside(base, solved) {
        // Of few modes every other place is enough: all are looked at with all modes.
        let fewest = if allowed >= COARSELY_ALLOWED { POINTS / 2 } else { POINTS };
        let points = points(base, left, right, fewest);
        let values: Vec<f64> =
            points.iter().map(|&xi| depth(xi) - solved.displacement_outside(xi)).collect();
        penetration = values.iter().fold(penetration, |most, g| most.max(g / scale));
        penetrating.extend(above(&points, &values, allowed * scale));
    }
    Check { tension, penetration, largest, pulling, penetrating }
}

/// Tension at the outermost points reaches to the end of the zone.
fn extend_to_ends(pulling: &mut [[f64; 2]], solved: &Solved, zones: &[(Vec<f64>, Vec<f64>, f64)]) {
    for (part, (points, _, _)) in solved.parts.iter().zip(zones) {
        let (Some(first), Some(last)) = (points.first(), points.last()) else { continue };
        for interval in &mut *pulling {
            if interval[0] == *first {
                interval[0] = part.zone.left();
            }
            if interval[1] == *last {
                interval[1] = part.zone.right();
            }
        }
    }
}

/// Points of a zone with their pressures, and the rounding of those.
fn along(base: &Base<'_>, solved: &Solved, j: usize) -> (Vec<f64>, Vec<f64>, f64) {
    let zone = solved.parts[j].zone;
    let points = points(base, zone.left(), zone.right(), POINTS);
    let points = &points[1..points.len() - 1];
    let pressures = points.iter().map(|&xi| {
        let place = Place { from_left: xi - zone.left(), from_right: zone.right() - xi };
        solved.pressure(j, place)
    });
    let first = points.first().map_or(zone.length(), |xi| xi - zone.left());
    let floor = 4.0 * solved.rounding(j) / (solved.theta0 * (first * zone.length()).sqrt());
    (points.to_vec(), pressures.collect(), floor)
}

/// The intervals of the base beside the zones.
pub(super) fn outside(base: &Base<'_>, solved: &Solved) -> Vec<[f64; 2]> {
    let mut intervals = Vec::new();
    for &[first, last] in &base.problem.pieces {
        let mut left = first;
        for zone in solved.parts.iter().map(|part| part.zone) {
            if zone.left() < last && zone.right() > first {
                if zone.left() > left {
                    intervals.push([left, zone.left()]);
                }
                left = zone.right();
            }
        }
        if left < last {
            intervals.push([left, last]);
        }
    }
    intervals
}

/// Both ends and points between, closer near the ends, dense enough for the valleys of the profile.
fn points(base: &Base<'_>, left: f64, right: f64, fewest: usize) -> Vec<f64> {
    let wanted = (right - left) * base.cells() as f64;
    let count = (wanted as usize).clamp(fewest, MOST_POINTS);
    (0..=count)
        .map(|i| {
            let half = (0.5 * PI * i as f64 / count as f64).sin();
            (left + (right - left) * half * half).clamp(left, right)
        })
        .collect()
}

/// The intervals around points where the values exceed a threshold, to the nearest points where they do not.
pub(super) fn above(points: &[f64], values: &[f64], threshold: f64) -> Vec<[f64; 2]> {
    let mut intervals: Vec<[f64; 2]> = Vec::new();
    let mut inside = false;
    for i in 0..points.len() {
        let exceeds = values[i] > threshold;
        if exceeds && !inside {
            let left = if i == 0 { points[0] } else { 0.5 * (points[i - 1] + points[i]) };
            intervals.push([left, points[i]]);
        }
        if exceeds && let Some(last) = intervals.last_mut() {
            last[1] = points.get(i + 1).map_or(points[i], |next| 0.5 * (points[i] + next));
        }
        inside = exceeds;
    }
    intervals
}

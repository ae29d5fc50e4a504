//! Complementarity between the nodes: where the answer pulls and where the base penetrates.

use std::f64::consts::PI;

use super::base::Base;
use super::system::Solved;

/// Points of a zone and of an interval beside the zones, at least and at most.
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

impl Check {
    /// Whether nothing is to be corrected.
    pub(super) fn is_clean(&self) -> bool {
        self.pulling.is_empty() && self.penetrating.is_empty()
    }
}

/// Points of a zone with their pressures, and the rounding of those.
struct Along {
    points: Vec<f64>,
    pressures: Vec<f64>,
    floor: f64,
}

/// Tension and penetration beyond `allowed`, relative to their scales, are listed for correction.
pub(super) fn check(base: &Base<'_>, solved: &Solved, allowed: f64) -> Check {
    let zones: Vec<Along> = (0..solved.zones.len()).map(|j| along(base, solved, j)).collect();
    let largest = (zones.iter().flat_map(|zone| &zone.pressures))
        .filter(|p| p.is_finite())
        .fold(f64::MIN_POSITIVE, |most, p| most.max(p.abs()));
    let mut tension = 0.0f64;
    let mut pulling = Vec::new();
    for (zone, along) in solved.zones.iter().zip(&zones) {
        let values: Vec<f64> = along.pressures.iter().map(|p| -p).collect();
        tension = values.iter().fold(tension, |most, t| most.max(t / largest));
        let mut found = above(&along.points, &values, allowed * largest + along.floor);
        // Tension at the outermost points reaches to the end of the zone.
        if let (Some(first), Some(last)) = (along.points.first(), along.points.last()) {
            for interval in &mut found {
                if interval[0] == *first {
                    interval[0] = zone.left();
                }
                if interval[1] == *last {
                    interval[1] = zone.right();
                }
            }
        }
        pulling.extend(found);
    }
    let settlement = solved.state.settlement;
    let scale = settlement.abs() + base.range() + solved.state.force.abs() * solved.theta0;
    let (mut penetration, mut penetrating) = (0.0f64, Vec::new());
    if base.problem.is_unilateral {
        for [left, right] in outside(solved) {
            let points = points(base, left, right);
            let depth = |r: f64| settlement - base.height(beside(r, left, right));
            let values: Vec<f64> =
                points.iter().map(|&r| depth(r) - solved.displacement_outside(r)).collect();
            penetration = values.iter().fold(penetration, |most, g| most.max(g / scale));
            penetrating.extend(above(&points, &values, allowed * scale));
        }
    }
    Check { tension, penetration, largest, pulling, penetrating }
}

/// At a step the height is that of this side.
fn beside(r: f64, left: f64, right: f64) -> f64 {
    let from = if left > 0.0 { left.next_up() } else { 0.0 };
    let to = if right < 1.0 { right.next_down() } else { 1.0 };
    if from < to { r.clamp(from, to) } else { r }
}

fn along(base: &Base<'_>, solved: &Solved, j: usize) -> Along {
    let zone = solved.zones[j];
    let points = points(base, zone.left(), zone.right());
    let inner = &points[1..points.len() - 1];
    let pressures: Vec<f64> = (inner.iter())
        .map(|&r| solved.pressure_beside(j, r - zone.left(), zone.right() - r))
        .collect();
    let first = inner.first().map_or(zone.length(), |r| r - zone.left());
    let floor = solved.ring(j).map_or(0.0, |part| {
        let size = solved.theta0 * zone.left() * (first * zone.length()).sqrt();
        4.0 * part.rounding() / size
    });
    Along { points: inner.to_vec(), pressures, floor }
}

/// The intervals of the base beside the zones.
pub(super) fn outside(solved: &Solved) -> Vec<[f64; 2]> {
    let mut intervals = Vec::new();
    let mut left = 0.0;
    for zone in &solved.zones {
        if zone.left() > left {
            intervals.push([left, zone.left()]);
        }
        left = zone.right();
    }
    if left < 1.0 {
        intervals.push([left, 1.0]);
    }
    intervals
}

/// Both ends and points between, closer near the ends, dense enough for the valleys of the profile.
fn points(base: &Base<'_>, left: f64, right: f64) -> Vec<f64> {
    let wanted = 2.0 * (right - left) * base.cells() as f64;
    let count = (wanted as usize).clamp(POINTS, MOST_POINTS);
    (0..=count)
        .map(|i| {
            let half = (0.5 * PI * i as f64 / count as f64).sin();
            (left + (right - left) * half * half).clamp(left, right)
        })
        .collect()
}

/// The intervals around points where the values exceed a threshold, to the nearest points where they do not.
fn above(points: &[f64], values: &[f64], threshold: f64) -> Vec<[f64; 2]> {
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

//! Complementarity between the nodes: where the answer pulls and where the base penetrates.

use std::f64::consts::PI;

use super::COARSELY_ALLOWED;
use super::problem::Base;
use super::system::{Part, Place, Solved};
use super::zones::Zone;

/// A penetration that changes by less than this share is the same again; how zones that vanished are narrowed for the next attempt, and how far.
const SAME: f64 = 1e-2;
const NARROWER: f64 = 0.2;
const NARROWEST: f64 = 1e-4;
/// Points of a zone and of an interval outside the zones, at least and at most.
pub(super) const POINTS: usize = 48;
const MOST_POINTS: usize = 1500;
/// Tenths of tenths of half a zone to which places close in on a kink.
const CLOSING: i32 = 12;

/// Parts of an interval between two breaks.
const BETWEEN: usize = 8;

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

/// Widths of the zones that are put where the base penetrates, as shares of the intervals where it does: one that comes in too wide pulls, vanishes and leaves the same penetration.
pub(super) struct Narrowing {
    penetration: f64,
    width: f64,
}

impl Narrowing {
    pub(super) fn new() -> Self {
        Self { penetration: f64::INFINITY, width: 1.0 }
    }

    /// The width for this penetration; none where narrowing does not help.
    pub(super) fn next(&mut self, penetration: f64) -> Option<f64> {
        let change = (penetration - self.penetration).abs();
        self.width = if change <= SAME * penetration { NARROWER * self.width } else { 1.0 };
        self.penetration = penetration;
        (self.width >= NARROWEST).then_some(self.width)
    }
}

impl Check {
    /// That of the zones: tension beyond `allowed`, relative to the largest pressure, is listed for correction.
    pub(super) fn of_zones<'z>(
        zones: impl Iterator<Item = &'z Zone>,
        along: &[Along],
        allowed: f64,
    ) -> Self {
        let largest = (along.iter().flat_map(|zone| &zone.pressures))
            .filter(|p| p.is_finite())
            .fold(f64::MIN_POSITIVE, |most, p| most.max(p.abs()));
        let mut tension = 0.0f64;
        let mut pulling = Vec::new();
        for (zone, along) in zones.zip(along) {
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
        Self { tension, penetration: 0.0, largest, pulling, penetrating: Vec::new() }
    }

    /// Adds the penetration at points beside the zones; beyond `allowed`, relative to a scale, it is listed for correction.
    pub(super) fn look_beside(
        &mut self,
        points: &[f64],
        penetration: impl Fn(f64) -> f64,
        [scale, allowed]: [f64; 2],
    ) {
        let values: Vec<f64> = points.iter().map(|&xi| penetration(xi)).collect();
        self.penetration = values.iter().fold(self.penetration, |most, g| most.max(g / scale));
        self.penetrating.extend(above(points, &values, allowed * scale));
    }

    /// The intervals of penetration, narrowed by a factor towards their middles.
    pub(super) fn narrowed(&self, width: f64) -> Vec<[f64; 2]> {
        narrowed(&self.penetrating, width)
    }

    /// Whether nothing is to be corrected.
    pub(super) fn is_clean(&self) -> bool {
        self.pulling.is_empty() && self.penetrating.is_empty()
    }
}

/// Intervals narrowed by a factor towards their middles.
pub(super) fn narrowed(intervals: &[[f64; 2]], width: f64) -> Vec<[f64; 2]> {
    let of = |&[left, right]: &[f64; 2]| {
        let (middle, half) = (0.5 * (left + right), 0.5 * width * (right - left));
        [(middle - half).max(left), (middle + half).min(right)]
    };
    intervals.iter().map(of).collect()
}

/// Points of a zone with their pressures, and the rounding of those.
pub(super) struct Along {
    pub(super) points: Vec<f64>,
    pub(super) pressures: Vec<f64>,
    pub(super) floor: f64,
}

/// Tension and penetration beyond `allowed`, relative to their scales, are listed for correction.
pub(super) fn check(base: &Base<'_>, solved: &Solved, allowed: f64) -> Check {
    let along: Vec<Along> = (0..solved.parts.len()).map(|j| along(base, solved, j)).collect();
    let zones = || solved.parts.iter().map(|part| &part.zone);
    let mut check = Check::of_zones(zones(), &along, allowed);
    let depth = |xi: f64| solved.state.settlement - solved.state.tilt * xi - base.height(xi);
    let forces: f64 = solved.parts.iter().map(|part| part.force().abs()).sum();
    let scale = forces + solved.state.settlement.abs() + solved.state.tilt.abs() + base.range();
    for ends in outside(&base.problem.pieces, &zones()) {
        // Of few modes every other place is enough: all are looked at with all modes.
        let fewest = if allowed >= COARSELY_ALLOWED { POINTS / 2 } else { POINTS };
        let mut points = points(ends, base.cells(), fewest);
        points.extend(between_breaks(&base.problem.profile.breaks, ends));
        points.sort_by(f64::total_cmp);
        points.dedup();
        check.look_beside(
            &points,
            |xi| depth(xi) - solved.displacement_outside(xi),
            [scale, allowed],
        );
    }
    check
}

fn along(base: &Base<'_>, solved: &Solved, j: usize) -> Along {
    let zone = solved.parts[j].zone;
    let points = points(zone.ends, base.cells(), POINTS);
    let mut points = points[1..points.len() - 1].to_vec();
    points.extend(beside_hollows(&solved.parts[j]));
    points.extend(between_breaks(&base.problem.profile.breaks, zone.ends));
    points.sort_by(f64::total_cmp);
    points.dedup();
    let pressures = points.iter().map(|&xi| {
        let place = Place { from_left: xi - zone.left(), from_right: zone.right() - xi };
        solved.pressure(j, place)
    });
    let first = points.first().map_or(zone.length(), |xi| xi - zone.left());
    let floor = 4.0 * solved.rounding(j) / (solved.theta0 * (first * zone.length()).sqrt());
    let pressures = pressures.collect();
    Along { points, pressures, floor }
}

/// Places that close in on the hollow kinks of a zone from either side: under these the pressure falls below all bounds, but as slowly as a logarithm.
fn beside_hollows(part: &Part) -> Vec<f64> {
    let Zone { ends: [left, right], .. } = part.zone;
    let kinks = part.slopes.hollows().map(|(angle, _)| part.centre() + part.half() * angle.cos());
    let offsets = || (1..=CLOSING).flat_map(|k| [-1.0, 1.0].map(|side| side * 0.1f64.powi(k)));
    let beside = kinks.flat_map(|kink| offsets().map(move |offset| kink + offset * part.half()));
    beside.filter(|xi| left < *xi && *xi < right).collect()
}

/// Places between the breaks of a profile, which may lie close about a narrow feature.
pub(super) fn between_breaks(breaks: &[f64], [left, right]: [f64; 2]) -> Vec<f64> {
    let inside = |xi: &f64| left < *xi && *xi < right;
    let breaks: Vec<f64> = breaks.iter().copied().filter(inside).collect();
    let part = |pair: &[f64]| {
        let [from, to] = [pair[0], pair[1]];
        (1..BETWEEN).map(move |i| from + (to - from) * i as f64 / BETWEEN as f64)
    };
    breaks.windows(2).flat_map(part).collect()
}

/// The intervals of the pieces of a base beside zones.
pub(super) fn outside<'z>(
    pieces: &[[f64; 2]],
    zones: &(impl Iterator<Item = &'z Zone> + Clone),
) -> Vec<[f64; 2]> {
    let mut intervals = Vec::new();
    for &[first, last] in pieces {
        let mut left = first;
        for zone in zones.clone() {
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

/// Both ends and points between, closer near the ends, so many on a unit that the valleys of the profile show.
pub(super) fn points([left, right]: [f64; 2], on_a_unit: usize, fewest: usize) -> Vec<f64> {
    let wanted = (right - left) * on_a_unit as f64;
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

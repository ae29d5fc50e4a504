//! Complementarity between the nodes: where the answer pulls and where the base penetrates.

use std::f64::consts::PI;

use super::problem::Base;
use super::system::{Part, Place, Solved};
use crate::contact::check::{Check, POINTS, between_breaks};
use crate::contact::search::COARSELY_ALLOWED;
use crate::contact::zones::{Zone, outside};

/// Most points of a zone and of an interval outside the zones. Half and twice change none of 20 answers (survey).
pub(super) const MOST_POINTS: usize = 1500;
/// Tenths of tenths of half a zone to which places close in on a kink. At half or twice 1 of 4 answers are lost (survey).
const CLOSING: i32 = 12;

/// Adds the tension of zones, and the largest pressure; beyond `allowed`, relative to that, tension is listed for correction.
pub(super) fn of_zones(zones: &[Zone], along: &[Along], allowed: f64) -> Check {
    let largest = (along.iter().flat_map(|zone| &zone.pressures))
        .filter(|p| p.is_finite())
        .fold(f64::MIN_POSITIVE, |most, p| most.max(p.abs()));
    let mut check = Check { largest, ..Check::none() };
    for (zone, along) in zones.iter().zip(along) {
        let values: Vec<f64> = along.pressures.iter().map(|p| -p).collect();
        let listed = check.pulling.len();
        check.add_tension(&along.points, &values, [largest, allowed * largest + along.floor]);
        // Tension at the outermost points reaches to the end of the zone.
        if let (Some(first), Some(last)) = (along.points.first(), along.points.last()) {
            for interval in &mut check.pulling[listed..] {
                if interval[0] == *first {
                    interval[0] = zone.left();
                }
                if interval[1] == *last {
                    interval[1] = zone.right();
                }
            }
        }
    }
    check
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
    let zones: Vec<Zone> = solved.parts.iter().map(|part| part.zone).collect();
    let mut check = of_zones(&zones, &along, allowed);
    let depth = |xi: f64| solved.state.settlement - solved.state.tilt * xi - base.height(xi);
    let forces: f64 = solved.parts.iter().map(|part| part.force().abs()).sum();
    let scale = forces + solved.state.settlement.abs() + solved.state.tilt.abs() + base.range();
    for ends in outside(&base.problem.pieces, &zones) {
        // Of few modes every other place is enough: all are looked at with all modes.
        let fewest = if allowed >= COARSELY_ALLOWED { POINTS / 2 } else { POINTS };
        let mut points = points(ends, base.cells(), fewest);
        points.extend(between_breaks(&base.problem.profile.breaks, ends));
        points.sort_by(f64::total_cmp);
        points.dedup();
        let values: Vec<f64> =
            points.iter().map(|&xi| depth(xi) - solved.displacement_outside(xi)).collect();
        check.add_penetration(&points, &values, [scale, allowed * scale]);
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

/// So many points between two places, closer to them.
pub(super) fn between(from: f64, to: f64, count: usize) -> impl Iterator<Item = f64> {
    (0..count)
        .map(move |i| {
            let half = (0.5 * PI * (i as f64 + 0.5) / count as f64).sin();
            from + (to - from) * half * half
        })
        .filter(move |at| *at > from && *at < to)
}

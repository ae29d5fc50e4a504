//! Complementarity between the nodes: where the answer pulls and where the base penetrates.

use super::base::Base;
use super::system::Solved;
use crate::contact::check::POINTS;
use crate::contact::check::{Check, between_breaks};
use crate::contact::smooth::check::{Along, of_zones, points};
use crate::contact::zones::outside;

/// Tension and penetration beyond `allowed`, relative to their scales, are listed for correction.
pub(super) fn check(base: &Base<'_>, solved: &Solved, allowed: f64) -> Check {
    let along: Vec<Along> = (0..solved.zones.len()).map(|j| along(base, solved, j)).collect();
    let mut check = of_zones(&solved.zones, &along, allowed);
    if !base.problem.is_unilateral {
        return check;
    }
    let settlement = solved.state.settlement;
    let scale = settlement.abs() + base.range() + solved.state.force.abs() * solved.theta0;
    for [left, right] in outside(&[[0.0, 1.0]], &solved.zones) {
        let points = looked_at(base, [left, right]);
        let depth = |r: f64| settlement - base.height(beside(r, left, right));
        let values: Vec<f64> =
            points.iter().map(|&r| depth(r) - solved.displacement_outside(r)).collect();
        check.add_penetration(&points, &values, [scale, allowed * scale]);
    }
    check
}

/// Both ends and places between that show every feature of the profile.
fn looked_at(base: &Base<'_>, ends: [f64; 2]) -> Vec<f64> {
    let mut points = points(ends, 2 * base.cells(), POINTS);
    points.extend(between_breaks(&base.problem.breaks, ends));
    points.sort_by(f64::total_cmp);
    points.dedup();
    points
}

/// At a step the height is that of this side.
fn beside(r: f64, left: f64, right: f64) -> f64 {
    let from = if left > 0.0 { left.next_up() } else { 0.0 };
    let to = if right < 1.0 { right.next_down() } else { 1.0 };
    if from < to { r.clamp(from, to) } else { r }
}

fn along(base: &Base<'_>, solved: &Solved, j: usize) -> Along {
    let zone = solved.zones[j];
    let points = looked_at(base, zone.ends);
    let points = points[1..points.len() - 1].to_vec();
    let pressures: Vec<f64> = (points.iter())
        .map(|&r| solved.pressure_beside(j, r - zone.left(), zone.right() - r))
        .collect();
    let first = points.first().map_or(zone.length(), |r| r - zone.left());
    let floor = solved.ring(j).map_or(0.0, |part| {
        let size = solved.theta0 * zone.left() * (first * zone.length()).sqrt();
        4.0 * part.rounding() / size
    });
    Along { points, pressures, floor }
}

//! Whether zones are the answer: no tension in them, no penetration beside them.

use super::field::{Field, displacement_outside};
use crate::contact::check::{Check, POINTS, between_breaks};
use crate::contact::search::COARSELY_ALLOWED;
use crate::contact::smooth::check::{MOST_POINTS, between};
use crate::contact::smooth::problem::Base;
use crate::contact::zones::{Zone, outside};

/// Points between two cuts where the zone is cut at places that are no bends. Half and twice change none of 20 answers (survey).
const POINTS_A_PART: usize = 12;

/// The pressures of zones, without the singularity at corners.
#[derive(Debug, Clone)]
pub(super) struct Along {
    /// Places in each zone.
    pub(super) places: Vec<Vec<f64>>,
    /// The pressures there.
    pub(super) pressures: Vec<Vec<f64>>,
    /// The largest `|p0|`.
    pub(super) largest: f64,
    corners: Vec<[f64; 2]>,
}

impl Along {
    pub(super) fn new(base: &Base<'_>, fields: &[Field]) -> Self {
        let places: Vec<Vec<f64>> = fields.iter().map(|field| inner(base, field)).collect();
        let pressures: Vec<Vec<f64>> = (fields.iter().zip(&places))
            .map(|(field, places)| {
                places.iter().map(|&xi| field.regular(field.place(xi))).collect()
            })
            .collect();
        let corners: Vec<[f64; 2]> =
            fields.iter().map(|field| [0, 1].map(|side| field.corner(side))).collect();
        let all = pressures.iter().flatten().chain(corners.as_flattened());
        let largest = all.fold(f64::MIN_POSITIVE, |most, p| most.max(p.abs()));
        Self { places, pressures, largest, corners }
    }
}

/// Tension and penetration beyond `allowed`, relative to their scales, are listed for correction.
pub(super) fn check(base: &Base<'_>, fields: &[Field], along: &Along, allowed: f64) -> Check {
    let Along { places, pressures, largest, corners } = along;
    let mut check = Check { largest: *largest, ..Check::none() };
    for (j, field) in fields.iter().enumerate() {
        let around = |[first, last]: [f64; 2], inner: &[f64]| [&[first], inner, &[last]].concat();
        let points = around(field.strip.zone.ends, &places[j]);
        let pulls: Vec<f64> = around(corners[j], &pressures[j]).iter().map(|p| -p).collect();
        check.add_tension(&points, &pulls, [*largest, allowed * largest]);
        // Slopes alone know nothing of a step.
        let beyond = base.beyond_steps(field.strip.zone.ends);
        if !beyond.is_empty() {
            check.tension = check.tension.max(1.0);
        }
        check.pulling.extend(beyond);
    }
    if base.problem.is_unilateral {
        look_beside(&mut check, base, fields, allowed);
    }
    check
}

fn look_beside(check: &mut Check, base: &Base<'_>, fields: &[Field], allowed: f64) {
    let state = fields[0].strip.state;
    let scale = state.settlement.abs() + state.tilt.abs() + base.range();
    let zones: Vec<Zone> = fields.iter().map(|field| field.strip.zone).collect();
    for [from, to] in outside(&base.problem.pieces, &zones) {
        // Of few modes every other place is enough: all are looked at with all modes.
        let all = points_of(base, to - from, POINTS);
        let count = if allowed >= COARSELY_ALLOWED { all / 2 } else { all };
        // At the end of a zone, and at a wall, there are two heights.
        let mut points: Vec<f64> = between(from, to, count).collect();
        points.extend(between_breaks(&base.problem.profile.cuts(), [from, to]));
        points.sort_by(f64::total_cmp);
        points.dedup();
        let depth = |xi: f64| state.settlement - state.tilt * xi - base.height(xi);
        let values: Vec<f64> =
            points.iter().map(|&xi| depth(xi) - displacement_outside(fields, xi)).collect();
        check.add_penetration(&points, &values, [scale, allowed * scale]);
    }
}

/// Places in a zone.
fn inner(base: &Base<'_>, field: &Field) -> Vec<f64> {
    let [left, right] = field.strip.zone.ends;
    let mut cuts = vec![left];
    cuts.extend(base.problem.profile.cuts().iter().filter(|at| left < **at && **at < right));
    cuts.push(right);
    let parts = cuts.len() - field.breaks.len() - 1;
    let each = (points_of(base, right - left, 2 * POINTS) / parts).max(POINTS_A_PART);
    let count = if cuts.len() > 2 * POINTS { 2 } else { each };
    cuts.windows(2).flat_map(|pair| between(pair[0], pair[1], count)).collect()
}

/// Enough for the valleys of the profile.
fn points_of(base: &Base<'_>, length: f64, least: usize) -> usize {
    ((length * base.cells() as f64) as usize).clamp(least, MOST_POINTS)
}

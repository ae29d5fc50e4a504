//! Whether zones are the answer: no tension in them, no penetration beside them.

use std::f64::consts::PI;

use super::field::{Field, displacement_outside};
use crate::contact::smooth::check::{above, between_breaks};
use crate::contact::smooth::problem::Base;

/// Points between two bends, and beside a zone, at least and at most.
const POINTS: usize = 96;
const POINTS_BESIDE: usize = 48;
/// The same where the zone is cut at places that are no bends.
const POINTS_A_PART: usize = 12;
const MOST_POINTS: usize = 1500;
/// Tension and penetration, relative to their scales, that are rounding.
const ALLOWED: f64 = 2e-10;

/// What is left of tension and penetration.
#[derive(Debug, Clone)]
pub(super) struct Check {
    /// Places in each zone.
    pub(super) places: Vec<Vec<f64>>,
    /// The pressures there, without the singularity at corners.
    pub(super) pressures: Vec<Vec<f64>>,
    /// Largest `|p0|` without the singularity at corners.
    pub(super) largest: f64,
    /// Largest tension over that.
    pub(super) tension: f64,
    /// Largest penetration over the size of the displacements.
    pub(super) penetration: f64,
    /// Intervals of each that are too large to be rounding.
    pub(super) pulling: Vec<[f64; 2]>,
    pub(super) penetrating: Vec<[f64; 2]>,
}

impl Check {
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
        let (mut tension, mut pulling) = (0.0, Vec::new());
        for (j, field) in fields.iter().enumerate() {
            let around =
                |[first, last]: [f64; 2], inner: &[f64]| [&[first], inner, &[last]].concat();
            let points = around(field.strip.zone.ends, &places[j]);
            let mut pulls = around(corners[j], &pressures[j]);
            pulls.iter_mut().for_each(|p| *p /= -largest);
            tension = worst(tension, &pulls);
            pulling.extend(above(&points, &pulls, ALLOWED));
            // Slopes alone know nothing of a step.
            let beyond = base.beyond_steps(field.strip.zone.ends);
            tension = if beyond.is_empty() { tension } else { f64::max(tension, 1.0) };
            pulling.extend(beyond);
        }
        let (penetration, penetrating) = (0.0, Vec::new());
        let mut check =
            Self { places, pressures, largest, tension, penetration, pulling, penetrating };
        if base.problem.is_unilateral {
            check.look_beside(base, fields);
        }
        check
    }

    fn look_beside(&mut self, base: &Base<'_>, fields: &[Field]) {
        let state = fields[0].strip.state;
        let scale = state.settlement.abs() + state.tilt.abs() + base.range();
        for [from, to] in outside(base, fields) {
            let mut points = vec![from];
            points.extend(between(from, to, points_of(base, to - from, POINTS_BESIDE)));
            points.extend(between_breaks(&base.problem.profile.cuts(), [from, to]));
            points.push(to);
            points.sort_by(f64::total_cmp);
            points.dedup();
            let depths: Vec<f64> = (points.iter())
                .map(|&xi| {
                    let depth = state.settlement - state.tilt * xi - base.height(xi);
                    (depth - displacement_outside(fields, xi)) / scale
                })
                .collect();
            // At the end of a zone, and at a wall, there are two heights.
            let inner = &depths[1..depths.len() - 1];
            self.penetration = worst(self.penetration, inner);
            self.penetrating.extend(above(&points[1..points.len() - 1], inner, ALLOWED));
        }
    }

    pub(super) fn is_clean(&self) -> bool {
        let shares = [self.tension, self.penetration];
        shares.into_iter().all(|share| share <= ALLOWED)
    }
}

/// The largest value; not a number if one is not.
fn worst(start: f64, values: &[f64]) -> f64 {
    values
        .iter()
        .fold(start, |most, &value| if value > most || value.is_nan() { value } else { most })
}

/// Places in a zone.
fn inner(base: &Base<'_>, field: &Field) -> Vec<f64> {
    let [left, right] = field.strip.zone.ends;
    let mut cuts = vec![left];
    cuts.extend(base.problem.profile.cuts().iter().filter(|at| left < **at && **at < right));
    cuts.push(right);
    let parts = cuts.len() - field.breaks.len() - 1;
    let each = (points_of(base, right - left, POINTS) / parts).max(POINTS_A_PART);
    let count = if cuts.len() > POINTS { 2 } else { each };
    cuts.windows(2).flat_map(|pair| between(pair[0], pair[1], count)).collect()
}

/// The parts of the base beside the zones.
fn outside(base: &Base<'_>, fields: &[Field]) -> Vec<[f64; 2]> {
    let mut beside = Vec::new();
    for &[first, last] in &base.problem.pieces {
        let mut left = first;
        for [from, to] in fields.iter().map(|field| field.strip.zone.ends) {
            if from < last && to > first {
                beside.push([left, from]);
                left = to;
            }
        }
        beside.push([left, last]);
    }
    beside.retain(|[left, right]| left < right);
    beside
}

/// Enough for the valleys of the profile.
fn points_of(base: &Base<'_>, length: f64, least: usize) -> usize {
    ((length * base.cells() as f64) as usize).clamp(least, MOST_POINTS)
}

/// Points between two places, closer to them.
fn between(from: f64, to: f64, count: usize) -> impl Iterator<Item = f64> {
    (0..count)
        .map(move |i| {
            let half = (0.5 * PI * (i as f64 + 0.5) / count as f64).sin();
            from + (to - from) * half * half
        })
        .filter(move |at| *at > from && *at < to)
}

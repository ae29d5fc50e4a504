//! Whether one zone is the answer: no tension in it, no penetration beside it.

use std::f64::consts::PI;

use super::ALLOWED;
use super::field::Field;
use crate::Error;
use crate::contact::smooth::problem::Base;

/// Points between two bends, and beside the zone, at least and at most.
const POINTS: usize = 96;
const MOST_POINTS: usize = 1500;

/// What is left of tension and penetration.
#[derive(Debug, Clone)]
pub(super) struct Check {
    /// Places in the zone.
    pub(super) places: Vec<f64>,
    /// Largest `|p0|` without the singularity at corners.
    pub(super) largest: f64,
    /// Largest tension over that, and its place.
    pub(super) tension: (f64, f64),
    /// Largest penetration over the size of the displacements, and its place.
    pub(super) penetration: (f64, f64),
}

impl Check {
    pub(super) fn new(base: &Base<'_>, field: &Field) -> Self {
        let [left, right] = field.strip.zone.ends;
        let mut cuts = vec![left];
        cuts.extend(&field.breaks);
        cuts.push(right);
        let count = if cuts.len() > POINTS { 2 } else { points(base, right - left) };
        let places: Vec<f64> =
            cuts.windows(2).flat_map(|pair| between(pair[0], pair[1], count)).collect();
        let values: Vec<f64> = places.iter().map(|&xi| field.regular(field.place(xi))).collect();
        let corners = [0, 1].map(|side| field.corner(side));
        let all = values.iter().chain(&corners);
        let largest = all.fold(f64::MIN_POSITIVE, |most, p| most.max(p.abs()));
        let ends = [left, right].into_iter().zip(corners);
        let pressures = places.iter().copied().zip(values).chain(ends);
        let tension = worst(pressures.map(|(at, p)| (-p / largest, at)));
        let penetration = if base.problem.is_unilateral {
            let state = &field.strip.state;
            let scale = state.settlement.abs() + state.tilt.abs() + base.range();
            let beside = outside(base, [left, right]).into_iter();
            let places = beside.flat_map(|[from, to]| between(from, to, points(base, to - from)));
            worst(places.map(|xi| (-gap(base, field, xi) / scale, xi)))
        } else {
            (0.0, 0.0)
        };
        Self { places, largest, tension, penetration }
    }

    /// Refuses what pulls or penetrates.
    pub(super) fn require(&self) -> Result<(), Error> {
        let worst = [(self.tension, "tension"), (self.penetration, "penetration")];
        for ((size, at), found) in worst {
            if size.is_nan() || size > ALLOWED {
                return Err(Error::SeveralZones { variable: "xi", at, found });
            }
        }
        Ok(())
    }
}

/// The gap beside the zone.
fn gap(base: &Base<'_>, field: &Field, xi: f64) -> f64 {
    let state = &field.strip.state;
    field.displacement_outside(xi) - (state.settlement - state.tilt * xi - base.height(xi))
}

fn worst(values: impl Iterator<Item = (f64, f64)>) -> (f64, f64) {
    values
        .fold((0.0, 0.0), |most, pair| if pair.0 > most.0 || pair.0.is_nan() { pair } else { most })
}

/// The parts of the base beside the zone.
fn outside(base: &Base<'_>, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
    let pieces = base.problem.pieces.iter();
    let beside = pieces
        .flat_map(|&[left, right]| [[left, right.min(from)], [left.max(to), right]].into_iter());
    beside.filter(|[left, right]| left < right).collect()
}

/// Enough for the valleys of the profile.
fn points(base: &Base<'_>, length: f64) -> usize {
    ((length * base.cells() as f64) as usize).clamp(POINTS, MOST_POINTS)
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

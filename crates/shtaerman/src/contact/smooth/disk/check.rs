//! Whether a disk of contact is one: no tension in it, no penetration beside it, also under its tilt.

use super::SmoothDisk;
use super::field::Field;
use crate::Error;
use crate::contact::check::POINTS;
use crate::contact::extremes::Sampled;
use crate::contact::search::ALLOWED;
use crate::contact::smooth::check::between;
use crate::contact::steps::INSIDE;

/// What is left of tension and penetration.
pub(super) struct Check {
    /// Places in the contact, from the axis, without kinks.
    pub(super) places: Vec<f64>,
    /// `p0` there without the tilt, and without its singularity at a corner.
    pub(super) pressures: Vec<f64>,
    pub(super) regular: Vec<f64>,
    /// Largest `|p0| (1 - r^2/c^2)^beta`, or `|p0|` where the edge is free.
    pub(super) largest: f64,
    /// Largest tension over that, and its place.
    pub(super) tension: (f64, f64),
    /// Largest penetration over the size of the displacements, and its place.
    pub(super) penetration: (f64, f64),
}

impl Check {
    pub(super) fn new(problem: &SmoothDisk, field: &Field) -> Self {
        let cuts = field.transform.cuts();
        let places: Vec<f64> =
            cuts.windows(2).flat_map(|pair| between(pair[0], pair[1], 2 * POINTS)).collect();
        let pressures: Vec<f64> = places.iter().map(|&r| field.even_pressure(r)).collect();
        let values: Vec<f64> = (places.iter().zip(&pressures))
            .map(|(&r, pressure)| corner_share(field, r) * pressure)
            .collect();
        let finite = values.iter().filter(|value| value.is_finite());
        let largest = finite.fold(f64::MIN_POSITIVE, |most, p| most.max(p.abs()));
        let worst = |places: &[f64], values: &[f64]| {
            let pairs = places.iter().zip(values).map(|(at, value)| (*value, *at));
            pairs.fold((0.0, 0.0), |most, pair| if pair.0 > most.0 { pair } else { most })
        };
        let pulls: Vec<f64> = values.iter().map(|p| -p / largest).collect();
        let mut tension = worst(&places, &pulls);
        let corner = -field.corner_factors()[0] / field.whole_taper() / largest;
        if corner > tension.0 {
            tension = (corner, field.radius);
        }
        let penetration = if problem.is_unilateral && field.radius < 1.0 {
            let from = field.radius * (1.0 + INSIDE);
            let places: Vec<f64> = between(from, 1.0, 2 * POINTS).collect();
            let mut scale = field.state.settlement.abs();
            let depths: Vec<f64> = (places.iter())
                .map(|&r| {
                    let height = (problem.height)(r);
                    scale = scale.max(height.abs());
                    -gap(problem, field, r)
                })
                .collect();
            let shares: Vec<f64> = depths.iter().map(|depth| depth / scale).collect();
            worst(&places, &shares)
        } else {
            (0.0, 0.0)
        };
        Self { places, pressures, regular: values, largest, tension, penetration }
    }

    /// Refuses what pulls or penetrates.
    pub(super) fn require(&self) -> Result<(), Error> {
        let worst = [(self.tension, "tension"), (self.penetration, "penetration")];
        for ((size, at), found) in worst {
            if size > ALLOWED {
                return Err(Error::Rings { variable: "xi", at, found });
            }
        }
        Ok(())
    }

    /// Refuses a tilt that lifts the disk off on one side.
    pub(super) fn require_contact(&self, problem: &SmoothDisk, field: &Field) -> Result<(), Error> {
        let factor = field.tilt_factor().abs();
        let (name, value) = problem.rotational();
        if factor == 0.0 || value == 0.0 {
            return Ok(());
        }
        let limit = self.largest_share(problem, field, factor);
        if limit >= 1.0 - ALLOWED {
            return Ok(());
        }
        Err(Error::LiftsOff { field: name, value, limit: limit * value.abs() })
    }

    /// How much of the tilt keeps the contact as it is.
    fn largest_share(&self, problem: &SmoothDisk, field: &Field, factor: f64) -> f64 {
        if field.is_free {
            return 0.0;
        }
        let share = |r: f64| field.even_pressure(r) * field.taper(r) / (factor * r);
        let lowest = |places: &[f64], share: &dyn Fn(f64) -> f64| {
            let values = places.iter().map(|&r| -share(r)).collect();
            -Sampled::new(|r| -share(r), places.to_vec(), values).maximum().value
        };
        let mut limit =
            (field.corner_factors()[0] / (factor * field.radius)).min(lowest(&self.places, &share));
        if field.radius < 1.0 {
            let rise = |r: f64| field.state.tilt.abs() * r * (1.0 - field.share_of_tilt(r));
            let from = field.radius * (1.0 + INSIDE);
            let places: Vec<f64> = between(from, 1.0, 2 * POINTS).collect();
            limit = limit.min(lowest(&places, &|r| gap(problem, field, r) / rise(r)));
        }
        limit.max(0.0)
    }
}

/// The gap without the tilt.
fn gap(problem: &SmoothDisk, field: &Field, r: f64) -> f64 {
    let depth = field.state.settlement - (problem.height)(r);
    field.transform.displacement(r, field.level()) - depth
}

/// What takes its singularity at a corner from the pressure.
fn corner_share(field: &Field, r: f64) -> f64 {
    if field.is_free { 1.0 } else { field.taper(r) / field.whole_taper() }
}

/// The pressure, without its singularity at a corner.
pub(super) fn regular(field: &Field, r: f64) -> f64 {
    corner_share(field, r) * field.even_pressure(r)
}

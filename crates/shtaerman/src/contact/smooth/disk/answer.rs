//! The answer of a smooth circular punch.

use std::sync::Arc;

use fredholm::inversion::Shape;

use super::SmoothDisk;
use super::check::{Check, regular};
use super::field::Field;
use crate::contact::accuracy::ROUNDING;
use crate::contact::accuracy::{Accuracy, ErrorKind};
use crate::contact::balance::State;
use crate::contact::complementarity::Complementarity;
use crate::contact::method::{Method, MethodName};
use crate::contact::rates::{Linearised, Rates};
use crate::contact::smooth::told::{Told, rates};
use crate::contact::solution::Solution;
use crate::contact::steps::INSIDE;
use crate::contact::stiffness::Stiffness;
use crate::{Error, Load, Rotational, Vertical};

/// Radius, pressure, settlement, tilt, force and moment of a circular punch on a smooth body, without dimensions.
#[derive(Debug, Clone)]
pub(crate) struct SmoothDiskContact {
    problem: Arc<SmoothDisk>,
    field: Field,
    /// Places in the contact, from the axis, and the pressure there without the tilt.
    sampled: Vec<(f64, f64)>,
    told: Told,
}

impl SmoothDiskContact {
    pub(super) fn new(
        problem: &SmoothDisk,
        shape: &Shape<'_>,
        field: Field,
        left: &Check,
    ) -> Result<Self, Error> {
        let errors = estimate(problem, shape, &field, left);
        let shares = [left.tension.0, left.penetration.0];
        let told = Told::new((&problem.load, &field.state), left.largest, errors, shares)?;
        let sampled = left.places.iter().copied().zip(left.pressures.iter().copied()).collect();
        Ok(Self { problem: Arc::new(problem.clone()), field, sampled, told })
    }
}

impl Solution for SmoothDiskContact {
    fn state(&self) -> State {
        self.field.state
    }

    /// `diag(2 e c^(1+mu)/(1+mu), 4 e c^(3+mu)/((1+mu)^2 (3+mu)))`; a free edge that moves adds nothing of first order.
    fn stiffness(&self) -> Stiffness {
        Stiffness {
            force_settlement: self.field.rate(),
            coupling: 0.0,
            moment_tilt: self.field.turning(),
        }
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        vec![[-self.field.radius, self.field.radius]]
    }

    /// Flat `(P0 +- 3 M0)/(2 sqrt(pi))`; on graded ground `lim sqrt(2 pi) d^((1-mu)/2) p0`.
    fn corner_intensity(&self) -> Option<Vec<[f64; 2]>> {
        if self.field.is_free {
            return Some(vec![[0.0; 2]]);
        }
        // c^2 - r^2 = 2 c d
        let scale = self.field.corner_scale();
        let [even, odd] = self.field.corner_factors();
        Some(vec![[scale * (even - odd), scale * (even + odd)]])
    }

    /// Along the diameter of the tilt; infinite at a kink of the base, too.
    fn pressure(&self, xi: f64) -> f64 {
        if xi.is_nan() || xi.abs() <= self.field.radius { self.field.pressure(xi) } else { 0.0 }
    }

    fn displacement(&self, xi: f64) -> f64 {
        if xi.abs() > self.field.radius {
            return self.field.displacement_outside(xi);
        }
        let inside = self.field.radius * (1.0 - INSIDE);
        let r = if self.field.radius < 1.0 { xi.abs().min(inside) } else { xi.abs() };
        let State { settlement, tilt, .. } = self.field.state;
        settlement - tilt * xi - (self.problem.height)(r)
    }

    fn sample(&self) -> (Vec<f64>, Vec<f64>) {
        let known = self.sampled.iter().flat_map(|&(r, even)| [(-r, even), (r, even)]);
        let radius = self.field.radius;
        let ends = [-1.0, -radius, 0.0, radius, 1.0].map(|xi| (xi, self.pressure(xi)));
        let mut sampled: Vec<(f64, f64)> =
            known.map(|(xi, even)| (xi, even + self.field.odd_pressure(xi))).chain(ends).collect();
        sampled.sort_by(|one, two| one.0.total_cmp(&two.0));
        sampled.dedup_by_key(|sample| sample.0);
        sampled.into_iter().filter(|(_, pressure)| pressure.is_finite()).unzip()
    }

    fn method(&self) -> Method {
        Method { name: MethodName::FirstKind, n: self.field.transform.size() }
    }

    /// Of the pressure in the middle: nearer to the edge it grows as `(1 - r^2/c^2)^-((1-mu)/2)`.
    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.told.accuracy)
    }

    fn edge_error(&self) -> Option<f64> {
        self.field.is_free.then_some(self.told.edge_error)
    }

    fn complementarity(&self) -> Option<Complementarity> {
        self.problem.is_unilateral.then_some(self.told.complementarity)
    }

    /// What a flat base of its radius adds.
    fn linearised(&self, _load: Load, peak: f64) -> Option<Linearised> {
        let (field, load) = (&self.field, &self.problem.load);
        let stiffness = self.stiffness();
        let largest = self.pressure(peak);
        let of = |prescribed: [f64; 2]| -> Rates {
            let [raise, turn] = stiffness.displaced(load, prescribed);
            let pressure = if largest.is_finite() { field.flat(peak, raise, turn) } else { 0.0 };
            // A free edge follows the depth.
            let width = if field.is_free { 2.0 * raise / field.transform.end_slope() } else { 0.0 };
            [raise, stiffness.force_settlement * raise, -turn, pressure, width]
        };
        let rates = rates(load, [field.state.force, largest], of);
        Some(Linearised { rates, errors: [[0.0; 5]; 3] })
    }

    fn size(&self) -> f64 {
        self.told.largest
    }
}

/// The error: of the pressure by leaving out the last coefficients, of the force by integrating in another order; of the edge what that makes.
fn estimate(
    problem: &SmoothDisk,
    shape: &Shape<'_>,
    field: &Field,
    left: &Check,
) -> (Accuracy, f64) {
    let State { settlement, tilt, force, moment } = field.state;
    let least = ROUNDING * left.largest;
    let pressure = match field.truncated() {
        Some(other) => (left.places.iter().zip(&left.regular))
            .map(|(&r, known)| (known - regular(&other, r)).abs())
            .filter(|difference| !difference.is_infinite())
            .fold(least, f64::max),
        None => least,
    };
    // The force is the difference of that of a flat base this deep and what its shape leaves out.
    let depth = field.level().abs();
    let given = match problem.load.vertical {
        Vertical::Force(_) => 0.0,
        Vertical::Settlement(_) => settlement.abs() + (problem.height)(0.0).abs(),
    };
    // A free edge is rounded itself.
    let slope = field.transform.end_slope().max(0.0);
    let rounded = if field.is_free { slope * field.radius } else { 0.0 };
    let rounding = ROUNDING * depth + 2.0 * f64::EPSILON * (given + rounded);
    let force_error = (field.integrated_force() - force).abs()
        + field.rate() * rounding
        + shape.tolerance * force.abs();
    let depth_error = force_error / field.rate();
    // A depth that is off by this adds a flat base's pressure.
    let pressure = pressure
        + field.flat_pressure(depth_error + field.transform.slope_rounding() * field.radius);
    let turn = ROUNDING * moment.abs();
    let arm = match (problem.load.rotational, problem.load.vertical) {
        (Rotational::Eccentricity(e), Vertical::Settlement(_)) => e.abs() * force_error,
        _ => 0.0,
    };
    let shift = (turn + arm) / field.turning();
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure,
        settlement: depth_error + ROUNDING * settlement.abs(),
        tilt: shift.max(ROUNDING * tilt.abs()),
        force: force_error,
        moment: turn + arm,
    };
    let edge = if field.is_free {
        (depth_error / slope.max(f64::MIN_POSITIVE)).max(ROUNDING * field.radius).min(1.0)
    } else {
        0.0
    };
    (accuracy, edge)
}

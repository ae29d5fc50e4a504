//! The answer of a smooth circular punch.

use std::sync::Arc;

use super::SmoothDisk;
use super::check::{Check, regular};
use super::field::Field;
use super::shape::Shape;
use crate::contact::accuracy::{Accuracy, ErrorKind};
use crate::contact::balance::State;
use crate::contact::complementarity::Complementarity;
use crate::contact::stiffness::Stiffness;
use crate::{Error, Rotational, Vertical};

/// Rounding of a quantity relative to its size.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Radius, pressure, settlement, tilt, force and moment of a circular punch on a smooth body, without dimensions.
#[derive(Debug, Clone)]
pub(crate) struct SmoothDiskContact {
    problem: Arc<SmoothDisk>,
    field: Field,
    /// Places in the contact, from the axis, and the pressure there without the tilt.
    sampled: Vec<(f64, f64)>,
    accuracy: Accuracy,
    edge_error: f64,
    complementarity: Complementarity,
    largest: f64,
}

impl SmoothDiskContact {
    pub(super) fn new(
        problem: &SmoothDisk,
        shape: &Shape<'_>,
        field: Field,
        left: &Check,
    ) -> Result<Self, Error> {
        let (accuracy, edge_error) = estimate(problem, shape, &field, left);
        let state = field.state;
        let values = [
            ("force", state.force),
            ("moment", state.moment),
            ("settlement", state.settlement),
            ("tilt", state.tilt),
            ("pressure", left.largest),
            ("error of the pressure", accuracy.pressure),
        ];
        if let Some((quantity, value)) = values.into_iter().find(|(_, value)| !value.is_finite()) {
            return Err(Error::Overflow { quantity, value });
        }
        let (tension, penetration) = (left.tension.0, left.penetration.0);
        Ok(Self {
            problem: Arc::new(problem.clone()),
            field,
            sampled: left.places.iter().copied().zip(left.pressures.iter().copied()).collect(),
            accuracy,
            edge_error,
            complementarity: Complementarity { tension, penetration },
            largest: left.largest,
        })
    }

    pub(super) fn field(&self) -> &Field {
        &self.field
    }

    /// The problem solved.
    #[must_use]
    pub(crate) fn problem(&self) -> &SmoothDisk {
        &self.problem
    }

    /// `P0 = P/(E a^2)`; where it is prescribed, as given.
    #[must_use]
    pub(crate) fn force0(&self) -> f64 {
        self.field.state.force
    }

    /// `M0 = M/(E a^3)`; where it is prescribed, as given.
    #[must_use]
    pub(crate) fn moment0(&self) -> f64 {
        self.field.state.moment
    }

    /// `delta0`, zero at infinity.
    #[must_use]
    pub(crate) fn settlement0(&self) -> f64 {
        self.field.state.settlement
    }

    /// `alpha0`.
    #[must_use]
    pub(crate) fn tilt0(&self) -> f64 {
        self.field.state.tilt
    }

    /// The radius of the contact in radii of the base.
    #[must_use]
    pub(crate) fn radius(&self) -> f64 {
        self.field.radius
    }

    /// Whether the edge of the contact is free, with a pressure that vanishes as `d^((1+mu)/2)`; else it rests at a corner.
    #[must_use]
    pub(crate) fn is_free(&self) -> bool {
        self.field.is_free
    }

    /// Corner intensities `lim sqrt(2 pi d) p0` at the left and the right end of the diameter of the tilt, `d` the distance from the end in `xi`: times
    /// `E sqrt(a)` those of the problem. 0 at a free edge; flat, `(P0 +- 3 M0)/(2 sqrt(pi))`. On graded ground `lim sqrt(2 pi) d^((1-mu)/2) p0`.
    #[must_use]
    pub(crate) fn intensity0(&self) -> [f64; 2] {
        if self.field.is_free {
            return [0.0; 2];
        }
        // c^2 - r^2 = 2 c d
        let scale = self.field.corner_scale();
        let [even, odd] = self.field.corner_factors();
        [scale * (even - odd), scale * (even + odd)]
    }

    /// `p0` along the diameter of the tilt: infinite at a corner and at a kink of the base, 0 beside the contact.
    #[must_use]
    pub(crate) fn pressure0(&self, xi: f64) -> f64 {
        if xi.is_nan() || xi.abs() <= self.field.radius { self.field.pressure(xi) } else { 0.0 }
    }

    /// `p0` at places of the contact along the diameter of the tilt, from left to right, and at its ends.
    pub(super) fn sampled0(&self) -> Vec<(f64, f64)> {
        let known = self.sampled.iter().flat_map(|&(r, even)| [(-r, even), (r, even)]);
        let radius = self.field.radius;
        let ends = [-1.0, -radius, 0.0, radius, 1.0].map(|xi| (xi, self.pressure0(xi)));
        let mut sampled: Vec<(f64, f64)> =
            known.map(|(xi, even)| (xi, even + self.field.odd_pressure(xi))).chain(ends).collect();
        sampled.sort_by(|one, two| one.0.total_cmp(&two.0));
        sampled.dedup_by_key(|sample| sample.0);
        sampled
    }

    /// The elastic displacement along the diameter of the tilt, also beyond the base.
    #[must_use]
    pub(crate) fn elastic_displacement0(&self, xi: f64) -> f64 {
        if xi.abs() > self.field.radius {
            return self.field.displacement_outside(xi);
        }
        // At a step the height is that of the inner side.
        let r = if self.field.radius < 1.0 {
            xi.abs().min(self.field.radius * (1.0 - 1e-12))
        } else {
            xi.abs()
        };
        let State { settlement, tilt, .. } = self.field.state;
        settlement - tilt * xi - (self.problem.height)(r)
    }

    /// `d(P0, M0)/d(delta0, -alpha0) = diag(2 e c^(1+mu)/(1+mu), 4 e c^(3+mu)/((1+mu)^2 (3+mu)))`; a free edge that moves adds nothing of first order.
    #[must_use]
    pub(crate) fn stiffness0(&self) -> Stiffness {
        Stiffness {
            force_settlement: self.field.rate(),
            coupling: 0.0,
            moment_tilt: self.field.turning(),
        }
    }

    /// The largest `|p0|` seen, at a corner without its factor `(1 - r^2/c^2)^-((1-mu)/2)`.
    #[must_use]
    pub(crate) fn largest_inside0(&self) -> f64 {
        self.largest
    }

    /// What is left of tension and penetration.
    #[must_use]
    pub(crate) fn complementarity(&self) -> Complementarity {
        self.complementarity
    }

    /// The estimated error; that of the pressure in the middle, nearer to the edge it grows as `(1 - r^2/c^2)^-((1-mu)/2)`.
    #[must_use]
    pub(crate) fn accuracy(&self) -> &Accuracy {
        &self.accuracy
    }

    /// The estimated error of a free edge, in `xi`.
    #[must_use]
    pub(crate) fn edge_error0(&self) -> f64 {
        self.edge_error
    }

    /// The largest estimated error relative to its size.
    #[must_use]
    pub(crate) fn relative_error(&self) -> f64 {
        self.accuracy.relative(&self.field.state.sizes(self.largest))
    }

    /// Number of coefficients that stand for the base.
    #[must_use]
    pub(crate) fn modes(&self) -> usize {
        self.field.transform.size()
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
    let by_force = matches!(problem.load.vertical, Vertical::Force(_));
    let arm = match problem.load.rotational {
        Rotational::Eccentricity(e) if !by_force => e.abs() * force_error,
        _ => 0.0,
    };
    let of = |unknown: bool, error: f64| if unknown { error } else { 0.0 };
    let by_moment = matches!(problem.load.rotational, Rotational::Moment(_));
    let by_tilt = matches!(problem.load.rotational, Rotational::Tilt(_));
    let shift = (turn + arm) / field.turning();
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure,
        settlement: of(by_force, depth_error + ROUNDING * settlement.abs()),
        tilt: of(!by_tilt, shift.max(ROUNDING * tilt.abs())),
        force: of(!by_force, force_error),
        moment: of(!by_moment, turn + arm),
    };
    let edge = if field.is_free {
        (depth_error / slope.max(f64::MIN_POSITIVE)).max(ROUNDING * field.radius).min(1.0)
    } else {
        0.0
    };
    (accuracy, edge)
}

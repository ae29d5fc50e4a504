//! The settlement relative to a stated point.
//!
//! In plane strain the half-plane yields by the logarithm of the distance, without end: a settlement means something only against another point. The surface
//! at a distance, or a point in the depth, moves in the same gauge by what follows from the pressure, and the difference is free of any gauge.

use std::f64::consts::{FRAC_PI_2, PI};

use serde::Serialize;

use crate::bodies::Bodies;
use crate::error::InverseError;
use crate::{Contact, Error, Geometry, Scaling};

/// Nodes on either side of the middle of a piece, and how far they reach.
const HALF_COUNT: i32 = 220;
const REACH: f64 = 3.4;

/// The point against which a settlement is measured, in the units of the problem.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(tag = "datum", content = "at", rename_all = "snake_case")]
pub enum Datum {
    /// The surface at this `x`.
    Distance(f64),
    /// The point at this depth under the middle of the punch.
    Depth(f64),
}

/// A settlement relative to a datum (m).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RelativeSettlement {
    /// The datum.
    #[serde(flatten)]
    pub datum: Datum,
    /// By how much the datum itself moves in the gauge of the settlement, positive into the body.
    pub displacement: f64,
    /// The settlement of the punch minus that.
    pub settlement: f64,
}

impl Contact {
    /// The settlement relative to a point of the body. It depends on no gauge.
    ///
    /// The surface at `x` moves by `theta int ln(a/|x-s|) p(s) ds`; the point at the depth `y` under the middle (from Flamant's solution, plane strain) by
    /// `theta int [ln(a/r) + y^2/(2 (1-nu) r^2)] p(s) ds`, `r^2 = s^2 + y^2`.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a distance that is zero or not finite and a depth that is not positive; [`Error::Inverse`] for an elastic punch, which
    /// has a gauge of its own, and for a depth where that solution is not known: dimensionless problems (`nu`), graded foundations, circular and periodic geometries.
    pub fn relative_settlement(&self, datum: Datum) -> Result<RelativeSettlement, Error> {
        let bodies = self.problem().bodies();
        if self.problem().punch().body().is_some() {
            let words = "a datum belongs to a rigid punch: the settlement of an elastic one is the approach of two bodies";
            return Err(InverseError::Unsuited(words).into());
        }
        let displacement = match datum {
            Datum::Distance(x) => {
                let given = x.is_finite() && x != 0.0;
                crate::error::require(given, "datum distance", x, "finite and other than zero")?;
                // Beyond one period a row repeats itself.
                let x = match bodies.geometry() {
                    Geometry::Periodic { period } => {
                        let period = period * (self.half_width() / bodies.half_width());
                        x - period * (x / period).round()
                    }
                    _ => x,
                };
                self.elastic_displacement(x)
            }
            Datum::Depth(depth) => self.displacement_at_depth(depth)?,
        };
        if !displacement.is_finite() {
            let quantity = "displacement of the datum";
            return Err(Error::Overflow { quantity, value: displacement });
        }
        let settlement = self.settlement() - displacement;
        Ok(RelativeSettlement { datum, displacement, settlement })
    }

    fn displacement_at_depth(&self, depth: f64) -> Result<f64, Error> {
        crate::error::positive("datum depth", depth)?;
        let bodies = self.problem().bodies();
        let plane = matches!(bodies.geometry(), Geometry::Plane | Geometry::Pair { .. });
        let (Bodies::Physical { foundation, grading: None, layering: None, .. }, true) =
            (bodies, plane)
        else {
            let words = "a datum in the depth belongs to a physical problem of plane punches on a homogeneous foundation; elsewhere give a distance";
            return Err(InverseError::Unsuited(words).into());
        };
        let y = depth / self.half_width();
        let share = 0.5 / (1.0 - foundation.poisson_ratio());
        let kernel = |s: f64| {
            let r = s.hypot(y);
            share * (y / r).powi(2) - r.ln()
        };
        let given = bodies.theta0() * self.carried(&kernel);
        Ok(given * self.scale(Scaling::displacement))
    }

    /// `int k(xi) p0(xi) dxi` for a kernel that may change fast around the middle.
    fn carried(&self, kernel: &dyn Fn(f64) -> f64) -> f64 {
        let mut cuts = self.problem().profile().breakpoints(self.problem().bodies().half_width());
        cuts.push(0.0);
        cuts.sort_by(f64::total_cmp);
        let mut sum = 0.0;
        for [left, right] in self.dimensionless().zones() {
            let mut from = left;
            let inside = cuts.iter().copied().filter(|cut| *cut > left && *cut < right);
            for to in inside.chain([right]) {
                sum += integral(from, to, &|xi| {
                    let pressure = self.pressure_at(xi);
                    if pressure.is_finite() { pressure * kernel(xi) } else { 0.0 }
                });
                from = to;
            }
        }
        sum
    }
}

/// `int_left^right f dx` by the double-exponential rule, which minds no logarithm at an end.
pub(crate) fn integral(left: f64, right: f64, f: &dyn Fn(f64) -> f64) -> f64 {
    let step = REACH / f64::from(HALF_COUNT);
    let length = right - left;
    (-HALF_COUNT..=HALF_COUNT)
        .map(|j| {
            let t = step * f64::from(j);
            let s = FRAC_PI_2 * t.sinh();
            // Distance from the nearer end, as a share of the length.
            let share = 1.0 / (1.0 + (2.0 * s.abs()).exp());
            let weight = 0.25 * PI * t.cosh() / s.cosh().powi(2);
            let x = if s < 0.0 { left + length * share } else { right - length * share };
            step * length * weight * f(x.clamp(left, right))
        })
        .sum()
}

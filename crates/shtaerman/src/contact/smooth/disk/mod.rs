//! The smooth limit of a circular punch, by the transforms of Galin and Sneddon, on graded ground those of Popov and Hess.
//!
//! With the exponent of grading `mu`, `beta = (1-mu)/2`, `e = 4^beta/(theta0 Gamma(1-beta)^2)`, without grading `2/(pi theta0)`, the dimensionless `E*`,
//! `h = df0/dr` and `G(x) = x^(1-mu) int_0^x h(r) dr/(x^2 - r^2)^beta`, a contact within `r <= c` has
//!
//! - `d(x) = delta0 - f0(0) - G(x)`, `P0 = 2 e int_0^c x^mu d(x) dx`, `d(c) = 0` at a free edge;
//! - `p0(r) = (e/pi) [d(c)/(c^2 - r^2)^beta + int_r^c G'(x) dx/(x^2 - r^2)^beta]`;
//! - `u0(r) = (2/pi) cos(pi mu/2) int_0^c x^mu d(x) dx/(r^2 - x^2)^((1+mu)/2)` beside it;
//!
//! and a tilt of the whole disk adds `-(2/pi) e alpha0 x/((1+mu) (c^2 - r^2)^beta)` to the pressure, `M0 = -4 e c^(3+mu) alpha0/((1+mu)^2 (3+mu))` (L. A. Galin 1946,
//! I. N. Sneddon 1965; V. L. Popov, M. Hess and E. Willert, *Handbook of Contact Mechanics*, 2019, ch. 2 and 9). On homogeneous ground a contact that is no single disk is
//! that of rings.

mod answer;
mod check;
mod field;
mod radius;

use answer::SmoothDiskContact;

use std::fmt;
use std::sync::Arc;

use fredholm::inversion::{Powers, Shape, Symmetry, Weight};

use super::Curve;
use crate::contact::balance::State;
use crate::contact::parts::MOST_CUTS;
use crate::contact::steps::{REACH, rise};
use crate::contact::valleys::SAMPLES;
use crate::deadline::Deadline;
use crate::error::require;
use crate::{Error, Load, Rotational, Vertical};
use check::Check;
use field::Field;

/// A circular punch on a smooth body, without dimensions:
///
/// `pi theta0 int W_0(r, s) p0(s) s ds = delta0 - f0(r)`, `W_0 = int_0^inf t^mu J_0(r t) J_0(s t) dt`, on a disk, and the tilt of the whole base.
#[derive(Clone)]
pub(crate) struct SmoothDisk {
    /// `mu` of a graded body, `0 <= mu < 1`; 0 for a homogeneous one.
    pub(crate) exponent: f64,
    /// `theta0 > 0`.
    pub(crate) theta0: f64,
    /// What is prescribed.
    pub(crate) load: Load,
    /// `f0(r)`, `0 <= r <= 1`.
    pub(crate) height: Curve,
    /// `df0/dr`, at a kink on either side.
    pub(crate) slope: Curve,
    /// Where the profile has kinks or steps.
    pub(crate) breaks: Vec<f64>,
    /// The points of a measured profile, between which it is a polynomial.
    pub(crate) joints: Vec<f64>,
    /// Relative accuracy of integrals of the slope; 0 for the best, about `1e-10` for measured points.
    pub(crate) tolerance: f64,
    /// Whether the radius of the contact is part of the answer, with the pressure nowhere negative.
    pub(crate) is_unilateral: bool,
    /// When the search for rings has to come to its end.
    pub(crate) deadline: Deadline,
    /// Whether it is past.
    pub(crate) is_over: Arc<dyn Fn() -> bool + Send + Sync>,
}

impl fmt::Debug for SmoothDisk {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { exponent, theta0, load, breaks, tolerance, is_unilateral, .. } = self;
        formatter
            .debug_struct("SmoothDisk")
            .field("exponent", exponent)
            .field("theta0", theta0)
            .field("load", load)
            .field("breaks", breaks)
            .field("tolerance", tolerance)
            .field("is_unilateral", is_unilateral)
            .finish_non_exhaustive()
    }
}

/// A radius with its load.
struct Candidate {
    radius: f64,
    is_free: bool,
    /// `delta0 - f0(0)`.
    depth: f64,
    force: f64,
}

impl SmoothDisk {
    /// Solves the problem.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a problem that is not one, a force that is not positive in unilateral contact, a step inside the base in
    /// bilateral contact; [`Error::NoContact`]; [`Error::Rings`] where the contact is no single disk; [`Error::LiftsOff`] for a moment that does not leave the whole base in contact; [`Error::Overflow`] when the answer is not finite.
    pub(crate) fn solve(&self) -> Result<SmoothDiskContact, Error> {
        self.check()?;
        let limit = self.limit()?;
        let shape = self.shape()?;
        if !self.is_unilateral {
            let field = self.field(&shape, &self.full(&shape, 1.0));
            let field = self.turned(field);
            let left = Check::new(self, &field);
            return SmoothDiskContact::new(self, &shape, field, &left);
        }
        self.require_load()?;
        let mut refused = None;
        for candidate in self.candidates(&shape, limit) {
            let field = self.field(&shape, &candidate);
            let left = Check::new(self, &field);
            match left.require() {
                Ok(()) => {
                    let field = self.turned(field);
                    left.require_contact(self, &field)?;
                    return SmoothDiskContact::new(self, &shape, field, &left);
                }
                Err(error) => refused = refused.or(Some(error)),
            }
        }
        Err(refused.unwrap_or(Error::Rings { variable: "xi", at: 0.0, found: "no contact" }))
    }

    /// `e`.
    pub(super) fn modulus(&self, ground: &Powers) -> f64 {
        ground.modulus(std::f64::consts::PI * self.theta0)
    }

    pub(super) fn shape(&self) -> Result<Shape<'_>, Error> {
        let mut breaks: Vec<f64> =
            self.breaks.iter().copied().filter(|at| *at > 0.0 && *at < 1.0).collect();
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        if breaks.len() > MOST_CUTS {
            breaks.clear();
        }
        let powers = Powers::new(self.exponent)?;
        let (slope, joints, tolerance) = (&*self.slope, self.joints.clone(), self.tolerance);
        let (part, is_over) = (Symmetry::Revolution, &*self.is_over);
        Ok(Shape { slope, breaks, joints, tolerance, noise: 0.0, powers, part, is_over })
    }

    fn samples(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let places = (0..=SAMPLES).map(|i| i as f64 / SAMPLES as f64);
        places.map(|r| (r, (self.height)(r)))
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        let Self { theta0, load, .. } = self;
        require(theta0.is_finite() && *theta0 > 0.0, "theta0", *theta0, "finite and positive")?;
        Load::new(load.vertical, load.rotational)?;
        for (r, height) in self.samples() {
            require(height.is_finite(), "profile", r, "such that the height is finite")?;
        }
        Ok(())
    }

    /// The largest radius of a contact: the edge of the base or the first step.
    fn limit(&self) -> Result<f64, Error> {
        let is_step =
            |at: &f64| *at > REACH && at + REACH < 1.0 && rise(&*self.height, *at).is_some();
        let first = self.breaks.iter().copied().filter(is_step).fold(1.0, f64::min);
        require(
            self.is_unilateral || first == 1.0,
            "profile",
            first,
            "without a step inside the base: bilateral contact of smooth bodies has no pressure across one",
        )?;
        Ok(first)
    }

    fn require_load(&self) -> Result<(), Error> {
        match self.load.vertical {
            Vertical::Force(force) => {
                let requirement =
                    "greater than zero in unilateral contact: a pull lifts the punch off";
                require(force > 0.0, "force", force, requirement)?;
            }
            Vertical::Settlement(settlement) => {
                let lowest = self.samples().min_by(|one, two| one.1.total_cmp(&two.1));
                let (at, height) = lowest.unwrap_or_default();
                if settlement <= height {
                    return Err(Error::NoContact);
                }
                if settlement <= (self.height)(0.0) {
                    return Err(Error::Rings {
                        variable: "xi",
                        at,
                        found: "contact without the axis",
                    });
                }
            }
        }
        Ok(())
    }

    /// Contact up to a wall.
    fn full(&self, shape: &Shape<'_>, radius: f64) -> Candidate {
        // P0 = rate [depth - c int h(c cos t) sin^(2+mu) t dt]
        let compliance = 1.0 / field::rate(&shape.powers, self.modulus(&shape.powers), radius);
        let mean = radius * shape.integral(radius, Weight::SineSquared);
        let (depth, force) = match self.load.vertical {
            Vertical::Force(force) => (force * compliance + mean, force),
            Vertical::Settlement(settlement) => {
                let depth = settlement - (self.height)(0.0);
                (depth, (depth - mean) / compliance)
            }
        };
        Candidate { radius, is_free: false, depth, force }
    }

    /// Disks with the load prescribed, from the smallest.
    fn candidates<'a>(
        &'a self,
        shape: &'a Shape<'_>,
        limit: f64,
    ) -> impl Iterator<Item = Candidate> + 'a {
        let modulus = self.modulus(&shape.powers);
        let force = move |c: f64| {
            let rate = field::rate(&shape.powers, modulus, c);
            rate * c * shape.integral(c, Weight::CosineSquared)
        };
        let height = (self.height)(0.0);
        let radii = match self.load.vertical {
            Vertical::Force(target) => radius::crossings(&force, target, &shape.breaks, limit),
            Vertical::Settlement(settlement) => {
                let depth = |c: f64| shape.transform(c);
                radius::crossings(&depth, settlement - height, &shape.breaks, limit)
            }
        };
        let free = radii.into_iter().map(move |radius| {
            let (depth, force) = match self.load.vertical {
                Vertical::Force(prescribed) => (shape.transform(radius), prescribed),
                Vertical::Settlement(settlement) => (settlement - height, force(radius)),
            };
            Candidate { radius, is_free: true, depth, force }
        });
        free.chain(std::iter::once_with(move || self.full(shape, limit)))
    }

    fn field(&self, shape: &Shape<'_>, candidate: &Candidate) -> Field {
        let &Candidate { radius, is_free, depth, force } = candidate;
        let settlement = match self.load.vertical {
            Vertical::Settlement(settlement) => settlement,
            Vertical::Force(_) => depth + (self.height)(0.0),
        };
        let state = State { settlement, tilt: 0.0, force, moment: 0.0 };
        Field::new(shape, self.modulus(&shape.powers), [radius, depth], is_free, state)
    }

    /// The same with the tilt of the load.
    fn turned(&self, mut field: Field) -> Field {
        let turning = field.turning();
        let (tilt, moment) = match self.load.rotational {
            Rotational::Tilt(tilt) => (tilt, -tilt * turning),
            Rotational::Moment(moment) => (-moment / turning, moment),
            Rotational::Eccentricity(e) => {
                (-e * field.state.force / turning, e * field.state.force)
            }
        };
        // Adding zero turns a negative zero into a plain one.
        (field.state.tilt, field.state.moment) = (tilt + 0.0, moment + 0.0);
        field
    }

    /// Name and value of the rotational load.
    pub(super) fn rotational(&self) -> (&'static str, f64) {
        match self.load.rotational {
            Rotational::Moment(value) => ("moment", value),
            Rotational::Eccentricity(value) => ("eccentricity", value),
            Rotational::Tilt(value) => ("tilt", value),
        }
    }
}

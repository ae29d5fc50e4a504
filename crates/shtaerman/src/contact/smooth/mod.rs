//! The smooth limit: contact without a layer, an equation of the first kind on the zones.
//!
//! `theta0 int K(xi, eta) p0(eta) dm(eta) = delta0 - alpha0 xi - f0(xi)`. The pressure is singular at the walls of the base, `p0 ~ d^-beta` at a distance `d`, and vanishes as `d^(1-beta)` at free
//! edges; `beta = 1/2`, on graded ground `(1 - mu)/2`.
//!
//! What the ground makes of given zones is a [`FirstKind`]: a [plane](plane), [graded] ground, a [disk] with rings about it. Everything else is here once: the [base](base) of the punch, the zones by the
//! [search](crate::contact::search), a [check] between the places where the equation holds, the [errors](stated), and the [answer].

mod answer;
mod base;
mod check;
mod disk;
mod equation;
mod graded;
mod modes;
mod plane;
mod pressure;
mod stated;
mod topology;

use std::sync::Arc;

use super::setting::Setting;
use super::solution::Solution;
use crate::Error;
use answer::contact;
use base::Base;
use equation::FirstKind;

impl Setting {
    /// The contact of a smooth surface.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a force that is not positive in unilateral contact, a step inside a base in bilateral contact, and what a geometry does not know; [`Error::TipsOver`],
    /// [`Error::NoContact`], [`Error::NotComplementary`] when no zones were found, [`Error::ZonesTooClose`], [`Error::TooManyZones`] for more than can be coupled, [`Error::Rings`] and
    /// [`Error::LiftsOff`] for disks that tilt or stand on graded ground.
    pub(super) fn without_layer(&self) -> Result<Arc<dyn Solution>, Error> {
        let base = Arc::new(Base::new(self)?);
        let bodies = self.problem().bodies();
        match bodies.grading() {
            _ if bodies.is_circular() => disk::solve(base),
            Some(grading) => answer(&graded::Graded::new(base, grading.exponent())?),
            None if self.problem().is_wave() => plane::wave(&base),
            None => answer(&plane::Plane::new(base)),
        }
    }
}

/// The answer on the whole base, or on the zones where it touches.
fn answer<F: FirstKind>(equation: &F) -> Result<Arc<dyn Solution>, Error> {
    Ok(Arc::new(contact(equation)?))
}

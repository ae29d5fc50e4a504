//! A half-space under a circular punch: a disk of contact with rings about it.
//!
//! With the exponent of grading `mu`, `beta = (1-mu)/2`, `e = 4^beta/(theta0 Gamma(1-beta)^2)`, without grading `2/(pi theta0)`, the dimensionless `E*`, `h = df0/dr` and
//! `G(x) = x^(1-mu) int_0^x h(r) dr/(x^2 - r^2)^beta`, a contact within `r <= c` has
//!
//! - `d(x) = delta0 - f0(0) - G(x)`, `P0 = 2 e int_0^c x^mu d(x) dx`, `d(c) = 0` at a free edge;
//! - `p0(r) = (e/pi) [d(c)/(c^2 - r^2)^beta + int_r^c G'(x) dx/(x^2 - r^2)^beta]`;
//! - `u0(r) = (2/pi) cos(pi mu/2) int_0^c x^mu d(x) dx/(r^2 - x^2)^((1+mu)/2)` beside it;
//!
//! and a tilt of the whole disk adds `-(2/pi) e alpha0 x/((1+mu) (c^2 - r^2)^beta)` to the pressure, `M0 = -4 e c^(3+mu) alpha0/((1+mu)^2 (3+mu))` (L. A. Galin 1946,
//! I. N. Sneddon 1965; V. L. Popov, M. Hess and E. Willert, *Handbook of Contact Mechanics*, 2019, ch. 2 and 9).
//!
//! On a [ring] the kernel is a logarithm of the radius and what is smooth beside it, so the [modes](super::modes) of plane contact serve; a disk inside the rings is eliminated by the transforms. Rings are
//! solved for on homogeneous ground, without a tilt.

mod core;
mod coupling;
mod ring;
mod ring_part;
mod solved;
mod tilt;

use std::cell::{OnceCell, RefCell};
use std::sync::Arc;

use fredholm::inversion::{AbelTransform, Powers, Shape, Symmetry};

use super::answer::contact;
use super::base::Base;
use super::check::check;
use super::equation::{COMPARED, Detail, FINE, FirstKind};
use crate::contact::edges::settle;
use crate::contact::search::ALLOWED;
use crate::contact::solution::Solution;
use crate::contact::zones::Zone;
use crate::{Error, Rotational};
use solved::Solved;
use tilt::require_contact;

/// In the answer a transform serves radii that are smaller by this share, so that steps to the edge do not ask for one each: it is known to its rounding at its own end, and falls by no more than a few times this (theory).
const NEARBY: f64 = 1e-6;

/// While zones are looked for a transform serves radii down to this share of its own: under a parabola it is known there to `eps/SERVED^2`, 1e-12 (theory), which an edge that is looked for does not ask for, and steps that halve the radius ask for one in
/// six of them.
const SERVED: f64 = 1.0 / 64.0;

/// The contact of a circular punch.
pub(super) fn solve(base: Arc<Base>) -> Result<Arc<dyn Solution>, Error> {
    let disk = Disk::new(base)?;
    if disk.takes_rings() {
        return Ok(Arc::new(contact(&disk)?));
    }
    let found = contact(&disk);
    let found = match found {
        Ok(found) => found,
        Err(
            error @ (Error::InvalidValue { .. } | Error::Overflow { .. } | Error::TimeLimit { .. }),
        ) => {
            return Err(error);
        }
        Err(_) => return Err(disk.rings()),
    };
    require_contact(&disk, found.solved())?;
    Ok(Arc::new(found))
}

/// The equation on a half-space.
pub(super) struct Disk {
    base: Arc<Base>,
    powers: Powers,
    /// `e`.
    modulus: f64,
    /// What is prescribed of the tilt.
    rotational: Rotational,
    /// The transform over the whole base, and the last one up to less.
    whole: OnceCell<AbelTransform>,
    latest: RefCell<Option<(f64, Arc<AbelTransform>)>>,
}

impl Disk {
    fn new(base: Arc<Base>) -> Result<Self, Error> {
        let powers = Powers::new(base.ground.exponent())?;
        let modulus = powers.modulus(std::f64::consts::PI * base.setting.theta0());
        let rotational = base.setting.load().rotational;
        let (whole, latest) = (OnceCell::new(), RefCell::new(None));
        Ok(Self { base, powers, modulus, rotational, whole, latest })
    }

    /// Whether a contact of rings can be solved for.
    fn takes_rings(&self) -> bool {
        self.powers.exponent() == 0.0 && self.rotational.named().1 == 0.0
    }

    /// That the contact is no single disk, with a place that shows it.
    fn rings(&self) -> Error {
        let bodies = self.base.setting.problem().bodies();
        let whole = self.base.whole();
        let seen =
            settle(self, &whole, &FINE, None).map(|solved| check(&self.base, &solved, ALLOWED));
        let (at, found) = match seen {
            Ok(left) if !left.pulling.is_empty() => {
                (0.5 * (left.pulling[0][0] + left.pulling[0][1]), "tension")
            }
            Ok(left) if !left.penetrating.is_empty() => (left.penetrating[0][1], "penetration"),
            _ => (self.base.lowest(), "contact without the axis"),
        };
        let (variable, at) = (bodies.coordinate(), at * bodies.half_width());
        Error::Rings { variable, at, found, roughness: None }
    }

    /// The transform up to a radius: while zones are looked for a part of the one over the whole base where that tells it, else of the last one that reached hardly farther.
    fn transform(&self, radius: f64, is_own: bool) -> Arc<AbelTransform> {
        let up_to = |radius: f64| self.with_shape(|shape| AbelTransform::new(shape, radius));
        let part = || self.whole.get_or_init(|| up_to(1.0)).within(radius);
        if let Some(part) = if is_own { None } else { part() } {
            return Arc::new(part);
        }
        let (share, served) = if is_own { (1.0 - NEARBY, 1.0 - NEARBY) } else { (0.5, SERVED) };
        let mut latest = self.latest.borrow_mut();
        let known = latest.as_ref().filter(|(far, _)| served * far <= radius && radius <= *far);
        // While the edges of rings move that of the disk often rests.
        if let Some((far, transform)) = known
            && let Some(part) = if *far == radius {
                Some(Arc::clone(transform))
            } else {
                transform.within(radius).map(Arc::new)
            }
        {
            return part;
        }
        let far = (radius / share).min(1.0);
        let transform = Arc::new(up_to(far));
        let part = transform.within(radius).map(Arc::new);
        // Where a kink lies between that tells nothing of the radius.
        let (far, transform) =
            if part.is_some() { (far, transform) } else { (radius, Arc::new(up_to(radius))) };
        *latest = Some((far, Arc::clone(&transform)));
        part.unwrap_or(transform)
    }

    /// The slope of the base along a radius, for Abel's transforms.
    fn with_shape<T>(&self, of: impl FnOnce(&Shape<'_>) -> T) -> T {
        let base = &self.base;
        let shape = Shape {
            slope: &|r| base.quick_slope(r),
            breaks: base.breaks.clone(),
            joints: base.joints.clone(),
            tolerance: base.tolerance,
            noise: 0.0,
            remote: 0.0,
            powers: self.powers.clone(),
            part: Symmetry::Revolution,
            is_over: &|| base.deadline().is_past(),
        };
        of(&shape)
    }
}

impl FirstKind for Disk {
    type Solved = Solved;
    const MOST_ZONES: usize = 48;

    fn base(&self) -> &Arc<Base> {
        &self.base
    }

    fn on_zones(&self, zones: &[Zone], detail: Detail) -> Result<Solved, Error> {
        let is_disk = |zone: &Zone| zone.left() == 0.0;
        if !self.takes_rings() && !matches!(zones, [zone] if is_disk(zone)) {
            return Err(Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN });
        }
        Solved::new(self, zones, detail)
    }

    /// With fewer modes, other panels, and less of the series of the disk.
    fn compared(&self, solved: &Solved) -> Option<Solved> {
        if solved.has_rings() {
            return Some(Solved::new(self, &solved.zones, COMPARED).ok()?.compared(self));
        }
        Some(solved.compared(self))
    }
}

//! A half-plane whose modulus grows with depth, under one punch or a pair.
//!
//! `theta0 int |xi - eta|^-mu p0(eta) deta = delta0 - alpha0 xi - f0(xi)` on zones. Corners hold a pressure that is singular as `d^-beta`, `beta = (1-mu)/2`, at
//! free edges it vanishes as `d^(1-beta)`.
//!
//! On a [strip] the profile has [parts](on_zone): kinks, and a rest that is a series of the polynomials which the kernel maps to multiples of themselves or, where it bends otherwise, is solved by Abel's
//! transforms of its even and odd halves. Several strips are [coupled](couple) by those polynomials.

mod couple;
mod on_zone;
mod solved;
mod strip;

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use fredholm::inversion::Powers;

use super::base::Base;
use super::equation::{Detail, FirstKind};
use crate::Error;
use crate::contact::zones::Zone;
use solved::Solved;

/// The equation on graded ground.
pub(super) struct Graded {
    base: Arc<Base>,
    ground: Ground,
}

/// The kernel with its `theta0`.
#[derive(Debug, Clone)]
struct Ground {
    powers: Powers,
    /// `e = 4^beta pi/(Lambda Gamma(1-beta)^2)`, `Lambda = pi theta0/(Gamma(mu) cos(pi mu/2))`.
    modulus: f64,
}

impl Graded {
    pub(super) fn new(base: Arc<Base>, exponent: f64) -> Result<Self, Error> {
        let powers = Powers::new(exponent)?;
        let theta0 = base.setting.theta0();
        let response = theta0 * PI / (libm::tgamma(exponent) * (FRAC_PI_2 * exponent).cos());
        let ground = Ground { modulus: powers.modulus(response), powers };
        Ok(Self { base, ground })
    }
}

impl FirstKind for Graded {
    type Solved = Solved;

    fn base(&self) -> &Arc<Base> {
        &self.base
    }

    fn on_zones(&self, zones: &[Zone], detail: Detail) -> Result<Solved, Error> {
        Solved::new(&self.base, &self.ground, zones, detail.digits)
    }

    fn compared(&self, solved: &Solved) -> Option<Solved> {
        Some(solved.truncated())
    }
}

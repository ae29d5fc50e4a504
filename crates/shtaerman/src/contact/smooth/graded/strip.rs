//! The pressures on zones of given ends, as far as it takes no panels.
//!
//! On `xi = c + s`, `|s| <= b`, with the slopes `h_e`, `h_o` of the even and the odd part of the profile about `c`, the depth `D = delta0 - alpha0 c - f0(c)`,
//! `S(t) = int_0^t sin^mu`, `B = S(pi/2)`, `Lambda = pi theta0/(Gamma(mu) cos(pi mu/2))` and `e = 4^beta pi/(Lambda Gamma(1-beta)^2)`,
//!
//! - `G_e(x) = x int_0^{pi/2} h_e(x cos t) (cos t sin^mu t + mu sin t S(t)) dt`, `G_o(x) = int_0^{pi/2} h_o(x cos t) sin^mu t dt`;
//! - `p0 = (e/pi) [d_e(b) (b^2 - s^2)^-beta + int_|s|^b G_e' (x^2 - s^2)^-beta dx + s (the same of d_o, G_o)]`, `d_e = mu B D - G_e`, `d_o = -alpha0 B - G_o`;
//! - `P0 = (2e/pi) B b^mu (mu B D - mu b int h_e sin t S dt)`,
//!   `M0 = c P0 + (2e/pi) B b^(2+mu) (-alpha0 B/(2+mu) - int h_o sin^(2+mu) t dt/(1+mu))`.

use std::f64::consts::{FRAC_PI_2, PI};

use fredholm::inversion::Powers;
use libm::tgamma;

use crate::Error;
use crate::contact::balance::State;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;

/// The kernel with its `theta0`.
#[derive(Debug, Clone)]
pub(super) struct Ground {
    pub(super) powers: Powers,
    /// `e`.
    pub(super) modulus: f64,
}

impl Ground {
    pub(super) fn new(exponent: f64, theta0: f64) -> Result<Self, Error> {
        let powers = Powers::new(exponent)?;
        let response = theta0 * PI / (tgamma(exponent) * (FRAC_PI_2 * exponent).cos());
        let modulus = powers.modulus(response);
        Ok(Self { powers, modulus })
    }

    /// `B`.
    pub(super) fn total(&self) -> f64 {
        self.powers.total()
    }
}

/// A zone with its loads.
#[derive(Debug, Clone, Copy)]
pub(super) struct Strip {
    pub(super) zone: Zone,
    /// Of all zones together, and its stiffness.
    pub(super) state: State,
    pub(super) stiffness: Stiffness,
    /// Of this zone alone, about its middle.
    pub(super) own: Stiffness,
    pub(super) force: f64,
    /// The even and the odd density without the profile's: of one zone `mu B D` and `-alpha0 B`.
    pub(super) levels: [f64; 2],
    /// `G_e(b)`, `G_o(b)`, of a smooth profile those of its first two polynomials.
    pub(super) transforms: [f64; 2],
    /// What other polynomials add at the ends, those of others and of the profile, and its size.
    pub(super) ripple: [f64; 2],
    pub(super) ripple_size: f64,
    /// Size of the slope of the profile.
    pub(super) steepest: f64,
}

impl Strip {
    pub(super) fn half(&self) -> f64 {
        0.5 * self.zone.length()
    }

    pub(super) fn centre(&self) -> f64 {
        0.5 * (self.zone.left() + self.zone.right())
    }

    /// `D` of one zone.
    pub(super) fn depth(&self, ground: &Ground) -> f64 {
        self.levels[0] / (ground.powers.exponent() * ground.total())
    }

    /// `d_e(b) -+ b d_o(b)` at the left (0) or right (1) end.
    pub(super) fn end_density(&self, side: usize) -> f64 {
        let [even, odd] = [0, 1].map(|part| self.levels[part] - self.transforms[part]);
        let arm = if side == 0 { -self.half() } else { self.half() };
        even + arm * odd + self.ripple[side]
    }

    /// Size of what is added up in that.
    pub(super) fn density_scale(&self) -> f64 {
        let [even, odd] = [0, 1].map(|part| self.levels[part].abs() + self.transforms[part].abs());
        even + self.half() * (odd + self.steepest) + self.ripple_size
    }
}

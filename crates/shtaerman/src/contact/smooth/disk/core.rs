//! The disk inside the rings, or alone.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use fredholm::inversion::{AbelTransform, Place, Powers, TURN};

/// A disk of contact with what the rings about it make of its own depth.
#[derive(Debug, Clone)]
pub(super) struct Core {
    /// `c`.
    pub(super) radius: f64,
    pub(super) is_free: bool,
    /// `G`; none for a flat base.
    pub(super) transform: Option<Arc<AbelTransform>>,
    pub(super) powers: Powers,
    /// `e`.
    pub(super) modulus: f64,
    /// `delta0 - f0(0)`.
    pub(super) level: f64,
    /// `d(c)` and its slope.
    pub(super) corner: f64,
    pub(super) slope: f64,
    /// Rounding of the depth, relative to it.
    pub(super) rounding: f64,
    /// `alpha0`.
    pub(super) tilt: f64,
}

impl Core {
    /// `dP0/d delta0` of a disk alone.
    pub(super) fn rate(powers: &Powers, modulus: f64, radius: f64) -> f64 {
        2.0 * modulus * radius * powers.power(radius) / (1.0 + powers.exponent())
    }

    /// `dM0/d(-alpha0)` of a disk alone.
    pub(super) fn turning(powers: &Powers, modulus: f64, radius: f64) -> f64 {
        let mu = powers.exponent();
        4.0 * modulus * powers.power(radius) * radius.powi(3) / ((1.0 + mu).powi(2) * (3.0 + mu))
    }

    /// `sqrt(c^2 - r^2)`, by the distance from the edge.
    pub(super) fn root(&self, from_edge: f64) -> f64 {
        (from_edge.max(0.0) * (2.0 * self.radius - from_edge)).sqrt()
    }

    /// What takes the singularity from a pressure: `(1 - r^2/c^2)^beta`.
    pub(super) fn share(&self, from_edge: f64) -> f64 {
        self.powers.taper(self.root(from_edge)) / self.powers.taper(self.radius)
    }

    /// `p0` at a place on this side of the axis, 0 for both, for what rings add besides.
    pub(super) fn pressure(&self, place: Place, side: f64, by_rings: f64) -> f64 {
        let (root, r) = (self.root(place.from_right), place.from_left);
        // At a free edge the corner is rounding.
        let corner = if self.is_free { 0.0 } else { self.corner } + side * self.tilt_density() * r;
        if root == 0.0 {
            return if corner == 0.0 { 0.0 } else { corner * f64::INFINITY };
        }
        let flat = if corner == 0.0 { 0.0 } else { corner / self.powers.taper(root) };
        let bent = self.transform.as_ref().map_or(0.0, |transform| transform.pressure(r));
        self.modulus / PI * (flat + bent + PI * root * by_rings)
    }

    /// What a flat base so deep has in the middle.
    pub(super) fn flat_pressure(&self, depth: f64) -> f64 {
        self.modulus / PI * depth / self.powers.taper(self.radius)
    }

    /// What the tilt adds to the corner, over the radius.
    pub(super) fn tilt_density(&self) -> f64 {
        -2.0 / (1.0 + self.powers.exponent()) * self.tilt
    }

    /// What the tilt adds to the pressure so far from the edge.
    pub(super) fn turned(&self, from_edge: f64) -> f64 {
        let density = self.tilt_density() * (self.radius - from_edge);
        self.modulus / PI * density / self.powers.taper(self.root(from_edge))
    }

    /// How much of the tilt the surface follows at `r >= c`: `(4/pi) cos(pi mu/2)/(1+mu) int_0^z w^(2+mu) (1 - w^2)^(-(1+mu)/2) dw`, `z = c/r`, `w = sin y`.
    pub(super) fn share_of_tilt(&self, r: f64) -> f64 {
        let z = (self.radius / r).min(1.0);
        let powers = &self.powers;
        if powers.exponent() == 0.0 {
            return 2.0 / PI * (z.asin() - z * (1.0 - z * z).sqrt());
        }
        if z >= 1.0 {
            return 1.0;
        }
        let f = |y: f64| powers.power(y.tan()) * y.sin().powi(2);
        let sum = powers.graded(0, [0.0, z.asin()], [TURN, FRAC_PI_2], f);
        2.0 * powers.beside() / (1.0 + powers.exponent()) * sum
    }

    /// `lim sqrt(2 pi) d^beta p0` for `d(c) = 1`.
    pub(super) fn intensity(&self) -> f64 {
        self.modulus / PI * self.corner_scale()
    }

    /// `lim sqrt(2 pi) d^beta (c^2 - r^2)^-beta`.
    pub(super) fn corner_scale(&self) -> f64 {
        if self.powers.exponent() == 0.0 {
            (PI / self.radius).sqrt()
        } else {
            self.powers.corner(self.radius)
        }
    }

    /// Rounding of the depth: of what it is the sum, and of a free edge.
    pub(super) fn depth_rounding(&self) -> f64 {
        let edge =
            if self.is_free { 2.0 * f64::EPSILON * self.slope.abs() * self.radius } else { 0.0 };
        self.rounding * self.level.abs() + edge
    }

    /// What rounding of the transform, and what is not known of bends, makes of the pressure of a flat base.
    pub(super) fn slope_rounding(&self) -> f64 {
        let Some(all) = &self.transform else { return 0.0 };
        all.slope_rounding() * self.radius + all.bend_error() * self.powers.taper(self.radius)
    }
}

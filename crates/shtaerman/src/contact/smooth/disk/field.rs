//! Pressure and displacement of a disk of contact.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

use fredholm::inversion::{AbelTransform, Powers, Shape, TURN, Weight};

use crate::contact::balance::State;

/// A disk of contact.
#[derive(Debug, Clone)]
pub(super) struct Field {
    /// `c`.
    pub(super) radius: f64,
    pub(super) is_free: bool,
    pub(super) state: State,
    pub(super) transform: AbelTransform,
    ground: Powers,
    /// `e`.
    modulus: f64,
    /// `delta0 - f0(0)`.
    depth: f64,
    /// `d(c)`.
    corner: f64,
}

impl Field {
    pub(super) fn new(
        shape: &Shape<'_>,
        modulus: f64,
        [radius, depth]: [f64; 2],
        is_free: bool,
        state: State,
    ) -> Self {
        let ground = shape.powers.clone();
        let rate = rate(&ground, modulus, radius);
        // d(c) = P0/rate - c int h(c cos t) sin^mu t cos^2 t dt
        let corner = if is_free {
            0.0
        } else {
            state.force / rate - radius * shape.integral(radius, Weight::CosineSquared)
        };
        let transform = AbelTransform::new(shape, radius);
        Self { radius, is_free, state, transform, ground, modulus, depth, corner }
    }

    /// The same with less of each series; none where there is nothing to leave out.
    pub(super) fn truncated(&self) -> Option<Self> {
        let other = || Self { transform: self.transform.truncated(), ..self.clone() };
        self.transform.has_tail().then(other)
    }

    /// `delta0 - f0(0)`.
    pub(super) fn level(&self) -> f64 {
        self.depth
    }

    /// `dP0/d delta0`.
    pub(super) fn rate(&self) -> f64 {
        rate(&self.ground, self.modulus, self.radius)
    }

    /// `dM0/d(-alpha0)`.
    pub(super) fn turning(&self) -> f64 {
        let mu = self.ground.exponent();
        let size = self.ground.power(self.radius) * self.radius.powi(3);
        4.0 * self.modulus * size / ((1.0 + mu).powi(2) * (3.0 + mu))
    }

    /// What a flat base this deep has in the middle.
    pub(super) fn flat_pressure(&self, depth: f64) -> f64 {
        self.modulus / PI * depth / self.ground.taper(self.radius)
    }

    /// What a flat base this deep and turned by `-alpha0` adds at `xi`.
    pub(super) fn flat(&self, xi: f64, raise: f64, turn: f64) -> f64 {
        let arm = 2.0 / (1.0 + self.ground.exponent()) * xi;
        self.modulus / PI * (raise + turn * arm) / self.taper(xi.abs())
    }

    /// `P0` from the panels.
    pub(super) fn integrated_force(&self) -> f64 {
        2.0 * self.modulus * self.transform.volume(self.depth)
    }

    /// `sqrt(c^2 - r^2)`.
    pub(super) fn root(&self, r: f64) -> f64 {
        ((self.radius - r) * (self.radius + r)).max(0.0).sqrt()
    }

    /// `(c^2 - r^2)^beta`.
    pub(super) fn taper(&self, r: f64) -> f64 {
        self.ground.taper(self.root(r))
    }

    /// `c^(2 beta)`.
    pub(super) fn whole_taper(&self) -> f64 {
        self.ground.taper(self.radius)
    }

    /// `lim sqrt(2 pi) d^beta (c^2 - r^2)^-beta`.
    pub(super) fn corner_scale(&self) -> f64 {
        if self.ground.exponent() == 0.0 {
            (PI / self.radius).sqrt()
        } else {
            self.ground.corner(self.radius)
        }
    }

    /// The part without angle, at `0 <= r <= c`.
    pub(super) fn even_pressure(&self, r: f64) -> f64 {
        if self.is_free && r >= self.radius {
            return 0.0;
        }
        let corner = if self.corner == 0.0 { 0.0 } else { self.corner / self.taper(r) };
        self.modulus / PI * (corner + self.transform.pressure(r))
    }

    /// `lim (c^2 - r^2)^beta p0` of the part without angle, and of the tilt at `x = c`.
    pub(super) fn corner_factors(&self) -> [f64; 2] {
        [self.modulus / PI * self.corner, self.tilt_factor() * self.radius]
    }

    /// `p1 (c^2 - r^2)^beta/r`.
    pub(super) fn tilt_factor(&self) -> f64 {
        -FRAC_2_PI / (1.0 + self.ground.exponent()) * self.modulus * self.state.tilt
    }

    /// `p0(xi)` in the contact.
    pub(super) fn pressure(&self, xi: f64) -> f64 {
        let r = xi.abs();
        if r >= self.radius && !self.is_free {
            let [even, odd] = self.corner_factors();
            let factor = even + odd * xi.signum();
            return if factor == 0.0 { 0.0 } else { factor * f64::INFINITY };
        }
        self.even_pressure(r) + self.odd_pressure(xi)
    }

    /// What the tilt adds inside.
    pub(super) fn odd_pressure(&self, xi: f64) -> f64 {
        let factor = self.tilt_factor();
        if factor == 0.0 { 0.0 } else { factor * xi / self.taper(xi.abs()) }
    }

    /// The displacement of the surface at `|xi| >= c`.
    pub(super) fn displacement_outside(&self, xi: f64) -> f64 {
        let even = self.transform.displacement(xi.abs(), self.depth);
        even - self.state.tilt * xi * self.share_of_tilt(xi.abs())
    }

    /// How much of the tilt the surface follows at `r >= c`.
    pub(super) fn share_of_tilt(&self, r: f64) -> f64 {
        let z = (self.radius / r).min(1.0);
        if self.ground.exponent() > 0.0 {
            return self.graded_share(z);
        }
        FRAC_2_PI * (z.asin() - z * (1.0 - z * z).sqrt())
    }

    /// `(4/pi) cos(pi mu/2)/(1+mu) int_0^z w^(2+mu) (1 - w^2)^(-(1+mu)/2) dw`, `w = sin y`.
    fn graded_share(&self, z: f64) -> f64 {
        if z >= 1.0 {
            return 1.0;
        }
        let ground = &self.ground;
        let turn = [0.0, z.asin()];
        let f = |y: f64| ground.power(y.tan()) * y.sin().powi(2);
        let sum = ground.graded(0, turn, [TURN, FRAC_PI_2], f);
        2.0 * ground.beside() / (1.0 + ground.exponent()) * sum
    }
}

/// `dP0/d delta0` of a disk.
pub(super) fn rate(ground: &Powers, modulus: f64, radius: f64) -> f64 {
    2.0 * modulus * radius * ground.power(radius) / (1.0 + ground.exponent())
}

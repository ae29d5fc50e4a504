//! What free displacements are off by where a layer bends: by the tangent stiffness, **estimates**.
//!
//! The difference `e` of two pressures has `A e = d - a x - w~` with `A = m + theta K` and the modulus `m >= 0` of the layer between both. With `A psi = 1` and
//! `A chi = x - c`, `c` such that `<1, chi> = 0`, the load says `k (d - a c) = <psi, w~>`, `k = <1, psi>`, and `-k_c a = <chi, w~>`, `k_c = <x - c, chi>`. As `psi >= 0`,
//! `|d - a c| <= W`, the largest `|w~|`. And `|<chi, w~>|` is at most `sqrt(k_c) ||w~/sqrt(m)||`, by the energy, and `W` times the integral of `|chi|`: on the hull of the
//! zones, of half-length `h`, a line is the potential of one density with two signs, and what `A` answers to a potential of one sign has that sign and no larger force than what it
//! answers to the largest value of that potential.

use std::f64::consts::{LN_2, PI};

use crate::kernel::Kernel;

/// The largest potential of `s/(pi sqrt(1 - s^2))` on `[0, 1]` is that at 1: `(pi/2 + 1)/pi`.
const HALF_LINE: f64 = 0.5 + 1.0 / PI;

/// `d(P, M)/d(delta, -alpha)` with the hull of the zones.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tangent {
    pub(crate) stiffness: [[f64; 2]; 2],
    pub(crate) kernel: Kernel,
    pub(crate) theta: f64,
    pub(crate) hull: [f64; 2],
}

/// The residual in two norms: the largest `|w~|` and `||w~/sqrt(m)||`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Residuals {
    pub(crate) largest: f64,
    pub(crate) energy: f64,
}

impl Tangent {
    /// `c`: a force there does not turn the base.
    pub(crate) fn centre(&self) -> f64 {
        let [[k11, k12], _] = self.stiffness;
        k12 / k11
    }

    /// `k`.
    pub(crate) fn level(&self) -> f64 {
        self.stiffness[0][0]
    }

    /// `k_c`; infinite errors follow where rounding has left nothing of it.
    pub(crate) fn about_centre(&self) -> f64 {
        let [_, [_, k22]] = self.stiffness;
        let about = k22 - self.centre() * self.stiffness[0][1];
        if about > 8.0 * f64::EPSILON * k22 { about } else { 0.0 }
    }

    /// A bound of `|<chi, w~>|` without force.
    pub(crate) fn turned(&self, residuals: Residuals) -> f64 {
        let by_energy = self.about_centre().sqrt() * residuals.energy;
        let [left, right] = self.hull;
        let half = 0.5 * (right - left);
        let off = (0.5 * (left + right) - self.centre()).abs();
        let Some(constant) = self.constant() else { return by_energy };
        // A constant is as good as a settlement, of which nothing is left without force.
        let level = self.level() / (1.0 + self.theta * (constant + half.ln()) * self.level());
        let potential = half * (HALF_LINE + constant / PI);
        by_energy.min((2.0 * potential + off) * level * residuals.largest)
    }

    /// A bound of `|<chi, w~>|` about the origin, where a settlement is prescribed: `A^-1 x` is `chi` and `c psi`.
    pub(crate) fn turned_about_origin(&self, residuals: Residuals) -> f64 {
        self.turned(residuals) + self.centre().abs() * self.level() * residuals.largest
    }

    /// What is added to `ln(h/|x - s|)` for the complete maximum principle on the hull; none for kernels of which no line's density is written down here.
    fn constant(&self) -> Option<f64> {
        match self.kernel {
            Kernel::Logarithm | Kernel::ShiftedLogarithm { .. } => Some(2.0 - LN_2),
            Kernel::Row { .. } | Kernel::Power { .. } | Kernel::Layered(_) => None,
        }
    }
}

//! The deformed surface of the body, and the gap beside the contact.

use super::Contact;
use super::draft::Draft;
use crate::{Error, Scaling};

impl Contact {
    /// Elastic displacement of the body's surface (m) (without the layer) at `x` beside or under the punch, positive into the body:
    /// `theta int ln(a/|x-s|) p(s) ds`, in the gauge of the settlement. Without dimensions over `chi E`.
    ///
    /// In contact it is `delta - alpha x - f - chi p`.
    #[must_use]
    pub fn elastic_displacement(&self, x: f64) -> f64 {
        self.solution().displacement(x / self.half_width()) * self.scale(Scaling::displacement)
    }

    /// Depth of the punch's base (m) at `x` under it: `delta - alpha x - f(x)`, positive into the body.
    #[must_use]
    pub fn base_depth(&self, x: f64) -> f64 {
        self.base_depth_at(x / self.half_width()) * self.scale(Scaling::displacement)
    }

    fn base_depth_at(&self, xi: f64) -> f64 {
        let height = self.solved().dimensionless_profile(xi);
        self.solution().state().settlement - self.state().tilt * xi - height
    }

    /// The gap `f0 + alpha0 xi - delta0 + theta0 int ln(1/|xi - eta|) p0(eta) deta` between base and body outside the zones; 0 in them.
    /// Points beyond the punch count as the nearer edge.
    pub(crate) fn gap_at(&self, xi: f64) -> f64 {
        let xi = xi.clamp(-1.0, 1.0);
        if self.solution().touches(xi) {
            return 0.0;
        }
        self.solution().displacement(xi) - self.base_depth_at(xi)
    }

    /// The gap (m) between base and body at `x` outside the zones of contact; 0 in them.
    ///
    /// # Errors
    /// [`Error::BeyondPunch`] outside the closed base, also for NaN.
    pub fn gap(&self, x: f64) -> Result<f64, Error> {
        Ok(self.gap_at(self.on_base(x)?) * self.scale(Scaling::displacement))
    }
}

impl Draft {
    /// `theta0 int ln(1/|xi - eta|) p0(eta) deta` for `|xi| > 1`.
    ///
    /// With `xi = (z + 1/z)/2`, `|z| > 1`, the kernel is `-ln(|z|/2) + sum_{m>0} (2/m) z^-m T_m(eta)`, so the displacement is the series under the punch with the
    /// powers of `1/z` in place of `T_m(xi)`: continuous at the edges, and more accurate the farther away, as the terms beyond `n` fall as `z^-n`.
    pub(super) fn beside(&self, xi: f64) -> f64 {
        let distance = xi.abs();
        let z = distance + (distance - 1.0).sqrt() * (distance + 1.0).sqrt();
        let inverse = xi.signum() / z;
        // Coefficient 0 is theta0 P0 ln 2; outside, ln 2 becomes ln 2 - ln z.
        let coefficients = self.potential.series().coefficients();
        let series = coefficients.iter().rev().fold(0.0, |sum, c| c + inverse * sum);
        series - self.theta0 * self.state.force * z.ln()
    }
}

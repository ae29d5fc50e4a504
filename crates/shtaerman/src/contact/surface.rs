//! The deformed surface of the body, and the gap beside the contact.

use super::Contact;
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

//! The deformed surface of the body.

use super::Contact;

impl Contact {
    /// Elastic displacement of the body's surface (m) (without the layer) at `x` beside or under the punch, positive into the body:
    /// `theta int ln(a/|x-s|) p(s) ds`, in the gauge of the settlement. In the units of the problem.
    ///
    /// Under the punch it is `delta - alpha x - f - chi p`. Outside, with `xi = (z + 1/z)/2`, `|z| > 1`, the kernel is
    /// `ln(1/|xi - eta|) = -ln(|z|/2) + sum_{m>0} (2/m) z^-m T_m(eta)`, so the displacement is the same series with the powers of `1/z` in place
    /// of `T_m(xi)`: continuous at the edges, and more accurate the farther away, as the terms beyond `n` fall as `z^-n`.
    #[must_use]
    pub fn elastic_displacement(&self, x: f64) -> f64 {
        let xi = x / self.problem().frame().half_width();
        let scale = self.problem().frame().scaling().map_or(1.0, crate::Scaling::displacement);
        let displacement =
            if xi.abs() <= 1.0 { self.draft().potential.at(xi) } else { self.beside(xi) };
        displacement * scale
    }

    /// `theta0 int ln(1/|xi - eta|) p0(eta) deta` for `|xi| > 1`.
    fn beside(&self, xi: f64) -> f64 {
        let distance = xi.abs();
        let z = distance + (distance - 1.0).sqrt() * (distance + 1.0).sqrt();
        let inverse = xi.signum() / z;
        // Coefficient 0 is theta0 P0 ln 2; outside, ln 2 becomes ln 2 - ln z.
        let coefficients = self.draft().potential.series().coefficients();
        let series = coefficients.iter().rev().fold(0.0, |sum, c| c + inverse * sum);
        series - self.theta0() * self.force0() * z.ln()
    }

    /// Depth of the punch's base (m) at `x` under it: `delta - alpha x - f(x)`, positive into the body.
    #[must_use]
    pub fn base_depth(&self, x: f64) -> f64 {
        let xi = x / self.problem().frame().half_width();
        let scale = self.problem().frame().scaling().map_or(1.0, crate::Scaling::displacement);
        (self.settlement0() - self.tilt0() * xi - self.problem().dimensionless_profile(xi)) * scale
    }
}

//! The limit of the rest of the split on the diagonal.

use std::f64::consts::LN_2;

use super::angular::Harmonic;

/// Terms beyond this exponent are below rounding.
const FADED: f64 = 42.0;

/// The limit of `K + (2/x) ln d` at the diagonal, `(2/x) [ln 8x + int_0^inf (exp(-2 z sech t) cos 2 m theta - 1) dt]`, `z = chi x`, `tan(theta/2) = exp(-t)`.
///
/// From `2 int_0^pi cos(u/2)/R du = (2/x) ln(4x/d)` and, with `u = 2 theta`, `int_0^(pi/2) (1 - cos theta)/sin theta dtheta = ln 2`; `dtheta/sin theta = dt`. The integrand is even and analytic: the trapezoidal rule.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Diagonal {
    step: f64,
    /// `sech t`, and `2 sin^2(m theta)`.
    nodes: Vec<(f64, f64)>,
}

impl Diagonal {
    pub(super) fn new(harmonic: &Harmonic, largest_decay: f64) -> Self {
        let step = harmonic.step();
        let m = f64::from(harmonic.order());
        let range = FADED + (largest_decay + m * m).ln_1p();
        let node = |j: u32| {
            let t = f64::from(j) * step;
            let sine = (2.0 * m * (-t).exp().atan()).sin();
            (1.0 / t.cosh(), 2.0 * sine * sine)
        };
        Self { step, nodes: (0..=(range / step) as u32).map(node).collect() }
    }

    /// The limit at `x > 0`.
    pub(super) fn rest(&self, screening: f64, x: f64) -> f64 {
        let twice = 2.0 * screening * x;
        let term = |&(secant, versine): &(f64, f64)| {
            let decayed = (-twice * secant).exp_m1();
            decayed - versine * (1.0 + decayed)
        };
        let first = self.nodes.first().map_or(0.0, term);
        let sum: f64 = self.nodes.iter().skip(1).map(term).sum();
        2.0 / x * ((4.0 * x).ln() + LN_2 + self.step * (0.5 * first + sum))
    }
}

//! The part of a row's potential beside three logarithms.

use std::f64::consts::PI;

use crate::chebyshev::{evaluate_at, nodes};
use crate::panel::Panel;
use crate::sum::Sum;

/// Nodes of the regular part: `(2 + sqrt 3)^-NODES` is below rounding.
const NODES: usize = 32;
/// Roundings of the regular part in units of the machine, relative to the mass and the largest value of its kernel: twelve of each value, times Lebesgue's constant, and as many again of
/// coefficients and sums.
const ROUNDED: f64 = 80.0;

/// The regular part of the potential of a density.
#[derive(Debug, Clone, Default)]
pub(crate) struct Regular {
    /// Chebyshev coefficients on `[-1, 1]`.
    coefficients: Vec<f64>,
    rounding: f64,
}

impl Regular {
    /// `K = -sum ln|d + j L| + 3 ln L - ln 2 pi + sum (zeta(2k) - 1)/k (d/L)^2k` over `j = -1, 0, 1`: the rest has its singularities two periods away.
    pub(crate) fn new(panels: &[Panel], period: f64) -> Self {
        let at = nodes(NODES);
        let values: Vec<f64> = (at.places.iter())
            .map(|x| integral_with(panels, |t| kernel((x - t) / period, period)))
            .collect();
        let mass: f64 = panels.iter().map(Panel::mass).sum();
        let largest = 3.0 * period.ln() + 2.0;
        let rounding = ROUNDED * mass * largest;
        Self { coefficients: at.coefficients(&values), rounding }
    }

    /// The values at places and a bound of their rounding in units of the machine.
    #[inline(always)]
    pub(crate) fn at<const N: usize>(&self, places: &[f64; N]) -> ([f64; N], f64) {
        (evaluate_at(&self.coefficients, places), self.rounding)
    }
}

fn integral_with(panels: &[Panel], kernel: impl Fn(f64) -> f64) -> f64 {
    let mut sum = Sum::default();
    for panel in panels {
        for ((x, weight), q) in panel.nodes().zip(panel.at_nodes()) {
            sum.add(weight * q * kernel(x));
        }
    }
    sum.value()
}

/// `-ln(2 sin(pi u)/(L^3 u (1 - u^2)))`, `0 <= u <= 1` the share of the distance in the period.
fn kernel(u: f64, period: f64) -> f64 {
    let u = u.abs();
    let rest = (1.0 - u).max(0.0);
    let sine = |v: f64| if v == 0.0 { PI } else { (PI * v).sin() / v };
    // From the nearer zero of the sine.
    let quotient =
        if u < rest { sine(u) / (rest * (1.0 + u)) } else { sine(rest) / (u * (1.0 + u)) };
    3.0 * period.ln() - (2.0 * quotient).ln()
}

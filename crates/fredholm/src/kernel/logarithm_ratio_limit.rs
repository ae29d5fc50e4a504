//! Kernel 2 at its limit: `ln((x + s)/|x - s|)` on `(0, a)`.

use std::f64::consts::{FRAC_PI_4, PI};

use super::half_sums::half_sums;
use super::logarithm_ratio::{ratio, ratios};
use super::{
    EndExponents, Expansion, Gram, Kernel, Moments, Pair, Parity, Singularity, SpectralRelation,
    Split,
};
use crate::basis::harmonics::Harmonics;
use crate::basis::interval_moments::interval_moments;
use crate::basis::{ChebyshevSeries, Function};
use crate::{Error, Interval};

/// `K(x, s) = ln((x + s)/|x - s|)` on `(0, a)`: the odd half of [`Logarithm`](super::Logarithm) on `(-a, a)`, a punch under a moment. Positive; 0 at `x = 0`.
///
/// Spectral relation: `phi_m = T_{2m+1}(x/a)`, `w = 1/sqrt(a^2 - x^2)`, `lambda_m = pi/(2m + 1)`, `h_m = pi/4`. It is not the limit `b -> 0` of that of
/// [`LogarithmRatio`](super::LogarithmRatio), which has a weight that is not integrable at 0, and eigenvalues that crowd.
///
/// Gram matrix: `R_km = -(a/2) [1/((2k + 2m + 2)^2 - 1) + 1/((2k - 2m)^2 - 1)]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogarithmRatioLimit {
    interval: Interval,
}

impl LogarithmRatioLimit {
    /// The kernel on `(0, length)`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `length` lies between `1e-150` and `1e150`.
    pub fn new(length: f64) -> Result<Self, Error> {
        if (1e-150..=1e150).contains(&length) {
            return Ok(Self { interval: Interval::new(0.0, length)? });
        }
        Err(Error::InvalidParameter {
            name: "length",
            value: length,
            requirement: "between 1e-150 and 1e150, so that its square neither overflows nor vanishes",
        })
    }

    /// `a`.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.interval.right()
    }

    fn harmonics(&self, x: f64) -> Harmonics {
        let a = self.length();
        let x = x.clamp(0.0, a);
        Harmonics::odd_chebyshev(x / a, (a - x) / a)
    }
}

impl Kernel for LogarithmRatioLimit {
    fn interval(&self) -> Interval {
        self.interval
    }

    fn singularity(&self) -> Singularity {
        Singularity::Logarithm
    }

    fn split(&self, x: f64, s: f64, _distance: f64) -> Split {
        Split { factor: -1.0, rest: (x + s).ln() }
    }

    fn pair(&self, x: f64, s: f64, distance: f64) -> Pair {
        Pair { value: ratio(x, s, distance), factor: -1.0 }
    }

    fn pairs(
        &self,
        x: f64,
        points: &[f64],
        distances: &[f64],
        values: &mut [f64],
        factors: &mut [f64],
    ) {
        ratios(x, points, distances, values);
        factors.fill(-1.0);
    }

    // At 0 both parts of the split are infinite; the kernel vanishes on both sides of that corner.
    fn value(&self, x: f64, s: f64) -> f64 {
        match (x == s, x == 0.0) {
            (true, true) => 0.0,
            (true, false) => f64::INFINITY,
            (false, _) => ratio(x, s, (x - s).abs()),
        }
    }
}

impl SpectralRelation for LogarithmRatioLimit {
    fn weight_exponents(&self) -> EndExponents {
        EndExponents { left: 0.0, right: -0.5 }
    }

    fn weight_rest(&self, _n: usize, x: f64) -> f64 {
        1.0 / (self.length() + x).sqrt()
    }

    fn eigenvalue(&self, n: usize) -> f64 {
        PI / (2.0 * n as f64 + 1.0)
    }

    fn norm(&self, _n: usize) -> f64 {
        FRAC_PI_4
    }

    fn expansion_factor(&self, n: usize) -> f64 {
        4.0 / (2.0 * n as f64 + 1.0)
    }

    fn parity(&self) -> Parity {
        Parity::None
    }

    fn eigenfunctions(&self, x: f64, values: &mut [f64]) {
        self.harmonics(x).fill(values.iter_mut());
    }

    fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        self.harmonics(x).sum(coefficients.iter())
    }

    fn largest_sum(&self, coefficients: &[f64]) -> Option<f64> {
        let odd = coefficients.iter().flat_map(|c| [0.0, *c]).collect();
        Some(ChebyshevSeries::new(odd).largest_value())
    }

    fn gram(&self, count: usize) -> Result<Gram, Error> {
        let integral = |j: usize| {
            let j = 2.0 * j as f64;
            -self.length() / ((j - 1.0) * (j + 1.0))
        };
        half_sums(count, 1, |count| (0..count).map(integral).collect())
    }

    /// Converges fast for functions that an odd continuation leaves smooth; slowly, and not resolved, where `f(0)` is not 0.
    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error> {
        let odd = |xi: f64| {
            if xi == 0.0 { 0.0 } else { xi.signum() * f(self.length() * xi.abs()) }
        };
        let function = Function::resolve(&odd)?;
        let coefficients = function.series().coefficients().iter().skip(1).step_by(2).copied();
        Ok(Expansion {
            coefficients: coefficients.collect(),
            error: function.error(),
            resolved: function.is_resolved(),
        })
    }

    /// By a rule on the interval: the functions need not be odd for it.
    fn moments(&self, f: &dyn Fn(f64) -> f64, count: usize) -> Result<Moments, Error> {
        interval_moments(self, f, count, 2)
    }

    /// `int_0^a phi_n w ds = (-1)^n/(2n + 1)`: here 1 is not among the eigenfunctions.
    fn mass(&self, n: usize) -> f64 {
        let sign = if n.is_multiple_of(2) { 1.0 } else { -1.0 };
        sign / (2.0 * n as f64 + 1.0)
    }
}

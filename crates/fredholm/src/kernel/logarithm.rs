//! Kernel 1: the logarithm, `ln 1/|x - s|` on `(-a, a)`.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{
    EndExponents, Expansion, Gram, Kernel, Moments, Parity, Singularity, SpectralRelation, Split,
};
use crate::basis::{self, Function};
use crate::special::logarithms;
use crate::{Error, Interval};

/// `K(x, s) = ln l/|x - s|` on `(-a, a)`, with the gauge length `l`, 1 unless said: the plane punch.
///
/// Spectral relation (section 3): with `w = 1/sqrt(a^2 - x^2)` and `phi_n = T_n(x/a)`,
/// `lambda_0 = pi ln(2 l/a)`, `lambda_n = pi/n`, `h_0 = pi`, `h_n = pi/2`. The kernel is positive for `a < 2 l` (logarithmic
/// capacity `a/2` of the interval below the gauge).
///
/// Gram matrix, (3.4): `R_km = -a [1/((k+m)^2 - 1) + 1/((k-m)^2 - 1)]` for even `k + m`, else 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Logarithm {
    interval: Interval,
    /// `ln l`.
    offset: f64,
}

impl Logarithm {
    /// The kernel on `(-half_length, half_length)`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `half_length` is finite and positive.
    pub fn new(half_length: f64) -> Result<Self, Error> {
        Ok(Self { interval: Interval::symmetric(half_length)?, offset: 0.0 })
    }

    /// `ln gauge/|x - s|` on `(-half_length, half_length)`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless both are finite and positive.
    pub fn with_gauge(half_length: f64, gauge: f64) -> Result<Self, Error> {
        if gauge.is_finite() && gauge > 0.0 {
            return Ok(Self { interval: Interval::symmetric(half_length)?, offset: gauge.ln() });
        }
        Err(Error::InvalidParameter {
            name: "gauge",
            value: gauge,
            requirement: "finite and positive",
        })
    }

    /// The kernel on `(-1, 1)`, to which every plane punch is scaled, (2.5).
    #[must_use]
    pub fn unit() -> Self {
        Self { interval: Interval::unit(), offset: 0.0 }
    }

    /// `a`.
    #[must_use]
    pub fn half_length(&self) -> f64 {
        self.interval.right()
    }
}

impl Kernel for Logarithm {
    fn interval(&self) -> Interval {
        self.interval
    }

    fn singularity(&self) -> Singularity {
        Singularity::Logarithm
    }

    fn split(&self, _x: f64, _s: f64, _distance: f64) -> Split {
        Split { factor: -1.0, rest: self.offset }
    }

    fn pairs(
        &self,
        _x: f64,
        _points: &[f64],
        distances: &[f64],
        values: &mut [f64],
        factors: &mut [f64],
    ) {
        values.copy_from_slice(distances);
        logarithms(values);
        values.iter_mut().for_each(|value| *value = self.offset - *value);
        factors.fill(-1.0);
    }

    fn is_even(&self) -> bool {
        true
    }
}

impl SpectralRelation for Logarithm {
    fn weight_exponents(&self) -> EndExponents {
        EndExponents { left: -0.5, right: -0.5 }
    }

    fn weight_rest(&self, _n: usize, _x: f64) -> f64 {
        1.0
    }

    fn eigenvalue(&self, n: usize) -> f64 {
        if n == 0 { PI * ((2.0 / self.half_length()).ln() + self.offset) } else { PI / n as f64 }
    }

    fn norm(&self, n: usize) -> f64 {
        if n == 0 { PI } else { FRAC_PI_2 }
    }

    // The quotient of the two rounded values would cost the exact 2/m of section 3.
    fn expansion_factor(&self, n: usize) -> f64 {
        if n == 0 { (2.0 / self.half_length()).ln() + self.offset } else { 2.0 / n as f64 }
    }

    fn parity(&self) -> Parity {
        Parity::Alternating
    }

    fn eigenfunctions(&self, x: f64, values: &mut [f64]) {
        basis::chebyshev::polynomials(x / self.half_length(), values);
    }

    fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        basis::chebyshev::sum(coefficients, x / self.half_length())
    }

    fn largest_sum(&self, coefficients: &[f64]) -> Option<f64> {
        Some(basis::ChebyshevSeries::new(coefficients.to_vec()).largest_value())
    }

    fn gram(&self, count: usize) -> Result<Gram, Error> {
        let entry = |j: usize| {
            if j.is_multiple_of(2) {
                -self.half_length() / ((j as f64 - 1.0) * (j as f64 + 1.0))
            } else {
                0.0
            }
        };
        Ok(Gram::ToeplitzHankel {
            toeplitz: (0..count).map(entry).collect(),
            hankel: (0..(2 * count).saturating_sub(1)).map(entry).collect(),
        })
    }

    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error> {
        let scaled = |xi: f64| f(self.half_length() * xi);
        let function = Function::resolve(&scaled)?;
        Ok(Expansion {
            coefficients: function.series().coefficients().to_vec(),
            error: function.error(),
            resolved: function.is_resolved(),
        })
    }

    fn moments(&self, f: &dyn Fn(f64) -> f64, count: usize) -> Result<Moments, Error> {
        let scaled = |xi: f64| f(self.half_length() * xi);
        let function = Function::resolve(&scaled)?;
        let mut values = function.series().moments(count);
        values.iter_mut().for_each(|value| *value *= self.half_length());
        Ok(Moments { values, error: function.error(), resolved: function.is_resolved() })
    }
}

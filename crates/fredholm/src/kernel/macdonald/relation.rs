//! The spectral relation of the Macdonald kernel on a finite interval.

use super::Macdonald;
use super::spheroidal::Spheroidal;
use crate::basis::expansion::expand_by_rule;
use crate::kernel::{
    EndExponents, Expansion, Gram, Kernel, Parity, SpectralRelation, forward_kernel,
};
use crate::quadrature::Rule;
use crate::quadrature::gauss_jacobi;
use crate::{Error, memory};

/// Most eigenfunctions.
const MOST: usize = 4096;

/// The Macdonald kernel prepared for a number of eigenfunctions.
///
/// Spectral relation, with `t = x/a` and `c = kappa a`: `w = (a^2 - x^2)^(mu - 1/2)`, `h_n = a^(2 mu)`, and `phi_n(x)` are the generalised spheroidal functions
/// (for `mu = 0` those of Mathieu), the solutions of
///
/// `(1 - t^2) y'' - (2 mu + 1) t y' + (chi_n + c^2 t^2) y = 0`
///
/// that are finite at both ends, with `int_{-1}^{1} phi_n^2 (1 - t^2)^(mu - 1/2) dt = 1` and `phi_n(1) > 0`: the operator of the kernel commutes with that of this
/// equation. All `lambda_n` are positive, `lambda_n ~ a^mu sqrt(pi) (2c)^-mu Gamma(1/2 - mu) n^(2 mu - 1)`. They have an absolute error of about
/// `1e-14 lambda_0`.
///
/// ```
/// use fredholm::kernel::{Macdonald, SpectralRelation};
///
/// let relation = Macdonald::new(1.0, 0.2, 1.0)?.relation(20)?;
/// // mpmath, 22 digits.
/// assert!((relation.eigenvalue(0) - 4.478_423_707_685_688).abs() < 1e-12);
/// # Ok::<(), fredholm::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct MacdonaldRelation {
    kernel: Macdonald,
    functions: Spheroidal,
    /// `a^mu`.
    scale: f64,
}

impl Macdonald {
    /// The kernel with its first `count` eigenfunctions: `O(count (count + kappa a))` operations.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `1 <= count <= 4096`; [`Error::EigenvaluesNotFound`].
    pub fn relation(&self, count: usize) -> Result<MacdonaldRelation, Error> {
        if !(1..=MOST).contains(&count) {
            return Err(Error::InvalidParameter {
                name: "number of eigenfunctions",
                value: count as f64,
                requirement: "between 1 and 4096: each takes memory",
            });
        }
        let functions = Spheroidal::new(self.order(), self.decay() * self.half_length(), count)?;
        let scale = self.half_length().powf(self.order());
        Ok(MacdonaldRelation { kernel: self.clone(), functions, scale })
    }
}

impl MacdonaldRelation {
    /// The kernel.
    #[must_use]
    pub fn kernel(&self) -> &Macdonald {
        &self.kernel
    }

    /// `chi_n` of the differential equation, ascending, above `-c^2`; NaN beyond [`available`](SpectralRelation::available).
    #[must_use]
    pub fn characteristic_value(&self, n: usize) -> f64 {
        self.functions.characteristic_values.get(n).copied().unwrap_or(f64::NAN)
    }

    fn local(&self, x: f64) -> f64 {
        x / self.kernel.half_length()
    }
}

impl Kernel for MacdonaldRelation {
    forward_kernel!(self => self.kernel);
}

impl SpectralRelation for MacdonaldRelation {
    fn available(&self) -> usize {
        self.functions.count()
    }

    fn weight_exponents(&self) -> EndExponents {
        let exponent = self.kernel.order() - 0.5;
        EndExponents { left: exponent, right: exponent }
    }

    fn weight_rest(&self, _n: usize, _x: f64) -> f64 {
        1.0
    }

    fn eigenvalue(&self, n: usize) -> f64 {
        self.functions.eigenvalues.get(n).map_or(f64::NAN, |value| self.scale * value)
    }

    fn norm(&self, n: usize) -> f64 {
        if n < self.available() { self.scale * self.scale } else { f64::NAN }
    }

    fn parity(&self) -> Parity {
        Parity::Alternating
    }

    fn eigenfunctions(&self, x: f64, values: &mut [f64]) {
        self.functions.values(self.local(x), values);
    }

    fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        self.functions.sum(coefficients, self.local(x))
    }

    fn combination<'s>(
        &'s self,
        coefficients: &[f64],
    ) -> Box<dyn Fn(f64) -> f64 + Send + Sync + 's> {
        let series = self.functions.series(coefficients);
        Box::new(move |x| self.functions.evaluate(&series, self.local(x)))
    }

    fn gram(&self, count: usize) -> Result<Gram, Error> {
        if count > self.available() {
            return Err(Error::TooFew { needed: count, available: self.available() });
        }
        memory::admit(count.saturating_sub(1), 16.0 * (count as f64).powi(2))?;
        let mut entries = self.functions.gram(count)?;
        entries.iter_mut().for_each(|entry| *entry *= self.kernel.half_length());
        Ok(Gram::Dense { order: count, entries })
    }

    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error> {
        let exponent = self.kernel.order() - 0.5;
        let half = self.kernel.half_length();
        expand_by_rule(self, f, |count| {
            // The functions are polynomials of a degree that exceeds their index.
            let count = count + self.functions.excess();
            let Rule { nodes, weights } = gauss_jacobi(count, exponent, exponent)?;
            let scale = self.scale * self.scale;
            Ok(Rule {
                nodes: nodes.iter().map(|t| half * t).collect(),
                weights: weights.iter().map(|weight| scale * weight).collect(),
            })
        })
    }

    fn mass(&self, n: usize) -> f64 {
        self.scale * self.scale * self.functions.mass(n)
    }
}

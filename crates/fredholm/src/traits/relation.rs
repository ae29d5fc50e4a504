//! The spectral relation of a kernel.

use super::definition::Kernel;
use crate::Error;

/// How the eigenfunctions of a kernel behave under `x -> -x` on a symmetric interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parity {
    /// `phi_n(-x) = (-1)^n phi_n(x)`: the degenerate system splits into an even and an odd one, (3.10) and (3.11).
    Alternating,
    /// No symmetry to use.
    None,
}

/// The unweighted Gram matrix `R_km = int_L phi_k phi_m dx` of (1.9).
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Gram {
    /// `R_km = toeplitz(|k - m|) + hankel(k + m)`, each given by its first entries.
    ToeplitzHankel {
        /// `toeplitz[j]` for `j = |k - m|`.
        toeplitz: Vec<f64>,
        /// `hankel[j]` for `j = k + m`.
        hankel: Vec<f64>,
    },
    /// All entries, row by row.
    Dense {
        /// Order of the matrix.
        order: usize,
        /// `entries[k * order + m]`.
        entries: Vec<f64>,
    },
    /// `R_km = 1` for `k = m`, else 0: the eigenfunctions are orthonormal without a weight, and the degenerate system is diagonal.
    Identity,
}

impl Gram {
    /// `R_km`.
    ///
    /// # Panics
    /// When an index is not below the count the matrix was built for.
    #[must_use]
    pub fn entry(&self, k: usize, m: usize) -> f64 {
        match self {
            Self::ToeplitzHankel { toeplitz, hankel } => toeplitz[k.abs_diff(m)] + hankel[k + m],
            Self::Dense { order, entries } => entries[k * order + m],
            Self::Identity => f64::from(u8::from(k == m)),
        }
    }
}

/// The powers with which a weight begins at the ends of the interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndExponents {
    /// `beta` in `(x - left)^beta`, above -1.
    pub left: f64,
    /// `beta` in `(right - x)^beta`, above -1; 0 where the right end is infinite.
    pub right: f64,
}

/// A kernel whose eigenfunctions are known: `int_L K(x, s) phi_n(s) w(s) dm(s) = lambda_n phi_n(x)`, (1.2), orthogonal with
/// the weight `w` and norms `h_n`, (1.3), so that `K = sum (lambda_m / h_m) phi_m(x) phi_m(s)`, (1.5). `dm` is the measure of the kernel, `ds`
/// for most.
///
/// Indices run below [`available`](Self::available); a method that is given a higher one gives NaN.
pub trait SpectralRelation: Kernel {
    /// How many eigenfunctions can be had: no limit where they have formulae, else the number they were computed for.
    fn available(&self) -> usize {
        usize::MAX
    }

    /// The powers with which the weight begins at the ends.
    fn weight_exponents(&self) -> EndExponents;

    /// The weight of `phi_n` without those powers, smooth and positive on the closed interval. All `phi_n` have one weight, but for
    /// the kernel `ln 1/(2 sin |x-s|/2)`, where it goes by parity.
    fn weight_rest(&self, n: usize, x: f64) -> f64;

    /// The weight `w(x)` of `phi_n`, positive inside the interval; infinite or 0 at an end with a power.
    fn weight(&self, n: usize, x: f64) -> f64 {
        let interval = self.interval();
        let EndExponents { left, right } = self.weight_exponents();
        let at_left = power(x - interval.left(), left);
        let at_right = if interval.is_finite() { power(interval.right() - x, right) } else { 1.0 };
        self.weight_rest(n, x) * at_left * at_right
    }

    /// The eigenvalue `lambda_n` of (1.2).
    fn eigenvalue(&self, n: usize) -> f64;

    /// The norm `h_n = int_L phi_n^2 w dm` of (1.3).
    fn norm(&self, n: usize) -> f64;

    /// The factor `lambda_m / h_m` of the bilinear expansion (1.5).
    fn expansion_factor(&self, n: usize) -> f64 {
        self.eigenvalue(n) / self.norm(n)
    }

    /// Symmetry of the eigenfunctions.
    fn parity(&self) -> Parity;

    /// Fills `values` with `phi_0(x), phi_1(x), ...`.
    fn eigenfunctions(&self, x: f64, values: &mut [f64]);

    /// `sum_m coefficients[m] phi_m(x)`, by a stable recurrence.
    fn sum(&self, coefficients: &[f64], x: f64) -> f64;

    /// The function `sum_m coefficients[m] phi_m` for many points. As [`sum`](Self::sum) unless a kernel has something to prepare.
    fn combination<'s>(
        &'s self,
        coefficients: &[f64],
    ) -> Box<dyn Fn(f64) -> f64 + Send + Sync + 's> {
        let coefficients = coefficients.to_vec();
        Box::new(move |x| self.sum(&coefficients, x))
    }

    /// The largest `|sum_m coefficients[m] phi_m|` to 2 %, where a cosine transform has it: of cosines in a variable of their own.
    fn largest_sum(&self, coefficients: &[f64]) -> Option<f64> {
        let _ = coefficients;
        None
    }

    /// The Gram matrix `R_km = int_L phi_k phi_m dm` of `phi_0 .. phi_{count-1}`, to machine precision.
    ///
    /// # Errors
    /// [`Error::TooLarge`] when it does not fit into memory; [`Error::TooFew`] beyond [`available`](Self::available); whatever the kernel's own
    /// route may meet.
    fn gram(&self, count: usize) -> Result<Gram, Error>;

    /// The coefficients `c_n = h_n^-1 int_L f phi_n w dm` of `f = sum c_n phi_n`, as many as resolve `f` or as can be had.
    ///
    /// # Errors
    /// [`Error::NotFinite`] when `f` is not finite at a point where it is needed.
    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error>;

    /// The moments `f_k = int_L f phi_k dm` of (1.9) for `k < count`: from the expansion and the Gram matrix, unless a kernel has a better way.
    ///
    /// # Errors
    /// Those of [`expand`](Self::expand) and [`gram`](Self::gram).
    fn moments(&self, f: &dyn Fn(f64) -> f64, count: usize) -> Result<Moments, Error> {
        let Expansion { coefficients, error, resolved } = self.expand(f)?;
        let gram = self.gram(count.max(coefficients.len()))?;
        let moment = |k| coefficients.iter().enumerate().map(|(n, c)| c * gram.entry(k, n)).sum();
        Ok(Moments { values: (0..count).map(moment).collect(), error, resolved })
    }

    /// `int_L u phi_n w dm` with the [`mass_function`](Kernel::mass_function) `u`: `h_0` for `n = 0` and 0 for the others where `u = phi_0`.
    fn mass(&self, n: usize) -> f64 {
        if n == 0 { self.norm(0) } else { 0.0 }
    }
}

fn power(distance: f64, exponent: f64) -> f64 {
    if exponent == 0.0 { 1.0 } else { distance.max(0.0).powf(exponent) }
}

/// Moments of a function with the eigenfunctions, and how well the function was resolved.
#[derive(Debug, Clone, PartialEq)]
pub struct Moments {
    /// `f_k = int_L f phi_k dm`.
    pub values: Vec<f64>,
    /// Estimate of the largest error of the function's expansion, relative to its largest value; an estimate.
    pub error: f64,
    /// Whether the function was resolved to rounding.
    pub resolved: bool,
}

/// A function expanded in the eigenfunctions of a kernel.
#[derive(Debug, Clone, PartialEq)]
pub struct Expansion {
    /// `c_n` in `f = sum c_n phi_n`.
    pub coefficients: Vec<f64>,
    /// Estimate of the largest error of the sum, relative to the largest value of `f`.
    pub error: f64,
    /// Whether the function was resolved to rounding.
    pub resolved: bool,
}

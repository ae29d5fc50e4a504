//! The spectral relation of a kernel.

use super::Kernel;
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
        }
    }
}

/// A kernel whose eigenfunctions are known: `int_L K(x, s) phi_n(s) w(s) ds = lambda_n phi_n(x)`, (1.2), orthogonal with
/// the weight `w` and norms `h_n`, (1.3), so that `K = sum (lambda_m / h_m) phi_m(x) phi_m(s)`, (1.5).
pub trait SpectralRelation: Kernel {
    /// The weight `w(x)`, positive inside the interval.
    fn weight(&self, x: f64) -> f64;

    /// The eigenvalue `lambda_n` of (1.2).
    fn eigenvalue(&self, n: usize) -> f64;

    /// The norm `h_n = int_L phi_n^2 w dx` of (1.3).
    fn norm(&self, n: usize) -> f64;

    /// Symmetry of the eigenfunctions.
    fn parity(&self) -> Parity;

    /// Fills `values` with `phi_0(x), phi_1(x), ...`.
    fn eigenfunctions(&self, x: f64, values: &mut [f64]);

    /// `sum_m coefficients[m] phi_m(x)`, by a stable recurrence.
    fn sum(&self, coefficients: &[f64], x: f64) -> f64;

    /// The Gram matrix of `phi_0 .. phi_{count-1}`, to machine precision.
    ///
    /// # Errors
    /// [`Error::TooLarge`] when it does not fit into memory; whatever the kernel's own route may meet.
    fn gram(&self, count: usize) -> Result<Gram, Error>;

    /// The moments `f_k = int_L f phi_k dx` of (1.9) for `k < count`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] when `f` is not finite at a point where it is needed.
    fn moments(&self, f: &dyn Fn(f64) -> f64, count: usize) -> Result<Moments, Error>;

    /// The factor `lambda_m / h_m` of the bilinear expansion (1.5).
    fn expansion_factor(&self, n: usize) -> f64 {
        self.eigenvalue(n) / self.norm(n)
    }
}

/// Moments of a function with the eigenfunctions, and how well the function was resolved.
#[derive(Debug, Clone, PartialEq)]
pub struct Moments {
    /// `f_k = int_L f phi_k dx`.
    pub values: Vec<f64>,
    /// Estimate of the largest error of the function's expansion, relative to its largest value; an estimate.
    pub error: f64,
    /// Whether the function was resolved to rounding.
    pub resolved: bool,
}

//! The degenerate system (1.9) in symmetric positive form.

use super::split::{Indices, admit, check_parameter, expansion_factors, steps};
use crate::kernel::{Gram, SpectralRelation};
use crate::linear::Cholesky;
use crate::{DegenerateSolution, Error};

/// The degenerate system of a kernel at one parameter, factored: for `k = 0 .. degree`
///
/// `X_k + lambda sum_m D_m R_km X_m = f_k`, `D_m = lambda_m / h_m`, `X_k = int_L phi phi_k dx`   (1.9)
///
/// With `Y = sqrt(D) X` it is symmetric positive definite, `(I + lambda sqrt(D) R sqrt(D)) Y = sqrt(D) f`, and is solved by
/// Cholesky; where the eigenfunctions alternate in parity it splits into the even and the odd system, (3.10) and (3.11).
///
/// Cost: `degree^3 / 12` multiplications and `2 degree^2` bytes a parity (four and eight times that without parity); each right-hand side
/// `degree^2`.
#[derive(Debug, Clone)]
pub struct DegenerateSystem<'k, K> {
    kernel: &'k K,
    parameter: f64,
    factors: Vec<f64>,
    blocks: Vec<Block>,
}

/// One part of the unknowns and the factor of their part of the matrix.
#[derive(Debug, Clone)]
struct Block {
    indices: Indices,
    cholesky: Cholesky,
}

impl<'k, K: SpectralRelation> DegenerateSystem<'k, K> {
    /// Builds and factors the system for `phi + parameter K phi = f` with the eigenfunctions `phi_0 .. phi_degree`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a negative or not finite parameter, [`Error::NotPositive`] when one of the
    /// eigenvalues is not positive, [`Error::TooLarge`] beyond memory, [`Error::NotPositiveDefinite`] if rounding spoils the factorisation.
    pub fn new(kernel: &'k K, parameter: f64, degree: usize) -> Result<Self, Error> {
        check_parameter(parameter)?;
        let parts = steps(kernel.parity()) as f64;
        let order = degree as f64 / parts + 1.0;
        admit(degree, 8.0 * parts * order * order)?;
        let factors = expansion_factors(kernel, degree)?;
        let gram = kernel.gram(degree + 1)?;
        let blocks = Indices::parts(kernel.parity(), degree + 1)
            .map(|indices| Block::new(&gram, &factors, parameter, indices))
            .collect::<Result<_, _>>()?;
        Ok(Self { kernel, parameter, factors, blocks })
    }

    /// The highest index kept.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.factors.len() - 1
    }

    /// The kernel.
    #[must_use]
    pub fn kernel(&self) -> &'k K {
        self.kernel
    }

    /// `lambda`.
    #[must_use]
    pub fn parameter(&self) -> f64 {
        self.parameter
    }

    /// The solution for the moments `f_k = int_L f phi_k dx`, `k = 0 .. degree`; missing moments count as zero.
    #[must_use]
    pub fn solve(&self, moments: &[f64]) -> DegenerateSolution<'k, K> {
        let mut projections = vec![0.0; self.factors.len()];
        for block in &self.blocks {
            let roots = || block.indices.of(&self.factors).map(f64::sqrt);
            let given = block.indices.of(moments).chain(std::iter::repeat(0.0));
            let mut part: Vec<f64> = roots().zip(given).map(|(d, f)| d * f).collect();
            block.cholesky.solve(&mut part);
            block.indices.put(part.iter().zip(roots()).map(|(y, d)| y / d), &mut projections);
        }
        DegenerateSolution::new(self.kernel, self.parameter, &self.factors, projections)
    }
}

impl Block {
    fn new(gram: &Gram, factors: &[f64], parameter: f64, indices: Indices) -> Result<Self, Error> {
        let root: Vec<f64> = indices.of(factors).map(f64::sqrt).collect();
        let cholesky = Cholesky::new(root.len(), |i, j| {
            let identity = if i == j { 1.0 } else { 0.0 };
            identity + parameter * root[i] * gram.entry(indices.at(i), indices.at(j)) * root[j]
        })?;
        Ok(Self { indices, cholesky })
    }
}

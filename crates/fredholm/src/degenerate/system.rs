//! The degenerate system (1.9) in symmetric positive form.

use crate::kernel::{Gram, Parity, SpectralRelation};
use crate::linear::Cholesky;
use crate::{DegenerateSolution, Error, memory};

/// Memory left alone when a dense system is admitted: the right-hand sides, the result and the rest of the program.
const HEADROOM: f64 = 0.9;

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

/// The indices `first, first + step, ...` and the factor of their part of the matrix.
#[derive(Debug, Clone)]
struct Block {
    first: usize,
    step: usize,
    cholesky: Cholesky,
}

impl<'k, K: SpectralRelation> DegenerateSystem<'k, K> {
    /// Builds and factors the system for `phi + parameter K phi = f` with the eigenfunctions `phi_0 .. phi_degree`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a negative or not finite parameter, [`Error::NotPositive`] when one of the
    /// eigenvalues is not positive, [`Error::TooLarge`] beyond memory, [`Error::NotPositiveDefinite`] if rounding spoils the factorisation.
    pub fn new(kernel: &'k K, parameter: f64, degree: usize) -> Result<Self, Error> {
        if !(parameter.is_finite() && parameter >= 0.0) {
            return Err(Error::InvalidParameter {
                name: "parameter",
                value: parameter,
                requirement: "finite and not negative",
            });
        }
        let step = match kernel.parity() {
            Parity::Alternating => 2,
            Parity::None => 1,
        };
        admit(degree, step)?;
        let factors = expansion_factors(kernel, degree)?;
        let gram = kernel.gram(degree + 1)?;
        let blocks = (0..step)
            .filter(|&first| first <= degree)
            .map(|first| Block::new(&gram, &factors, parameter, first, step))
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
            let indices = (block.first..self.factors.len()).step_by(block.step);
            let mut part: Vec<f64> = indices
                .clone()
                .map(|k| self.factors[k].sqrt() * moments.get(k).copied().unwrap_or(0.0))
                .collect();
            block.cholesky.solve(&mut part);
            for (k, y) in indices.zip(part) {
                projections[k] = y / self.factors[k].sqrt();
            }
        }
        DegenerateSolution::new(self.kernel, self.parameter, &self.factors, projections)
    }
}

impl Block {
    fn new(
        gram: &Gram,
        factors: &[f64],
        parameter: f64,
        first: usize,
        step: usize,
    ) -> Result<Self, Error> {
        let root: Vec<f64> = factors.iter().skip(first).step_by(step).map(|d| d.sqrt()).collect();
        let cholesky = Cholesky::new(root.len(), |i, j| {
            let identity = if i == j { 1.0 } else { 0.0 };
            identity
                + parameter * root[i] * gram.entry(first + step * i, first + step * j) * root[j]
        })?;
        Ok(Self { first, step, cholesky })
    }
}

fn expansion_factors<K: SpectralRelation>(kernel: &K, degree: usize) -> Result<Vec<f64>, Error> {
    (0..=degree)
        .map(|index| {
            let factor = kernel.expansion_factor(index);
            if factor > 0.0 {
                Ok(factor)
            } else {
                Err(Error::NotPositive { index, eigenvalue: kernel.eigenvalue(index) })
            }
        })
        .collect()
}

/// Refuses a system whose dense blocks would not fit into memory, before anything is allocated.
fn admit(degree: usize, step: usize) -> Result<(), Error> {
    // In floating point: the square of a hostile degree overflows every integer.
    let order = (degree / step) as f64 + 1.0;
    let needed = (8.0 * step as f64 * order * order) as u64;
    let available = memory::available();
    if needed as f64 > HEADROOM * available as f64 {
        return Err(Error::TooLarge { degree, needed, available });
    }
    Ok(())
}

//! The degenerate system (1.9) in symmetric positive form.

use super::split::{Indices, expansion_factors, steps};
use crate::kernel::{Gram, SpectralRelation};
use crate::linear::{Factored, dot};
use crate::{DegenerateSolution, Error, memory};

/// The matrix and its factor.
const BYTES_AN_ENTRY: f64 = 16.0;

/// The degenerate system of a kernel at one parameter, factored: for `k = 0 .. degree`
///
/// `X_k + lambda sum_m D_m R_km X_m = f_k`, `D_m = lambda_m / h_m`, `X_k = int_L phi phi_k dm`   (1.9)
///
/// With `S = sqrt|D|`, `J` the signs of `D` and `Y = S X` it is `(I + lambda S R S J) Y = S f`. Where all `D_m` are positive and `lambda >= 0` the matrix is symmetric
/// positive definite and Cholesky serves, else elimination with pivots; where the eigenfunctions alternate in parity it splits into the even and the odd system, (3.10)
/// and (3.11).
///
/// Cost: `degree^3 / 12` multiplications and `4 degree^2` bytes a parity (four and eight times that without parity; four times the multiplications where
/// Cholesky does not serve); each right-hand side `degree^2`.
#[derive(Debug, Clone)]
pub struct DegenerateSystem<'k, K: ?Sized> {
    kernel: &'k K,
    parameter: f64,
    factors: Vec<f64>,
    blocks: Vec<Block>,
}

/// One part of the unknowns and the factor of their part of the matrix.
#[derive(Debug, Clone)]
struct Block {
    indices: Indices,
    roots: Vec<f64>,
    factored: Factored,
    /// Rows of the matrix for the unknowns whose `D_m` vanishes: `X_m` does not follow from `Y_m` there.
    silent: Vec<(usize, Vec<f64>)>,
}

impl<'k, K: SpectralRelation + ?Sized> DegenerateSystem<'k, K> {
    /// Builds and factors the system for `phi + parameter K phi = f` with the eigenfunctions `phi_0 .. phi_degree`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a parameter that is not finite; [`Error::Singular`] when the system has no inverse to rounding (never for a positive
    /// kernel and `parameter >= 0`); [`Error::TooFew`] beyond what the kernel was prepared for; [`Error::TooLarge`] beyond memory.
    pub fn new(kernel: &'k K, parameter: f64, degree: usize) -> Result<Self, Error> {
        if !parameter.is_finite() {
            return Err(Error::InvalidParameter {
                name: "parameter",
                value: parameter,
                requirement: "finite",
            });
        }
        let parts = steps(kernel.parity()) as f64;
        let order = degree as f64 / parts + 1.0;
        memory::admit(degree, BYTES_AN_ENTRY * parts * order * order)?;
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

    /// Whether the system is symmetric positive definite.
    #[must_use]
    pub fn is_positive(&self) -> bool {
        self.blocks.iter().all(|block| block.factored.is_positive())
    }

    /// The solution for the moments `f_k = int_L f phi_k dm`, `k = 0 .. degree`; missing moments count as zero.
    #[must_use]
    pub fn solve(&self, moments: &[f64]) -> DegenerateSolution<'k, K> {
        let mut projections = vec![0.0; self.factors.len()];
        for block in &self.blocks {
            block.solve(moments, &mut projections);
        }
        DegenerateSolution::new(self.kernel, self.parameter, &self.factors, projections)
    }
}

impl Block {
    fn new(gram: &Gram, factors: &[f64], parameter: f64, indices: Indices) -> Result<Self, Error> {
        let roots: Vec<f64> = indices.of(factors).map(|d| d.abs().sqrt()).collect();
        let signs: Vec<f64> = indices.of(factors).map(f64::signum).collect();
        let order = roots.len();
        let entry = |i: usize, j: usize| {
            roots[i] * gram.entry(indices.at(i), indices.at(j)) * roots[j] * signs[j]
        };
        let matrix: Vec<f64> = (0..order)
            .flat_map(|j| (0..order).map(move |i| (i, j)))
            .map(|(i, j)| entry(i, j))
            .collect();
        let factored = if signs.iter().all(|sign| *sign > 0.0) {
            Factored::shifted(&matrix, order, parameter)?
        } else {
            Factored::indefinite(&matrix, order, parameter)?
        };
        let row = |i: usize| {
            let coupling = |j: usize| {
                parameter * gram.entry(indices.at(i), indices.at(j)) * roots[j] * signs[j]
            };
            (i, (0..order).map(coupling).collect())
        };
        let silent = (0..order).filter(|&i| roots[i] == 0.0).map(row).collect();
        Ok(Self { indices, roots, factored, silent })
    }

    fn solve(&self, moments: &[f64], projections: &mut [f64]) {
        let given: Vec<f64> =
            self.indices.of(moments).chain(std::iter::repeat(0.0)).take(self.roots.len()).collect();
        let mut y: Vec<f64> = self.roots.iter().zip(&given).map(|(root, f)| root * f).collect();
        self.factored.solve(&mut y);
        let mut x: Vec<f64> = y.iter().zip(&self.roots).map(|(y, root)| y / root).collect();
        for (i, row) in &self.silent {
            x[*i] = given[*i] - dot(row, &y);
        }
        self.indices.put(x, projections);
    }
}

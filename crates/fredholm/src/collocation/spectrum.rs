//! One eigendecomposition for every parameter.

use super::operator::require_finite_parameter;
use super::{SincOperator, SincSolution, Sweep};
use crate::Error;
use crate::linear::Eigensystem;

/// `1 + lambda nu` below this share of the largest counts as zero.
const ZERO: f64 = 1e-13;

/// The eigenvalues and eigenvectors of a collocated kernel.
///
/// Integrals of a solution then cost `O(N)` for each parameter ([`Sweep`]), its values at the nodes `O(N^2)`. Values carry
/// noise of about `1e-12 lambda/1e4` at the ends, where [`SincFactor`](super::SincFactor) has none.
#[derive(Debug, Clone)]
pub struct SincSpectrum<'o> {
    operator: &'o SincOperator,
    blocks: Vec<Eigensystem>,
}

impl SincOperator {
    /// The eigendecomposition of the operator, which serves every parameter.
    ///
    /// # Errors
    /// [`Error::EigenvaluesNotFound`] when the eigenvalues are not found.
    pub fn spectrum(&self) -> Result<SincSpectrum<'_>, Error> {
        SincSpectrum::new(self)
    }
}

impl<'o> SincSpectrum<'o> {
    pub(super) fn new(operator: &'o SincOperator) -> Result<Self, Error> {
        let blocks = operator
            .blocks()
            .iter()
            .map(|block| Eigensystem::new(&block.matrix, block.order()))
            .collect::<Result<_, _>>()?;
        Ok(Self { operator, blocks })
    }

    /// Eigenvalues of `K`, unweighted, ascending; those of a positive kernel may come out as -1e-16 by rounding.
    #[must_use]
    pub fn eigenvalues(&self) -> Vec<f64> {
        let mut values: Vec<f64> =
            self.blocks.iter().flat_map(|block| block.values.iter().copied()).collect();
        values.sort_by(f64::total_cmp);
        values
    }

    /// The solution of `phi + parameter K phi = f`, `f` given by its values at the nodes.
    ///
    /// # Errors
    /// As [`SincOperator::factor`] and [`SincFactor::solve`](super::SincFactor::solve).
    pub fn solve(&self, parameter: f64, right_hand_side: &[f64]) -> Result<SincSolution, Error> {
        require_finite_parameter(parameter)?;
        self.operator.require_values(right_hand_side)?;
        let mut scaled = Vec::with_capacity(self.blocks.len());
        for (block, system) in self.operator.blocks().iter().zip(&self.blocks) {
            require_regular(parameter, &system.values)?;
            let mut coefficients = system.coefficients(&block.scaled(right_hand_side));
            for (c, eigenvalue) in coefficients.iter_mut().zip(&system.values) {
                *c /= 1.0 + parameter * eigenvalue;
            }
            scaled.push(system.combine(&coefficients));
        }
        Ok(self.operator.finish(parameter, right_hand_side, &scaled))
    }

    /// Integrals and end values for very many parameters from 0 to `largest_parameter`, for the right-hand sides `1`, `x`
    /// and one function `f` given by its values at the nodes and its one-sided limits at the left and right end.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `largest_parameter` is finite and not negative, [`Error::NotPositiveDefinite`]
    /// when the kernel is not positive, [`Error::WrongLength`] and [`Error::NotFinite`] for a bad right-hand side.
    pub fn sweep(
        &self,
        right_hand_side: &[f64],
        ends: [f64; 2],
        largest_parameter: f64,
    ) -> Result<Sweep, Error> {
        Sweep::new(self, right_hand_side, ends, largest_parameter)
    }

    pub(super) fn operator(&self) -> &'o SincOperator {
        self.operator
    }

    pub(super) fn blocks(&self) -> &[Eigensystem] {
        &self.blocks
    }
}

fn require_regular(parameter: f64, eigenvalues: &[f64]) -> Result<(), Error> {
    let shifted = || eigenvalues.iter().map(|eigenvalue| 1.0 + parameter * eigenvalue);
    let largest = shifted().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let smallest = shifted().fold(f64::INFINITY, |least: f64, value| least.min(value.abs()));
    if smallest > ZERO * largest { Ok(()) } else { Err(Error::Singular { parameter, smallest }) }
}

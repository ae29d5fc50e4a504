//! The equation factored at one parameter.

use super::operator::require_finite_parameter;
use super::{SincOperator, SincSolution};
use crate::Error;
use crate::linear::Factored;

/// `1 + lambda K`, factored: the most accurate route for one parameter and any number of right-hand sides.
///
/// By Cholesky while the operator is positive (`N^3/12` multiplications if the kernel is even, four times that if not),
/// else by elimination with pivots. Each right-hand side costs `N^2`, or `2 N^2`.
#[derive(Debug, Clone)]
pub struct SincFactor<'o> {
    operator: &'o SincOperator,
    parameter: f64,
    blocks: Vec<Factored>,
}

impl SincOperator {
    /// The factored equation `phi + parameter K phi = f` for one parameter, of either sign.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a parameter that is not finite, [`Error::Singular`] when the operator has no
    /// inverse to rounding.
    pub fn factor(&self, parameter: f64) -> Result<SincFactor<'_>, Error> {
        require_finite_parameter(parameter)?;
        SincFactor::new(self, parameter)
    }
}

impl<'o> SincFactor<'o> {
    pub(super) fn new(operator: &'o SincOperator, parameter: f64) -> Result<Self, Error> {
        let blocks = operator
            .blocks()
            .iter()
            .map(|block| Factored::shifted(&block.matrix, block.order(), parameter))
            .collect::<Result<_, _>>()?;
        Ok(Self { operator, parameter, blocks })
    }

    /// `lambda`.
    #[must_use]
    pub fn parameter(&self) -> f64 {
        self.parameter
    }

    /// Whether `1 + lambda K` is positive definite.
    #[must_use]
    pub fn is_positive(&self) -> bool {
        self.blocks.iter().all(Factored::is_positive)
    }

    /// The solution for a right-hand side given by its values at the nodes of the operator.
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless there is one value for each node, [`Error::NotFinite`] for NaN or an infinity.
    pub fn solve(&self, right_hand_side: &[f64]) -> Result<SincSolution, Error> {
        self.operator.require_values(right_hand_side)?;
        let scaled: Vec<Vec<f64>> = (self.operator.blocks().iter().zip(&self.blocks))
            .map(|(block, factored)| {
                let mut z = block.scaled(right_hand_side);
                factored.solve(&mut z);
                z
            })
            .collect();
        Ok(self.operator.finish(self.parameter, right_hand_side, &scaled))
    }
}

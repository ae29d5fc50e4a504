//! The system (1.9) by the route that its size asks for.

mod constant_shift;

pub use constant_shift::{ConstantShift, ShiftedSolution};

use super::split::positive_factors;
use super::{DegenerateSolution, DegenerateSystem, StructuredSystem};
use crate::Error;
use crate::kernel::{Gram, SpectralRelation};

/// Largest degree that is solved densely: about where the structured solve becomes the faster one.
const LARGEST_DENSE_DEGREE: usize = 600;

/// The degenerate system of a kernel at one parameter, ready for right-hand sides: dense Cholesky for few terms, preconditioned conjugate gradients
/// with fast products for many, where the Gram matrix is Toeplitz plus Hankel.
#[derive(Debug)]
pub enum DegenerateSolver<'k, K: ?Sized> {
    /// Cholesky.
    Dense(DegenerateSystem<'k, K>),
    /// Conjugate gradients.
    Structured(StructuredSystem<'k, K>),
}

impl<'k, K: SpectralRelation + ?Sized> DegenerateSolver<'k, K> {
    /// The solver for `phi + parameter K phi = f` with the eigenfunctions `phi_0 .. phi_degree`.
    ///
    /// # Errors
    /// Those of [`DegenerateSystem::new`] and [`StructuredSystem::new`].
    pub fn new(kernel: &'k K, parameter: f64, degree: usize) -> Result<Self, Error> {
        let structured = degree > LARGEST_DENSE_DEGREE
            && parameter >= 0.0
            && matches!(kernel.gram(1)?, Gram::ToeplitzHankel { .. })
            && positive_factors(kernel, degree).is_ok();
        Ok(if structured {
            Self::Structured(StructuredSystem::new(kernel, parameter, degree)?)
        } else {
            Self::Dense(DegenerateSystem::new(kernel, parameter, degree)?)
        })
    }

    /// The solution for the moments `f_k = int_L f phi_k dx`, `k = 0 .. degree`.
    ///
    /// # Errors
    /// Those of [`StructuredSystem::solve`]: no convergence.
    pub fn solve(&self, moments: &[f64]) -> Result<DegenerateSolution<'k, K>, Error> {
        match self {
            Self::Dense(system) => Ok(system.solve(moments)),
            Self::Structured(system) => {
                Ok(system.solve(moments, StructuredSystem::<K>::TOLERANCE)?.0)
            }
        }
    }
}

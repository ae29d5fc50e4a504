//! The structured system at one parameter.

use std::sync::OnceLock;

use super::conjugate_gradients::{self, Convergence, Goal, Iterable};
use super::operator::{Part, StructuredOperator};
use super::preconditioner::Preconditioner;
use super::product::Workspace;
use crate::kernel::SpectralRelation;
use crate::linear::vector::{dot, largest};
use crate::{DegenerateSolution, Error};

/// Iterations allowed for one parity: several times what a parameter of `1e8` takes.
const ITERATIONS: usize = 2000;
/// Rounding errors of a product, in units of the machine precision times the size of what it sums.
const ROUNDING: f64 = 4.0;

/// The degenerate system (1.9) of a kernel at one parameter, as [`DegenerateSystem`](crate::DegenerateSystem) has it, for truncations of a million and more:
///
/// `(I + lambda sqrt(D) R sqrt(D)) Y = sqrt(D) f`, `Y = sqrt(D) X`
///
/// by conjugate gradients, with products by fast transforms and the leading block of the matrix as preconditioner.
///
/// Cost: `O(degree log degree)` an iteration. The number of iterations does not grow with the degree; kernel 1 to `1e-12`, a parity: 4 at
/// `lambda = 0.6`, 5 at 60, 9 at 6000, 14 at 60000.
///
/// ```
/// use fredholm::kernel::{Logarithm, SpectralRelation};
/// use fredholm::{SincOperator, StructuredSystem};
///
/// let (kernel, theta) = (Logarithm::unit(), 2.0);
/// let system = StructuredSystem::new(&kernel, theta, 20_000)?;
/// let moments = kernel.moments(&|_| 1.0, 20_001)?;
/// let (pressure, convergence) = system.solve(&moments.values, 1e-14)?;
/// assert!(convergence.residual <= 1e-14);
///
/// let operator = SincOperator::new(&kernel, 50)?;
/// let independent = &operator.solve(theta, &[vec![1.0; operator.count()]])?[0];
/// assert!((pressure.projections()[0] - independent.integral(|_| 1.0)).abs() < 1e-12);
/// # Ok::<(), fredholm::Error>(())
/// ```
#[derive(Debug)]
pub struct StructuredSystem<'k, K: ?Sized> {
    operator: StructuredOperator<'k, K>,
    parameter: f64,
    /// Made when a right-hand side first needs them: many are even or odd.
    preconditioners: Vec<OnceLock<Result<Preconditioner, Error>>>,
}

impl<'k, K: SpectralRelation + ?Sized> StructuredSystem<'k, K> {
    /// The relative residual to ask for where nothing speaks for another.
    pub const TOLERANCE: f64 = 1e-14;

    /// The system for `phi + parameter K phi = f` with the eigenfunctions `phi_0 .. phi_degree`. For several
    /// parameters make one [`StructuredOperator`] and ask it for its [`system`](StructuredOperator::system).
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a negative or not finite parameter; those of [`StructuredOperator::new`].
    pub fn new(kernel: &'k K, parameter: f64, degree: usize) -> Result<Self, Error> {
        crate::degenerate::split::check_parameter(parameter)?;
        StructuredOperator::new(kernel, degree)?.system(parameter)
    }

    pub(super) fn at(operator: StructuredOperator<'k, K>, parameter: f64) -> Self {
        let preconditioners = operator.parts().iter().map(|_| OnceLock::new()).collect();
        Self { operator, parameter, preconditioners }
    }

    /// The operator.
    #[must_use]
    pub fn operator(&self) -> &StructuredOperator<'k, K> {
        &self.operator
    }

    /// The highest index kept.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.operator.degree()
    }

    /// `lambda`.
    #[must_use]
    pub fn parameter(&self) -> f64 {
        self.parameter
    }

    /// The solution for the moments `f_k = int_L f phi_k dx`, `k = 0 .. degree` (missing ones count as zero), to a
    /// relative residual of `tolerance`, or as near to it as rounding lets.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a tolerance that is not between 0 and 1 or a moment that is not finite,
    /// [`Error::NotConverged`] when the iteration stops short of both, [`Error::NotPositiveDefinite`] when rounding spoils the leading block.
    pub fn solve(
        &self,
        moments: &[f64],
        tolerance: f64,
    ) -> Result<(DegenerateSolution<'k, K>, Convergence), Error> {
        if !(tolerance > 0.0 && tolerance < 1.0) {
            return Err(Error::InvalidParameter {
                name: "tolerance",
                value: tolerance,
                requirement: "between 0 and 1",
            });
        }
        let mut projections = vec![0.0; self.degree() + 1];
        let mut convergence = Convergence::default();
        for (part, preconditioner) in self.operator.parts().iter().zip(&self.preconditioners) {
            let (mut right, scale) = right_hand_side(part, moments)?;
            if scale == 0.0 {
                continue;
            }
            let goal = Goal { tolerance, maximum: ITERATIONS };
            let preconditioner = preconditioner
                .get_or_init(|| Preconditioner::new(part, self.parameter))
                .as_ref()
                .map_err(Clone::clone)?;
            right.iter_mut().for_each(|value| *value /= scale);
            let mut matrix = Matrix::new(part, self.parameter, preconditioner);
            let (y, found) = conjugate_gradients::solve(&mut matrix, &right, goal)?;
            convergence.include(found);
            let x = y.iter().zip(part.roots()).map(|(y, root)| scale * y / root);
            part.indices().put(x, &mut projections);
        }
        let factors = self.operator.factors();
        let kernel = self.operator.kernel();
        Ok((DegenerateSolution::new(kernel, self.parameter, factors, projections), convergence))
    }
}

/// `sqrt(D) f` and its largest absolute value, by which it is divided so that no square overflows or vanishes.
fn right_hand_side(part: &Part, moments: &[f64]) -> Result<(Vec<f64>, f64), Error> {
    let indices = part.indices();
    if let Some(value) = indices.of(moments).find(|moment| !moment.is_finite()) {
        return Err(Error::InvalidParameter { name: "moment", value, requirement: "finite" });
    }
    let given = indices.of(moments).chain(std::iter::repeat(0.0));
    let right: Vec<f64> = part.roots().iter().zip(given).map(|(root, f)| root * f).collect();
    let scale = largest(&right);
    Ok((right, scale))
}

impl Convergence {
    fn include(&mut self, other: Self) {
        self.iterations += other.iterations;
        self.residual = self.residual.max(other.residual);
        self.limited_by_rounding |= other.limited_by_rounding;
    }
}

/// `I + lambda sqrt(D) R sqrt(D)` of one parity, with room for its products.
struct Matrix<'a> {
    part: &'a Part,
    parameter: f64,
    preconditioner: &'a Preconditioner,
    workspace: Workspace,
    /// Norms of `R` and `sqrt(D)`.
    norms: [f64; 2],
}

impl<'a> Matrix<'a> {
    fn new(part: &'a Part, parameter: f64, preconditioner: &'a Preconditioner) -> Self {
        let norms = [part.gram_norm(), largest(part.roots())];
        Self { part, parameter, preconditioner, workspace: part.workspace(), norms }
    }
}

impl Iterable for Matrix<'_> {
    fn apply(&mut self, vector: &[f64], image: &mut [f64]) {
        self.part.apply(self.parameter, &mut self.workspace, vector, image);
    }

    fn precondition(&self, vector: &mut [f64]) {
        self.preconditioner.apply(vector);
    }

    fn rounding(&self, vector: &[f64]) -> f64 {
        let weighted: f64 =
            vector.iter().zip(self.part.roots()).map(|(y, root)| (y * root).powi(2)).sum();
        let [gram, root] = self.norms;
        let product = self.parameter * root * gram * weighted.sqrt();
        ROUNDING * f64::EPSILON * (dot(vector, vector).sqrt() + product)
    }
}

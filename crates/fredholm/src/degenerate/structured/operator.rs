//! What the systems of all parameters share.

use std::sync::Arc;

use fredholm_transforms::Planner;

use super::preconditioner::largest_leading_order;
use super::product::{Product, Workspace};
use super::system::StructuredSystem;
use crate::degenerate::split::{Indices, check_parameter, positive_factors};
use crate::kernel::{Gram, Parity, SpectralRelation};
use crate::{Error, memory};

/// Memory a coefficient takes at the peak of a solve, in bytes: measured, rounded up.
pub const BYTES_A_DEGREE: f64 = 240.0;

/// The Gram matrix `R` and the factors `D` of a kernel up to a degree, ready for fast products: independent of the
/// parameter, and shared by the systems of several.
///
/// Needs a kernel whose Gram matrix is [`Gram::ToeplitzHankel`]. A clone shares everything.
///
/// Cost: `O(degree log degree)`, about 150 bytes a degree.
#[derive(Debug)]
pub struct StructuredOperator<'k, K: ?Sized> {
    kernel: &'k K,
    shared: Arc<Shared>,
}

#[derive(Debug)]
struct Shared {
    factors: Vec<f64>,
    parts: Vec<Part>,
}

/// One parity of the operator.
#[derive(Debug)]
pub(super) struct Part {
    indices: Indices,
    /// `sqrt(D)`.
    roots: Vec<f64>,
    product: Product,
    /// The first entries of the Toeplitz and the Hankel matrix of this part.
    toeplitz: Vec<f64>,
    hankel: Vec<f64>,
}

impl<K: ?Sized> Clone for StructuredOperator<'_, K> {
    fn clone(&self) -> Self {
        Self { kernel: self.kernel, shared: Arc::clone(&self.shared) }
    }
}

impl<'k, K: SpectralRelation + ?Sized> StructuredOperator<'k, K> {
    /// The operator for the eigenfunctions `phi_0 .. phi_degree`.
    ///
    /// # Errors
    /// [`Error::TooLarge`] beyond memory, [`Error::NotPositive`] when one of the eigenvalues is not positive,
    /// [`Error::Unstructured`] when the Gram matrix is not Toeplitz plus Hankel; whatever the kernel's own route to it meets.
    pub fn new(kernel: &'k K, degree: usize) -> Result<Self, Error> {
        memory::admit(degree, BYTES_A_DEGREE * degree as f64)?;
        let factors = positive_factors(kernel, degree)?;
        let Gram::ToeplitzHankel { toeplitz, hankel } = kernel.gram(degree + 1)? else {
            return Err(Error::Unstructured);
        };
        if toeplitz.len() <= degree || hankel.len() <= 2 * degree {
            return Err(Error::Unstructured);
        }
        let parts = Part::all(kernel.parity(), &factors, &toeplitz, &hankel);
        Ok(Self { kernel, shared: Arc::new(Shared { factors, parts }) })
    }

    /// The system for `phi + parameter K phi = f`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a negative or not finite parameter.
    pub fn system(&self, parameter: f64) -> Result<StructuredSystem<'k, K>, Error> {
        check_parameter(parameter)?;
        Ok(StructuredSystem::at(self.clone(), parameter))
    }

    /// The highest index kept.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.shared.factors.len() - 1
    }

    /// The kernel.
    #[must_use]
    pub fn kernel(&self) -> &'k K {
        self.kernel
    }

    /// `(R x)_k = int_L phi_k sum_m x_m phi_m dx`, `k = 0 .. degree`; missing coefficients count as zero.
    #[must_use]
    pub fn product(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; self.shared.factors.len()];
        for part in self.parts() {
            let indices = part.indices;
            part.product.apply(
                &mut part.product.workspace(),
                |q| coefficients.get(indices.at(q)).copied().unwrap_or(0.0),
                |p, value| values[indices.at(p)] = value,
            );
        }
        values
    }

    pub(super) fn factors(&self) -> &[f64] {
        &self.shared.factors
    }

    pub(super) fn parts(&self) -> &[Part] {
        &self.shared.parts
    }
}

impl Part {
    /// All parts of a kernel of this parity.
    fn all(parity: Parity, factors: &[f64], toeplitz: &[f64], hankel: &[f64]) -> Vec<Self> {
        let mut planner = Planner::new();
        Indices::parts(parity, factors.len())
            .map(|indices| Self::new(&mut planner, indices, factors, toeplitz, hankel))
            .collect()
    }

    fn new(
        planner: &mut Planner,
        indices: Indices,
        factors: &[f64],
        toeplitz: &[f64],
        hankel: &[f64],
    ) -> Self {
        let roots: Vec<f64> = indices.of(factors).map(f64::sqrt).collect();
        let toeplitz = |j: usize| toeplitz[indices.step * j];
        let hankel = |j: usize| hankel[2 * indices.first + indices.step * j];
        let leading = roots.len().min(largest_leading_order());
        Self {
            indices,
            product: Product::new(planner, roots.len(), toeplitz, hankel),
            toeplitz: (0..leading).map(toeplitz).collect(),
            hankel: (0..2 * leading - 1).map(hankel).collect(),
            roots,
        }
    }

    pub(super) fn indices(&self) -> Indices {
        self.indices
    }

    /// Number of unknowns.
    pub(super) fn count(&self) -> usize {
        self.product.count()
    }

    /// `sqrt(D_p)`.
    pub(super) fn root(&self, p: usize) -> f64 {
        self.roots[p]
    }

    pub(super) fn roots(&self) -> &[f64] {
        &self.roots
    }

    /// The Toeplitz entry at distance `j`, or zero beyond those kept.
    pub(super) fn toeplitz(&self, j: usize) -> f64 {
        self.toeplitz.get(j).copied().unwrap_or(0.0)
    }

    /// The order of the largest leading block whose entries are kept.
    pub(super) fn leading(&self) -> usize {
        self.toeplitz.len()
    }

    /// `R_pq` within the leading block.
    pub(super) fn leading_entry(&self, p: usize, q: usize) -> f64 {
        self.toeplitz[p.abs_diff(q)] + self.hankel[p + q]
    }

    pub(super) fn workspace(&self) -> Workspace {
        self.product.workspace()
    }

    /// `image = (I + parameter sqrt(D) R sqrt(D)) vector`.
    pub(super) fn apply(
        &self,
        parameter: f64,
        workspace: &mut Workspace,
        vector: &[f64],
        image: &mut [f64],
    ) {
        self.product.apply(
            workspace,
            |q| self.roots[q] * vector[q],
            |p, value| image[p] = vector[p] + parameter * self.roots[p] * value,
        );
    }

    /// The size of `sqrt(D) R sqrt(D)` against `1/p`: how far the coupling reaches for a parameter of 1.
    pub(super) fn strength(&self) -> f64 {
        let middle = self.leading() / 2;
        let p = middle as f64 + 0.5;
        p * self.roots[middle] * self.roots[middle] * self.toeplitz(0).abs()
    }

    /// An upper bound of the norm of `R`.
    pub(super) fn gram_norm(&self) -> f64 {
        self.product.norm_bound()
    }
}

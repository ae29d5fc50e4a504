//! The approximate solution (1.8).

use crate::kernel::SpectralRelation;

/// The solution of the degenerate equation,
///
/// `phi(x) = f(x) - lambda sum_m D_m X_m phi_m(x)`   (1.8)
///
/// It is kept as its coefficients: the right-hand side `f` stays with the caller and is handed in again for values.
#[derive(Debug, Clone)]
pub struct DegenerateSolution<'k, K: ?Sized> {
    kernel: &'k K,
    projections: Vec<f64>,
    correction: Vec<f64>,
}

impl<'k, K: SpectralRelation + ?Sized> DegenerateSolution<'k, K> {
    pub(super) fn new(
        kernel: &'k K,
        parameter: f64,
        factors: &[f64],
        projections: Vec<f64>,
    ) -> Self {
        let correction = projections.iter().zip(factors).map(|(x, d)| parameter * d * x).collect();
        Self { kernel, projections, correction }
    }

    /// `X_k = int_L phi phi_k dx`, `k = 0 .. degree`: for kernel 1, `X_0` is the integral of the solution and `a X_1` its first moment.
    #[must_use]
    pub fn projections(&self) -> &[f64] {
        &self.projections
    }

    /// `lambda D_m X_m`: the coefficients of `f - phi` in the eigenfunctions.
    #[must_use]
    pub fn correction(&self) -> &[f64] {
        &self.correction
    }

    /// The function `f - phi` for many points.
    #[must_use]
    pub fn prepared_correction(&self) -> Box<dyn Fn(f64) -> f64 + Send + Sync + 'k> {
        self.kernel.combination(&self.correction)
    }

    /// `phi(x)`, given `f(x)`.
    #[must_use]
    pub fn evaluate(&self, x: f64, right_hand_side: f64) -> f64 {
        right_hand_side - self.kernel.sum(&self.correction, x)
    }
}

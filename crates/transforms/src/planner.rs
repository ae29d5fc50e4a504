//! Plans of complex Fourier transforms.

use std::fmt;
use std::sync::Arc;

use rustfft::{Fft, FftPlanner};

/// Plans transforms, and keeps what equal lengths share.
pub struct Planner(FftPlanner<f64>);

impl Planner {
    /// A planner that has planned nothing.
    #[must_use]
    pub fn new() -> Self {
        Self(FftPlanner::new())
    }

    /// `X_k = sum_j x_j exp(-2 pi i j k / length)`.
    pub(crate) fn forward(&mut self, length: usize) -> Arc<dyn Fft<f64>> {
        self.0.plan_fft_forward(length)
    }

    /// The same with `exp(2 pi i j k / length)`.
    pub(crate) fn inverse(&mut self, length: usize) -> Arc<dyn Fft<f64>> {
        self.0.plan_fft_inverse(length)
    }
}

impl Default for Planner {
    fn default() -> Self {
        Self::new()
    }
}

impl fmt::Debug for Planner {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("Planner")
    }
}

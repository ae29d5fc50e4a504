//! A homogeneous half-plane under one punch or a pair: `K = ln 1/|xi - eta|`.

use std::sync::Arc;

use fredholm::SincOperator;
use fredholm::complementarity::mean_logarithms;
use fredholm::kernel::{Kernel, Logarithm};
use fredholm::multipole::PanelKernel;

use super::shared::line_operator;
use super::{Ground, Hull};
use crate::Error;

#[derive(Debug)]
pub(super) struct Line {
    kernel: Logarithm,
}

impl Line {
    pub(super) fn new() -> Self {
        Self { kernel: Logarithm::unit() }
    }
}

impl Ground for Line {
    fn kernel(&self) -> &dyn Kernel {
        &self.kernel
    }

    fn reduced_slope(&self, _xi: f64, _eta: f64) -> f64 {
        -1.0
    }

    fn means(&self, lefts: &[[f64; 2]], right: [f64; 2]) -> Vec<f64> {
        mean_logarithms(lefts, right)
    }

    fn local_ends(&self) -> Option<[f64; 2]> {
        Some([-1.0, 1.0])
    }

    fn gauge(&self, hull: &Hull) -> f64 {
        hull.half.ln()
    }

    fn known_operator(&self, half_count: usize) -> Option<Result<Arc<SincOperator>, Error>> {
        Some(line_operator(half_count))
    }

    fn panel_kernel(&self) -> Option<(PanelKernel, f64)> {
        Some((PanelKernel::Logarithm, 1.0))
    }

    fn value(&self, y: f64, t: f64) -> f64 {
        -(y - t).abs().max(f64::MIN_POSITIVE).ln()
    }
}

//! Sums of many products.

use super::kernel::PanelKernel;
use crate::linear::dot;

/// Products that are added up side by side, and together only at the end.
#[derive(Default)]
pub(super) struct Lanes {
    sums: [f64; 8],
    rest: f64,
}

impl Lanes {
    #[inline(always)]
    pub(super) fn add(&mut self, left: &[f64], right: &[f64]) {
        let length = left.len().min(right.len());
        let (left, left_rest) = left[..length].as_chunks::<8>();
        let (right, right_rest) = right[..length].as_chunks::<8>();
        for (left, right) in left.iter().zip(right) {
            for lane in 0..8 {
                self.sums[lane] += left[lane] * right[lane];
            }
        }
        self.rest +=
            left_rest.iter().zip(right_rest).map(|(left, right)| left * right).sum::<f64>();
    }

    #[inline(always)]
    pub(super) fn total(&self) -> f64 {
        let [a, b, c, d, e, f, g, h] = self.sums;
        (((a + e) + (c + g)) + ((b + f) + (d + h))) + self.rest
    }
}

/// Charges at distances that are added up, so many side by side.
pub(super) struct PlainSum<'k> {
    kernel: &'k PanelKernel,
    distances: [f64; SIDE_BY_SIDE],
    charges: [f64; SIDE_BY_SIDE],
    count: usize,
    sum: f64,
}

/// As many as near leaves have, about.
pub(super) const SIDE_BY_SIDE: usize = 64;

impl<'k> PlainSum<'k> {
    pub(super) fn new(kernel: &'k PanelKernel) -> Self {
        let none = [0.0; SIDE_BY_SIDE];
        Self { kernel, distances: none, charges: none, count: 0, sum: 0.0 }
    }

    /// A charge at a place, seen from another.
    pub(super) fn add(&mut self, (x, place): (f64, f64), charge: f64) {
        let [distance, factor] = self.kernel.apart(x, place);
        (self.distances[self.count], self.charges[self.count]) = (distance, factor * charge);
        self.count += 1;
        if self.count == SIDE_BY_SIDE {
            self.flush();
        }
    }

    fn flush(&mut self) {
        let values = &mut self.distances[..self.count];
        self.kernel.values(values);
        self.sum += dot(values, &self.charges);
        self.count = 0;
    }

    pub(super) fn total(mut self) -> f64 {
        self.flush();
        self.sum
    }
}

//! Roots of unity from two short tables.

use std::f64::consts::TAU;

use crate::Complex;

/// `exp(-2 pi i k / order)` for `0 <= k < order`, as the product of two table entries: two tables of about
/// `sqrt(order)` entries stay in the cache where a full one would be read from memory each time.
#[derive(Debug, Clone)]
pub(crate) struct Rotation {
    coarse: Vec<Complex>,
    fine: Vec<Complex>,
    bits: u32,
}

impl Rotation {
    pub(crate) fn new(order: usize) -> Self {
        let bits = order.max(1).ilog2().div_ceil(2);
        let root = |k: usize| Complex::from_polar(1.0, -TAU * (k as f64 / order as f64));
        Self {
            coarse: (0..=order >> bits).map(|k| root(k << bits)).collect(),
            fine: (0..1usize << bits).map(root).collect(),
            bits,
        }
    }

    /// `exp(-2 pi i k / order)`.
    #[inline]
    pub(crate) fn at(&self, k: usize) -> Complex {
        self.coarse[k >> self.bits] * self.fine[k & ((1 << self.bits) - 1)]
    }
}

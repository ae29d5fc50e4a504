//! Potentials at several places together, summed with what their sums lose.

use crate::allowance::UNIT;
use crate::sum::two_sum;

/// Potentials at several places, with what their sums lose and bounds of their roundings in units of the machine.
#[derive(Debug, Clone)]
pub(crate) struct Sums<const N: usize> {
    values: [f64; N],
    lost: [f64; N],
    roundings: [f64; N],
}

impl<const N: usize> Sums<N> {
    pub(crate) const NONE: Self = Self { values: [0.0; N], lost: [0.0; N], roundings: [0.0; N] };

    /// Adds a part of the potentials with this sign. Loops over lanes as all of these are written out: what the standard library maps is compiled by itself, for narrow vectors.
    #[inline(always)]
    pub(crate) fn add(&mut self, sign: f64, values: &[f64; N], roundings: &[f64; N]) {
        for i in 0..N {
            let (sum, lost) = two_sum(self.values[i], sign * values[i]);
            self.values[i] = sum;
            self.lost[i] += lost;
            self.roundings[i] += roundings[i];
        }
    }

    /// Potentials and bounds of their roundings: sums add one each, and those of the bounds themselves less than a hundredth.
    #[inline(always)]
    pub(crate) fn finished(&self) -> [(f64, f64); N] {
        let mut found = [(0.0, 0.0); N];
        for (i, found) in found.iter_mut().enumerate() {
            let value = self.values[i] + self.lost[i];
            *found = (value, UNIT * (1.01 * self.roundings[i] + 2.0 * value.abs()));
        }
        found
    }
}

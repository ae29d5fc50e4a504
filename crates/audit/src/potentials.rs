//! Potentials at several places, summed with what their sums lose.

use crate::allowance::UNIT;
use crate::sum::two_sum;

/// Potentials at several places, with what their sums lose and bounds of their roundings.
#[derive(Debug, Clone, Default)]
pub(crate) struct Potentials {
    values: Vec<f64>,
    lost: Vec<f64>,
    roundings: Vec<f64>,
}

impl Potentials {
    /// Of a single place.
    pub(crate) fn one() -> Self {
        let mut one = Self::default();
        one.begin(1);
        one
    }

    /// Forgets what was added, for this many places.
    pub(crate) fn begin(&mut self, count: usize) {
        for entries in [&mut self.values, &mut self.lost, &mut self.roundings] {
            entries.clear();
            entries.resize(count, 0.0);
        }
    }

    /// Adds a part of the potential at one of the places.
    pub(crate) fn add(&mut self, index: usize, value: f64, rounding: f64) {
        let (sum, lost) = two_sum(self.values[index], value);
        self.values[index] = sum;
        self.lost[index] += lost;
        self.roundings[index] += rounding;
    }

    /// Potentials and bounds of their roundings: sums add one each, and those of the bounds themselves less than a hundredth.
    pub(crate) fn finished(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        (self.values.iter().zip(&self.lost).zip(&self.roundings)).map(
            |((value, lost), rounding)| {
                let value = value + lost;
                (value, 1.01 * rounding + 2.0 * UNIT * value.abs())
            },
        )
    }
}

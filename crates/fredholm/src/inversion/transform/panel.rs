//! A polynomial for `G` on a panel of `s`, with its slope.

use super::super::rule::{ORDER, RULE, derivative, series, series_at};

#[derive(Debug, Clone)]
pub(super) struct Panel {
    pub(super) ends: [f64; 2],
    pub(super) values: [f64; ORDER],
    /// `dG/ds`.
    pub(super) slopes: [f64; ORDER],
    /// Number of coefficients that are not rounding.
    pub(super) count: usize,
}

impl Panel {
    pub(super) fn new(ends: [f64; 2], mut values: [f64; ORDER]) -> Self {
        let half = 0.5 * (ends[1] - ends[0]);
        let size = largest(&values);
        // Derivatives of the last coefficients would blow rounding up.
        let is_more = |n: &usize| values[*n].abs() > rounding_of(*n) * size;
        let count = (0..ORDER).rev().find(is_more).map_or(0, |last| last + 1);
        values[count..].fill(0.0);
        Self { ends, values, slopes: derivative(&values).map(|c| c / half), count }
    }

    /// The slope without what rounding makes of it at the start, where it is known to vanish; at the end it stays, as a jump where panels meet would be felt as well.
    pub(super) fn with_rest(mut self) -> Self {
        let start = self.slope(self.ends[0]);
        self.slopes[0] -= 0.5 * start;
        self.slopes[1] += 0.5 * start;
        self
    }

    pub(super) fn local(&self, s: f64) -> f64 {
        let [from, to] = self.ends;
        ((2.0 * s - from - to) / (to - from)).clamp(-1.0, 1.0)
    }

    pub(super) fn sum(&self, coefficients: &[f64; ORDER], s: f64) -> f64 {
        series(&coefficients[..self.count], self.local(s))
    }

    pub(super) fn values_at(&self, places: &[f64; ORDER]) -> [f64; ORDER] {
        series_at(&self.values[..self.count], &places.map(|s| self.local(s)))
    }

    pub(super) fn slopes_at(&self, places: &[f64; ORDER]) -> [f64; ORDER] {
        series_at(&self.slopes[..self.count], &places.map(|s| self.local(s)))
    }

    pub(super) fn value(&self, s: f64) -> f64 {
        self.sum(&self.values, s)
    }

    pub(super) fn slope(&self, s: f64) -> f64 {
        self.sum(&self.slopes, s)
    }

    pub(super) fn length(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    /// The part up to `to`.
    pub(super) fn within(&self, to: f64) -> Self {
        let [from, end] = self.ends;
        if to >= end {
            return self.clone();
        }
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let values = self.values_at(&RULE.nodes.map(|u| middle + half * u));
        Self::new([from, to], RULE.coefficients(&values))
    }

    /// The derivative of a series blows the rounding of its coefficients up by the square of their number.
    pub(super) fn blown(&self, size: f64) -> f64 {
        24.0 * f64::EPSILON * (self.count * self.count) as f64 * size / self.length()
    }
}

/// What the coefficient of the degree `n` is rounded by, relative to the values: `2 n + 1` times as much as they are.
pub(super) fn rounding_of(n: usize) -> f64 {
    f64::EPSILON * (2 * n + 1) as f64
}

pub(super) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, c| most.max(c.abs()))
}

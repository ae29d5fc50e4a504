//! A polynomial on an interval.

use crate::legendre::{self, ORDER, RULE};
use crate::near::rounded;

/// The last coefficients, whose size tells whether a panel resolves the density.
pub(crate) const TAIL: usize = 3;

/// A polynomial on `[left, right]`.
#[derive(Debug, Clone)]
pub(crate) struct Panel {
    pub(crate) left: f64,
    pub(crate) right: f64,
    pub(crate) coefficients: [f64; ORDER],
    /// A bound of its size.
    pub(crate) largest: f64,
    /// A bound of its size less its mean.
    pub(crate) swing: f64,
    /// Roundings of a value in units of the machine.
    pub(crate) evaluated: f64,
    /// Roundings of its potential on the panel, without that of its mean, see [`rounded`].
    pub(crate) rounded: f64,
}

impl Panel {
    pub(crate) fn new(left: f64, right: f64, coefficients: [f64; ORDER]) -> Self {
        let swing: f64 = coefficients[1..].iter().map(|c| c.abs()).sum();
        Self {
            left,
            right,
            coefficients,
            largest: swing + coefficients[0].abs(),
            swing,
            evaluated: legendre::evaluated(&coefficients),
            rounded: rounded(&coefficients, 1.0),
        }
    }

    pub(crate) fn middle(&self) -> f64 {
        0.5 * (self.left + self.right)
    }

    /// The largest of the last coefficients: what the panel cannot resolve is about as large.
    pub(crate) fn tail(&self) -> f64 {
        self.largest_of(ORDER - TAIL..ORDER)
    }

    /// The largest of as many before these.
    pub(crate) fn before_tail(&self) -> f64 {
        self.largest_of(ORDER - 2 * TAIL..ORDER - TAIL)
    }

    fn largest_of(&self, range: std::ops::Range<usize>) -> f64 {
        self.coefficients[range].iter().fold(0.0, |most, c| most.max(c.abs()))
    }

    pub(crate) fn half(&self) -> f64 {
        0.5 * (self.right - self.left)
    }

    /// A bound of `int |q|`.
    pub(crate) fn mass(&self) -> f64 {
        2.0 * self.half() * self.largest
    }

    /// The place as the panel has it, between -1 and 1.
    pub(crate) fn own(&self, x: f64) -> f64 {
        self.own_from(0.0, x)
    }

    /// The same of `from + offset`.
    pub(crate) fn own_from(&self, from: f64, offset: f64) -> f64 {
        let (from_left, to_right) = ((from - self.left) + offset, (self.right - from) - offset);
        ((from_left - to_right) / (self.right - self.left)).clamp(-1.0, 1.0)
    }

    pub(crate) fn evaluate(&self, x: f64) -> f64 {
        legendre::evaluate(&self.coefficients, self.own(x))
    }

    /// Places of the Gauss nodes, with their weights.
    pub(crate) fn nodes(&self) -> impl Iterator<Item = (f64, f64)> {
        let (middle, half) = (self.middle(), self.half());
        RULE.nodes.iter().zip(&RULE.weights).map(move |(t, w)| (middle + half * t, half * w))
    }

    /// Values at the Gauss nodes.
    pub(crate) fn at_nodes(&self) -> [f64; ORDER] {
        legendre::evaluate_at(&self.coefficients, &RULE.nodes)
    }
}

//! Enclosures of the Taylor coefficients of an expression over a whole interval of the parameter.
//!
//! Samples of a function say nothing about what it does between them; a bound of a derivative over an interval does. Every operation maps the
//! enclosures of the coefficients `f^(k)/k!` of its operands to those of its result by the usual recurrences (R. E. Moore, *Methods and
//! Applications of Interval Analysis*, SIAM 1979, ch. 3), rounded outward.
//!
//! Meant are the exact values of the formula, with its numbers and constant parts rounded. A coefficient of order `k` that is bounded says that the
//! derivative of order `k - 1` is Lipschitz continuous inside the interval and that the derivative of order `k`, which then exists almost everywhere,
//! divided by `k!`, lies in the enclosure. So `abs(x)` across zero has the first coefficient `[-1, 1]` and none beyond.
//!
//! What switches (`abs`, `max`, `sign`, comparisons, ..) is followed on the side on which the open interval lies: the value at an end itself does not
//! count, nor does what happens within the slack beside an end, so that an interval that starts at the rounded place of a switch lies on one side
//! of it.

mod jet;
mod nonlinear;
mod powers;
mod series;
mod sum;

use super::Expression;
use super::enclose::Enclosure;
use super::interval::Interval;
use super::line::Line;
use super::program::Operation;
use jet::{Arithmetic, Jet};
pub use series::Series;

/// Taylor coefficients over an interval of the parameter, each enclosed.
#[derive(Debug, Clone, PartialEq)]
pub struct Taylor {
    /// Of `f^(k)/k! scale^k`.
    series: Series,
    range: Enclosure,
    exponent: i32,
    switches: [bool; 2],
}

impl Taylor {
    /// Scaled coefficients, as [`Scale`] has them, and the range of values.
    pub fn new(series: Series, range: Enclosure, scale: Scale) -> Self {
        Self { series, range, exponent: scale.exponent, switches: [false; 2] }
    }

    /// The values, unless one may be undefined or infinite.
    pub fn range(&self) -> Option<Interval> {
        self.range.is_finite().then_some(self.range.interval)
    }

    /// `f^(k)/k!`.
    pub fn coefficient(&self, k: usize) -> Interval {
        if k == 0 {
            return self.range().unwrap_or(Interval::WHOLE);
        }
        self.series.get(k).shifted(-self.exponent.saturating_mul(k as i32))
    }

    /// Binary logarithm of the largest `|f^(k)/k!|`, which may itself be out of the range of numbers.
    pub fn logarithm(&self, k: usize) -> f64 {
        self.series.get(k).size().log2() - f64::from(self.exponent) * k as f64
    }

    /// Whether something that was followed to the inside switches at the left and at the right end: coefficients on either side of such an end say
    /// nothing of what happens there.
    pub fn switches(&self) -> [bool; 2] {
        self.switches
    }
}

/// What lengths are measured in, so that high powers of short ones neither underflow nor overflow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    exponent: i32,
}

impl Scale {
    /// The power of two nearest to half the length of an interval; one for a point.
    pub fn of(interval: Interval) -> Self {
        let exponent = (0.5 * interval.length()).log2().round();
        let is_usual = exponent.abs() <= 1000.0;
        Self { exponent: if is_usual { exponent as i32 } else { 0 } }
    }

    /// The length itself.
    pub fn value(self) -> f64 {
        f64::from(self.exponent).exp2()
    }
}

impl Expression {
    /// Encloses the Taylor coefficients up to an order over an interval of the parameter of a line. A switch no farther than `slack` from an
    /// end counts as one at the end.
    pub fn taylor_along(
        &self,
        line: &Line,
        parameter: Interval,
        order: usize,
        slack: f64,
    ) -> Taylor {
        let scale = Scale::of(parameter);
        let arithmetic = Arithmetic::new(order, parameter, scale.value(), slack);
        let ends = [parameter.lower(), parameter.upper()].map(|end| Interval::ends(end, end));
        let variable = |index: usize| {
            let at = |interval| line.enclose(index, interval);
            let (Some(values), Some(left), Some(right)) = (at(parameter), at(ends[0]), at(ends[1]))
            else {
                return Jet::unknown();
            };
            arithmetic.variable(values, [left, right], line.slope(index))
        };
        let jet = self.jet(&arithmetic, variable);
        Taylor { switches: arithmetic.switches(), ..Taylor::new(jet.series, jet.range, scale) }
    }

    fn jet(&self, arithmetic: &Arithmetic, variable: impl Fn(usize) -> Jet) -> Jet {
        let mut stack = Vec::with_capacity(self.compiled.height);
        for operation in &self.operations {
            let mut operand = || stack.pop().unwrap_or_else(Jet::unknown);
            let result = match *operation {
                Operation::Constant(value) => Jet::constant(value),
                Operation::Rounded(value, error) => Jet::rounded(value, error),
                Operation::Variable(index) => variable(index),
                Operation::Unary(function) => arithmetic.unary(function, &operand()),
                Operation::Binary(function) => {
                    let second = operand();
                    arithmetic.binary(function, &operand(), &second)
                }
                Operation::Where => {
                    let (fails, holds) = (operand(), operand());
                    arithmetic.choose(&operand(), &holds, &fails)
                }
            };
            stack.push(result);
        }
        stack.pop().unwrap_or_else(Jet::unknown)
    }
}

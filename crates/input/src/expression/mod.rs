//! Profile expressions: formulas for the base of a punch, such as `x^2/(2*0.8)` or `abs(xi)`.
//!
//! A text is compiled once ([`Expression::parse`]) to a flat program, which is then evaluated
//! without allocation, with its derivative, over whole intervals, and checked to be finite and
//! searched for kinks before it is put into an equation.
//!
//! ```
//! use shtaerman_input::expression::{Expression, Interval, Line, Verdict};
//!
//! // A parabola with a flat of half-width 2 mm: x (m), base (m).
//! let base = Expression::parse("max(0, abs(x) - 0.002)^2 / (2*0.8)", &["x"])?;
//! assert_eq!(base.evaluate(&[0.001]), 0.0);
//! assert!((base.evaluate(&[0.012]) - 6.25e-5).abs() < 1e-18);
//! assert!((base.evaluate_with_derivative(&[0.012], 0).1 - 0.0125).abs() < 1e-15);
//!
//! // On a punch of half-width 20 mm the parameter is xi = x/a.
//! let line = Line::new(&[(0.0, 0.02)]);
//! let range = Interval::new(-1.0, 1.0).unwrap();
//! assert_eq!(base.finiteness(&line, range), Verdict::ProvedFinite);
//! let kinks = base.breakpoints(&line, range).places;
//! assert!(kinks.iter().zip([-0.1, 0.0, 0.1]).all(|(kink, place)| (kink - place).abs() < 1e-15));
//!
//! let error = Expression::parse("2x", &["x"]).unwrap_err();
//! assert_eq!(error.help().as_deref(), Some("write 2*x"));
//! # Ok::<(), shtaerman_input::expression::ExpressionError>(())
//! ```
//!
//! # The language
//!
//! From loosest to tightest:
//!
//! | written | meaning |
//! |---|---|
//! | `a < b`, `<=`, `>`, `>=` | 1 where it holds, 0 elsewhere; not chained |
//! | `a + b`, `a - b` | from left to right |
//! | `a * b`, `a / b` | from left to right; products must be written out: `2*x`, not `2x` |
//! | `-a`, `+a` | `-2^2` is -4 |
//! | `a ^ b`, `a ** b` | from right to left; `2^-3` is 1/8 |
//!
//! Numbers are `12`, `1.5`, `.5`, `5.`, `1e-3`; constants `pi`, `e`, `tau` (a variable of the same
//! name takes precedence). The functions:
//!
//! | functions | |
//! |---|---|
//! | `sqrt cbrt hypot(a,b) pow(a,b)` | roots and powers |
//! | `exp expm1 ln log log10 log2 log1p ln_1p` | `log` is the natural logarithm, as `ln` |
//! | `sin cos tan asin acos atan atan2(y,x)` | angles in radians |
//! | `sinh cosh tanh asinh acosh atanh` | |
//! | `abs sign floor ceil` | `sign(0)` is 0 |
//! | `step heaviside` | the same: 1 for arguments >= 0, else 0 |
//! | `min(a,b,...) max(a,b,...)` | two or more arguments |
//! | `clamp(x,low,high)` | `min(max(x,low),high)` |
//! | `where(condition,a,b)` | `a` where the condition is not 0, else `b` |
//!
//! Values follow IEEE arithmetic (`1/0` is `inf`) with two exceptions that keep faults visible: an
//! undefined argument (NaN) makes any function undefined, also `min`, `max` and powers, and only
//! the branch of `where` that is not taken is ignored; and there is one zero only, so that `1/x`
//! is `+inf` at 0 whatever the sign bit.

mod breakpoint;
mod constant;
mod derivative;
mod enclose;
mod error;
mod evaluate;
mod finite;
mod float;
mod folding;
mod function;
mod interval;
mod line;
mod parse;
mod periodic;
mod program;
mod reflection;
mod rise;
mod taylor;
mod terms;
mod token;

#[cfg(test)]
mod tests;

use std::fmt;

pub use breakpoint::{Breakpoints, MOST_BREAKPOINTS};
pub use enclose::Enclosure;
pub use error::{Arity, ErrorReason, ExpressionError};
pub use finite::{Defect, SAMPLES, Verdict};
pub use folding::remainder_of_sum;
pub use interval::Interval;
pub use line::Line;
pub use reflection::Reflection;
pub use taylor::{Scale, Series, Taylor};

use derivative::Dual;
use evaluate::run;
use program::Operation;
use rise::Rise;

/// Longest text that is read, in bytes.
pub const TEXT_LIMIT: usize = 64 * 1024;

/// Deepest nesting of brackets, powers and signs that is read.
pub const DEPTH_LIMIT: usize = 200;

/// Most intermediate values; the nesting limit allows no more than five a level.
const STACK_LIMIT: usize = 1023;

/// A formula in named variables, compiled.
///
/// The language is described on the [page of the module](self).
#[derive(Debug, Clone, PartialEq)]
pub struct Expression {
    text: String,
    variables: Vec<String>,
    operations: Vec<Operation>,
    height: usize,
}

impl Expression {
    /// Compiles a text whose variables have these names; values are given in the same order.
    ///
    /// # Errors
    ///
    /// [`ExpressionError`] with the place in the text, for anything that is not an expression, for
    /// texts of more than [`TEXT_LIMIT`] bytes (refused unread) and for nesting beyond
    /// [`DEPTH_LIMIT`].
    pub fn parse(text: &str, variables: &[&str]) -> Result<Self, ExpressionError> {
        Self::parse_with_magnitudes(text, variables, &[])
    }

    /// The same with further names, each for the magnitude `|v|` of the variable at a position.
    ///
    /// ```
    /// # use shtaerman_input::expression::Expression;
    /// let ball = Expression::parse_with_magnitudes("r^2 / 2", &["x"], &[("r", 0)]).unwrap();
    /// assert_eq!(ball.evaluate(&[-0.5]), 0.125);
    /// ```
    ///
    /// # Errors
    ///
    /// As [`parse`](Self::parse).
    pub fn parse_with_magnitudes(
        text: &str,
        variables: &[&str],
        magnitudes: &[(&str, usize)],
    ) -> Result<Self, ExpressionError> {
        let operations = parse::parse(text, variables, magnitudes)?;
        Ok(Expression {
            text: text.to_owned(),
            variables: variables.iter().map(|&name| name.to_owned()).collect(),
            height: program::stack_height(&operations),
            operations,
        })
    }

    /// The text as it was written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The names of the variables, in the order in which values are given.
    pub fn variables(&self) -> &[String] {
        &self.variables
    }

    /// Whether the variable at a position occurs in the expression.
    pub fn uses(&self, variable: usize) -> bool {
        self.operations.contains(&Operation::Variable(variable))
    }

    /// Number of operations.
    pub fn length(&self) -> usize {
        self.operations.len()
    }

    /// The value for these variables. A variable that is not given counts as NaN.
    pub fn evaluate(&self, variables: &[f64]) -> f64 {
        run(&self.operations, self.height, |index| given(variables, index)).0
    }

    /// The value at a parameter of a line.
    pub fn evaluate_at(&self, line: &Line, t: f64) -> f64 {
        run(&self.operations, self.height, |index| line.variable(index, t)).0
    }

    /// Writes the values at many parameters of a line; as many as the shorter slice has.
    pub fn evaluate_along(&self, line: &Line, parameters: &[f64], values: &mut [f64]) {
        for (value, &t) in values.iter_mut().zip(parameters) {
            *value = self.evaluate_at(line, t);
        }
    }

    /// The value and its derivative with respect to the variable at a position.
    ///
    /// At kinks (`abs` at 0, `min` and `max` of equal arguments, `hypot` at the origin) it is the
    /// derivative to the right. Steps (`sign`, `step`, `floor`, `ceil`, comparisons) have the
    /// derivative 0, also where they jump; `where` has that of the branch taken. It is infinite
    /// at a vertical tangent such as `sqrt(x)` at 0, and undefined (NaN) where the value is or the
    /// chain rule leaves `0 * inf`, as for `sqrt(x^2)` at 0.
    pub fn evaluate_with_derivative(&self, variables: &[f64], variable: usize) -> (f64, f64) {
        let dual = |index| {
            let slope = if index == variable { 1.0 } else { 0.0 };
            Dual::variable(given(variables, index), slope)
        };
        run(&self.operations, self.height, dual).0.parts()
    }

    /// The value at a parameter of a line and its derivative along the line, with the rules of
    /// [`evaluate_with_derivative`](Self::evaluate_with_derivative).
    pub fn derivative_along(&self, line: &Line, t: f64) -> (f64, f64) {
        let dual = |index| Dual::variable(line.variable(index, t), line.slope(index));
        run(&self.operations, self.height, dual).0.parts()
    }

    /// `f(c + t) - f(c) - f'(c) t` along a line about the parameter `c`: how far the value leaves the tangent, with the digits that a difference of values loses where
    /// `t` is small. Functions without a short form of it, and kinks between, subtract.
    pub fn rise_along(&self, line: &Line, c: f64, t: f64) -> f64 {
        let rise = |index| Rise::variable(line.variable(index, c), line.slope(index) * t);
        let (_, slope) = self.derivative_along(line, c);
        run(&self.operations, self.height, rise).0.rest(slope * t)
    }

    /// Encloses all values taken while each variable ranges over its interval, independently of
    /// the others. A variable that is not given makes the enclosure undefined.
    ///
    /// The ends are rounded outward: the enclosure contains the values computed by
    /// [`evaluate`](Self::evaluate) and the exact ones of the formula with its numbers and
    /// constant parts rounded. It can be wider than need be where a variable occurs twice.
    pub fn enclose(&self, variables: &[Interval]) -> Enclosure {
        let enclosure = |index: usize| {
            variables.get(index).map_or(Enclosure::UNKNOWN, |&known| Enclosure::defined(known))
        };
        run(&self.operations, self.height, enclosure).0
    }

    /// Encloses all values taken on an interval of the parameter of a line.
    pub fn enclose_along(&self, line: &Line, parameter: Interval) -> Enclosure {
        let enclosure =
            |index| line.enclose(index, parameter).map_or(Enclosure::UNKNOWN, Enclosure::defined);
        run(&self.operations, self.height, enclosure).0
    }
}

/// The names of all functions that an expression can call.
pub fn function_names() -> impl Iterator<Item = &'static str> {
    function::FUNCTIONS.iter().map(|(name, _)| *name)
}

fn given(variables: &[f64], index: usize) -> f64 {
    variables.get(index).copied().unwrap_or(f64::NAN)
}

/// Shows the text as it was written.
impl fmt::Display for Expression {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.text)
    }
}

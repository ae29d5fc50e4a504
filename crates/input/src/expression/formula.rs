//! A compiled formula and what is asked of it.

use std::fmt;

use super::compiled::Compiled;
use super::derivative::Dual;
use super::duals::Duals;
use super::enclose::Enclosure;
use super::enclosures::{self, known};
use super::error::ExpressionError;
use super::interval::Interval;
use super::line::Line;
use super::parse;
use super::program::Operation;
use super::rise::Rise;

/// A formula in named variables, compiled.
///
/// The language is described on the [page of the module](super).
#[derive(Debug, Clone, PartialEq)]
pub struct Expression {
    pub(super) text: String,
    pub(super) variables: Vec<String>,
    pub(super) operations: Vec<Operation>,
    pub(super) compiled: Compiled,
}

impl Expression {
    /// Compiles a text whose variables have these names; values are given in the same order.
    ///
    /// # Errors
    ///
    /// [`ExpressionError`] with the place in the text, for anything that is not an expression, for
    /// texts of more than [`TEXT_LIMIT`](super::TEXT_LIMIT) bytes (refused unread) and for nesting beyond
    /// [`DEPTH_LIMIT`](super::DEPTH_LIMIT).
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
            compiled: Compiled::new(&operations),
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
        self.compiled.run(|index| given(variables, index))
    }

    /// The values for several sets of variables side by side, those of [`evaluate`](Self::evaluate) to the last bit for less.
    pub fn evaluate_beside<const COUNT: usize>(&self, variables: &[[f64; COUNT]]) -> [f64; COUNT] {
        // As compiled for the widest vectors that the processor has.
        pulp::Arch::new().dispatch(
            #[inline(always)]
            || {
                self.compiled
                    .run(|index| variables.get(index).copied().unwrap_or([f64::NAN; COUNT]))
            },
        )
    }

    /// The value at a parameter of a line.
    pub fn evaluate_at(&self, line: &Line, t: f64) -> f64 {
        self.compiled.run(|index| line.variable(index, t))
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
        self.compiled.run(dual).parts()
    }

    /// The value at a parameter of a line and its derivative along the line, with the rules of
    /// [`evaluate_with_derivative`](Self::evaluate_with_derivative).
    pub fn derivative_along(&self, line: &Line, t: f64) -> (f64, f64) {
        let dual = |index| Dual::variable(line.variable(index, t), line.slope(index));
        self.compiled.run(dual).parts()
    }

    /// Values and derivatives at several parameters side by side, those of [`derivative_along`](Self::derivative_along) to the last bit for less.
    pub fn derivatives_along<const COUNT: usize>(
        &self,
        line: &Line,
        t: &[f64; COUNT],
    ) -> [[f64; COUNT]; 2] {
        // As compiled for the widest vectors that the processor has.
        pulp::Arch::new().dispatch(
            #[inline(always)]
            || {
                let duals = |index| {
                    let values = std::array::from_fn(|k| line.variable(index, t[k]));
                    Duals::variable(values, line.slope(index))
                };
                self.compiled.run(duals).parts()
            },
        )
    }

    /// `f(c + t) - f(c) - f'(c) t` along a line about the parameter `c`: how far the value leaves the tangent, with the digits that a difference of values loses where
    /// `t` is small. Functions without a short form of it, and kinks between, subtract.
    pub fn rise_along(&self, line: &Line, c: f64, t: f64) -> f64 {
        let rise = |index| Rise::variable(line.variable(index, c), line.slope(index) * t);
        let (_, slope) = self.derivative_along(line, c);
        self.compiled.run(rise).rest(slope * t)
    }

    /// Encloses all values taken while each variable ranges over its interval, independently of
    /// the others. A variable that is not given makes the enclosure undefined.
    ///
    /// The ends are rounded outward: the enclosure contains the values computed by
    /// [`evaluate`](Self::evaluate) and the exact ones of the formula with its numbers and
    /// constant parts rounded. It can be wider than need be where a variable occurs twice.
    pub fn enclose(&self, variables: &[Interval]) -> Enclosure {
        self.compiled.run(|index| known(variables.get(index).copied()))
    }

    /// Encloses all values taken on an interval of the parameter of a line.
    pub fn enclose_along(&self, line: &Line, parameter: Interval) -> Enclosure {
        let [found] = self.enclose_beside(line, &[parameter]);
        found
    }

    /// The same for several intervals side by side, for less; each is that of [`enclose`](Self::enclose) to the last bit.
    pub fn enclose_beside<const COUNT: usize>(
        &self,
        line: &Line,
        parameters: &[Interval; COUNT],
    ) -> [Enclosure; COUNT] {
        enclosures::beside(&self.compiled, line, parameters)
    }
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

//! Proofs that an expression is even or odd.

use super::Expression;
use super::line::Line;
use super::program::Operation;
use super::terms::{Term, Terms};

/// What is proved of an expression under the reflection of a parameter, `t -> -t`; zero is both.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Reflection {
    /// `f(-t) = f(t)` for every `t`.
    pub is_even: bool,
    /// `f(-t) = -f(t)` for every `t`.
    pub is_odd: bool,
}

impl Reflection {
    /// Of what is zero.
    pub const OF_ZERO: Reflection = Reflection { is_even: true, is_odd: true };
}

impl Expression {
    /// Whether the expression is even or odd along a line, as far as its form shows: both sides are
    /// written out for a positive parameter, with signs taken out of odd functions and left out of
    /// even ones, and compared term by term. No value is looked at, so that what holds, holds
    /// everywhere; what is even only by algebra, such as `x*(x + 1) - x`, is not seen to be.
    ///
    /// ```
    /// use shtaerman_input::expression::{Expression, Line};
    ///
    /// let reflection = |text: &str| {
    ///     Expression::parse(text, &["xi"]).unwrap().reflection(&Line::identity())
    /// };
    /// assert!(reflection("xi^2 + cos(3*xi)").is_even);
    /// assert!(reflection("(xi - 1)^2 + (xi + 1)^2").is_even);
    /// assert!(reflection("where(xi < 0, -xi, xi)").is_even);
    /// assert!(reflection("xi*abs(xi)").is_odd);
    /// assert!(!reflection("xi^2 + 1e-9*exp(-((xi - 0.3)/1e-6)^2)").is_even);
    /// ```
    #[must_use]
    pub fn reflection(&self, line: &Line) -> Reflection {
        let mut terms = Terms::new();
        let here = self.term(line, &mut terms, false);
        let there = self.term(line, &mut terms, true);
        match (here, there) {
            (Some(here), Some(there)) if !terms.is_full() => {
                Reflection { is_even: there == here, is_odd: there == here.negated() }
            }
            _ => Reflection::default(),
        }
    }

    /// The expression at a positive parameter, or at its mirror image.
    fn term(&self, line: &Line, terms: &mut Terms, is_mirrored: bool) -> Option<Term> {
        let mut stack: Vec<Term> = Vec::new();
        for operation in &self.operations {
            let term = match *operation {
                Operation::Constant(value) | Operation::Rounded(value, _) => terms.constant(value),
                Operation::Variable(index) => variable(line, index, terms, is_mirrored)?,
                Operation::Unary(function) => {
                    let u = stack.pop()?;
                    terms.unary(function, u)
                }
                Operation::Binary(function) => {
                    let (v, u) = (stack.pop()?, stack.pop()?);
                    terms.binary(function, u, v)
                }
                Operation::Where => {
                    let (fails, holds, condition) = (stack.pop()?, stack.pop()?, stack.pop()?);
                    terms.choose(condition, holds, fails)
                }
            };
            if terms.is_full() {
                return None;
            }
            stack.push(term);
        }
        stack.pop()
    }
}

/// A variable that goes with the parameter, against it or not at all; no other is known.
fn variable(line: &Line, index: usize, terms: &mut Terms, is_mirrored: bool) -> Option<Term> {
    let (offset, slope) = (line.variable(index, 0.0), line.slope(index));
    if slope == 0.0 {
        return offset.is_finite().then(|| terms.constant(offset));
    }
    let term = terms.positive_variable(index);
    let is_negated = (slope < 0.0) != is_mirrored;
    (offset == 0.0 && slope.is_finite()).then(|| if is_negated { term.negated() } else { term })
}

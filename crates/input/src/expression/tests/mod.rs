//! Tests of the expression against hand values, closed forms and an evaluator of their own.

mod breakpoints;
mod definitions;
mod derivatives;
mod enclosures;
mod finiteness;
mod folds;
mod grammar;
mod hostile;
mod magnitudes;
mod reflections;
mod rises;
mod rounded;
#[allow(clippy::excessive_precision, reason = "references with all their digits")]
mod taylor;
mod trees;

use super::{Expression, ExpressionError, Interval, Line};

/// Variables used throughout.
const NAMES: [&str; 3] = ["x", "xi", "a"];

fn parsed(text: &str) -> Expression {
    Expression::parse(text, &NAMES).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn refused(text: &str) -> ExpressionError {
    Expression::parse(text, &NAMES).expect_err(text)
}

fn value(text: &str) -> f64 {
    parsed(text).evaluate(&[0.3, -0.5, 2.0])
}

/// `x = a xi` with `a = 2`.
fn tied() -> Line {
    Line::new(&[(0.0, 2.0), (0.0, 1.0), (2.0, 0.0)])
}

fn unit_range() -> Interval {
    Interval::new(-1.0, 1.0).unwrap()
}

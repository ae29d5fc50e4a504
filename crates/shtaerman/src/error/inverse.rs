//! Why an inverse problem has no answer.

use crate::quantity::{Dimension, engineering, engineering_with_digits};

/// Digits in which values are told, and in which none is lost.
const FEWEST_DIGITS: usize = 6;
const MOST_DIGITS: usize = 17;

/// Why an inverse problem has no answer; values are in the units of the problem, `dimension` is for messages.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InverseError {
    /// No value of the unknown gives what is wanted.
    #[error("{}", no_such_value(unknown, quantity, *wanted, [*least, *most], *dimension))]
    NoSuchValue {
        /// What was looked for.
        unknown: &'static str,
        /// What was to be reached.
        quantity: &'static str,
        /// The value wanted.
        wanted: f64,
        /// The least that can be had.
        least: f64,
        /// The most that can be had.
        most: f64,
        /// What the values measure.
        dimension: Dimension,
    },

    /// What is wanted lies in a jump.
    #[error("no {unknown} gives a {quantity} of {}: it jumps from {} to {} at {at:e}", engineering(*wanted, *dimension), engineering(*below, *dimension), engineering(*above, *dimension))]
    Jump {
        /// What was looked for.
        unknown: &'static str,
        /// What was to be reached.
        quantity: &'static str,
        /// The value wanted.
        wanted: f64,
        /// The value of the unknown at the jump.
        at: f64,
        /// The values on both sides of it, the smaller first.
        below: f64,
        /// The larger of them.
        above: f64,
        /// What the values measure.
        dimension: Dimension,
    },

    /// The value of the unknown lies beyond the last that can be solved.
    #[error("the {unknown} for a {quantity} of {} lies where the problem cannot be solved: the last that can be is {at:e}, with a {quantity} of {}, and beyond it {reason}", engineering(*wanted, *dimension), engineering(*value, *dimension))]
    NotSolved {
        /// What was looked for.
        unknown: &'static str,
        /// What was to be reached.
        quantity: &'static str,
        /// The value wanted.
        wanted: f64,
        /// The last value of the unknown that can be solved.
        at: f64,
        /// What that gives.
        value: f64,
        /// What the values measure.
        dimension: Dimension,
        /// Why the next one is refused.
        reason: String,
    },

    /// Every crown exceeds the limit.
    #[error("no crown keeps the peak pressure at {} or below: the lowest is {}, {}", engineering(*limit, *dimension), engineering(*least, *dimension), best_base(*radius, *dimension))]
    LimitTooLow {
        /// The limit.
        limit: f64,
        /// The lowest peak pressure that a crown gives.
        least: f64,
        /// The radius that gives it; `None` for the flat base.
        radius: Option<f64>,
        /// What the pressures measure.
        dimension: Dimension,
    },

    /// The crown looked for lies at, or beyond, the last that can be solved.
    #[error("the crown looked for lies where crowns cannot be solved: the last that can is that {}, with a peak pressure of {}, and beyond it {reason}", best_base(*radius, *dimension), engineering(*peak, *dimension))]
    Unsolved {
        /// The peak pressure of the last crown that can be solved.
        peak: f64,
        /// Its radius.
        radius: Option<f64>,
        /// What the pressure measures.
        dimension: Dimension,
        /// Why the next one is refused.
        reason: String,
    },

    /// The prescribed pressure does not fit the problem.
    #[error("the prescribed pressure {fault}")]
    Pressure {
        /// What is wrong with it.
        fault: String,
    },

    /// The problem does not prescribe what the inverse problem needs, or has no such unknown.
    #[error("{0}")]
    Unsuited(&'static str),
}

fn no_such_value(
    unknown: &str,
    quantity: &str,
    wanted: f64,
    [least, most]: [f64; 2],
    unit: Dimension,
) -> String {
    // As many digits as tell what is wanted from what there is.
    let with = |digits: usize| move |value: f64| engineering_with_digits(value, unit, digits);
    let tells = |digits: &usize| {
        let shown = with(*digits);
        [least, most].iter().all(|end| *end == wanted || shown(*end) != shown(wanted))
    };
    let shown = with((FEWEST_DIGITS..MOST_DIGITS).find(tells).unwrap_or(MOST_DIGITS));
    let is_one = least == most || most - least <= 1e-12 * most.abs();
    if is_one && (wanted - least).abs() <= 1e-12 * wanted.abs() {
        return format!(
            "a {quantity} of {} tells no {unknown}: it is that whatever the {unknown}",
            shown(wanted)
        );
    }
    let attainable = if is_one {
        format!("the {quantity} is {} whatever the {unknown}", shown(least))
    } else {
        format!("it can be from {} to {}", shown(least), shown(most))
    };
    format!("no {unknown} gives a {quantity} of {}: {attainable}", shown(wanted))
}

fn best_base(radius: Option<f64>, unit: Dimension) -> String {
    let length = if unit == Dimension::NONE { unit } else { Dimension::LENGTH };
    radius.map_or("with the flat base".to_owned(), |radius| {
        format!("with the crown radius {}", engineering(radius, length))
    })
}

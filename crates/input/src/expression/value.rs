//! What a program can compute with: numbers, numbers with a derivative, enclosures.

use super::function::{Binary, Unary};
use super::waves::{cosines, sines};

/// A kind of value with the operations of a program.
pub(super) trait Value: Copy {
    fn constant(value: f64) -> Self;
    /// A number computed from others, off by the error at most.
    fn rounded(value: f64, _error: f64) -> Self {
        Self::constant(value)
    }
    fn unary(function: Unary, u: Self) -> Self;
    fn binary(function: Binary, u: Self, v: Self) -> Self;
    /// `holds` where the condition is not zero, `fails` where it is.
    fn choose(condition: Self, holds: Self, fails: Self) -> Self;
}

impl Value for f64 {
    fn constant(value: f64) -> Self {
        value
    }

    fn unary(function: Unary, u: Self) -> Self {
        function.value(u)
    }

    fn binary(function: Binary, u: Self, v: Self) -> Self {
        function.value(u, v)
    }

    fn choose(condition: Self, holds: Self, fails: Self) -> Self {
        if condition.is_nan() {
            f64::NAN
        } else if condition != 0.0 {
            holds
        } else {
            fails
        }
    }
}

/// Numbers side by side, each by itself: reading the program costs as much as most of its operations.
impl<const COUNT: usize> Value for [f64; COUNT] {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        [value; COUNT]
    }

    #[inline(always)]
    fn unary(function: Unary, u: Self) -> Self {
        match function {
            Unary::Sin => sines(u),
            Unary::Cos => cosines(u),
            _ => one_by_one(function, u),
        }
    }

    #[inline(always)]
    fn binary(function: Binary, u: Self, v: Self) -> Self {
        match function {
            Binary::Add => std::array::from_fn(|k| u[k] + v[k]),
            Binary::Subtract => std::array::from_fn(|k| u[k] - v[k]),
            Binary::Multiply => std::array::from_fn(|k| u[k] * v[k]),
            Binary::Divide => std::array::from_fn(|k| u[k] / (v[k] + 0.0)),
            _ => pair_by_pair(function, u, v),
        }
    }

    fn choose(condition: Self, holds: Self, fails: Self) -> Self {
        std::array::from_fn(|k| f64::choose(condition[k], holds[k], fails[k]))
    }
}

fn one_by_one<const COUNT: usize>(function: Unary, u: [f64; COUNT]) -> [f64; COUNT] {
    u.map(|u| function.value(u))
}

fn pair_by_pair<const COUNT: usize>(
    function: Binary,
    u: [f64; COUNT],
    v: [f64; COUNT],
) -> [f64; COUNT] {
    std::array::from_fn(|k| function.value(u[k], v[k]))
}

//! What a program can compute with: numbers, numbers with a derivative, enclosures.

use super::function::{Binary, Unary};

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
    fn constant(value: f64) -> Self {
        [value; COUNT]
    }

    fn unary(function: Unary, u: Self) -> Self {
        u.map(|u| function.value(u))
    }

    fn binary(function: Binary, u: Self, v: Self) -> Self {
        std::array::from_fn(|k| function.value(u[k], v[k]))
    }

    fn choose(condition: Self, holds: Self, fails: Self) -> Self {
        std::array::from_fn(|k| f64::choose(condition[k], holds[k], fails[k]))
    }
}

//! Numbers computed from numbers when a formula is read, with what rounding may have made of them.

use super::enclose::Enclosure;
use super::function::{Binary, Unary};
use super::value::Value;

/// Largest factor of a power that is checked by multiplying it out.
const MOST_FACTORS: f64 = 64.0;
/// Whole numbers up to there are numbers of the machine.
const WHOLE: f64 = (1u64 << 53) as f64;
/// Products below have remainders that are none of the machine's.
const LEAST_PRODUCT: f64 = 1e-280;

/// A value with its error; none where it is not finite.
pub(super) fn unary(function: Unary, (u, error): (f64, f64)) -> Option<(f64, f64)> {
    let value = function.value(u);
    let is_exact = error == 0.0
        && match function {
            Unary::Negate | Unary::Abs | Unary::Sign | Unary::Floor | Unary::Ceil | Unary::Step => {
                true
            }
            Unary::Square => is_product(u, u, value),
            Unary::Sqrt => is_product(value, value, u),
            _ => false,
        };
    let enclosure = || Enclosure::unary(function, Enclosure::rounded(u, error));
    known(value, is_exact, enclosure)
}

/// A value with its error; none where it is not finite.
pub(super) fn binary(
    function: Binary,
    (u, first): (f64, f64),
    (v, second): (f64, f64),
) -> Option<(f64, f64)> {
    let value = function.value(u, v);
    let is_exact = first == 0.0
        && second == 0.0
        && match function {
            Binary::Add => remainder_of_sum(u, v) == 0.0,
            Binary::Subtract => remainder_of_sum(u, -v) == 0.0,
            Binary::Multiply => is_product(u, v, value),
            Binary::Divide => is_product(value, v, u),
            Binary::Power => is_power(u, v, value),
            _ => function.is_switch(),
        };
    let enclosure =
        || Enclosure::binary(function, Enclosure::rounded(u, first), Enclosure::rounded(v, second));
    known(value, is_exact, enclosure)
}

fn known(value: f64, is_exact: bool, enclosure: impl FnOnce() -> Enclosure) -> Option<(f64, f64)> {
    if !value.is_finite() || is_exact {
        return value.is_finite().then_some((value, 0.0));
    }
    let enclosure = enclosure();
    let range = enclosure.interval;
    let error = (range.upper() - value).max(value - range.lower()).next_up();
    (enclosure.is_finite() && error.is_finite()).then_some((value, error.max(0.0)))
}

/// What the rounded sum of two numbers lacks: a number of the machine itself (O. Moller, BIT 5 (1965) 37).
pub fn remainder_of_sum(u: f64, v: f64) -> f64 {
    let sum = u + v;
    let second = sum - u;
    (u - (sum - second)) + (v - second)
}

fn is_product(u: f64, v: f64, product: f64) -> bool {
    let is_zero = product == 0.0 && (u == 0.0 || v == 0.0);
    is_zero || product.abs() > LEAST_PRODUCT && u.mul_add(v, -product) == 0.0
}

fn is_power(base: f64, exponent: f64, value: f64) -> bool {
    let is_whole = base.fract() == 0.0
        && exponent.fract() == 0.0
        && (0.0..=MOST_FACTORS).contains(&exponent)
        && value.abs() <= WHOLE;
    is_whole && (0..exponent as u32).fold(1.0, |product, _| product * base) == value
}

//! Forward-mode derivatives.

use super::function::{Binary, Unary};
use super::value::Value;
use super::waves::{both, cosine, sine};

/// A value and its derivative to the right.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Dual {
    value: f64,
    slope: f64,
    /// Whether the value depends on the variable at all: if not, the slope is zero even where the
    /// derivative of an outer function is infinite.
    varies: bool,
}

impl Dual {
    pub(super) fn variable(value: f64, slope: f64) -> Self {
        Dual { value, slope, varies: slope != 0.0 }
    }

    /// Value and slope; an undefined value has an undefined slope.
    pub(super) fn parts(self) -> (f64, f64) {
        (self.value, if self.value.is_nan() { f64::NAN } else { self.slope })
    }

    /// With whether it depends on the variable.
    pub(super) fn new(value: f64, slope: f64, varies: bool) -> Self {
        Dual { value, slope, varies }
    }

    /// Value, slope, and whether it depends on the variable.
    pub(super) fn known(self) -> (f64, f64, bool) {
        (self.value, self.slope, self.varies)
    }

    fn derived(value: f64, slope: f64, varies: bool) -> Self {
        Dual { value, slope: if varies { slope } else { 0.0 }, varies }
    }
}

impl Value for Dual {
    fn constant(value: f64) -> Self {
        Dual { value, slope: 0.0, varies: false }
    }

    fn unary(function: Unary, u: Self) -> Self {
        // Both of one angle take little more than one.
        if let Unary::Sin | Unary::Cos = function {
            let [[sine], [cosine]] = both([u.value]);
            let (value, outer) =
                if function == Unary::Sin { (sine, cosine) } else { (cosine, -sine) };
            return Dual::derived(value, outer * u.slope, u.varies);
        }
        let value = function.value(u.value);
        let slope = match function {
            Unary::Negate => -u.slope,
            Unary::Abs if u.value == 0.0 => u.slope.abs(),
            Unary::Sign | Unary::Floor | Unary::Ceil | Unary::Step => 0.0,
            _ => outer_slope(function, u.value, value) * u.slope,
        };
        Dual::derived(value, slope, u.varies)
    }

    fn binary(function: Binary, u: Self, v: Self) -> Self {
        let value = function.value(u.value, v.value);
        let slope = match function {
            Binary::Add => u.slope + v.slope,
            Binary::Subtract => u.slope - v.slope,
            Binary::Multiply => partial(v.value, u) + partial(u.value, v),
            Binary::Divide => {
                let divisor = v.value + 0.0;
                partial(1.0 / divisor, u) - partial(value / divisor, v)
            }
            Binary::Power => power_slope(u, v, value),
            Binary::Minimum if u.value == v.value => u.slope.min(v.slope),
            Binary::Maximum if u.value == v.value => u.slope.max(v.slope),
            // The side that is taken, which may be a constant: under a root of it there is no slope.
            Binary::Minimum | Binary::Maximum if value == u.value => return u,
            Binary::Minimum | Binary::Maximum if value == v.value => return v,
            Binary::Minimum | Binary::Maximum => f64::NAN,
            Binary::Hypot if value == 0.0 => u.slope.hypot(v.slope),
            Binary::Hypot => partial(u.value / value, u) + partial(v.value / value, v),
            Binary::Atan2 => {
                let radius = u.value.hypot(v.value);
                partial(v.value / radius / radius, u) - partial(u.value / radius / radius, v)
            }
            Binary::Less | Binary::LessEqual | Binary::Greater | Binary::GreaterEqual => 0.0,
        };
        Dual::derived(value, slope, u.varies || v.varies)
    }

    fn choose(condition: Self, holds: Self, fails: Self) -> Self {
        if condition.value.is_nan() {
            Dual::derived(f64::NAN, f64::NAN, true)
        } else if condition.value != 0.0 {
            holds
        } else {
            fails
        }
    }
}

/// `factor * u'`, which is zero where `u` does not vary even if the factor is not finite.
fn partial(factor: f64, u: Dual) -> f64 {
    if u.varies { factor * u.slope } else { 0.0 }
}

/// Derivative of a function at `u`, where it has the given value.
pub(super) fn outer_slope(function: Unary, u: f64, value: f64) -> f64 {
    use std::f64::consts::{LN_2, LN_10};
    match function {
        Unary::Square => 2.0 * u,
        Unary::Sqrt => 0.5 / value,
        Unary::Cbrt => 1.0 / (3.0 * value * value),
        Unary::Exp => value,
        Unary::Expm1 => u.exp(),
        Unary::Ln => 1.0 / u,
        Unary::Log10 => 1.0 / (u * LN_10),
        Unary::Log2 => 1.0 / (u * LN_2),
        Unary::Log1p => 1.0 / (1.0 + u),
        Unary::Sin => cosine(u),
        Unary::Cos => -sine(u),
        Unary::Tan => 1.0 + value * value,
        Unary::Asin => 1.0 / ((1.0 - u) * (1.0 + u)).sqrt(),
        Unary::Acos => -1.0 / ((1.0 - u) * (1.0 + u)).sqrt(),
        Unary::Atan => 1.0 / (1.0 + u * u),
        Unary::Sinh => u.cosh(),
        Unary::Cosh => u.sinh(),
        Unary::Tanh => 1.0 / u.cosh() / u.cosh(),
        Unary::Asinh => 1.0 / u.hypot(1.0),
        Unary::Acosh => 1.0 / ((u - 1.0).sqrt() * (u + 1.0).sqrt()),
        Unary::Atanh => 1.0 / ((1.0 - u) * (1.0 + u)),
        Unary::Abs => u.signum(),
        Unary::Negate => -1.0,
        Unary::Sign | Unary::Floor | Unary::Ceil | Unary::Step => 0.0,
    }
}

fn power_slope(u: Dual, v: Dual, value: f64) -> f64 {
    let by_base = if v.value == 0.0 {
        0.0
    } else {
        partial(v.value * Binary::Power.value(u.value, v.value - 1.0), u)
    };
    let by_exponent =
        if u.value == 0.0 && v.value > 0.0 { 0.0 } else { partial(value * u.value.ln(), v) };
    by_base + by_exponent
}

//! How far a function leaves its tangent: what is left when value and slope at a centre are taken out, without cancellation.
//!
//! With `u(c + t) = u0 + u1 t + r` each operation gives its own `r` from those of its operands, in terms of second order only: of a product `u v` it is
//! `u0 rv + v0 ru + (u1 t + ru)(v1 t + rv)`, of `g(u)` it is `g'(u0) ru + [g(u0 + d) - g(u0) - g'(u0) d]` with `d = u1 t + ru`, and the bracket is written out for the
//! functions that have a short form of it. Others, and kinks, subtract.

use super::derivative::outer_slope;
use super::function::{Binary, Unary};
use super::value::Value;

/// Largest whole exponent that is multiplied out.
const MOST_FACTORS: f64 = 64.0;
/// Two ways to the same tangent differ by no more than this share of it.
const ROUNDING: f64 = 1e-13;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rise {
    /// `u0`.
    value: f64,
    /// `u1 t`.
    linear: f64,
    /// `r`.
    rest: f64,
}

impl Rise {
    pub(super) fn variable(value: f64, linear: f64) -> Self {
        Self { value, linear, rest: 0.0 }
    }

    /// `u(c + t) - u(c) - u' t` for the given `u' t`.
    pub(super) fn rest(self, linear: f64) -> f64 {
        let difference = self.linear - linear;
        let is_rounding = difference.abs() <= ROUNDING * linear.abs();
        if self.there().is_nan() {
            f64::NAN
        } else if is_rounding {
            self.rest
        } else {
            self.rest + difference
        }
    }

    /// `d`.
    fn change(self) -> f64 {
        self.linear + self.rest
    }

    /// `u(c + t)`.
    fn there(self) -> f64 {
        self.value + self.change()
    }

    fn is_constant(self) -> bool {
        self.linear == 0.0 && self.rest == 0.0
    }

    fn is_whole(self) -> bool {
        let size = self.value.abs();
        self.is_constant() && size.fract() == 0.0 && (1.0..=MOST_FACTORS).contains(&size)
    }

    fn times(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            linear: self.value * other.linear + other.value * self.linear,
            rest: self.value * other.rest
                + other.value * self.rest
                + self.change() * other.change(),
        }
    }

    fn over(self, other: Self) -> Self {
        let value = self.value / (other.value + 0.0);
        let linear = (self.linear - value * other.linear) / other.value;
        let rest = (self.rest - value * other.rest - linear * other.change()) / other.there();
        Self { value, linear, rest }
    }

    /// A whole power above zero.
    fn power(self, exponent: u32) -> Self {
        let mut product = Self::constant(1.0);
        for bit in (0..u32::BITS - exponent.leading_zeros()).rev() {
            product = product.times(product);
            if exponent >> bit & 1 == 1 {
                product = product.times(self);
            }
        }
        product
    }

    /// By subtraction.
    fn subtracted(value: f64, there: f64, linear: f64) -> Self {
        Self { value, linear, rest: there - value - linear }
    }
}

impl Value for Rise {
    fn constant(value: f64) -> Self {
        Self { value, linear: 0.0, rest: 0.0 }
    }

    fn unary(function: Unary, u: Self) -> Self {
        let value = function.value(u.value);
        if u.is_constant() {
            return Self::constant(value);
        }
        let there = function.value(u.there());
        let d = u.change();
        let same_side = (u.value > 0.0 && u.there() > 0.0) || (u.value < 0.0 && u.there() < 0.0);
        let beyond = match function {
            Unary::Negate => 0.0,
            Unary::Abs if same_side => 0.0,
            Unary::Square => d * d,
            Unary::Sqrt => -d * d / (2.0 * value * (value + there).powi(2)),
            Unary::Exp => value * exponential_rest(d),
            Unary::Expm1 => u.value.exp() * exponential_rest(d),
            Unary::Ln => logarithm_rest(d / u.value),
            Unary::Log1p => logarithm_rest(d / (1.0 + u.value)),
            Unary::Sin => u.value.cos() * sine_rest(d) + u.value.sin() * cosine_rest(d),
            Unary::Cos => u.value.cos() * cosine_rest(d) - u.value.sin() * sine_rest(d),
            _ => {
                let slope = outer_slope(function, u.value, value);
                return Self::subtracted(value, there, slope * u.linear);
            }
        };
        let slope = outer_slope(function, u.value, value);
        let result = Self { value, linear: slope * u.linear, rest: slope * u.rest + beyond };
        // At a root of its argument a square root has no tangent.
        if result.rest.is_finite() { result } else { Self::subtracted(value, there, result.linear) }
    }

    fn binary(function: Binary, u: Self, v: Self) -> Self {
        let value = function.value(u.value, v.value);
        let there = function.value(u.there(), v.there());
        match function {
            Binary::Add => Self { value, linear: u.linear + v.linear, rest: u.rest + v.rest },
            Binary::Subtract => Self { value, linear: u.linear - v.linear, rest: u.rest - v.rest },
            Binary::Multiply => u.times(v),
            Binary::Divide => u.over(v),
            Binary::Power if v.is_whole() => {
                let power = u.power(v.value.abs() as u32);
                if v.value > 0.0 { power } else { Self::constant(1.0).over(power) }
            }
            Binary::Power if u.value > 0.0 && u.there() > 0.0 => {
                Self::unary(Unary::Exp, v.times(Self::unary(Unary::Ln, u)))
            }
            Binary::Minimum | Binary::Maximum if value == u.value && there == u.there() => u,
            Binary::Minimum | Binary::Maximum if value == v.value && there == v.there() => v,
            Binary::Hypot if value > 0.0 => {
                Self::unary(Unary::Sqrt, Self::binary(Binary::Add, u.times(u), v.times(v)))
            }
            _ => Self::subtracted(value, there, 0.0),
        }
    }

    fn choose(condition: Self, holds: Self, fails: Self) -> Self {
        let branch = |condition: f64| if condition != 0.0 { holds } else { fails };
        let (here, there) = (branch(condition.value), branch(condition.there()));
        if condition.there().is_nan() {
            Self::constant(f64::NAN)
        } else if (condition.value != 0.0) == (condition.there() != 0.0) {
            here
        } else {
            Self::subtracted(here.value, there.there(), here.linear)
        }
    }
}

/// `sum_(k >= 2) a_k` for terms `a_k = a_(k-1) ratio(k)`.
fn series(second: f64, ratio: impl Fn(f64) -> f64) -> f64 {
    const TERMS: i32 = 24;
    let (mut term, mut sum) = (second, second);
    for k in 3..TERMS {
        term *= ratio(f64::from(k));
        sum += term;
    }
    sum
}

/// `e^d - 1 - d`.
fn exponential_rest(d: f64) -> f64 {
    if d.abs() < 0.5 { series(0.5 * d * d, |k| d / k) } else { d.exp_m1() - d }
}

/// `ln(1 + z) - z`.
fn logarithm_rest(z: f64) -> f64 {
    if z.abs() < 0.1 { series(-0.5 * z * z, |k| -z * (k - 1.0) / k) } else { z.ln_1p() - z }
}

/// `sin d - d`.
fn sine_rest(d: f64) -> f64 {
    if d.abs() < 0.5 {
        // The terms of odd order k' = 2 k - 1, from d^3/6.
        series(-d * d * d / 6.0, |k| -d * d / ((2.0 * k - 1.0) * (2.0 * k - 2.0)))
    } else {
        d.sin() - d
    }
}

/// `cos d - 1`.
fn cosine_rest(d: f64) -> f64 {
    -2.0 * (0.5 * d).sin().powi(2)
}

//! Enclosures of all values that an expression takes on an interval.

use super::function::{Binary, Unary};
use super::interval::Interval;
use super::periodic;
use super::value::Value;

/// Where the values of an expression lie while its variables range over intervals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Enclosure {
    /// Contains every value that is defined, including infinite ones.
    pub interval: Interval,
    /// Whether a value may be undefined (NaN): a domain may be left, or `0/0`, `0 * inf`,
    /// `inf - inf` and their like may occur. Never false when it should be true.
    pub may_be_undefined: bool,
}

impl Enclosure {
    /// Whether every value is proved to be defined and finite.
    pub fn is_finite(self) -> bool {
        !self.may_be_undefined && self.interval.is_bounded()
    }

    pub(super) const UNKNOWN: Enclosure =
        Enclosure { interval: Interval::WHOLE, may_be_undefined: true };

    pub(super) fn defined(interval: Interval) -> Self {
        Enclosure { interval, may_be_undefined: false }
    }

    fn new((interval, may_be_undefined): (Interval, bool)) -> Self {
        Enclosure { interval, may_be_undefined }
    }

    fn ends(lower: f64, upper: f64) -> Self {
        Self::defined(Interval::ends(lower, upper))
    }
}

impl Value for Enclosure {
    fn constant(value: f64) -> Self {
        Interval::point(value).map_or(Enclosure::UNKNOWN, Enclosure::defined)
    }

    fn rounded(value: f64, error: f64) -> Self {
        if error == 0.0 {
            return Self::constant(value);
        }
        let (lower, upper) = ((value - error).next_down(), (value + error).next_up());
        Interval::new(lower, upper).map_or(Enclosure::UNKNOWN, Enclosure::defined)
    }

    fn unary(function: Unary, u: Self) -> Self {
        let mut result = unary(function, u.interval);
        result.may_be_undefined |= u.may_be_undefined;
        result
    }

    fn binary(function: Binary, u: Self, v: Self) -> Self {
        let mut result = binary(function, u.interval, v.interval);
        result.may_be_undefined |= u.may_be_undefined || v.may_be_undefined;
        result
    }

    fn choose(condition: Self, holds: Self, fails: Self) -> Self {
        let mut result = if !condition.interval.contains(0.0) {
            holds
        } else if condition.interval.is_point() {
            fails
        } else {
            let may_be_undefined = holds.may_be_undefined || fails.may_be_undefined;
            Enclosure { interval: holds.interval.hull(fails.interval), may_be_undefined }
        };
        result.may_be_undefined |= condition.may_be_undefined;
        result
    }
}

/// More than the error of any mathematical library on the functions used here (a few units in
/// the last place).
const LIBRARY_ERROR: f64 = 8.0 * f64::EPSILON;

#[inline(always)]
pub(super) fn widen_down(value: f64) -> f64 {
    let widened = (value - value.abs() * LIBRARY_ERROR).next_down();
    if value == f64::INFINITY { f64::MAX * (1.0 - LIBRARY_ERROR) } else { widened }
}

#[inline(always)]
pub(super) fn widen_up(value: f64) -> f64 {
    -widen_down(-value)
}

/// A rising function that is zero only where it is exactly so.
fn rising(function: Unary, u: Interval) -> Interval {
    let (lower, upper) = (function.value(u.lower()), function.value(u.upper()));
    let lower = if lower == 0.0 { lower } else { widen_down(lower) };
    let upper = if upper == 0.0 { upper } else { widen_up(upper) };
    Interval::ends(lower, upper)
}

/// A rising function that is computed without rounding.
fn stairs(function: Unary, u: Interval) -> Enclosure {
    Enclosure::ends(function.value(u.lower()), function.value(u.upper()))
}

/// A rising function on the part of `u` between two limits.
fn rising_within(function: Unary, u: Interval, lower: f64, upper: f64) -> Enclosure {
    let Some(defined) = u.within(lower, upper) else {
        return Enclosure::UNKNOWN;
    };
    Enclosure { interval: rising(function, defined), may_be_undefined: defined != u }
}

/// The part of an enclosure between limits that the true values never cross.
fn limited(interval: Interval, lower: f64, upper: f64) -> Interval {
    interval.within(lower, upper).unwrap_or(interval)
}

fn unary(function: Unary, u: Interval) -> Enclosure {
    use std::f64::consts::FRAC_PI_2;
    const INFINITY: f64 = f64::INFINITY;
    match function {
        Unary::Negate => Enclosure::defined(u.negated()),
        Unary::Abs => Enclosure::defined(u.magnitude()),
        Unary::Square => Enclosure::defined(u.square()),
        Unary::Sqrt => Enclosure::new(u.square_root()),
        Unary::Sign | Unary::Floor | Unary::Ceil | Unary::Step => stairs(function, u),
        Unary::Cbrt | Unary::Sinh | Unary::Asinh => Enclosure::defined(rising(function, u)),
        Unary::Exp => {
            let lower = widen_down(u.lower().exp()).max(0.0);
            Enclosure::ends(lower, widen_up(u.upper().exp()))
        }
        Unary::Expm1 => Enclosure::defined(limited(rising(function, u), -1.0, INFINITY)),
        Unary::Tanh => Enclosure::defined(limited(rising(function, u), -1.0, 1.0)),
        Unary::Atan => {
            let bound = FRAC_PI_2.next_up();
            Enclosure::defined(limited(rising(function, u), -bound, bound))
        }
        Unary::Ln | Unary::Log10 | Unary::Log2 => rising_within(function, u, 0.0, INFINITY),
        Unary::Log1p => rising_within(function, u, -1.0, INFINITY),
        Unary::Acosh => rising_within(function, u, 1.0, INFINITY),
        Unary::Asin | Unary::Atanh => rising_within(function, u, -1.0, 1.0),
        Unary::Acos => arc_cosine(u),
        Unary::Cosh => {
            let size = u.magnitude();
            let lower = widen_down(size.lower().cosh()).max(1.0);
            Enclosure::ends(lower, widen_up(size.upper().cosh()))
        }
        Unary::Sin => Enclosure::new(periodic::sine(u)),
        Unary::Cos => Enclosure::new(periodic::cosine(u)),
        Unary::Tan => Enclosure::new(periodic::tangent(u)),
    }
}

/// The one falling function.
fn arc_cosine(u: Interval) -> Enclosure {
    let Some(defined) = u.within(-1.0, 1.0) else {
        return Enclosure::UNKNOWN;
    };
    let lower = widen_down(defined.upper().acos()).max(0.0);
    let interval = Interval::ends(lower, widen_up(defined.lower().acos()));
    Enclosure { interval, may_be_undefined: defined != u }
}

fn binary(function: Binary, u: Interval, v: Interval) -> Enclosure {
    match function {
        Binary::Add => Enclosure::new(u.plus(v)),
        Binary::Subtract => Enclosure::new(u.plus(v.negated())),
        Binary::Multiply => Enclosure::new(u.times(v)),
        Binary::Divide => Enclosure::new(u.over(v)),
        Binary::Power => power(u, v),
        Binary::Minimum => Enclosure::ends(u.lower().min(v.lower()), u.upper().min(v.upper())),
        Binary::Maximum => Enclosure::ends(u.lower().max(v.lower()), u.upper().max(v.upper())),
        Binary::Hypot => {
            let (a, b) = (u.magnitude(), v.magnitude());
            let lower = widen_down(a.lower().hypot(b.lower())).max(0.0);
            Enclosure::ends(lower, widen_up(a.upper().hypot(b.upper())))
        }
        Binary::Atan2 => angle(u, v),
        Binary::Less => decided(u.upper() < v.lower(), u.lower() >= v.upper()),
        Binary::LessEqual => decided(u.upper() <= v.lower(), u.lower() > v.upper()),
        Binary::Greater => decided(u.lower() > v.upper(), u.upper() <= v.lower()),
        Binary::GreaterEqual => decided(u.lower() >= v.upper(), u.upper() < v.lower()),
    }
}

fn decided(surely_holds: bool, surely_fails: bool) -> Enclosure {
    Enclosure::ends(f64::from(surely_holds), f64::from(!surely_fails))
}

/// The angle of the points `(v, u)`; it jumps across the negative half of the first axis.
fn angle(u: Interval, v: Interval) -> Enclosure {
    use std::f64::consts::PI;
    let bound = PI.next_up();
    if u.contains(0.0) && v.lower() <= 0.0 {
        return Enclosure::ends(-bound, bound);
    }
    let hull = hull_of_corners(u, v, f64::atan2);
    Enclosure::defined(limited(hull, -bound, bound))
}

fn hull_of_corners(u: Interval, v: Interval, value: impl Fn(f64, f64) -> f64) -> Interval {
    let (mut lower, mut upper) = (f64::INFINITY, f64::NEG_INFINITY);
    for a in [u.lower(), u.upper()] {
        for b in [v.lower(), v.upper()] {
            let corner = value(a, b);
            lower = lower.min(widen_down(corner));
            upper = upper.max(widen_up(corner));
        }
    }
    Interval::ends(lower, upper)
}

/// `u^v`: on bases that are not negative the power is monotone in either argument, so that its
/// extremes are at corners; on negative ones it is even or odd for integer exponents and
/// undefined for others.
fn power(u: Interval, v: Interval) -> Enclosure {
    let positive = u.within(0.0, f64::INFINITY).map(|base| power_of_positive(base, v));
    if u.lower() >= 0.0 {
        return positive.map_or(Enclosure::UNKNOWN, Enclosure::defined);
    }
    let base = Interval::ends((-u.upper()).max(0.0), -u.lower());
    let mirrored = power_of_positive(base, v);
    let is_integer = v.is_point() && v.is_bounded() && v.lower().floor() == v.lower();
    let negative = match (is_integer, v.lower() % 2.0 == 0.0) {
        (true, true) => mirrored,
        (true, false) => mirrored.negated(),
        (false, _) => mirrored.hull(mirrored.negated()),
    };
    let interval = positive.map_or(negative, |positive| positive.hull(negative));
    Enclosure { interval, may_be_undefined: !is_integer }
}

fn power_of_positive(base: Interval, exponent: Interval) -> Interval {
    let hull = hull_of_corners(base, exponent, |u, v| Binary::Power.value(u, v));
    limited(hull, 0.0, f64::INFINITY)
}

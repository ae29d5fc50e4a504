//! Taylor coefficients of functions of one argument.

use std::f64::consts::{LN_2, LN_10};

use super::super::enclose::{Enclosure, widen_down, widen_up};
use super::super::function::Unary;
use super::super::interval::Interval;
use super::super::value::Value;
use super::series::Series;

/// The series of a function of `u` whose values are enclosed by `first`; of what switches only the values.
pub(super) fn function(function: Unary, u: &Series, first: Interval, order: usize) -> Series {
    match function {
        Unary::Negate => u.negated(),
        Unary::Square => u.square(order).with_first(first),
        Unary::Sqrt => u.root(1.0, 2.0, first, order),
        Unary::Cbrt => u.root(1.0, 3.0, first, order),
        Unary::Exp => exponential(u, order).with_first(first),
        Unary::Expm1 => exponential(u, order).with_first(first),
        Unary::Ln => u.integral_over(u, first, order),
        Unary::Log10 => scaled_logarithm(u, LN_10, first, order),
        Unary::Log2 => scaled_logarithm(u, LN_2, first, order),
        Unary::Log1p => u.integral_over(&one_plus(u), first, order),
        Unary::Sin | Unary::Cos | Unary::Sinh | Unary::Cosh => wave(function, u, first, order),
        Unary::Tan => {
            let derivative = Interval::ONE.plus(first.square()).0;
            tangent(u, [first, derivative], 1.0, order)
        }
        Unary::Tanh => tangent(u, [first, square_of_secant(u.get(0))], -1.0, order),
        Unary::Asin => u.integral_over(&root_of(&one_minus_square(u, order), order), first, order),
        Unary::Acos => {
            let root = root_of(&one_minus_square(u, order), order);
            u.negated().integral_over(&root, first, order)
        }
        Unary::Atan => u.integral_over(&one_plus(&u.square(order)), first, order),
        Unary::Asinh => u.integral_over(&root_of(&one_plus(&u.square(order)), order), first, order),
        Unary::Acosh => {
            let root = root_of(&one_minus_square(u, order).negated(), order);
            u.integral_over(&root, first, order)
        }
        Unary::Atanh => u.integral_over(&one_minus_square(u, order), first, order),
        Unary::Abs | Unary::Sign | Unary::Floor | Unary::Ceil | Unary::Step => {
            Series::cut(vec![first])
        }
    }
}

/// The values of a function of the argument.
fn value(function: Unary, u: &Series) -> Interval {
    Enclosure::unary(function, Enclosure::defined(u.get(0))).interval
}

fn one() -> Series {
    Series::constant(Interval::ONE)
}

fn one_plus(u: &Series) -> Series {
    one().plus(u)
}

fn one_minus_square(u: &Series, order: usize) -> Series {
    one().minus(&u.square(order))
}

fn root_of(u: &Series, order: usize) -> Series {
    let (values, _) = u.get(0).square_root();
    u.root(1.0, 2.0, values, order)
}

/// `ln u / ln b`.
fn scaled_logarithm(u: &Series, logarithm: f64, first: Interval, order: usize) -> Series {
    let base = Interval::ends(logarithm.next_down(), logarithm.next_up());
    let natural = u.integral_over(u, value(Unary::Ln, u), order);
    natural.over(&Series::constant(base), first, order)
}

/// `e^u`: the coefficients of `e^(u - u_0)` in a length in which those of `u` are at most 1, so that only the product with `e^(u_0)` under- or
/// overflows: far from its middle a narrow Gaussian has large factors before a vanishing one.
fn exponential(u: &Series, order: usize) -> Series {
    let growth = |(j, term): (usize, &Interval)| (term.size().log2() / j as f64).ceil();
    let steepest = u.terms().iter().enumerate().skip(1).map(growth).fold(0.0, f64::max);
    let shift = steepest.min(1100.0) as i32;
    let terms = u.terms().iter().enumerate();
    let shifted: Vec<_> = terms.map(|(j, term)| term.shifted(-shift * j as i32)).collect();
    let reduced =
        if u.is_polynomial() { Series::polynomial(shifted) } else { Series::cut(shifted) };
    let factors = Series::build(Interval::ONE, u.known(order), |g, k| reduced.chain(1.0, g, k));
    let count = factors.stored();
    let terms =
        (0..count).map(|k| factors.get(k).times(shifted_exponential(u.get(0), shift * k as i32)).0);
    Series::cut(terms.collect())
}

/// `2^shift e^u`.
fn shifted_exponential(u: Interval, shift: i32) -> Interval {
    let exponential = |u: Interval| Enclosure::unary(Unary::Exp, Enclosure::defined(u)).interval;
    let (least, most) = (-690.0, 700.0);
    if shift == 0 || (u.lower() > least && u.upper() < most) {
        return exponential(u).shifted(shift);
    }
    let step = Interval::ends(LN_2.next_down(), LN_2.next_up());
    let (added, _) = Interval::ends(f64::from(shift), f64::from(shift)).times(step);
    exponential(u.plus(added).0)
}

/// A sine or cosine, or one of their hyperbolic companions.
fn wave(function: Unary, u: &Series, first: Interval, order: usize) -> Series {
    let (companion, signs) = match function {
        Unary::Sin => (Unary::Cos, [1.0, 1.0, -1.0, -1.0]),
        Unary::Cos => (Unary::Sin, [1.0, -1.0, -1.0, 1.0]),
        Unary::Sinh => (Unary::Cosh, [1.0; 4]),
        _ => (Unary::Sinh, [1.0; 4]),
    };
    let companion = value(companion, u);
    let slope = u.get(1);
    if u.is_polynomial() && u.stored() == 2 && !slope.contains(0.0) {
        return wave_of_linear(slope, [first, companion], signs, order);
    }
    let sign = if matches!(function, Unary::Sin | Unary::Cos) { -1.0 } else { 1.0 };
    match function {
        Unary::Sin | Unary::Sinh => waves(u, [first, companion], sign, order).0,
        _ => waves(u, [companion, first], sign, order).1,
    }
}

/// A wave of `u_0 + u_1 t`: its derivatives are itself and its companion by turns, with such signs, times `u_1^k/k!`.
fn wave_of_linear(slope: Interval, values: [Interval; 2], signs: [f64; 4], order: usize) -> Series {
    // More than a product and a quotient, and this factor, are rounded by; and what is lost where they underflow.
    const ROUNDED: f64 = 4.0 * f64::EPSILON;
    const UNDERFLOW: f64 = f64::MIN_POSITIVE;
    let steepness = slope.magnitude();
    let (mut least, mut most) = (1.0f64, 1.0f64);
    let mut terms = Vec::with_capacity(order + 1);
    terms.push(values[0]);
    for k in 1..=order {
        least = (least * steepness.lower() / k as f64 * (1.0 - ROUNDED) - UNDERFLOW).max(0.0);
        most = most * steepness.upper() / k as f64 * (1.0 + ROUNDED) + UNDERFLOW;
        let is_falling = slope.upper() < 0.0 && k % 2 == 1;
        let is_opposite = is_falling != (signs[k % 4] < 0.0);
        let value = if is_opposite { values[k % 2].negated() } else { values[k % 2] };
        let lower = value.lower() * if value.lower() < 0.0 { most } else { least };
        let upper = value.upper() * if value.upper() < 0.0 { least } else { most };
        let term = Interval::ends(lower.next_down(), upper.next_up());
        if !term.is_bounded() {
            break;
        }
        terms.push(term);
    }
    Series::cut(terms)
}

/// Sine and cosine (`sign` -1) or their hyperbolic companions (1): `s' = u' c`, `c' = sign u' s`.
fn waves(u: &Series, first: [Interval; 2], sign: f64, order: usize) -> (Series, Series) {
    let [mut sine, mut cosine] = first.map(|first| vec![first]);
    for k in 1..u.known(order) {
        let (next_sine, next_cosine) = (u.chain(1.0, &cosine, k), u.chain(sign, &sine, k));
        if !next_sine.is_bounded() || !next_cosine.is_bounded() {
            break;
        }
        sine.push(next_sine);
        cosine.push(next_cosine);
    }
    (Series::cut(sine), Series::cut(cosine))
}

/// `g' = u' w` with `w = 1 + sign g^2`; of either the values are given.
fn tangent(u: &Series, first: [Interval; 2], sign: f64, order: usize) -> Series {
    let [mut g, mut w] = first.map(|first| vec![first]);
    for k in 1..u.known(order) {
        let next = u.chain(1.0, &w, k);
        if !next.is_bounded() {
            break;
        }
        g.push(next);
        let squared = Series::cut(g.clone()).square_term(k);
        w.push(if sign < 0.0 { squared.negated() } else { squared });
    }
    Series::cut(g)
}

/// Beyond this `cosh^2` is as good as out of the range of numbers.
const FAR: f64 = 300.0;

/// `1/cosh^2 u`, which is at most `4 e^(-2|u|)`.
fn square_of_secant(u: Interval) -> Interval {
    let size = u.magnitude();
    let squared = |u: f64| 1.0 / u.cosh().powi(2);
    let lower = if size.upper() > FAR { 0.0 } else { widen_down(squared(size.upper())).max(0.0) };
    let upper =
        if size.lower() > FAR { 4.0 * (-2.0 * size.lower()).exp() } else { squared(size.lower()) };
    Interval::ends(lower, widen_up(upper).min(1.0))
}

//! Enclosures of the sine, the cosine and the tangent.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::enclose::{widen_down, widen_up};
use super::interval::Interval;

/// Beyond this the period is not resolved well enough to look for extremes.
const LARGEST: f64 = 1e12;

/// Enclosure of the sine, and whether it may be undefined (at infinity).
pub(super) fn sine(u: Interval) -> (Interval, bool) {
    wave(u, f64::sin, FRAC_PI_2)
}

/// Enclosure of the cosine, and whether it may be undefined (at infinity).
pub(super) fn cosine(u: Interval) -> (Interval, bool) {
    wave(u, f64::cos, 0.0)
}

/// Enclosure of the tangent, and whether it may be undefined (at infinity). Its poles lie between
/// floating-point numbers; an interval that may hold one gives the whole line.
pub(super) fn tangent(u: Interval) -> (Interval, bool) {
    if !u.is_bounded() {
        return (Interval::WHOLE, true);
    }
    if may_contain(u, FRAC_PI_2, PI) {
        return (Interval::WHOLE, false);
    }
    (Interval::ends(widen_down(u.lower().tan()), widen_up(u.upper().tan())), false)
}

/// A wave between -1 and 1 with its maxima at `crest + 2 pi k`.
fn wave(u: Interval, function: fn(f64) -> f64, crest: f64) -> (Interval, bool) {
    if !u.is_bounded() {
        return (Interval::ends(-1.0, 1.0), true);
    }
    let (left, right) = (function(u.lower()), function(u.upper()));
    let has_crest = may_contain(u, crest, TAU);
    let has_trough = may_contain(u, crest - PI, TAU);
    let upper = if has_crest { 1.0 } else { widen_up(left.max(right)).min(1.0) };
    let lower = if has_trough { -1.0 } else { widen_down(left.min(right)).max(-1.0) };
    (Interval::ends(lower, upper), false)
}

/// Whether the interval may contain one of the places `first + k period`.
fn may_contain(u: Interval, first: f64, period: f64) -> bool {
    if u.lower() < -LARGEST || u.upper() > LARGEST || u.upper() - u.lower() >= period {
        return true;
    }
    // More than the errors of the difference, the quotient and the rounded period together.
    let turns = |value: f64| (value - first) / period;
    let slack = |turn: f64| 2.0 * f64::EPSILON * (turn.abs() + 1.0);
    let (left, right) = (turns(u.lower()), turns(u.upper()));
    (right + slack(right)).floor() >= (left - slack(left)).ceil()
}

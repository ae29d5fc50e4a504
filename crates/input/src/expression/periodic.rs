//! Enclosures of the sine, the cosine and the tangent.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::enclose::{widen_down, widen_up};
use super::interval::Interval;
use super::waves;

/// Beyond this the period is not resolved well enough to look for extremes.
const LARGEST: f64 = 1e12;

/// Where a wave between -1 and 1 has its maxima, but for whole periods.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crest {
    at: f64,
    function: fn(f64) -> f64,
}

impl Crest {
    pub(super) const OF_SINE: Self = Self { at: FRAC_PI_2, function: waves::sine };
    pub(super) const OF_COSINE: Self = Self { at: 0.0, function: waves::cosine };

    /// Enclosure of the wave, and whether it may be undefined (at infinity).
    pub(super) fn wave(self, u: Interval) -> (Interval, bool) {
        if !u.is_bounded() {
            return (Interval::ends(-1.0, 1.0), true);
        }
        let values = [u.lower(), u.upper()].map(self.function);
        let [lower, upper] = wave_between([u.lower(), u.upper()], values, self);
        (Interval::ends(lower, upper), false)
    }
}

/// Enclosure of the sine, and whether it may be undefined (at infinity).
pub(super) fn sine(u: Interval) -> (Interval, bool) {
    Crest::OF_SINE.wave(u)
}

/// Enclosure of the cosine, and whether it may be undefined (at infinity).
pub(super) fn cosine(u: Interval) -> (Interval, bool) {
    Crest::OF_COSINE.wave(u)
}

/// Enclosure of the tangent, and whether it may be undefined (at infinity). Its poles lie between
/// floating-point numbers; an interval that may hold one gives the whole line.
pub(super) fn tangent(u: Interval) -> (Interval, bool) {
    if !u.is_bounded() {
        return (Interval::WHOLE, true);
    }
    if may_contain([u.lower(), u.upper()], FRAC_PI_2, PI) {
        return (Interval::WHOLE, false);
    }
    (Interval::ends(widen_down(u.lower().tan()), widen_up(u.upper().tan())), false)
}

/// The ends of an enclosure of a wave between two finite places, at which it has these values.
#[inline(always)]
pub(super) fn wave_between(u: [f64; 2], [left, right]: [f64; 2], crest: Crest) -> [f64; 2] {
    let (has_crest, has_trough) =
        (may_contain(u, crest.at, TAU), may_contain(u, crest.at - PI, TAU));
    let upper = if has_crest { 1.0 } else { widen_up(left.max(right)).min(1.0) };
    let lower = if has_trough { -1.0 } else { widen_down(left.min(right)).max(-1.0) };
    [lower, upper]
}

/// Whether an interval may contain one of the places `first + k period`.
#[inline(always)]
fn may_contain([lower, upper]: [f64; 2], first: f64, period: f64) -> bool {
    let is_unresolved = (lower < -LARGEST) | (upper > LARGEST) | (upper - lower >= period);
    // More than the errors of the difference, the quotient and the rounded period together.
    let turns = |value: f64| (value - first) / period;
    let slack = |turn: f64| 2.0 * f64::EPSILON * (turn.abs() + 1.0);
    let (left, right) = (turns(lower), turns(upper));
    is_unresolved | ((right + slack(right)).floor() >= (left - slack(left)).ceil())
}

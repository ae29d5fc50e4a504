//! Beside a bend of the base, where `G` is `G(b) + c s^k + e s^2 + g s^4` and no polynomial follows it.

use super::super::powers::Powers;
use super::super::roots::CONSTANT;
use super::super::rule::integral;
use super::steps::{STEP, stepwise};

/// Nodes crowd towards the bend as this power, so that what goes with any power of the distance is a smooth function of theirs.
const CROWDED: i32 = 8;
/// From the next even power on a power is as good as hidden behind those (theory).
const SMOOTH: f64 = 4.0;
/// Safety on what the change of the power tells: the difference of two is no bound.
const SAFETY: f64 = 4.0;
/// How often the distance is doubled to see the power.
pub(super) const FARTHER: u32 = 4;
/// Rounding of `G` where it is integrated in parts, in roundings of its size.
const ROUNDED: f64 = 16.0;

/// The part of a segment next to its bend.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start {
    /// Up to this `s`.
    pub(super) to: f64,
    /// `k`.
    power: f64,
    /// `c s^k`, `e s^2` and `g s^4` at the end.
    rise: f64,
    square: f64,
    quartic: f64,
    /// What the rise may be off by.
    pub(super) error: f64,
}

/// What `G` shows beside a bend.
#[derive(Debug, Clone, Copy)]
pub(super) enum Seen {
    /// A power.
    Power(Start),
    /// None yet: nearer there may be one.
    Other,
    /// Nothing but rounding, and no more nearer.
    Noise,
}

impl Start {
    /// From `G(b)` and what `G` is sixteen, eight, four and two times as far, and at `to`; in this order. The noise is that of `G` beyond rounding.
    pub(super) fn seen(to: f64, level: f64, known: &[f64], noise: f64) -> Seen {
        let &[sixteen, eight, four, two, one] = known else { return Seen::Other };
        let places = [one, two, four, eight, sixteen];
        let rises = places.map(|value| value - level);
        let noise = ROUNDED * f64::EPSILON * level.abs().max(places[4].abs()) + noise;
        // Without what goes with the square and its square only the power is left.
        let bent = [0, 1, 2, 3].map(|j| rises[j + 1] - 4.0 * rises[j]);
        let left = [0, 1, 2].map(|j| bent[j + 1] - 16.0 * bent[j]);
        let (near, far) = ((left[1] / left[0]).log2(), (left[2] / left[1]).log2());
        if left[0].abs() <= ROUNDED * noise {
            return Seen::Noise;
        }
        if !(0.0 < near && near < SMOOTH) {
            return Seen::Other;
        }
        let [beyond_square, beyond_quartic] = [4.0, 16.0].map(|even| near.exp2() - even);
        let rise = left[0] / (beyond_square * beyond_quartic);
        let quartic = (bent[0] - beyond_square * rise) / 12.0;
        let square = rises[0] - rise - quartic;
        // The power is off by what the next one says, and the rise by the rounding of what it is made of.
        let rounding = 85.0 * noise / (beyond_square * beyond_quartic).abs();
        let error = SAFETY * rise.abs() * (near - far).abs() + rounding;
        if error.is_finite() {
            Seen::Power(Self { to, power: near, rise, square, quartic, error })
        } else {
            Seen::Other
        }
    }

    /// The same, known no better than a half of one that is known to so much: the next power falls by two more.
    pub(super) fn half_of(self, error: f64) -> Self {
        Self { error: self.error.max(error * (-self.power - 2.0).exp2()), ..self }
    }

    /// `dG/ds`.
    fn slope(&self, s: f64) -> f64 {
        let t = s / self.to;
        let even = (2.0 * self.square + 4.0 * self.quartic * t * t) * t;
        (self.rise * self.power * t.powf(self.power - 1.0) + even) / self.to
    }

    /// `int dG (s^2 + scale^2)^-beta`.
    pub(super) fn outside(&self, powers: &Powers, scale: f64) -> f64 {
        let f = |y: f64| self.slope(scale * y.sinh()) * powers.power(scale * y.cosh());
        let end = (self.to / scale).asinh();
        let first = end.min(STEP);
        let crowded = |w: f64| {
            let y = first * w.powi(CROWDED);
            f(y) * f64::from(CROWDED) * first * w.powi(CROWDED - 1)
        };
        integral(0.0, 1.0, crowded) + stepwise([first, end], STEP, f)
    }

    /// `int dG (s^2 - scale^2)^-beta` over what lies beyond `scale`.
    pub(super) fn inside(&self, powers: &Powers, scale: f64) -> f64 {
        let end = ((self.to - scale) * (self.to + scale)).max(0.0).sqrt() / scale;
        let f = |y: f64| self.slope(scale * y.cosh()) * powers.power(scale * y.sinh());
        powers.graded(0, [0.0, end.asinh()], [STEP, f64::INFINITY], f)
    }

    /// Whether the pressure is finite at the bend.
    pub(super) fn is_finite(&self, powers: &Powers) -> bool {
        self.power + powers.exponent() > 1.0 + 2.0 * CONSTANT
    }

    /// `int dG s^(mu-1)`, or 0 where that is no number.
    pub(super) fn at_bend(&self, powers: &Powers) -> f64 {
        let mu = powers.exponent();
        let excess = self.power + mu - 1.0;
        if !self.is_finite(powers) {
            return 0.0;
        }
        let even = 2.0 * self.square / (1.0 + mu) + 4.0 * self.quartic / (3.0 + mu);
        (self.rise * self.power / excess + even) * self.to.powf(mu - 1.0)
    }

    /// What that may be off by, which is more than anywhere else.
    pub(super) fn error(&self, powers: &Powers) -> f64 {
        let mu = powers.exponent();
        let excess = self.power + mu - 1.0;
        if !self.is_finite(powers) {
            return self.error * self.power * self.to.powf(mu - 1.0);
        }
        self.error * self.power / (excess * excess.min(1.0)) * self.to.powf(mu - 1.0)
    }
}

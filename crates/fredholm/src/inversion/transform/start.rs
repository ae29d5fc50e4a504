//! Beside a bend of the base, where `G` is `G(b) + c s^k + e s^2` and no polynomial follows it.

use super::super::powers::Powers;
use super::super::roots::CONSTANT;
use super::super::rule::integral;
use super::super::shape::Shape;
use super::{STEP, stepwise};

/// Nodes crowd towards the bend as this power, so that what goes with any power of the distance is a smooth function of theirs.
const CROWDED: i32 = 8;
/// Powers from here on are resolved by panels: their first one is off by what the second difference of so short a panel is (theory).
const SMOOTH: f64 = 2.5;
/// Rounding of `G` where it is integrated in parts, in roundings of its size.
const ROUNDED: f64 = 16.0;

/// The part of a segment next to its bend.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start {
    /// Up to this `s`.
    pub(super) to: f64,
    /// `k`.
    power: f64,
    /// `c s^k` and `e s^2` at the end.
    rise: f64,
    square: f64,
    /// What the rise may be off by.
    error: f64,
}

impl Start {
    /// From what `G` rises to once, twice, four and eight times as far; none where that shows no power.
    pub(super) fn new(shape: &Shape<'_>, kink: f64, to: f64) -> Option<Self> {
        let [level, places @ ..] =
            [0.0, 1.0, 2.0, 4.0, 8.0].map(|t| shape.transform_beyond(kink, t * to));
        let rises = places.map(|value| value - level);
        let noise = ROUNDED * f64::EPSILON * level.abs().max(places[3].abs()) + shape.noise;
        // Without what goes with the square only the power is left.
        let bent = [0, 1, 2].map(|j| rises[j + 1] - 4.0 * rises[j]);
        let (near, far) = ((bent[1] / bent[0]).log2(), (bent[2] / bent[1]).log2());
        if !(bent[0].abs() > ROUNDED * noise && 0.0 < near && near < SMOOTH) {
            return None;
        }
        let rise = bent[0] / (near.exp2() - 4.0);
        let square = rises[0] - rise;
        // The power is off by what the next one says, and the rise by the rounding of what it is made of.
        let error = rise.abs() * (near - far).abs() + 5.0 * noise / (near.exp2() - 4.0).abs();
        error.is_finite().then_some(Self { to, power: near, rise, square, error })
    }

    /// `dG/ds`.
    fn slope(&self, s: f64) -> f64 {
        let t = s / self.to;
        (self.rise * self.power * t.powf(self.power - 1.0) + 2.0 * self.square * t) / self.to
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
        let sum = self.rise * self.power / excess + 2.0 * self.square / (1.0 + mu);
        sum * self.to.powf(mu - 1.0)
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

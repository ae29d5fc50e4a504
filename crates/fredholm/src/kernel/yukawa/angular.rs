//! The angular integral and the factor of its logarithm, by trapezoidal rules in the elliptic variable.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::elliptic::{Circle, Points};

/// `-ln` of the relative error aimed at.
const DIGITS: f64 = 37.0;
/// The cosine of the harmonic cancels by `exp(m v)`, `v = ln(larger/smaller)`, at most to this.
const CANCELLED: f64 = 2.0;
/// Terms below `exp(-FADED)` of the first are left out.
const FADED: f64 = 40.0;
/// Decay lengths, and values of `v` and `m v`, where the factor of the logarithm is cut off: as late as its growth allows, so that the cutoff is smooth on the scale of the nodes.
const LENGTHS: f64 = 13.0;
const FOLD: f64 = 8.0;
const FOLD_OF_HARMONIC: f64 = 10.0;
/// Where the cutoff differs from 1 by less than 1e-16, and where it is below 1e-17.
const NOT_CUT: f64 = 0.02;
const CUT: f64 = 2.0;
/// Recurrences longer than this take longer than the functions.
const LONG: u32 = 12;
/// Lines `Im eta = beta` in the plane of the factor, with `cosh beta - 1`.
const LINES: [(f64, f64); 5] =
    [(0.5, 0.1277), (1.0, 0.5431), (1.5, 1.3525), (2.0, 2.7622), (3.0, 9.0677)];

/// The harmonic and how fine a rule it needs.
///
/// In the variable `w` of [`Circle`] the integrand `exp(-chi R) cos(m u)` is even about both ends and analytic for `|Im w| < K'`, where `Re R > 0`.
/// The error of the trapezoidal rule is `exp(-2 pi eta/h)` times the growth of the integrand up to `Im w = eta`: none for `m = 0`; else the cosine grows as
/// `exp(2 m gd^-1(eta))` at `u = pi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Harmonic {
    order: u32,
    /// `eta`, as a share of `K' >= pi/2`.
    share: f64,
    /// `DIGITS` and the growth.
    exponent: f64,
    /// Largest `d/(x + s)` that is taken.
    largest_modulus: f64,
}

impl Harmonic {
    pub(super) fn new(order: u32) -> Self {
        let (mut share, mut exponent) = (1.0, DIGITS);
        let m = f64::from(order);
        if order > 0 {
            let mut finest = f64::INFINITY;
            for trial in (1..64).map(|i| f64::from(i) / 64.0) {
                let needed = DIGITS + CANCELLED + 2.0 * m * (trial * FRAC_PI_2).tan().asinh();
                if needed / trial < finest {
                    (finest, share, exponent) = (needed / trial, trial, needed);
                }
            }
        }
        Self { order, share, exponent, largest_modulus: (0.5 * CANCELLED / m).tanh() }
    }

    pub(super) fn order(&self) -> u32 {
        self.order
    }

    /// Step of a trapezoidal rule along the axis of a strip of half-width `pi/2` with the same growth.
    pub(super) fn step(&self) -> f64 {
        PI * PI * self.share / self.exponent
    }

    /// Whether the points are so close that the cosine does not cancel.
    pub(super) fn serves(&self, points: Points) -> bool {
        points.distance <= self.largest_modulus * points.sum()
    }

    /// Intervals between `u = 0` and `u = pi`; `decay` is `chi d`. Away from the real axis `R` is smaller than `d`, so the decay makes more necessary; but a
    /// narrow peak is a Gaussian, for which fewer do.
    fn intervals(&self, circle: &Circle, decay: f64) -> f64 {
        let strip = (self.exponent + decay) / (self.share * circle.across);
        let gaussian = (2.0 * self.exponent * decay).sqrt();
        let per_length = if decay > self.exponent { strip.min(gaussian) } else { strip };
        (circle.along * per_length / TAU).ceil().max(2.0)
    }

    /// `2 int_0^pi exp(-chi R) cos(m u)/R du`.
    pub(super) fn integral(&self, screening: f64, points: Points, circle: &Circle) -> f64 {
        let decay = screening * points.distance;
        let intervals = self.intervals(circle, decay);
        let limit = decay + FADED;
        let half_sine = points.half_sine();
        let squared = half_sine * half_sine;
        let count = intervals as u32;
        let mut sum = 0.5 * (-decay).exp();
        for (j, stretch) in (1..).zip(circle.along(count)) {
            let exponent = decay * stretch;
            if exponent > limit {
                break;
            }
            let mut term = (-exponent).exp();
            if self.order > 0 {
                term *= cosine(self.order, squared * (stretch - 1.0) * (stretch + 1.0));
            }
            sum += if j == count { 0.5 * term } else { term };
        }
        4.0 * circle.along / (intervals * points.sum()) * sum
    }

    /// `erfc(6 (y - 1))/2` with `y` the distance in decay lengths and in the logarithm `v` of the ratio.
    pub(super) fn cutoff(&self, screening: f64, points: Points) -> f64 {
        let m = f64::from(self.order);
        let logarithm = -points.ratio.ln();
        let y = screening * points.distance / LENGTHS
            + logarithm * (1.0 / FOLD).max(m / FOLD_OF_HARMONIC);
        if y < NOT_CUT {
            1.0
        } else if y < CUT {
            0.5 * libm::erfc(6.0 * (y - 1.0))
        } else {
            0.0
        }
    }

    /// The factor `A` of `ln d`: `-(8/pi)/(x + s) int_0^K' cosh(chi R) cosh(m v) d eta` along `w = i eta`, where `u = i v` and `R` goes from `d` to 0.
    ///
    /// The branch point of the kernel is there; once around it the kernel changes by the integral of both signs of `R` along that line.
    pub(super) fn factor(&self, screening: f64, points: Points, circle: &Circle) -> f64 {
        let decay = screening * points.distance;
        let half_sine = points.half_sine();
        let squared = half_sine * half_sine;
        // Constants are integrated exactly.
        let spared = if self.order == 0 { (2.0 * decay.ln()).clamp(-DIGITS, 0.0) } else { 0.0 };
        // Off the axis both hyperbolic cosines grow by the factor cosh(beta) in their arguments.
        let argument = decay + 2.0 * f64::from(self.order) * half_sine.asinh();
        let per_length = LINES
            .iter()
            .filter(|(beta, _)| *beta < circle.along)
            .map(|(beta, growth)| (DIGITS + spared + argument * growth) / beta)
            .fold(f64::INFINITY, f64::min);
        let intervals = (circle.across * per_length / TAU).ceil().max(2.0);
        let term = |stretch: f64| {
            let growth = (decay * stretch).exp();
            0.5 * (growth + 1.0 / growth)
                * hyperbolic(self.order, squared * (1.0 - stretch) * (1.0 + stretch))
        };
        let count = intervals as u32;
        let mut sum = 0.5 * term(1.0);
        for (j, stretch) in (1..).zip(circle.across(count)) {
            let term = term(stretch);
            sum += if j == count { 0.5 * term } else { term };
        }
        -8.0 / PI * circle.across / (intervals * points.sum()) * sum
    }
}

/// `cos(m u)` from `sin^2(u/2)`, by differences (C. Reinsch) from the nearer end, so that the error does not grow with the square of `m`.
fn cosine(m: u32, half_sine_squared: f64) -> f64 {
    let from_end = half_sine_squared > 0.5;
    let square = if from_end { 1.0 - half_sine_squared } else { half_sine_squared };
    let value = if m > LONG {
        (2.0 * f64::from(m) * square.max(0.0).sqrt().asin()).cos()
    } else {
        multiple(m, -square)
    };
    if from_end && !m.is_multiple_of(2) { -value } else { value }
}

/// `cosh(m v)` from `sinh^2(v/2)`.
fn hyperbolic(m: u32, half_sine_squared: f64) -> f64 {
    if m > LONG {
        (2.0 * f64::from(m) * half_sine_squared.max(0.0).sqrt().asinh()).cosh()
    } else {
        multiple(m, half_sine_squared)
    }
}

/// `cosh(m v)` from `sinh^2(v/2)` of either sign.
fn multiple(m: u32, half_sine_squared: f64) -> f64 {
    let mut difference = 2.0 * half_sine_squared;
    let mut value = 1.0 + difference;
    for _ in 1..m {
        difference += 4.0 * half_sine_squared * value;
        value += difference;
    }
    if m == 0 { 1.0 } else { value }
}

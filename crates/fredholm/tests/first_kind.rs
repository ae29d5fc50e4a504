//! Equations of the first kind whose right-hand sides have bends with a power: slow convergence, and what is stated of it, against integrals of one's own.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::PI;

use fredholm::equation::{first_kind, first_kind_in_parts};
use fredholm::kernel::{Logarithm, LogarithmSquare, Power};
use shtaerman_random::Random;

const TERMS: usize = 1024;

/// `int_0^length g(y, length - y) y^(power - 1) dy` for a `g` that is smooth but for a square root at the far end: the middle rule in `z` with `y^power = length^power z^4 (35 - 84 z + 70 z^2 - 20 z^3)`, which is flat
/// at both ends.
fn beside(power: f64, length: f64, g: impl Fn(f64, f64) -> f64) -> f64 {
    let count = 20_000;
    let term = |i: i32| {
        let (z, left) = (
            (f64::from(i) + 0.5) / f64::from(count),
            (f64::from(count - i) - 0.5) / f64::from(count),
        );
        let part = |z: f64| z.powi(4) * (35.0 - z * (84.0 - z * (70.0 - 20.0 * z)));
        let exponent = if z < 0.5 { part(z).ln() } else { (-part(left)).ln_1p() } / power;
        140.0 * (z * left).powi(3) * g(length * exponent.exp(), -length * exponent.exp_m1())
    };
    length.powf(power) / (power * f64::from(count)) * (0..count).map(term).sum::<f64>()
}

/// `phi(k) sqrt(1 - k^2)` for `ln 1/|x - s|` on (-1, 1) and `1 - |x - k|^q`: `P/pi + q/pi^2 int |s - k|^(q-2) sqrt(1 - s^2) ds`, `P ln 2` one minus the mean of `|cos t - k|^q`.
fn at_the_bend(k: f64, q: f64) -> f64 {
    // Both sides of the bend, by the distances from it and from the end.
    let over = |power: f64, weight: &dyn Fn(f64) -> f64| {
        let side = |length: f64| beside(power, length, |y, rest| weight(rest * (2.0 - length + y)));
        side(1.0 + k) + side(1.0 - k)
    };
    let mean = over(q + 1.0, &|square: f64| 1.0 / (PI * square.sqrt()));
    let steep = over(q - 1.0, &|square: f64| square.sqrt());
    (1.0 - mean) / (2f64.ln() * PI) + q / (PI * PI) * steep
}

#[test]
fn behind_bends_with_a_power_the_error_stated_holds_and_is_no_more_than_eight_times_as_large() {
    let kernel = Logarithm::unit();
    // The reviewer's closed form of 1 - |x|^1.5.
    assert!((at_the_bend(0.0, 1.5) - 0.735_043_54).abs() < 1e-7);
    for case in 0..60 {
        let mut random = Random::of_case(0xF10, case);
        let q = random.between(1.1, 1.95);
        let k = random.between(-0.95, 0.95);
        let found = first_kind(&kernel, &|x: f64| 1.0 - (x - k).abs().powf(q), TERMS).unwrap();
        let weight = (1.0 - k * k).sqrt();
        let error = (found.evaluate(k) * weight - at_the_bend(k, q)).abs();
        let stated = found.error.solution;
        assert!(error <= stated && stated <= 8.0 * error, "{k} {q}: {error:e} {stated:e}");
        assert!(!found.converged);
    }
}

#[test]
fn bends_beside_an_end_are_within_the_error_stated() {
    let kernel = Logarithm::unit();
    for case in 0..40 {
        let mut random = Random::of_case(0xF11, case);
        let q = random.between(1.05, 1.95);
        let k = 1.0 - 10f64.powf(random.between(-7.0, -1.0));
        let found = first_kind(&kernel, &|x: f64| 1.0 - (x - k).abs().powf(q), TERMS).unwrap();
        let weight = ((1.0 - k) * (1.0 + k)).sqrt();
        let error = (found.evaluate(k) * weight - at_the_bend(k, q)).abs();
        assert!(error <= found.error.solution, "{k} {q}: {error:e} {:e}", found.error.solution);
    }
}

#[test]
fn a_logarithm_of_squares_is_one_of_the_squares() {
    // With u = x^2 the interval (b, a) becomes (b^2, a^2), here of half-length 1, and phi = 2 x psi(u).
    let kernel = LogarithmSquare::new(0.5, 1.5).unwrap();
    for case in 0..20 {
        let mut random = Random::of_case(0xF12, case);
        let (q, k) = (random.between(1.1, 1.95), random.between(-0.9, 0.9));
        let f = |x: f64| 1.0 - (x * x - 1.25 - k).abs().powf(q);
        let found = first_kind(&kernel, &f, TERMS).unwrap();
        let x = (1.25 + k).sqrt();
        let weight = 2.0 * x / (1.0 - k * k).sqrt();
        let error = (found.evaluate(x) / weight - at_the_bend(k, q)).abs();
        assert!(error <= found.error.solution, "{k} {q}: {error:e} {:e}", found.error.solution);
    }
}

#[test]
fn under_kinks_and_steps_no_error_is_finite() {
    let unit = Logarithm::unit();
    for k in [0.0, 0.3, -0.77] {
        let kink = first_kind(&unit, &|x: f64| (x - k).abs(), TERMS).unwrap();
        let step = first_kind(&unit, &|x| if x < k { 0.0 } else { 1.0 }, TERMS).unwrap();
        // At a kink the solution is infinite, and the sum grows with the number of terms.
        assert!(kink.error.solution > 1.0 && step.error.solution.is_infinite(), "{k}");
    }
    let power = Power::new(fredholm::Interval::symmetric(1.0).unwrap(), 0.4).unwrap();
    let step = first_kind(&power, &|x| if x < 0.3 { 0.0 } else { 1.0 }, TERMS).unwrap();
    assert!(step.error.solution.is_infinite());
}

/// A dent `A e^(-((x-c)/w)^2)` adds `2 A/(pi^1.5 w)` to the solution at its middle: nothing less may be stated where no term has it.
#[test]
fn a_dent_that_no_term_has_is_not_solved() {
    let relation = Logarithm::unit();
    for (height, width) in [(1e-2f64, 1e-6f64), (1e-5, 1e-5), (1e-7, 1e-6)] {
        let f = |x: f64| 1.0 + height * (-((x - 0.3) / width).powi(2)).exp();
        let added = 2.0 * height / (PI.powf(1.5) * width);
        let cuts: Vec<f64> = (-6..=6).map(|i| 0.3 + f64::from(i) * width).collect();
        let solution = first_kind_in_parts(&relation, &f, &cuts, 64).unwrap();
        assert!(
            solution.error.solution >= added,
            "{height} {width}: {:e}",
            solution.error.solution
        );
    }
}

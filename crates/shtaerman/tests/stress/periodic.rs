//! Pressures repeated with a period.

use std::f64::consts::PI;

use shtaerman::{Criterion, Stress, StressField};

use crate::stress::support::{Complex, DEPTHS, difference, divide, from_potential};

const RATIO: f64 = 0.3;

/// `p = mean + cos(kx)`: `sigma_y = -mean - (1 + ky) e^(-ky) cos kx` and so on.
fn wave(x: f64, y: f64) -> Stress {
    let decay = (-y).exp();
    let (sigma_x, sigma_y) =
        (-2.0 - (1.0 - y) * decay * x.cos(), -2.0 - (1.0 + y) * decay * x.cos());
    Stress { sigma_x, sigma_y, sigma_z: RATIO * (sigma_x + sigma_y), tau_xy: -y * decay * x.sin() }
}

/// The seam of a base without gaps is a place like any other.
#[test]
fn a_cosine_has_its_closed_form() {
    for left in [-PI, -2.0, 0.4] {
        let panel = [[left, left + 2.0 * PI]];
        let pressure = |_: usize, from: f64, _: f64| 2.0 + (left + from).cos();
        let field = StressField::from_pressure(&panel, Some(2.0 * PI), RATIO, pressure).unwrap();
        let seam = [0.0, 1e-9, -1e-9, 1e-4, -1e-4, 0.1].map(|d| left + d);
        for y in DEPTHS.into_iter().chain([700.0, 1e6]) {
            for x in (0..40).map(|i| f64::from(i) * 0.7 - 14.0).chain(seam) {
                let found = field.stress(x, y).unwrap();
                let error = difference(&wave(x, y), &found, 1.0);
                assert!(error < 1e-12, "{left} {x} {y}: {error:e}");
            }
        }
    }
}

fn sine((x, y): Complex, k: f64) -> Complex {
    ((k * x).sin() * (k * y).cosh(), (k * x).cos() * (k * y).sinh())
}

fn cosine((x, y): Complex, k: f64) -> Complex {
    ((k * x).cos() * (k * y).cosh(), -(k * x).sin() * (k * y).sinh())
}

/// Strips `|x - kL| < 1` under `p = 1`: `F = ln[sin k(z + 1)/sin k(z - 1)]`, `k = pi/L`.
fn strips(x: f64, y: f64, period: f64) -> Stress {
    let k = PI / period;
    let angle = |(re, im): Complex| {
        let angle = im.atan2(re);
        if angle < -0.5 * PI { angle + 2.0 * PI } else { angle }
    };
    let [one, two] = [x + 1.0, x - 1.0].map(|x| (x, y));
    let [sine_one, sine_two] = [one, two].map(|z| sine(z, k));
    let value = (
        (sine_one.0.hypot(sine_one.1) / sine_two.0.hypot(sine_two.1)).ln(),
        angle(sine_one) - angle(sine_two),
    );
    let [first, second] = [(one, sine_one), (two, sine_two)].map(|(z, s)| divide(cosine(z, k), s));
    from_potential(value, (k * (first.0 - second.0), k * (first.1 - second.1)), y, RATIO)
}

#[test]
fn strips_in_a_row_have_their_closed_form() {
    for period in [2.001, 2.5, 7.0] {
        let field =
            StressField::from_pressure(&[[-1.0, 1.0]], Some(period), RATIO, |_, _, _| 1.0).unwrap();
        for y in &DEPTHS[1..] {
            for i in -50..=50 {
                let x = 0.5 * period * f64::from(i) / 50.0 * 0.9999;
                let (exact, found) = (strips(x, *y, period), field.stress(x, *y).unwrap());
                let error = difference(&exact, &found, 1.0);
                assert!(error < 2e-12, "{period} {x} {y}: {error:e}");
                let moved = field.stress(x + 5.0 * period, *y).unwrap();
                assert!(difference(&exact, &moved, 1.0) < 1e-13 * (1.0 + 30.0 / y));
            }
        }
        // Deep down the pressure is its mean.
        let deep = field.stress(0.3, 40.0 * period).unwrap();
        assert!((deep.sigma_y + 2.0 / period).abs() < 1e-14);
    }
}

/// Half-ellipses in a row have their peaks below their middles: told is the one under the panel, and that at 0 as 0.
#[test]
fn a_peak_is_told_in_the_period_of_the_panels() {
    for (left, at) in [(-0.5, 0.0), (0.6, 1.1), (-0.9, -0.4), (7.25, 7.75)] {
        let panel = [[left, left + 1.0]];
        let pressure = |_: usize, from: f64, to: f64| (from * to).sqrt();
        let field = StressField::from_pressure(&panel, Some(2.0), RATIO, pressure).unwrap();
        for criterion in [Criterion::VonMises, Criterion::Tresca] {
            let peak = field.peak(criterion);
            assert!((peak.x - at).abs() < 1e-6 && peak.depth > 0.01, "{left}: {peak:?}");
            assert!(at != 0.0 || peak.x == 0.0, "{left}: {peak:?}");
        }
    }
}

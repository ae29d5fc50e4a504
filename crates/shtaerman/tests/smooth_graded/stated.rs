//! The error that is stated covers the true one, and is not far above it.

use std::f64::consts::PI;

use libm::tgamma;
use shtaerman::{ErrorKind, Rotational, Vertical};

use crate::smooth_graded::support::{Case, beta_integral, cosine};

/// The statement holds and is no larger than `most` of the size.
#[track_caller]
fn honest(estimate: f64, error: f64, size: f64, most: f64, what: &str) {
    assert!(error.abs() <= estimate, "{what}: error {error:.1e}, estimate {estimate:.1e}");
    assert!(estimate <= most * size, "{what}: estimate {:.1e} of the size", estimate / size);
}

/// From seeds: `b`, `R`, eccentric places of the parabola `(x - c)^2/(2R)`.
fn draws(count: usize) -> impl Iterator<Item = [f64; 4]> {
    let mut state = 0x9e37_79b9_7f4a_7c15u64;
    let mut next = move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..count).map(move |_| [next(), next(), next(), next()])
}

#[test]
fn strips_state_their_error() {
    for [one, two, three, four] in draws(120) {
        let mu = 0.02 + 0.95 * one;
        let b = 0.3 * 10f64.powf(-3.0 * two);
        let centre = 0.6 * (2.0 * three - 1.0);
        let radius = 10f64.powf(2.0 * four);
        let case = Case::plane(mu);
        let eigenvalue = PI / cosine(mu);
        let q = b.powf(1.0 + mu) / (eigenvalue * case.line() * radius * mu * (1.0 + mu));
        let force = q * b * beta_integral(0.5 * (1.0 + mu));
        let middle = 1.0 - 1.0 / (2.0 + mu) + 0.5 * mu * (1.0 + mu) / (2.0 + mu);
        let settlement = case.line() * b.powf(1.0 - mu) * q * eigenvalue * middle;
        let profile = format!("(x - ({centre}))^2/(2*{radius})");
        let contact = case.solve(&profile, Vertical::Force(force), Rotational::Tilt(0.0));
        let accuracy = contact.dimensionless().error().unwrap();
        assert_eq!(accuracy.kind, ErrorKind::Estimate);
        let scale = contact.problem().scaling().unwrap();
        let what = format!("mu {mu} b {b} c {centre} R {radius}");
        let [left, right] = contact.zones()[0];
        let edge = contact.dimensionless().error().and_then(|error| error.zones).unwrap();
        honest(edge, left - centre + b, b, 1e-8, &format!("left, {what}"));
        honest(edge, right - centre - b, b, 1e-8, &format!("right, {what}"));
        let pressure = accuracy.pressure * scale.pressure();
        for y in [-0.9, -0.3, 0.1, 0.6] {
            let exact = q * (1.0f64 - y * y).powf(0.5 * (1.0 + mu));
            let error = contact.pressure(centre + y * b).unwrap() - exact;
            honest(pressure, error, q, 1e-9, &format!("{y}, {what}"));
        }
        let error = contact.settlement() - settlement;
        let stated = accuracy.settlement * scale.displacement();
        honest(stated, error, settlement, 1e-7, &format!("settlement, {what}"));
    }
}

#[test]
fn disks_state_their_error() {
    for [one, two, three, _] in draws(60) {
        let mu = 0.02 + 0.95 * one;
        let c = 10f64.powf(-4.0 * two);
        let radius = 10f64.powf(2.0 * three);
        let case = Case::disk(mu);
        let beta = 0.5 * (1.0 - mu);
        let e = 4f64.powf(beta) / (case.rings() * tgamma(1.0 - beta).powi(2));
        let force = 4.0 * e * c.powf(3.0 + mu) / (radius * (1.0 + mu).powi(2) * (3.0 + mu));
        let contact = case.press(&format!("x^2/(2*{radius})"), force);
        let accuracy = contact.dimensionless().error().unwrap();
        let scale = contact.problem().scaling().unwrap();
        let what = format!("mu {mu} c {c} R {radius}");
        let edge = contact.dimensionless().error().and_then(|error| error.zones).unwrap();
        honest(edge, contact.zones()[0][1] - c, c, 1e-12, &what);
        let unit = 2.0 * e / (PI * radius * (1.0 + mu).powi(2)) * c.powf(1.0 + mu);
        let pressure = accuracy.pressure * scale.pressure();
        for y in [0.0f64, 0.3, 0.6, 0.9] {
            let exact = unit * (1.0 - y * y).powf(1.0 - beta);
            let error = contact.pressure(y * c).unwrap() - exact;
            honest(pressure, error, unit, 1e-10, &format!("{y}, {what}"));
        }
        let exact = c * c / (radius * (1.0 + mu));
        let stated = accuracy.settlement * scale.displacement();
        honest(stated, contact.settlement() - exact, exact, 1e-11, &what);
    }
}

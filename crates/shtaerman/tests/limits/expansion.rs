//! The expansion about the smooth limit.

use std::f64::consts::{LN_2, PI};

use crate::support::{CASES, PARABOLA, roughness};
use shtaerman::Contact;

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;

fn near(one: f64, other: f64, tolerance: f64, what: &str) {
    assert!((one - other).abs() <= tolerance * other.abs(), "{what}: {one} {other}");
}

/// The largest `theta0` that is solved directly and the next that is not, by bisection.
pub(crate) fn switch(solve: &dyn Fn(f64) -> Contact) -> [f64; 2] {
    let (mut low, mut high) = (1e6f64, 1e8f64);
    for _ in 0..36 {
        let middle = (low * high).sqrt();
        if solve(middle).method().name == "expansion" { high = middle } else { low = middle }
    }
    [low, high]
}

#[test]
fn the_switch_is_continuous() {
    for case in &CASES {
        let solve = |theta0: f64| case.solve(roughness(theta0));
        let [below, above] = switch(&solve).map(solve);
        assert_eq!(above.method().name, "expansion", "{}", case.name);
        assert_ne!(below.method().name, "expansion", "{}", case.name);
        assert!(above.reason().contains("error"), "{}", above.reason());
        near(above.settlement(), below.settlement(), 1e-9, case.name);
        for (one, other) in above.zones().iter().flatten().zip(below.zones().iter().flatten()) {
            near(*one, *other, 1e-9, case.name);
        }
        near(above.peak_pressure(), below.peak_pressure(), 1e-9, case.name);
    }
}

/// Beyond the switch, at a `theta0` where the direct solution still has edges and settlement, the expansion has the same: the smooth answer is known
/// to more digits than the correction needs.
#[test]
fn corrections_follow_the_logarithm() {
    for case in &CASES {
        let smooth = case.solve(0.0);
        let change = |theta0: f64| {
            let contact = case.solve(roughness(theta0));
            theta0 * (contact.settlement() - smooth.settlement())
        };
        // A ln theta0 + B from direct solutions, carried beyond the switch.
        let [one, two] = [2e4f64, 2e5].map(change);
        for theta0 in [5e7f64, 1e9] {
            let expected = one + (two - one) / 10f64.ln() * (theta0 / 2e4).ln();
            let found = change(theta0);
            let what = format!("{} {theta0:e}", case.name);
            assert!(
                (found - expected).abs() < 2e-3 * expected.abs().max(0.3),
                "{what}: {found} {expected}"
            );
        }
    }
}

#[test]
fn the_stated_error_is_small_and_the_contact_complementary() {
    for case in &CASES {
        for theta0 in [1e8, 1e10, 1e12] {
            let contact = case.solve(roughness(theta0));
            let error = contact.relative_error();
            assert!(error > 0.0 && error < 2e-6, "{} {theta0:e}: {error:e}", case.name);
            let left = contact.complementarity().unwrap();
            assert!(left.tension < 1e-9 && left.penetration < 1e-9, "{}: {left:?}", case.name);
        }
    }
}

#[test]
fn edges_of_the_parabola() {
    // a/a_H = 1 + c [ln(1/c) + gamma + 4 ln 2 - 1]/(2 pi), c = chi E*/a_H: recognised in digits found numerically, 0.3739830
    let exact = (EULER + 4.0 * LN_2 - 1.0) / (2.0 * PI);
    let hertz = PARABOLA.solve(0.0).zones()[0][1];
    near(hertz, (4.0 / (16.0 * PI)).sqrt(), 1e-12, "Hertz");
    let constant = |c: f64| {
        let edge = PARABOLA.solve(c * hertz).zones()[0][1];
        (edge / hertz - 1.0) / c - (1.0 / c).ln() / (2.0 * PI)
    };
    for (c, tolerance) in [(1e-4, 2e-6), (1e-5, 3e-7), (1e-7, 5e-6), (1e-8, 1e-5), (1e-9, 2e-5)] {
        let found = constant(c);
        assert!((found - exact).abs() < tolerance, "{c:e}: {found}");
    }
}

//! Invariants under random profiles, loads and roughness.

use proptest::prelude::*;

use crate::contact::support::{force_and_moment, integral, settlement_and_tilt, solve};
use shtaerman::Contact;

/// `c0 + c1 xi + c2 xi^2 + c3 sin(4 xi) + c4 exp(xi)`, and the same with `xi -> -xi`.
fn profile(c: [f64; 5], sign: f64) -> String {
    format!(
        "{} + {}*xi + {}*xi^2 + {}*sin(4*xi) + {}*exp({sign}*xi)",
        c[0],
        sign * c[1],
        c[2],
        sign * c[3],
        c[4]
    )
}

prop_compose! {
    fn coefficients()(c in prop::array::uniform5(-5.0..5.0f64)) -> [f64; 5] { c }
}

prop_compose! {
    fn theta0()(exponent in -6.0..2.3f64) -> f64 { 10f64.powf(exponent) }
}

/// Size of what cancels in an answer.
fn scale(contact: &Contact) -> f64 {
    let load = contact.dimensionless().force().abs() + contact.dimensionless().moment().abs();
    (20.0 + contact.dimensionless().settlement().abs() + contact.dimensionless().tilt().abs())
        * (1.0 + 0.01 * contact.theta0())
        + load
}

fn near(one: f64, other: f64, scale: f64) -> bool {
    (one - other).abs() <= 1e-11 * scale
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn force_and_moment_balance(c in coefficients(), theta0 in theta0(), force in -3.0..3.0f64, moment in -3.0..3.0f64) {
        let contact = solve(theta0, &profile(c, 1.0), force_and_moment(force, moment), 60);
        prop_assert!(near(integral(|xi| contact.dimensionless().pressure(xi).unwrap()), force, scale(&contact)));
        prop_assert!(near(integral(|xi| xi * contact.dimensionless().pressure(xi).unwrap()), moment, scale(&contact)));
        let bare = contact.dimensionless();
        let (peak, place) = (bare.peak_pressure(), bare.peak_pressure_at());
        prop_assert!(near(contact.dimensionless().pressure(place).unwrap(), peak, scale(&contact)));
        for i in 0..=300 {
            let xi = f64::from(i) / 150.0 - 1.0;
            prop_assert!(contact.dimensionless().pressure(xi).unwrap() <= peak + 1e-6 * scale(&contact), "xi = {}", xi);
        }
    }

    #[test]
    fn displacements_and_loads_are_inverse(c in coefficients(), theta0 in theta0(), delta in -3.0..3.0f64, alpha in -3.0..3.0f64) {
        let first = solve(theta0, &profile(c, 1.0), settlement_and_tilt(delta, alpha), 60);
        let again = solve(theta0, &profile(c, 1.0), force_and_moment(first.dimensionless().force(), first.dimensionless().moment()), 60);
        // The compliance grows as theta0, and rounding of the loads with it.
        let scale = scale(&first) * (1.0 + theta0);
        prop_assert!(near(again.dimensionless().settlement(), delta, scale), "{} {}", again.dimensionless().settlement(), delta);
        prop_assert!(near(again.dimensionless().tilt(), alpha, scale), "{} {}", again.dimensionless().tilt(), alpha);
    }

    #[test]
    fn reflection_reflects(c in coefficients(), theta0 in theta0(), force in -3.0..3.0f64, moment in -3.0..3.0f64, xi in -1.0..1.0f64) {
        let right = solve(theta0, &profile(c, 1.0), force_and_moment(force, moment), 60);
        let left = solve(theta0, &profile(c, -1.0), force_and_moment(force, -moment), 60);
        prop_assert!(near(left.dimensionless().settlement(), right.dimensionless().settlement(), scale(&right)));
        prop_assert!(near(left.dimensionless().tilt(), -right.dimensionless().tilt(), scale(&right)));
        prop_assert!(near(left.dimensionless().pressure(-xi).unwrap(), right.dimensionless().pressure(xi).unwrap(), scale(&right)));
    }

    #[test]
    fn rigid_motions_of_the_profile_leave_the_pressure(c in coefficients(), theta0 in theta0(), up in -9.0..9.0f64, turn in -9.0..9.0f64, xi in -1.0..1.0f64) {
        let plain = solve(theta0, &profile(c, 1.0), force_and_moment(1.0, 0.2), 60);
        let moved = solve(theta0, &format!("{} + {up} + {turn}*xi", profile(c, 1.0)), force_and_moment(1.0, 0.2), 60);
        prop_assert!(near(moved.dimensionless().settlement(), plain.dimensionless().settlement() + up, scale(&plain)));
        prop_assert!(near(moved.dimensionless().tilt(), plain.dimensionless().tilt() - turn, scale(&plain)));
        prop_assert!(near(moved.dimensionless().pressure(xi).unwrap(), plain.dimensionless().pressure(xi).unwrap(), scale(&plain)));
    }

    #[test]
    fn reciprocity(one in coefficients(), two in coefficients(), theta0 in theta0()) {
        let first = solve(theta0, &profile(one, 1.0), force_and_moment(1.0, -0.4), 60);
        let second = solve(theta0, &profile(two, 1.0), force_and_moment(-0.3, 0.9), 60);
        let work = |base: &Contact, pressing: &Contact| {
            integral(|xi| {
                let depth = base.dimensionless().settlement() - base.dimensionless().tilt() * xi - base.problem().dimensionless_profile(xi);
                depth * pressing.dimensionless().pressure(xi).unwrap()
            })
        };
        let size = scale(&first) * scale(&second);
        prop_assert!(near(work(&first, &second), work(&second, &first), size));
    }

    #[test]
    fn tension_is_where_the_pressure_is_negative(c in coefficients(), theta0 in theta0(), force in 0.0..20.0f64) {
        let contact = solve(theta0, &profile(c, 1.0), force_and_moment(force, 0.0), 60);
        let zones = contact.tension();
        prop_assert!(zones.windows(2).all(|pair| pair[0][1] < pair[1][0]));
        for i in 0..=400 {
            let xi = f64::from(i) / 200.0 - 1.0;
            let inside = zones.iter().any(|[left, right]| (*left..=*right).contains(&xi));
            let pressure = contact.dimensionless().pressure(xi).unwrap();
            prop_assert!(pressure.abs() < 1e-6 * scale(&contact) || inside == (pressure < 0.0), "xi = {}: {}", xi, pressure);
        }
    }
}

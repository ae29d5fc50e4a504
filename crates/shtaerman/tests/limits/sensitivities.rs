//! Sensitivities of the expansion: beside differences of solutions, and beside those of the direct solution at the switch.

use shtaerman::{Contact, Derivatives, Sensitivities};

use crate::expansion::switch;
use crate::support::{CASES, roughness};

/// Derivatives of a quantity times their parameters.
fn elasticities(contact: &Contact, derivatives: &Derivatives, roughness: f64) -> [f64; 3] {
    [
        derivatives.roughness.unwrap() * roughness,
        derivatives.young_modulus.unwrap(),
        derivatives.force.unwrap() * contact.force(),
    ]
}

/// Quantities with their derivatives.
fn parts<'s>(contact: &Contact, found: &'s Sensitivities) -> [(f64, &'s Derivatives); 3] {
    [
        (contact.settlement(), found.settlement.as_ref().unwrap()),
        (contact.peak_pressure(), found.peak_pressure.as_ref().unwrap()),
        (contact.contact_width(), &found.contact_width),
    ]
}

/// Rates by two ways differ by no more than both state, relative to the quantity or its largest rate.
fn agree(what: &str, value: f64, stated: f64, [left, right]: [[f64; 3]; 2]) {
    let sizes = left.iter().chain(&right).map(|rate| rate.abs());
    let size = sizes.fold(value.abs(), f64::max);
    for (a, b) in left.into_iter().zip(right) {
        let error = (a - b).abs() / size;
        assert!(error <= stated, "{what}: {a} {b}: {error:e} {stated:e}");
    }
}

/// What settlement, largest pressure and width may state.
const STATED: [f64; 3] = [1e-8, 1e-5, 3e-4];

#[test]
fn the_rates_are_those_of_differences() {
    for case in &CASES {
        for theta0 in [7e6, 1e9] {
            let roughness = roughness(theta0);
            let contact = case.solve(roughness);
            assert_eq!(contact.method().name, "expansion", "{}", case.name);
            let found = contact.tangent_sensitivities().unwrap();
            let others = contact.difference_sensitivities().unwrap();
            let pairs = parts(&contact, &found).into_iter().zip(parts(&contact, &others));
            for (k, ((value, one), (_, other))) in pairs.enumerate() {
                let what = format!("{} {theta0:e} {k}", case.name);
                assert!(one.error < STATED[k], "{what}: {:e}", one.error);
                let rates = [one, other].map(|rates| elasticities(&contact, rates, roughness));
                // Differences over steps of 1e-3 cannot show less than what the contact is known to over that.
                let known = contact.relative_error() / 1e-3;
                agree(&what, value, one.error + other.error + known, rates);
            }
        }
    }
}

#[test]
fn they_are_continuous_at_the_switch() {
    for case in &CASES {
        let [low, high] = switch(&|theta0| case.solve(roughness(theta0)))
            .map(|theta0| (roughness(theta0), case.solve(roughness(theta0))));
        assert_ne!(low.1.method().name, "expansion", "{}", case.name);
        assert_eq!(high.1.method().name, "expansion", "{}", case.name);
        let [below, above] =
            [&low, &high].map(|(_, contact)| contact.tangent_sensitivities().unwrap());
        let pairs = parts(&low.1, &below).into_iter().zip(parts(&high.1, &above));
        for (k, ((value, one), (_, other))) in pairs.enumerate() {
            let rates = [elasticities(&low.1, one, low.0), elasticities(&high.1, other, high.0)];
            // The width of the direct solution, at the end of its range, is not as sure as stated.
            let stated = if k == 2 { 4.0 * one.error } else { one.error } + other.error;
            agree(&format!("{} {k}", case.name), value, stated, rates);
        }
    }
}

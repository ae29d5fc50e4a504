//! Sensitivities of the expansion: beside differences of solutions, and beside those of the direct solution at the switch.

use shtaerman::{Contact, Derivatives, Sensitivities};

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
        (contact.peak_pressure().0, found.pressure_max.as_ref().unwrap()),
        (contact.contact_width(), &found.contact_width),
    ]
}

#[test]
fn the_rates_are_those_of_differences() {
    for case in &CASES {
        for theta0 in [4e6, 1e9] {
            let roughness = roughness(theta0);
            let contact = case.solve(roughness);
            assert_eq!(contact.method().name, "expansion", "{}", case.name);
            let found = contact.tangent_sensitivities().unwrap();
            let others = contact.difference_sensitivities().unwrap();
            let pairs = parts(&contact, &found).into_iter().zip(parts(&contact, &others));
            for (k, ((value, one), (_, other))) in pairs.enumerate() {
                let size = value.abs().max(1e-3);
                assert!(one.error < 1e-7, "{} {theta0:e} {k}: {:e}", case.name, one.error);
                let [one, two] =
                    [one, other].map(|derivatives| elasticities(&contact, derivatives, roughness));
                for (one, two) in one.into_iter().zip(two) {
                    // What differences of pressures known to 1e-10 show over steps of 1e-3.
                    let error = (one - two).abs() / size;
                    let tolerance = if k == 1 { 2e-6 } else { 1e-8 };
                    assert!(error < tolerance, "{} {theta0:e} {k}: {one} {two}", case.name);
                }
            }
        }
    }
}

#[test]
fn they_are_continuous_at_the_switch() {
    for case in &CASES {
        // On both sides of it for every case, whose zones are at most six times narrower than the base.
        let of = |theta0: f64| {
            let contact = case.solve(roughness(theta0));
            let found = contact.tangent_sensitivities().unwrap();
            let values = parts(&contact, &found).map(|(value, derivatives)| {
                elasticities(&contact, derivatives, roughness(theta0))
                    .map(|rate| rate / value.abs())
            });
            (contact.method().name, values)
        };
        let [low, high] = [of(0.99e6), of(7e6)];
        assert_ne!(low.0, "expansion", "{}", case.name);
        assert_eq!(high.0, "expansion", "{}", case.name);
        for (low, high) in low.1.iter().zip(&high.1) {
            // By roughness what is left of the corrections falls as ln(theta0)/theta0, or is a half at a corner and a share of the logarithm at a kink.
            for (one, two) in low.iter().zip(high) {
                assert!((one - two).abs() < 2e-2 * one.abs() + 4e-5, "{}: {one} {two}", case.name);
            }
        }
    }
}

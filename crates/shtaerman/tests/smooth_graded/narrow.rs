//! Features far narrower than the contact.

use std::f64::consts::PI;

use shtaerman::{Profile, Rotational, Solver, Vertical};

use crate::smooth_graded::support::{Case, close};

/// The force of a settlement of 1 without a profile, and the same less the force of full contact under a profile.
fn missing(case: &Case, formula: &str) -> [f64; 2] {
    let solved = |formula: &str, settlement: f64| {
        let profile = Profile::expression(formula).unwrap();
        let (vertical, rotational) = (Vertical::Settlement(settlement), Rotational::Tilt(0.0));
        case.problem(profile, 0.0, vertical, rotational).solve().unwrap().force()
    };
    let flat = solved("0", 1.0);
    [flat, flat - solved(formula, 1.0)]
}

#[test]
fn a_narrow_feature_has_the_force_that_reciprocity_gives() {
    // Betti: the force that a profile takes away is int f p_1, p_1 = P_1 (1 - x^2)^-beta/B the pressure of the flat punch, and int f over a narrow bump is h w sqrt(pi).
    for mu in [0.1, 0.6] {
        let case = Case { solver: Solver::bilateral(), ..Case::plane(mu) };
        for (width, at) in [(2e-4, 0.301_23), (3e-3, -0.6)] {
            let formula = format!("0.001*exp(-((x - {at})/{width})^2)");
            let [flat, found] = missing(&case, &formula);
            let beta = 0.5 * (1.0 - mu);
            // int (1 - x^2)^-beta dx
            let total = PI.sqrt() * libm::tgamma(1.0 - beta) / libm::tgamma(1.5 - beta);
            let count = 4000;
            let sum: f64 = (0..count)
                .map(|i| 12.0 * (f64::from(i) + 0.5) / f64::from(count) - 6.0)
                .map(|u| {
                    let x: f64 = at + width * u;
                    0.001 * (-u * u).exp() * (1.0 - x * x).powf(-beta) * 12.0 * width
                })
                .sum();
            let exact = flat * sum / (f64::from(count) * total);
            close(found / exact, 1.0, 1e-8, &format!("mu = {mu}, width = {width}"));
        }
    }
}

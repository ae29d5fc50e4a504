//! Zeros by symmetry only where there is symmetry.

use shtaerman::{Contact, Foundation, Problem, Profile, Punch, Solver};

use crate::contact::support::{assert_near, force_and_moment, integrate, settlement_and_tilt};

fn solve(theta0: f64, profile: &str, load: shtaerman::Load) -> Contact {
    let (foundation, punch) =
        (Foundation::dimensionless(theta0).unwrap(), Punch::new(1.0).unwrap());
    let profile = Profile::expression(profile).unwrap();
    Problem::new(foundation, punch.with_profile(profile), load)
        .unwrap()
        .with_solver(Solver::bilateral())
        .solve()
        .unwrap()
}

/// `int_{-1}^{1} xi^k p0 dxi` over the pieces between the steps of the base.
fn integral(contact: &Contact, breaks: &[f64], power: i32) -> f64 {
    let ends: Vec<f64> = [-1.0].into_iter().chain(breaks.iter().copied()).chain([1.0]).collect();
    let density = |xi: f64| contact.dimensionless().pressure(xi).unwrap() * xi.powi(power);
    let piece = |pair: &[f64]| {
        let half = 0.5 * (pair[1] - pair[0]);
        integrate(half, |d| density(pair[0] + d)) + integrate(half, |d| density(pair[1] - d))
    };
    ends.windows(2).map(piece).sum()
}

#[test]
fn steps_off_the_middle_balance_the_load() {
    for (profile, breaks) in [
        ("sign(xi - 0.3)", vec![0.3]),
        ("0.5*sign(xi + 0.7)", vec![-0.7]),
        ("where(xi < -0.2, 1, where(xi < 0.5, 0, 1))", vec![-0.2, 0.5]),
        ("where(xi < -0.2, 1, where(xi < 0.5, 0, -1))", vec![-0.2, 0.5]),
        ("where(abs(xi) < 0.4, 1, 0)", vec![-0.4, 0.4]),
    ] {
        for theta0 in [0.0, 1.0, 12.0] {
            let contact = solve(theta0, profile, force_and_moment(0.3, 0.05));
            // The pressure jumps at a step, where the quadrature sees neither side exactly.
            assert_near(integral(&contact, &breaks, 0), 0.3, 1e-10, profile);
            assert_near(integral(&contact, &breaks, 1), 0.05, 1e-10, profile);
        }
    }
}

#[test]
fn symmetric_steps_have_exact_zeros() {
    let even = solve(2.0, "where(abs(xi) < 0.4, 1, 0)", force_and_moment(0.3, 0.0));
    assert_eq!(even.dimensionless().tilt(), 0.0);
    // Under an odd base the settlement is that of a flat one.
    let [odd, flat] = ["sign(xi)", "0"].map(|text| solve(2.0, text, force_and_moment(0.3, 0.0)));
    assert_near(odd.dimensionless().settlement(), flat.dimensionless().settlement(), 1e-14, "odd");
}

#[test]
fn a_narrow_bump_beside_the_middle_tilts_the_punch() {
    // By reciprocity the moment of the response to f is int f q dxi with the response q to xi, of a bump of width w almost w sqrt(pi) q(xi0).
    let (theta0, at, height, width) = (1.2, 0.314, 1e-3, 8e-4);
    let turned = solve(theta0, "0", settlement_and_tilt(0.0, -1.0));
    let moment_tilt = turned.dimensionless().moment();
    let response =
        height * width * std::f64::consts::PI.sqrt() * turned.dimensionless().pressure(at).unwrap();
    let profile = format!("0.02*xi^2 + {height:e}*exp(-((xi - {at})/{width:e})^2)");
    let contact = solve(theta0, &profile, force_and_moment(1.0, 0.0));
    assert_near(contact.dimensionless().tilt() / (-response / moment_tilt), 1.0, 1e-6, "tilt");
}

/// Neither force nor moment: their errors are held against the pressures of both signs that balance. What is added to an even base has no moment, and the stiffness does not change.
#[test]
fn a_base_that_nothing_presses() {
    let load = shtaerman::Load::force(0.0).unwrap().with_tilt(0.0).unwrap();
    for theta0 in [0.1, 6.0, 300.0] {
        let balanced = solve(theta0, "xi^2", load);
        assert!(balanced.relative_error() < 1e-10, "{:e}", balanced.relative_error());
        let pressed = solve(theta0, "xi^2", force_and_moment(2.0, 0.0));
        let plain = solve(theta0, "0", force_and_moment(2.0, 0.0));
        let of = |contact: &Contact, xi: f64| contact.dimensionless().pressure(xi).unwrap();
        for xi in [-1.0, -0.6, 0.0, 0.3, 0.99] {
            let sum = of(&balanced, xi) + of(&plain, xi);
            assert_near(of(&pressed, xi) / sum, 1.0, 1e-10, "xi^2");
        }
    }
}

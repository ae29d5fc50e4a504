//! The smooth limit, `theta0 -> infinity`: how pressure, settlement and tilt of a flat punch approach the classical solution.

use std::f64::consts::{LN_2, PI};

use crate::contact::support::{assert_near, force_and_moment, solve};
use shtaerman::Contact;

fn flat(theta0: f64, force: f64, moment: f64, degree: usize) -> Contact {
    solve(theta0, "0", force_and_moment(force, moment), degree)
}

/// Edge pressure over `sqrt(theta0)`, freed of the leading term of its error, of order 2 in `1/n`.
fn edge(theta0: f64, force: f64, moment: f64, degree: usize) -> f64 {
    let [coarse, fine] = [degree / 2, degree].map(|n| {
        flat(theta0, force, moment, n).dimensionless().pressure(1.0).unwrap() / theta0.sqrt()
    });
    fine + (fine - coarse) / 3.0
}

#[test]
fn edge_pressures_are_the_known_ones() {
    // K/sqrt(E* chi) with K = P/sqrt(pi a): p0(1)/sqrt(theta0) -> P0/sqrt 2; found numerically, five digits.
    for (theta0, degree, force, moment, known) in [
        (1.0, 200, 1.0, 0.0, 0.87271),
        (10.0, 200, 1.0, 0.0, 0.72979),
        (100.0, 800, 1.0, 0.0, 0.71013),
        (1000.0, 3200, 1.0, 0.0, 0.70749),
        (1.0, 400, 0.0, 1.0, 2.11108),
        (10.0, 400, 0.0, 1.0, 1.52226),
        (100.0, 1600, 0.0, 1.0, 1.42954),
    ] {
        let what = format!("theta0 = {theta0}, P0 = {force}, M0 = {moment}");
        assert_near(edge(theta0, force, moment, degree), known, 6e-6, &what);
    }
}

#[test]
fn edge_pressures_tend_to_those_of_the_boundary_layer() {
    for (force, moment, limit) in [(1.0, 0.0, 0.5f64.sqrt()), (0.0, 1.0, 2f64.sqrt())] {
        let errors = [(10.0, 200), (100.0, 800)]
            .map(|(theta0, degree)| edge(theta0, force, moment, degree) - limit);
        assert!(errors[0] > 5.0 * errors[1] && errors[1] > 0.0, "{errors:?}");
        assert!(errors[1] < 0.015 * limit, "{errors:?}");
    }
}

#[test]
fn the_tilting_limit_runs_from_the_middle_third_to_the_middle_half() {
    // |M|/(P a) at which the edge pressure vanishes: the quotient of the edge pressures under unit force and moment.
    let known = [
        (1e-3, 100, 0.3335),
        (0.1, 100, 0.3484),
        (1.0, 200, 0.4134),
        (10.0, 400, 0.4794),
        (100.0, 800, 0.4968),
        (1e3, 3200, 0.4996),
    ];
    for (theta0, degree, limit) in known {
        let found = edge(theta0, 1.0, 0.0, degree) / edge(theta0, 0.0, 1.0, degree);
        assert_near(found, limit, 6e-5, &format!("theta0 = {theta0}"));
    }
}

#[test]
fn tension_begins_at_the_tilting_limit() {
    for (theta0, below, above) in [(0.1, 0.348, 0.349), (10.0, 0.479, 0.480)] {
        assert!(flat(theta0, 1.0, below, 200).tension().is_empty(), "theta0 = {theta0}");
        let pulling = flat(theta0, 1.0, above, 200).tension();
        assert!(matches!(pulling[..], [[-1.0, _]]), "theta0 = {theta0}: {pulling:?}");
    }
}

#[test]
fn the_interior_pressure_tends_to_the_classical_one() {
    let (force, moment) = (1.0, -0.2);
    let worst = |theta0: f64, degree: usize| {
        let contact = flat(theta0, force, moment, degree);
        [-0.8, -0.5, 0.0, 0.3, 0.7].into_iter().fold(0.0f64, |worst, xi: f64| {
            let classical = (force + 2.0 * moment * xi) / (PI * (1.0 - xi * xi).sqrt());
            worst.max((contact.dimensionless().pressure(xi).unwrap() / classical - 1.0).abs())
        })
    };
    let errors = [worst(10.0, 200), worst(100.0, 400), worst(1000.0, 1600)];
    // The correction is of the order ln(theta0)/theta0.
    assert!(errors[0] > 3.0 * errors[1] && errors[1] > 5.0 * errors[2], "{errors:?}");
    assert!(errors[2] < 5e-3, "{errors:?}");
}

#[test]
fn settlement_and_tilt_tend_to_the_classical_ones() {
    // delta = 2 P ln2/(pi E*) is theta0 P0 ln 2, alpha = -4 M/(pi E* a^2) is -2 theta0 M0. As d(delta0/theta0)/d(1/theta0) is
    // int p0^2/P0, which grows as ln(theta0)/pi^2, what lies beyond the limit is (ln theta0 + constant)/pi^2, and four times
    // that for the tilt.
    let constants = |theta0: f64, degree: usize| {
        let settlement = flat(theta0, 1.0, 0.0, degree).dimensionless().settlement();
        let tilt = -flat(theta0, 0.0, 1.0, degree).dimensionless().tilt();
        [
            PI * PI * (settlement - theta0 * LN_2) - theta0.ln(),
            PI * PI * (tilt - 2.0 * theta0) / 4.0 - theta0.ln(),
        ]
    };
    let [ten, hundred, thousand] =
        [(10.0, 200), (100.0, 800), (1000.0, 1600)].map(|(theta0, n)| constants(theta0, n));
    for i in 0..2 {
        let (first, second) = (hundred[i] - ten[i], thousand[i] - hundred[i]);
        assert!(
            second.abs() < 0.3 * first.abs() && second.abs() < 0.1,
            "{ten:?} {hundred:?} {thousand:?}"
        );
    }
}

#[test]
fn a_crowned_punch_tends_to_the_chebyshev_form() {
    // f0 = k xi^2 = k (T_0 + T_2)/2: p0 = [P0 - (k/theta0) 2 (1/2) T_2 ...]/(pi sqrt(1-xi^2)); pi E*/2 is 1/theta0 in these units.
    let (force, theta0) = (1.0, 1000.0);
    let k = 0.4 * theta0;
    let contact = solve(theta0, &format!("{k}*xi^2"), force_and_moment(force, 0.0), 1600);
    for xi in [-0.7f64, 0.0, 0.4] {
        let classical =
            (force - k / theta0 * (2.0 * xi * xi - 1.0)) / (PI * (1.0 - xi * xi).sqrt());
        assert_near(
            contact.dimensionless().pressure(xi).unwrap() / classical,
            1.0,
            5e-3,
            &format!("xi = {xi}"),
        );
    }
    assert_near(
        contact.dimensionless().settlement() / (theta0 * LN_2 + 0.5 * k),
        1.0,
        3e-3,
        "settlement",
    );
}

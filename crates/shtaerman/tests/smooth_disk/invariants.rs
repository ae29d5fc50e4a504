//! The limit of thin layers, scales, and conditions of contact.

use crate::smooth_disk::support::{A, MODULUS, close, pressed, problem, solve};
use shtaerman::{Profile, Solver};

#[test]
fn thin_layers_tend_to_it() {
    for profile in ["x^2", "2e-3*abs(x)", "1e4*x^4"] {
        let smooth = solve(profile, pressed(1e3));
        let mut before = [f64::INFINITY; 3];
        for theta0 in [1e2, 1e3, 1e4] {
            let chi = 2.0 * A / (std::f64::consts::PI * MODULUS * theta0);
            let base = Profile::expression(profile).unwrap();
            let rough = problem(base, chi, pressed(1e3), Solver::default()).solve().unwrap();
            let x = 0.5 * smooth.zones()[0][1];
            let errors = [
                rough.settlement() / smooth.settlement() - 1.0,
                rough.zones()[0][1] / smooth.zones()[0][1] - 1.0,
                rough.pressure(x).unwrap() / smooth.pressure(x).unwrap() - 1.0,
            ];
            for (error, before) in errors.iter().zip(before) {
                assert!(error.abs() < 0.25 * before, "{profile} {theta0}: {errors:?}");
            }
            before = errors.map(f64::abs);
        }
        assert!(before.iter().all(|error| *error < 0.02), "{before:?}");
    }
}

#[test]
fn a_place_whose_reciprocal_overflows_is_the_axis() {
    let contact = solve("1e-6*(1 - cos(300*x)) + 0.05*x^2", pressed(200.0)).dimensionless();
    let axis = contact.pressure(0.0).unwrap();
    for x in [5e-324, -1e-310, f64::MIN_POSITIVE, 1e-300, 1e-100] {
        close(contact.pressure(x).unwrap() / axis, 1.0, 1e-9, "pressure beside the axis");
    }
}

#[test]
fn conditions_of_contact() {
    let profile = "1e-6*(1 - cos(300*x)) + 0.05*x^2";
    let contact = solve(profile, pressed(200.0));
    let left = contact.complementarity().unwrap();
    assert!(left.tension < 1e-12 && left.penetration < 1e-12, "{left:?}");
    let edge = contact.zones()[0][1];
    assert!(edge < A);
    for i in 1..40 {
        let x = edge + (A - edge) * f64::from(i) / 40.0;
        assert!(contact.gap(x).unwrap() > 0.0);
    }
    // The force is that of the pressure: P = 2 pi int p r dr with r = c sin t
    let count = 2000;
    let step = std::f64::consts::FRAC_PI_2 / f64::from(count);
    let sum: f64 = (0..count)
        .map(|i| {
            let (sine, cosine) = ((f64::from(i) + 0.5) * step).sin_cos();
            contact.pressure(edge * sine).unwrap() * sine * cosine
        })
        .sum();
    close(2.0 * std::f64::consts::PI * edge * edge * sum * step, 200.0, 1e-6, "force");
}

#[test]
fn stiffness_is_the_slope_of_the_force() {
    let profile = "x^2 + 1e3*x^4";
    let contact = solve(profile, pressed(1e3));
    let step = 1e-4 * contact.settlement();
    let force = |by: f64| {
        solve(profile, crate::smooth_disk::support::sunk(contact.settlement() + by)).force()
    };
    let slope = (force(step) - force(-step)) / (2.0 * step);
    close(contact.stiffness().force_settlement, slope, 1e-7, "stiffness");
}

#[test]
fn the_displacement_is_that_of_the_pressure() {
    // u(r) = (4/(pi E*)) int p s K(2 sqrt(r s)/(r + s))/(r + s) ds by the arithmetic-geometric mean: K = pi/(2 agm(1, k'))
    let contact = solve("0.5*x^2 + 2e-4*max(abs(x) - 0.0005, 0)", pressed(800.0));
    let edge = contact.zones()[0][1];
    for r in [1.3 * edge, 4.0 * edge] {
        let count = 4000;
        let step = std::f64::consts::FRAC_PI_2 / f64::from(count);
        let sum: f64 = (0..count)
            .map(|i| {
                let (sine, cosine) = ((f64::from(i) + 0.5) * step).sin_cos();
                let s = edge * sine;
                let (mut one, mut two) = (1.0, (r - s) / (r + s));
                for _ in 0..30 {
                    (one, two) = (0.5 * (one + two), (one * two).sqrt());
                }
                contact.pressure(s).unwrap() * s * edge * cosine / (one * (r + s))
            })
            .sum();
        let exact = 2.0 / MODULUS * sum * step;
        close(contact.elastic_displacement(r), exact, 1e-5, "displacement");
    }
}

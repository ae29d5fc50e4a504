//! The profile for a prescribed pressure.

use crate::inverse::support::{bare, close, load, physical, unilateral};
use shtaerman::inverse::{Normalisation, prescribed_pressure};
use shtaerman::{
    Elastic, Foundation, Load, Problem, Profile, Punch, Rotational, Roughness, Solver, Vertical,
};

/// `int_-1^1 ln(1/|xi - eta|) deta`.
fn uniform(xi: f64) -> f64 {
    let term = |d: f64| if d > 0.0 { d * d.ln() } else { 0.0 };
    2.0 - term(1.0 - xi) - term(1.0 + xi)
}

#[test]
fn a_uniform_pressure_has_a_closed_form() {
    // P0 = 3: p0 = 3/2, f0 = theta0 p0 [U(0) - U(xi)]
    for theta0 in [0.0, 1.0, 300.0] {
        let problem = unilateral(theta0, "xi", load(3.0, 0.0));
        let shaped = prescribed_pressure(&problem, "7", Normalisation::Centre, 401).unwrap();
        for (xi, height) in shaped.places.iter().zip(&shaped.heights) {
            let exact = theta0 * 1.5 * (uniform(0.0) - uniform(*xi));
            assert!((height - exact).abs() <= 2e-14 * theta0, "{xi}: {height} {exact}");
        }
        close(shaped.factor, 1.5 / 7.0, 1e-14);
        close(shaped.settlement, 1.5 + theta0 * 3.0, 1e-14);
        assert!(shaped.moment.abs() < 1e-14 && shaped.tilt == 0.0);
        // Edges above the centre: the lowest point is the centre, too.
        let lowest = prescribed_pressure(&problem, "7", Normalisation::Lowest, 401).unwrap();
        assert!(lowest.heights.iter().all(|height| *height >= 0.0));
    }
}

#[test]
fn hertz_gives_the_parabola() {
    // Smooth: sqrt(1 - xi^2) with p_max = E* a/(2R) belongs to x^2/(2R).
    let (half_width, radius) = (5e-3, 0.7);
    let body = Elastic::new(200e9, 0.3).unwrap();
    let (foundation, punch) = (Foundation::new(body), Punch::new(half_width).unwrap());
    let contact_modulus = body.plane_strain_modulus();
    let force = std::f64::consts::PI * contact_modulus * half_width * half_width / (4.0 * radius);
    let problem = Problem::new(foundation, punch, load(force, 0.0)).unwrap();
    let shaped =
        prescribed_pressure(&problem, "sqrt(1 - xi^2)", Normalisation::Centre, 101).unwrap();
    let top = half_width * half_width / (2.0 * radius);
    for (x, height) in shaped.places.iter().zip(&shaped.heights) {
        assert!((height - x * x / (2.0 * radius)).abs() < 1e-12 * top, "{x}: {height}");
    }
    close(shaped.factor, contact_modulus * half_width / (2.0 * radius), 1e-13);
}

/// The profile as a trace, solved again.
fn round_trip(problem: &Problem, pressure: &str, count: usize) -> f64 {
    let shaped = prescribed_pressure(problem, pressure, Normalisation::Centre, count).unwrap();
    let trace = Profile::from_points(shaped.places.clone(), shaped.heights.clone()).unwrap();
    let contact = problem.with_profile(trace).unwrap().solve().unwrap();
    let largest = shaped.pressures.iter().fold(0.0f64, |most, p| most.max(*p));
    close(contact.settlement(), shaped.settlement, 1e-6);
    (shaped.places.iter().zip(&shaped.pressures))
        .map(|(x, p)| (contact.pressure(*x).unwrap() - p).abs() / largest)
        .fold(0.0, f64::max)
}

#[test]
fn solving_the_trace_gives_the_pressure_back() {
    let problem = physical(200e9, 1.2e-13, 5e-3, "0", load(8e5, 0.0));
    for (pressure, worst) in
        [("1", 3e-6), ("(1 - xi^2)^2 + 0.1", 3e-6), ("1 + 0.3*cos(4*xi)", 3e-6)]
    {
        let error = round_trip(&problem, pressure, 1001);
        assert!(error < worst, "{pressure}: {error:e}");
    }
    // Off centre.
    let eccentric = Load::new(Vertical::Force(8e5), Rotational::Eccentricity(5e-3 / 6.0)).unwrap();
    let error = round_trip(&problem.with_load(eccentric).unwrap(), "1 + xi/2", 1001);
    assert!(error < 3e-6, "{error:e}");
}

#[test]
fn a_power_law_and_a_tilt_enter() {
    let problem = physical(200e9, 1.2e-13, 5e-3, "0", load(8e5, 0.0));
    let power = problem.with_roughness(Roughness::power(1e-9, 0.5).unwrap()).unwrap();
    let plain = prescribed_pressure(&problem, "2 + xi^2", Normalisation::Centre, 11).unwrap();
    let bent = prescribed_pressure(&power, "2 + xi^2", Normalisation::Centre, 11).unwrap();
    let tilt = Load::new(Vertical::Force(8e5), Rotational::Tilt(1e-3)).unwrap();
    let tilted = problem.with_load(tilt).unwrap();
    let turned = prescribed_pressure(&tilted, "2 + xi^2", Normalisation::Centre, 11).unwrap();
    let middle = plain.pressures[5];
    for i in 0..11 {
        let p = plain.pressures[i];
        let layers = 1.2e-13 * (p - middle) - 1e-9 * (p.sqrt() - middle.sqrt());
        let size = plain.heights[0].abs();
        assert!((bent.heights[i] - plain.heights[i] - layers).abs() < 1e-12 * size);
        let turn = -1e-3 * plain.places[i];
        assert!((turned.heights[i] - plain.heights[i] - turn).abs() < 1e-12 * size);
    }
}

#[test]
fn a_pressure_that_does_not_fit_is_refused() {
    let problem = physical(200e9, 1.2e-13, 5e-3, "0", load(8e5, 0.0));
    for (pressure, said) in [
        ("1 - 2*xi^2", "pulls at x ="),
        ("xi", "carries no force"),
        ("0", "carries no force"),
        ("1/xi", "must be finite"),
        ("1/sqrt(1 - xi^2)", "must be finite"),
        ("1 + xi/2", "acts at an eccentricity of 833.333 µm, the load at 0"),
        ("where(xi < 0.2, 1, 2)", "jumps at x = 1 mm"),
        ("1 +", "`1 +`"),
        ("y", "`y`"),
    ] {
        let error =
            prescribed_pressure(&problem, pressure, Normalisation::Centre, 101).unwrap_err();
        assert!(error.to_string().contains(said), "{pressure}: {error}");
        assert!(!error.is_numerical());
    }
    // Without a sign to keep a pull is a pressure like any other.
    let bilateral = bare(1.0, "0", load(1.0, 0.0), Solver::bilateral());
    assert!(prescribed_pressure(&bilateral, "2 - 3*xi^2", Normalisation::Centre, 11).is_ok());
    assert!(prescribed_pressure(&problem, "1", Normalisation::Centre, 2).is_err());
}

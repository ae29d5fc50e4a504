//! Problems in units, with roughness 0.

use std::f64::consts::{LN_2, PI};

use crate::smooth::support::close;
use shtaerman::{
    Contact, Elastic, Foundation, Geometry, Load, Problem, Profile, Punch, Rotational, Solver,
    Vertical,
};

/// A problem in newtons, metres and pascals on steel, `E* = E/(1 - nu^2)`.
fn solve(geometry: Geometry, profile: Profile, load: Load, solver: Solver) -> Contact {
    let steel = Elastic::new(200e9, 0.3).unwrap();
    let (foundation, punch) = (
        Foundation::new(steel).with_roughness(0.0).unwrap(),
        Punch::in_geometry(geometry, 5e-3).unwrap(),
    );
    Problem::new(foundation, punch.with_profile(profile), load)
        .unwrap()
        .with_solver(solver)
        .solve()
        .unwrap()
}

const MODULUS: f64 = 200e9 / (1.0 - 0.3 * 0.3);

fn force(force: f64) -> Load {
    Load::new(Vertical::Force(force), Rotational::Moment(0.0)).unwrap()
}

#[test]
fn hertz_in_units() {
    // R = 0.8 m: a^2 = 4 P R/(pi E*)
    let profile = Profile::expression("x^2/(2*0.8)").unwrap();
    let contact = solve(Geometry::Plane, profile, force(0.4e6), Solver::default());
    let a = (4.0 * 0.4e6 * 0.8 / (PI * MODULUS)).sqrt();
    close(contact.zones()[0][1], a, 1e-12, "width");
    close(contact.pressure(0.0).unwrap(), 2.0 * 0.4e6 / (PI * a), 1e-12, "peak");
    close(contact.peak_pressure(), 2.0 * 0.4e6 / (PI * a), 1e-9, "peak");
    assert_eq!(contact.pressure_left(), 0.0);
}

#[test]
fn many_crests_are_lines_of_hertz() {
    // f = h cos(k x) + c x^2: zones far shorter than the waves, p = E* b h k^2/2 in the middle of each, P = pi b p/2
    let (amplitude, sag, total) = (1e-6, 1e-3, 1e3);
    for (crests, fewest) in [(60, 20), (110, 40)] {
        let wave_number = 2.0 * PI * f64::from(crests) / 5e-3;
        let profile = format!("{amplitude}*cos({wave_number}*x) + {sag}*x^2");
        let profile = Profile::expression(&profile).unwrap();
        let contact = solve(Geometry::Plane, profile, force(total), Solver::default());
        assert!(contact.zones().len() >= fewest, "{}", contact.zones().len());
        let mut carried = 0.0;
        for [left, right] in contact.zones() {
            let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
            let pressure = contact.pressure(middle).unwrap();
            let curvature = amplitude * wave_number * wave_number;
            close(pressure, 0.5 * MODULUS * half * curvature, 1e-3, "peak of a crest");
            carried += 0.5 * PI * half * pressure;
            // Between a crest and the next it stays clear.
            let beside = contact.gap(middle + 0.25 * PI / wave_number);
            assert!(beside.unwrap() > 0.0);
        }
        close(carried, total, 1e-3, "force");
    }
}

#[test]
fn a_measured_parabola() {
    let places: Vec<f64> = (0..=2000).map(|i| 5e-3 * (f64::from(i) / 1000.0 - 1.0)).collect();
    let heights = places.iter().map(|x| x * x / (2.0 * 0.8)).collect();
    let profile = Profile::from_points(places, heights).unwrap();
    let contact = solve(Geometry::Plane, profile, force(0.4e6), Solver::default());
    let a = (4.0 * 0.4e6 * 0.8 / (PI * MODULUS)).sqrt();
    close(contact.zones()[0][1], a, 1e-9, "width");
}

#[test]
fn a_flat_punch_in_units() {
    for solver in [Solver::default(), Solver::bilateral()] {
        let contact = solve(Geometry::Plane, Profile::flat(), force(1e6), solver);
        close(contact.settlement(), 2.0 * 1e6 * LN_2 / (PI * MODULUS), 1e-13, "settlement");
        assert_eq!(contact.pressure_right(), f64::INFINITY);
        close(contact.pressure(3e-3).unwrap(), 1e6 / (PI * 4e-3), 1e-13, "pressure");
    }
}

#[test]
fn a_pair_and_a_row_in_units() {
    let pair = Geometry::Pair { inner_half_gap: 1e-3 };
    let contact = solve(pair, Profile::flat(), force(1e6), Solver::default());
    let [a, b, x] = [5e-3, 1e-3, 3e-3f64];
    let exact = 1e6 * x / (PI * ((a * a - x * x) * (x * x - b * b)).sqrt());
    close(contact.pressure(x).unwrap(), exact, 1e-11, "pair");
    let row = Geometry::Periodic { period: 15e-3 };
    let contact = solve(row, Profile::flat(), force(1e6), Solver::default());
    let s = (PI / 3.0).sin();
    let psi = PI * x / 15e-3;
    let exact = 1e6 / 15e-3 * psi.cos() / (s * s - psi.sin().powi(2)).sqrt();
    close(contact.pressure(x).unwrap(), exact, 1e-11, "row");
}

#[test]
fn a_wave_in_units() {
    // p* = pi E* h/L; full contact at twice that
    let profile = Profile::expression("-1e-6*cos(pi*x/5e-3)").unwrap();
    let limit = PI * MODULUS * 1e-6 / 10e-3;
    let wave = Geometry::Periodic { period: 10e-3 };
    let load = |mean: f64| Load::new(Vertical::Force(mean * 10e-3), Rotational::Tilt(0.0)).unwrap();
    let contact = solve(wave, profile.clone(), load(2.0 * limit), Solver::default());
    close(contact.pressure(0.0).unwrap(), 3.0 * limit, 1e-12, "full");
    let contact = solve(wave, profile, load(0.3 * limit), Solver::default());
    let width = 10e-3 / PI * 0.3f64.sqrt().asin();
    close(contact.zones()[0][1], width, 1e-11, "partial");
}

/// A cylinder whose heights are computed with 20 m taken off them, under a given settlement: pressure, force and edges are known as far as these heights are.
#[test]
fn a_settlement_is_known_as_far_as_heights_are() {
    // E* and b of the circle by its integrals over the arcsine density, mpmath with 30 digits.
    for (settlement, edge, pressure) in [
        (3e-7, 0.002_530_341_071_034_786_3, 13_902_972.973_408_26),
        (5e-7, 0.003_637_979_563_585_407_6, 19_988_898.866_363_09),
    ] {
        let profile = Profile::expression("20 - sqrt(20^2 - x^2)").unwrap();
        let load = Load::new(Vertical::Settlement(settlement), Rotational::Tilt(0.0)).unwrap();
        let contact = solve(Geometry::Plane, profile, load, Solver::default());
        let scaling = *contact.problem().scaling().unwrap();
        let error = (contact.pressure(0.0).unwrap() - pressure).abs();
        let stated = contact.dimensionless().error().unwrap().pressure * scaling.pressure();
        assert!(error <= stated && stated < 1e-6 * pressure, "{error:e} {stated:e}");
        let error = (contact.zones()[0][1] - edge).abs() / 5e-3;
        let stated = contact.dimensionless().error().and_then(|error| error.zones).unwrap();
        assert!(error <= stated && stated < 1e-6, "{error:e} {stated:e}");
    }
}

/// The same base in a form that keeps its digits, under a pair and in a row, and on ground whose modulus grows with the depth.
#[test]
fn two_forms_of_a_base_agree_within_their_errors() {
    let steel = Elastic::new(200e9, 0.3).unwrap();
    let pair = Geometry::Pair { inner_half_gap: 1e-3 };
    for geometry in [Geometry::Plane, pair, Geometry::Periodic { period: 0.02 }] {
        let load = Load::new(Vertical::Settlement(4e-7), Rotational::Tilt(0.0)).unwrap();
        let [spoilt, kept] = ["20 - sqrt(20^2 - x^2)", "x^2/(20 + sqrt(20^2 - x^2))"].map(|text| {
            let (foundation, punch) = (
                Foundation::new(steel).with_roughness(0.0).unwrap(),
                Punch::in_geometry(geometry, 5e-3).unwrap(),
            );
            let profile = Profile::expression(text).unwrap();
            Problem::new(foundation, punch.with_profile(profile), load).unwrap().solve().unwrap()
        });
        let stated = |of: fn(&Contact) -> f64| of(&spoilt) + of(&kept);
        let allowed = stated(|contact| contact.dimensionless().error().unwrap().pressure);
        for xi in [0.25, -0.3, 0.35] {
            let difference = (spoilt.dimensionless().pressure(xi).unwrap()
                - kept.dimensionless().pressure(xi).unwrap())
            .abs();
            assert!(difference <= allowed, "{geometry:?} at {xi}: {difference:e} {allowed:e}");
        }
        let allowed = stated(|contact| {
            contact.dimensionless().error().and_then(|error| error.zones).unwrap_or(0.0)
        });
        for (one, other) in spoilt
            .dimensionless()
            .zones()
            .iter()
            .flatten()
            .zip(kept.dimensionless().zones().iter().flatten())
        {
            assert!((one - other).abs() <= allowed, "{geometry:?}: {one} {other} {allowed:e}");
        }
    }
}

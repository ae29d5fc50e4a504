//! Inverse problems in the other geometries.

use std::f64::consts::PI;

use crate::inverse::support::{close, load};
use shtaerman::inverse::{
    Goal, InverseError, Normalisation, crown, force, prescribed_pressure, roughness,
};
use shtaerman::{Elastic, Error, Foundation, Geometry, Problem, Profile, Punch, Roughness};

fn problem(
    geometry: Geometry,
    roughness: impl Into<Roughness>,
    profile: &str,
    force: f64,
) -> Problem {
    let foundation = Elastic::new(0.91, 0.3).unwrap();
    let (foundation, punch) = (
        Foundation::new(foundation).with_roughness(roughness).unwrap(),
        Punch::in_geometry(geometry, 1.0).unwrap(),
    );
    Problem::new(
        foundation,
        punch.with_profile(Profile::expression(profile).unwrap()),
        load(force, 0.0),
    )
    .unwrap()
}

/// `chi E*/a`: so rough that elasticity does not show, or only by a known share.
const LAYER: f64 = 1e6;

#[test]
fn a_layer_under_a_disk_has_closed_forms() {
    // chi p = c (w^2 - r^2): peak q = c w^2/chi, P = pi c w^4/(2 chi)
    let problem = problem(Geometry::Circular, LAYER, "x^2/2*1e3", 1e-4);
    let c = 500.0;
    let width = 0.8f64;
    let exact = 0.5 * PI * c * (0.5 * width).powi(4) / LAYER;
    close(force(&problem, Goal::ContactWidth(width)).unwrap().value, exact, 1e-5);
    let peak = c * (0.5 * width).powi(2) / LAYER;
    close(force(&problem, Goal::PeakPressure(peak)).unwrap().value, exact, 1e-5);
    let under = problem.with_load(load(exact, 0.0)).unwrap();
    close(roughness(&under, Goal::ContactWidth(0.8)).unwrap().value, LAYER, 1e-5);
}

#[test]
fn a_layer_under_a_row_has_closed_forms() {
    // Without elasticity neighbours do not matter: P = 4/3 c w^3/chi.
    let problem = problem(Geometry::Periodic { period: 2.5 }, LAYER, "x^2/2*1e3", 1e-4);
    let exact = 4.0 / 3.0 * 500.0 * 0.4f64.powi(3) / LAYER;
    close(force(&problem, Goal::ContactWidth(0.8)).unwrap().value, exact, 1e-5);
}

#[test]
fn a_power_law_alone_has_closed_forms() {
    // B sqrt(p) = c (w^2 - x^2): p = (c/B)^2 (w^2 - x^2)^2, P = (c/B)^2 16/15 w^5
    let law = Roughness::power(LAYER, 0.5).unwrap();
    let problem = problem(Geometry::Plane, law, "x^2/2*1e3", 1e-7);
    let (c, width) = (500.0 / LAYER, 0.8f64);
    let exact = 16.0 / 15.0 * c * c * (0.5 * width).powi(5);
    close(force(&problem, Goal::ContactWidth(width)).unwrap().value, exact, 1e-5);
    let under = problem.with_load(load(exact, 0.0)).unwrap();
    let found = roughness(&under, Goal::ContactWidth(width)).unwrap();
    close(found.value, LAYER, 1e-5);
    assert_eq!(found.contact.problem().foundation().law(), law.law());
    // A uniform pressure needs no more of a power law than of a linear one.
    let shaped = prescribed_pressure(&problem, "1", Normalisation::Centre, 33).unwrap();
    let plain = problem.with_roughness(3.0).unwrap();
    let linear = prescribed_pressure(&plain, "1", Normalisation::Centre, 33).unwrap();
    for (one, two) in shaped.heights.iter().zip(&linear.heights) {
        assert!((one - two).abs() < 1e-9 * shaped.settlement, "{one} {two}");
    }
}

#[test]
fn every_geometry_has_its_crown() {
    for geometry in [
        Geometry::Plane,
        Geometry::Circular,
        Geometry::Periodic { period: 3.0 },
        Geometry::Pair { inner_half_gap: 0.4 },
    ] {
        let problem = problem(geometry, 0.05, "0", 1e-3);
        let found = crown(&problem, None).unwrap();
        let flat = problem.solve().unwrap().peak_pressure();
        let best = found.best.contact.peak_pressure();
        assert!(found.best.radius.is_some() && best < flat, "{geometry:?}");
        let least = crown(&problem, Some(flat)).unwrap().least.unwrap();
        close(least.contact.peak_pressure(), flat, 1e-11);
    }
}

#[test]
fn a_profile_for_a_pressure_is_that_of_one_plane_punch() {
    for geometry in [Geometry::Circular, Geometry::Periodic { period: 3.0 }] {
        let problem = problem(geometry, 0.05, "0", 1e-3);
        let error = prescribed_pressure(&problem, "1", Normalisation::Centre, 33).unwrap_err();
        assert!(matches!(error, Error::Inverse(InverseError::Unsuited(_))), "{error}");
    }
}

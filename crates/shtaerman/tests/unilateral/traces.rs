//! Measured traces of any length against product integration (`data/traces.py`).

use serde::Deserialize;
use shtaerman::{
    Contact, Foundation, Geometry, Load, Problem, Profile, Punch, Rotational, Solver, Vertical,
};

#[derive(Deserialize)]
struct Data {
    rows: Vec<Row>,
}

#[derive(Deserialize)]
struct Row {
    theta0: f64,
    load: Given,
    xi: Vec<f64>,
    heights: Vec<f64>,
    inner_half_gap: Option<f64>,
    answer: Answer,
}

#[derive(Deserialize)]
struct Given {
    force: Option<f64>,
    settlement: Option<f64>,
    moment: Option<f64>,
    tilt: Option<f64>,
    eccentricity: Option<f64>,
}

#[derive(Deserialize)]
struct Answer {
    zones: Vec<[f64; 2]>,
    settlement: f64,
    tilt: f64,
    force: f64,
    moment: f64,
    places: Vec<f64>,
    pressures: Vec<f64>,
}

fn rows() -> Vec<Row> {
    serde_json::from_str::<Data>(include_str!("../data/traces.json")).unwrap().rows
}

fn solve(row: &Row, solver: Solver) -> Contact {
    let vertical = match (row.load.force, row.load.settlement) {
        (Some(force), _) => Vertical::Force(force),
        (None, settlement) => Vertical::Settlement(settlement.unwrap()),
    };
    let rotational = match (row.load.moment, row.load.eccentricity) {
        (Some(moment), _) => Rotational::Moment(moment),
        (_, Some(e)) => Rotational::Eccentricity(e),
        _ => Rotational::Tilt(row.load.tilt.unwrap()),
    };
    let load = Load::new(vertical, rotational).unwrap();
    let profile = Profile::from_points(row.xi.clone(), row.heights.clone()).unwrap();
    let geometry = row
        .inner_half_gap
        .map_or(Geometry::Plane, |inner_half_gap| Geometry::Pair { inner_half_gap });
    let (foundation, punch) = (
        Foundation::dimensionless(row.theta0).unwrap(),
        Punch::in_geometry(geometry, 1.0).unwrap(),
    );
    let problem = Problem::new(foundation, punch.with_profile(profile), load).unwrap();
    problem.with_solver(solver).solve().unwrap()
}

/// That the answer is as far off as it says, at most.
fn assert_as_stated(contact: &Contact, truth: &Answer, head: &str) {
    let contact = contact.dimensionless();
    let error = contact.error().unwrap();
    // The truth is rounded, too.
    let rounding = 2e-14 * (1.0 + truth.settlement.abs());
    for (name, found, known, stated) in [
        ("settlement", contact.settlement(), truth.settlement, error.settlement),
        ("tilt", contact.tilt(), truth.tilt, error.tilt),
        ("force", contact.force(), truth.force, error.force),
        ("moment", contact.moment(), truth.moment, error.moment),
    ] {
        let off = (found - known).abs();
        assert!(off <= stated + rounding, "{head}: {name} {off:e} {stated:e}");
    }
    for (xi, known) in truth.places.iter().zip(&truth.pressures) {
        let (off, stated) = ((contact.pressure(*xi).unwrap() - known).abs(), error.pressure);
        assert!(off <= stated + rounding, "{head}: pressure at {xi} {off:e} {stated:e}");
    }
}

#[test]
fn short_traces_are_as_exact_as_stated_and_that_is_exact() {
    let mut counts = Vec::new();
    for row in rows() {
        let (contact, truth) = (solve(&row, Solver::default()), &row.answer);
        let head = format!("theta0 = {}, {} points", row.theta0, row.xi.len());
        let error = contact.dimensionless().error().unwrap();
        let largest = truth.pressures.iter().fold(0.0f64, |most, p| most.max(*p));
        let aim = 1e-10 * (row.theta0 / 100.0).max(1.0);
        assert!(error.pressure <= aim * largest, "{head}: {:e}", error.pressure);
        assert_as_stated(&contact, truth, &head);
        assert_eq!(contact.dimensionless().zones().len(), truth.zones.len(), "{head}");
        let edges = contact.dimensionless().zones();
        for (one, other) in edges.iter().flatten().zip(truth.zones.iter().flatten()) {
            assert!((one - other).abs() < 1e-12, "{head}: {one} {other}");
        }
        counts.push(truth.zones.len());
    }
    assert!(counts.contains(&1) && counts.iter().any(|count| *count >= 6), "{counts:?}");
}

#[test]
fn what_ends_at_a_tolerance_is_as_exact_as_stated() {
    let mut nodes = [0; 2];
    for row in rows() {
        let full = solve(&row, Solver::default());
        for tolerance in [1e-3, 1e-6, 1e-8] {
            let contact = solve(&row, Solver::default().with_tolerance(tolerance).unwrap());
            let head = format!("theta0 = {}, {} points, {tolerance}", row.theta0, row.xi.len());
            assert_as_stated(&contact, &row.answer, &head);
            assert!(contact.relative_error() <= tolerance, "{head}");
            nodes[0] += contact.method().n;
            nodes[1] += full.method().n;
        }
    }
    // It pays: of panels three in five of the nodes.
    assert!(10 * nodes[0] < 8 * nodes[1], "{nodes:?}");
}

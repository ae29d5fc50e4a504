//! Both discretisations against each other, and panels against what must hold.

use super::*;
use crate::{Foundation, Load, Problem, Profile, Punch, Rotational, Vertical};

fn problem([theta0, exponent]: [f64; 2], profile: &str, rotational: Rotational) -> Problem {
    let foundation = Foundation::dimensionless(theta0).unwrap().with_exponent(exponent).unwrap();
    let punch = Punch::new(1.0).unwrap().with_profile(Profile::expression(profile).unwrap());
    let load = Load::new(Vertical::Force(1.0), rotational).unwrap();
    Problem::new(foundation, punch, load).unwrap()
}

fn base(problem: &Problem) -> Base {
    Base::new(&Setting::new(problem), ContactKind::Unilateral).unwrap()
}

fn assert_within(name: &str, a: f64, b: f64, most: f64) {
    assert!((a - b).abs() <= most, "{name}: {a} {b}, {most:e}");
}

/// Compares with collocation, where that finds the zones: within small bounds, and within what both state. The number of zones.
fn agrees(law: [f64; 2], problem: &Problem) -> Option<usize> {
    let found = on_panels(&base(problem)).unwrap();
    let exact = Way::Collocation(Effort::MOST).solve(&base(problem)).ok()?;
    let errors = [found.accuracy().unwrap(), exact.accuracy().unwrap()];
    let stated = |of: fn(&crate::contact::Accuracy) -> f64| of(errors[0]) + of(errors[1]);
    let (one, other) = (found.state(), exact.state());
    // What is added up in a displacement.
    let size = found.size().powf(law[1]) + one.settlement.abs() + one.tilt.abs();
    for (a, b, stated) in [
        (one.settlement, other.settlement, stated(|error| error.settlement)),
        (one.tilt, other.tilt, stated(|error| error.tilt)),
        (one.force, other.force, stated(|error| error.force)),
        (one.moment, other.moment, stated(|error| error.moment)),
    ] {
        assert_within("state", a, b, stated.min(1e-11 * size));
    }
    let (zones, known) = (found.zones(), exact.zones());
    assert_eq!(zones.len(), known.len());
    let edge = found.edge_error().unwrap_or(0.0) + exact.edge_error().unwrap_or(0.0);
    for (a, b) in zones.iter().flatten().zip(known.iter().flatten()) {
        assert_within("edge", *a, *b, (2.0 * edge + f64::EPSILON).min(1e-10));
    }
    let pressure = stated(|error| error.pressure).min(1e-10 * exact.size());
    for i in 0..=3000 {
        let xi = (f64::from(i) / 1500.0 - 1.0).clamp(-1.0, 1.0);
        assert_within("pressure", found.pressure(xi), exact.pressure(xi), pressure);
        assert_within("displacement", found.displacement(xi), exact.displacement(xi), 1e-11 * size);
    }
    assert!(found.relative_error() < 1e-9, "{errors:?}");
    let (one, other) = (found.stiffness().matrix(), exact.stiffness().matrix());
    let error = found.stiffness_error().unwrap().force_settlement;
    for (a, b) in one.as_flattened().iter().zip(other.as_flattened()) {
        // The responses have d ln d at free edges, for which the panels are not made.
        assert_within("stiffness", *a, *b, (error + 1e-13 * other[0][0]).min(1e-8 * other[0][0]));
    }
    let (peak, load) = (0.3 * zones[0][0] + 0.7 * zones[0][1], problem.dimensionless_load());
    let [one, other] =
        [&found as &dyn Solution, exact.as_ref()].map(|s| s.linearised(load, peak).unwrap());
    let errors = one.errors.as_flattened().iter().zip(other.errors.as_flattened());
    let rates = one.rates.as_flattened().iter().zip(other.rates.as_flattened());
    for ((a, b), (one, other)) in rates.zip(errors) {
        assert_within("rate", *a, *b, one + other + 1e-12 * b.abs() + 1e-14);
    }
    Some(zones.len())
}

#[test]
fn a_layer_that_bends_agrees_with_collocation() {
    // Free ends on both sides, one, none; kinks; several zones; soft and firm ground.
    for (theta0, exponent, profile, moment, zones) in [
        (2.0, 0.5, "xi^2", 0.05, 1),
        (0.3, 0.7, "abs(xi - 0.2)", 0.1, 1),
        (5.0, 0.3, "3*cos(9*xi) + xi^2", 0.0, 4),
        (40.0, 0.9, "60*xi^2 + 3*abs(xi)", 0.0, 1),
        (1.0, 0.4, "0.1*xi^2", 0.1, 1),
    ] {
        let law = [theta0, exponent];
        let found = agrees(law, &problem(law, profile, Rotational::Moment(moment)));
        assert_eq!(found, Some(zones), "{theta0} {exponent} {profile}");
    }
}

#[test]
fn collocation_agrees_in_several_zones() {
    let waves = [(0.5, 11), (0.5, 23), (2.0, 29), (5.0, 17), (20.0, 11), (20.0, 23), (20.0, 31)];
    let steeper = [(50.0, 31), (150.0, 31), (150.0, 45)];
    let count = |(theta0, waves): (f64, i32)| {
        let size = 2.0 * (1.0 + theta0);
        let profile = format!("{size}*(0.4*xi^2 + 0.1*cos({waves}*xi + 0.4))");
        agrees([theta0, 1.0], &problem([theta0, 1.0], &profile, Rotational::Moment(0.1)))
    };
    // Collocation does not find all zones of all of these.
    let counts: Vec<usize> = waves.into_iter().chain(steeper).filter_map(count).collect();
    assert!(counts.len() >= 3 && counts.iter().any(|count| *count >= 4), "{counts:?}");
}

#[test]
fn collocation_agrees_at_corners_and_steps() {
    let flat = problem([30.0, 1.0], "0", Rotational::Eccentricity(0.6));
    assert_eq!(agrees([30.0, 1.0], &flat), Some(1));
    let profile = "xi^2 + where(xi > 0.3, 8, 0)";
    let step = problem([3.0, 1.0], profile, Rotational::Moment(-0.1));
    assert!(agrees([3.0, 1.0], &step).is_some());
}

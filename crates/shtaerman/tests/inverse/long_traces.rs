//! Measured profiles on panels: the load and displacements against a rule of their own, sensitivities against differences of complete solves, what a force leads to when that is prescribed, and gaps that no sample shows.

use shtaerman::{
    Complementarity, Foundation, Load, MethodName, Problem, Profile, Punch, Rotational, Vertical,
};

const FORCED: Vertical = Vertical::Force(1.0);

fn problem(theta0: f64, profile: Profile, vertical: Vertical, rotational: Rotational) -> Problem {
    let foundation = Foundation::dimensionless(theta0).unwrap();
    let punch = Punch::new(1.0).unwrap().with_profile(profile);
    Problem::new(foundation, punch, Load::new(vertical, rotational).unwrap()).unwrap()
}

/// A trace with waves of many lengths.
fn trace(points: i32, theta0: f64) -> Profile {
    let positions = (0..points).map(|i| 2.0 * f64::from(i) / f64::from(points - 1) - 1.0);
    let wave = |x: f64, k: f64| k.powf(-1.5) * (3.1 * k * x + k * k).sin();
    let waves = |x: f64| (1..=60).map(|k| wave(x, f64::from(k))).sum::<f64>();
    let height = |x: f64| 2.0 * (1.0 + theta0) * (0.3 * x * x + 0.3 * waves(x));
    Profile::from_points(positions.clone().collect(), positions.map(height).collect()).unwrap()
}

fn assert_within(name: &str, a: f64, b: f64, most: f64) {
    assert!((a - b).abs() <= most, "{name}: {a} {b}, {most:e}");
}

#[test]
fn rates_on_panels_agree_with_differences() {
    for (theta0, vertical, rotational) in [
        (30.0, FORCED, Rotational::Moment(0.2)),
        (3.0, Vertical::Settlement(2.0), Rotational::Tilt(0.3)),
    ] {
        let problem = problem(theta0, trace(1100, theta0), vertical, rotational);
        let contact = problem.solve().unwrap();
        let tangent = contact.tangent_sensitivities().unwrap();
        assert_eq!(contact.method().name, MethodName::Panels);
        assert_eq!(contact.sensitivities().unwrap(), tangent);
        let other = contact.difference_sensitivities().unwrap();
        let known = [
            (tangent.settlement, other.settlement, contact.settlement()),
            (tangent.force, other.force, contact.force()),
            (tangent.tilt, other.tilt, contact.tilt()),
            (tangent.peak_pressure, other.peak_pressure, contact.peak_pressure()),
            (Some(tangent.contact_width), Some(other.contact_width), contact.contact_width()),
        ];
        for (one, other, value) in known {
            let (Some(one), Some(other)) = (one, other) else { continue };
            let pairs = [
                (one.theta0, other.theta0, theta0),
                (one.force, other.force, contact.force()),
                (one.settlement, other.settlement, contact.settlement()),
            ];
            let both = pairs.iter().filter_map(|(a, b, at)| Some(((*a)? * at, (*b)? * at)));
            let both: Vec<(f64, f64)> = both.collect();
            let size = both.iter().fold(value.abs(), |most, (a, _)| most.max(a.abs()));
            assert!(both.len() == 2 && one.error < 1e-5, "{one:?}");
            for (a, b) in both {
                assert_within("rate", a, b, 2.0 * (one.error + other.error) * size);
            }
        }
    }
}

#[test]
fn a_gap_narrower_than_the_samples_parts_a_zone() {
    // Between two of 10,000 points the base lifts off, far from the middle between the places that are looked at.
    let positions: Vec<f64> = (0..10_000).map(|i| 2.0 * f64::from(i) / 9999.0 - 1.0).collect();
    let height = |(i, x): (usize, &f64)| {
        let wave = |k: f64| 0.5 * k.powf(-1.5) * (3.1 * k * x + k * k).sin();
        let waves: f64 = (1..=100).map(|k| wave(f64::from(k))).sum();
        4.0 * (0.3 * x * x + waves + 0.005 * (1e4 * (i as f64).sin()).fract())
    };
    let heights = positions.iter().enumerate().map(height).collect();
    let profile = Profile::from_points(positions, heights).unwrap();
    let found = problem(1.0, profile, FORCED, Rotational::Moment(0.2)).solve().unwrap();
    assert_eq!(found.zones().len(), 34);
    let Complementarity { tension, penetration } = found.complementarity().unwrap();
    assert!(tension < 1e-12 && penetration < 1e-12, "{tension:e} {penetration:e}");
}

#[test]
fn what_comes_out_may_be_prescribed() {
    for (theta0, force, e) in [(30.0, 1.0, 0.1), (2.0, 0.4, -0.3)] {
        let arm = Rotational::Eccentricity(e);
        let held = |vertical, rotational| {
            problem(theta0, trace(1200, theta0), vertical, rotational).solve().unwrap()
        };
        let free = held(Vertical::Force(force), arm);
        let (given, known) = (free.dimensionless(), free.dimensionless().error().unwrap());
        assert_within("moment", given.moment(), e * force, 1e-14);
        let settled = Vertical::Settlement(given.settlement());
        let both = held(settled, Rotational::Tilt(given.tilt()));
        assert_within("force", both.dimensionless().force(), force, 1e-10);
        assert_within("moment", both.dimensionless().moment(), e * force, 1e-10);
        for (one, other) in free.zones().iter().flatten().zip(both.zones().iter().flatten()) {
            assert_within("edge", *one, *other, 1e-11);
        }
        // A settlement with an eccentricity is found by a search of its own.
        let contact = held(settled, arm);
        let (found, stated) = (contact.dimensionless(), contact.dimensionless().error().unwrap());
        assert_eq!(contact.method().name, MethodName::Panels);
        assert_eq!(found.zones().len(), free.zones().len());
        assert_within("force", found.force(), force, stated.force + 1e-13 * force);
        assert_within("moment", found.moment(), e * force, stated.moment + 1e-13 * force);
        assert_within("tilt", found.tilt(), given.tilt(), stated.tilt + known.tilt);
        // The rates are the inverse of those under the force.
        let [by_settlement, by_force] =
            [&contact, &free].map(|contact| contact.tangent_sensitivities().unwrap());
        let stiffness = by_settlement.force.unwrap().settlement.unwrap();
        let compliance = by_force.settlement.unwrap().force.unwrap();
        assert_within("rate", stiffness * compliance, 1.0, 1e-8);
    }
}

#[test]
fn force_moment_and_displacement_agree_with_a_rule_of_their_own() {
    let problem = problem(8.0, trace(1000, 8.0), FORCED, Rotational::Moment(0.2));
    let found = problem.solve().unwrap();
    assert_eq!(found.method().name, MethodName::Panels);
    let Complementarity { tension, penetration } = found.complementarity().unwrap();
    assert!(tension < 1e-12 && penetration < 1e-12, "{tension:e} {penetration:e}");
    let zones = found.zones();
    let inside = 0.6 * zones[3][0] + 0.4 * zones[3][1];
    let beside = 0.3 * zones[3][1] + 0.7 * zones[4][0];
    let joints = (0..1000).map(|i| 2.0 * f64::from(i) / 999.0 - 1.0);
    let (mut force, mut moment, mut displaced) = (0.0, 0.0, [0.0, 0.0]);
    for [left, right] in zones {
        let mut cuts: Vec<f64> = joints.clone().chain([inside]).collect();
        cuts.retain(|at| *at > left && *at < right);
        cuts.extend([left, right]);
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.windows(2) {
            let half = 0.5 * (pair[1] - pair[0]);
            for node in fredholm::quadrature::double_exponential(14) {
                // The distance from a place that is a cut is exact.
                let [from_left, from_right] = [half * node.from_left, half * node.from_right];
                let is_near = from_left < from_right;
                let s = if is_near { pair[0] + from_left } else { pair[1] - from_right };
                let part = half * node.weight * found.pressure(s).unwrap();
                force += part;
                moment += s * part;
                for (sum, x) in displaced.iter_mut().zip([inside, beside]) {
                    let distance = match (pair[0] == x, pair[1] == x) {
                        (true, _) => from_left,
                        (_, true) => from_right,
                        _ => (x - s).abs(),
                    };
                    *sum -= 8.0 * part * distance.ln();
                }
            }
        }
    }
    let size = found.peak_pressure() + found.settlement().abs() + found.tilt().abs();
    assert_within("force", force, 1.0, 1e-11);
    assert_within("moment", moment, 0.2, 1e-11);
    for (sum, x) in displaced.into_iter().zip([inside, beside]) {
        assert_within("displacement", sum, found.elastic_displacement(x), 1e-10 * size);
    }
}

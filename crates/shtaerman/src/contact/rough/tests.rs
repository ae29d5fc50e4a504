//! Many zones against collocation, cells, and what must hold.

use super::*;
use crate::contact::balance::State;
use crate::contact::complementarity::Complementarity;
use crate::contact::method::MethodName;
use crate::contact::setting::Setting;
use crate::{ContactKind, Foundation, Load, Problem, Profile, Punch, Rotational, Vertical};

fn base(problem: &Problem) -> Base {
    Base::new(&Setting::new(problem), ContactKind::Unilateral).unwrap()
}

/// By collocation, if that finds the zones.
fn by_collocation(problem: &Problem) -> Option<Arc<dyn Solution>> {
    Way::Collocation(Effort::MOST).solve(&base(problem)).ok()
}

/// What is added up in a displacement.
fn size(problem: &Problem, contact: &dyn Solution) -> f64 {
    let State { settlement, tilt, .. } = contact.state();
    let exponent = if let crate::roughness::Law::Power(exponent) = problem.frame().law() {
        exponent
    } else {
        1.0
    };
    contact.size().powf(exponent) + settlement.abs() + tilt.abs()
}

fn problem(theta0: f64, profile: Profile, vertical: Vertical, rotational: Rotational) -> Problem {
    let load = Load::new(vertical, rotational).unwrap();
    Problem::new(
        Foundation::dimensionless(theta0).unwrap(),
        Punch::new(1.0).unwrap().with_profile(profile),
        load,
    )
    .unwrap()
}

fn expression(theta0: f64, profile: &str, moment: f64) -> Problem {
    let profile = Profile::expression(profile).unwrap();
    problem(theta0, profile, Vertical::Force(1.0), Rotational::Moment(moment))
}

/// The same on a layer `p^exponent`.
fn bent(theta0: f64, exponent: f64, profile: &str, moment: f64) -> Problem {
    let (foundation, punch) = (
        Foundation::dimensionless(theta0).unwrap().with_exponent(exponent).unwrap(),
        Punch::new(1.0).unwrap(),
    );
    let load = Load::new(Vertical::Force(1.0), Rotational::Moment(moment)).unwrap();
    let profile = Profile::expression(profile).unwrap();
    Problem::new(foundation, punch.with_profile(profile), load).unwrap()
}

/// A trace with waves of many lengths.
fn trace(points: i32, theta0: f64) -> Profile {
    let positions: Vec<f64> =
        (0..points).map(|i| 2.0 * f64::from(i) / f64::from(points - 1) - 1.0).collect();
    let height = |x: &f64| {
        let wave = |k: i32| {
            let k = f64::from(k);
            k.powf(-1.5) * (3.1 * k * x + k * k).sin()
        };
        2.0 * (1.0 + theta0) * (0.3 * x * x + 0.3 * (1..=60).map(wave).sum::<f64>())
    };
    let heights = positions.iter().map(height).collect();
    Profile::from_points(positions, heights).unwrap()
}

fn panels(problem: &Problem) -> RoughContact<OnPanels> {
    on_panels(&base(problem)).unwrap()
}

/// Compares with collocation on the same problem, where that finds the zones; their number.
fn agrees(problem: &Problem) -> Option<usize> {
    let found = panels(problem);
    let exact = by_collocation(problem)?;
    let (one, other) = (found.state(), exact.state());
    let size = size(problem, &found);
    for (a, b) in [
        (one.settlement, other.settlement),
        (one.tilt, other.tilt),
        (one.force, other.force),
        (one.moment, other.moment),
    ] {
        assert!((a - b).abs() < 1e-11 * size, "{a} {b}");
    }
    let (zones, known) = (found.zones(), exact.zones());
    assert_eq!(zones.len(), known.len());
    for (a, b) in zones.iter().flatten().zip(known.iter().flatten()) {
        assert!((a - b).abs() < 1e-10, "{a} {b}");
    }
    let (mut largest, mut pressure) = (0.0f64, 0.0f64);
    for i in 0..=400 {
        let xi = (f64::from(i) / 200.0 - 1.0).clamp(-1.0, 1.0);
        let [a, b] = [found.pressure(xi), exact.pressure(xi)];
        (largest, pressure) = (largest.max(b), pressure.max((a - b).abs()));
        let off = (found.displacement(xi) - exact.displacement(xi)).abs();
        assert!(off < 1e-11 * size, "{xi}: {off:e}");
    }
    assert!(pressure < 1e-10 * largest, "{pressure:e}");
    assert!(found.relative_error() < 1e-9, "{:?}", found.accuracy());
    let (one, other) = (found.stiffness(), exact.stiffness());
    for (a, b) in [
        (one.force_settlement, other.force_settlement),
        (one.coupling, other.coupling),
        (one.moment_tilt, other.moment_tilt),
    ] {
        // The responses have d ln d at free edges, for which the panels are not made.
        assert!((a - b).abs() < 1e-8 * other.force_settlement, "{a} {b}");
    }
    states_what_it_is_off(problem, &found, exact.as_ref());
    Some(zones.len())
}

/// Errors are within what both state.
fn states_what_it_is_off(problem: &Problem, found: &dyn Solution, exact: &dyn Solution) {
    let (one, other) = (found.accuracy().unwrap(), exact.accuracy().unwrap());
    let (a, b) = (found.state(), exact.state());
    for (off, stated) in [
        (a.settlement - b.settlement, one.settlement + other.settlement),
        (a.tilt - b.tilt, one.tilt + other.tilt),
    ] {
        assert!(off.abs() <= stated, "{off:e} {stated:e}");
    }
    let stated = one.pressure + other.pressure;
    let mut worst = 0.0f64;
    for i in 0..=3000 {
        let xi = (f64::from(i) / 1500.0 - 1.0).clamp(-1.0, 1.0);
        worst = worst.max((found.pressure(xi) - exact.pressure(xi)).abs());
    }
    assert!(worst <= stated, "{worst:e} {stated:e}");
    let stated = found.edge_error().unwrap_or(0.0) + exact.edge_error().unwrap_or(0.0);
    for (a, b) in found.zones().iter().flatten().zip(exact.zones().iter().flatten()) {
        assert!((a - b).abs() <= 2.0 * stated + f64::EPSILON, "{a} {b} {stated:e}");
    }
    let (one, other) = (found.stiffness(), exact.stiffness());
    let error = found.stiffness_error().unwrap();
    for (off, stated) in [
        (one.force_settlement - other.force_settlement, error.force_settlement),
        (one.coupling - other.coupling, error.coupling),
        (one.moment_tilt - other.moment_tilt, error.moment_tilt),
    ] {
        assert!(off.abs() <= stated + 1e-13 * other.force_settlement, "{off:e} {stated:e}");
    }
    let [left, right] = found.zones()[0];
    let peak = 0.3 * left + 0.7 * right;
    let one = found.linearised(problem.dimensionless_load(), peak).unwrap();
    let other = exact.linearised(problem.dimensionless_load(), peak).unwrap();
    for input in 0..3 {
        for k in 0..5 {
            let (a, b) = (one.rates[input][k], other.rates[input][k]);
            let stated = one.errors[input][k] + other.errors[input][k];
            assert!(
                (a - b).abs() <= stated + 1e-12 * b.abs() + 1e-14,
                "{input} {k}: {a} {b} {stated:e}"
            );
        }
    }
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
        let found = agrees(&bent(theta0, exponent, profile, moment));
        assert_eq!(found, Some(zones), "{theta0} {exponent} {profile}");
    }
}

#[test]
fn collocation_agrees_in_several_zones() {
    let mut counts = Vec::new();
    for (theta0, waves) in [
        (0.5, 11.0),
        (0.5, 23.0),
        (2.0, 29.0),
        (5.0, 17.0),
        (20.0, 11.0),
        (20.0, 23.0),
        (20.0, 31.0),
        (50.0, 31.0),
        (150.0, 31.0),
        (150.0, 45.0),
    ] {
        let size = 2.0 * (1.0 + theta0);
        let profile = format!("{size}*(0.4*xi^2 + 0.1*cos({waves}*xi + 0.4))");
        counts.extend(agrees(&expression(theta0, &profile, 0.1)));
    }
    // Collocation does not find all zones of all of these.
    assert!(counts.len() >= 3 && counts.iter().any(|count| *count >= 4), "{counts:?}");
}

#[test]
fn collocation_agrees_at_corners_and_steps() {
    let flat = problem(30.0, Profile::flat(), Vertical::Force(1.0), Rotational::Eccentricity(0.6));
    assert_eq!(agrees(&flat), Some(1));
    assert!(agrees(&expression(3.0, "xi^2 + where(xi > 0.3, 8, 0)", -0.1)).is_some());
}

#[test]
fn force_moment_and_displacement_agree_with_a_rule_of_their_own() {
    let profile = trace(1000, 8.0);
    let problem = problem(8.0, profile, Vertical::Force(1.0), Rotational::Moment(0.2));
    let found = panels(&problem);
    let Complementarity { tension, penetration } = found.complementarity().unwrap();
    assert!(tension < 1e-12 && penetration < 1e-12, "{tension:e} {penetration:e}");
    let middle = found.zones()[3];
    let inside = middle[0] + 0.4 * (middle[1] - middle[0]);
    let beside = 0.3 * middle[1] + 0.7 * found.zones()[4][0];
    let joints = problem.profile().joints(1.0);
    let (mut force, mut moment, mut displaced) = (0.0, 0.0, [0.0, 0.0]);
    for [left, right] in found.zones() {
        let mut cuts: Vec<f64> = joints.iter().copied().chain([inside]).collect();
        cuts.retain(|at| *at > left && *at < right);
        cuts.extend([left, right]);
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.windows(2) {
            let half = 0.5 * (pair[1] - pair[0]);
            for node in fredholm::quadrature::double_exponential(14) {
                let near_left = node.from_left < node.from_right;
                let at = |from: f64, to: f64| {
                    // The distance from a place that is a cut is exact.
                    let distance =
                        if near_left { half * node.from_left } else { half * node.from_right };
                    if near_left { from + distance } else { to - distance }
                };
                let s = at(pair[0], pair[1]);
                let part = half * node.weight * found.pressure(s);
                force += part;
                moment += s * part;
                for (sum, x) in displaced.iter_mut().zip([inside, beside]) {
                    let distance = if pair[0] == x {
                        half * node.from_left
                    } else if pair[1] == x {
                        half * node.from_right
                    } else {
                        (x - s).abs()
                    };
                    *sum -= 8.0 * part * distance.ln();
                }
            }
        }
    }
    assert!((force - 1.0).abs() < 1e-11 && (moment - 0.2).abs() < 1e-11, "{force} {moment}");
    for (sum, x) in displaced.into_iter().zip([inside, beside]) {
        let known = found.displacement(x);
        assert!((sum - known).abs() < 1e-10 * size(&problem, &found), "{x}: {sum} {known}");
    }
}

#[test]
fn what_comes_out_may_be_prescribed() {
    let profile = trace(1200, 30.0);
    let free = panels(&problem(
        30.0,
        profile.clone(),
        Vertical::Force(1.0),
        Rotational::Eccentricity(0.1),
    ));
    let State { settlement, tilt, force, moment } = free.state();
    assert!((moment - 0.1 * force).abs() < 1e-14);
    let held = problem(30.0, profile, Vertical::Settlement(settlement), Rotational::Tilt(tilt));
    let held = panels(&held);
    assert!((held.state().force - force).abs() < 1e-10, "{:?}", held.state());
    assert!((held.state().moment - moment).abs() < 1e-10, "{:?}", held.state());
    for (one, other) in free.zones().iter().flatten().zip(held.zones().iter().flatten()) {
        assert!((one - other).abs() < 1e-11, "{one} {other}");
    }
}

#[test]
fn a_wave_agrees_with_a_rule_of_its_own() {
    // By Kress' rule with 240 nodes a zone and edges of its own, in another language.
    let waves = expression(0.5, "3*(0.4*xi^2 + 0.1*cos(23*xi+0.4))", 0.1);
    let found = panels(&waves);
    let accuracy = found.accuracy().unwrap();
    let State { settlement, tilt, .. } = found.state();
    let rounding = 4e-15;
    for (off, stated) in [
        (settlement - 1.316_596_649_734_666_2, accuracy.settlement),
        (tilt + 0.269_029_783_377_773_3, accuracy.tilt),
        (found.zones()[0][1] + 0.903_283_016_182_785, found.edge_error().unwrap()),
        (found.zones()[1][0] + 0.796_427_759_465_558_3, found.edge_error().unwrap()),
        (found.pressure(-0.97) - 0.179_993_382_878_006, accuracy.pressure),
        (found.pressure(-0.93) - 0.122_054_414_169_489_6, accuracy.pressure),
    ] {
        assert!(off.abs() <= stated + rounding && stated < 2e-12, "{off:e} {stated:e}");
    }
}

#[test]
fn rates_on_panels_agree_with_differences() {
    for (theta0, vertical, rotational) in [
        (30.0, Vertical::Force(1.0), Rotational::Moment(0.2)),
        (3.0, Vertical::Settlement(2.0), Rotational::Tilt(0.3)),
    ] {
        let problem = problem(theta0, trace(1100, theta0), vertical, rotational);
        let contact = problem.solve().unwrap();
        let tangent = contact.tangent_sensitivities().unwrap();
        assert_eq!(contact.method().name, MethodName::Panels);
        assert_eq!(contact.sensitivities().unwrap(), tangent);
        let differences = contact.difference_sensitivities().unwrap();
        let known = [
            (tangent.settlement, differences.settlement, contact.settlement()),
            (tangent.force, differences.force, contact.force()),
            (tangent.tilt, differences.tilt, contact.tilt()),
            (tangent.peak_pressure, differences.peak_pressure, contact.peak_pressure()),
            (Some(tangent.contact_width), Some(differences.contact_width), contact.contact_width()),
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
                let off = (a - b).abs();
                assert!(off <= 2.0 * (one.error + other.error) * size, "{one:?} {other:?}");
            }
        }
    }
}

#[test]
fn a_settlement_may_go_with_an_eccentricity() {
    for (theta0, force, e) in [(30.0, 1.0, 0.1), (2.0, 0.4, -0.3)] {
        let profile = trace(1200, theta0);
        let arm = Rotational::Eccentricity(e);
        let free = panels(&problem(theta0, profile.clone(), Vertical::Force(force), arm));
        let State { settlement, tilt, .. } = free.state();
        let held = problem(theta0, profile, Vertical::Settlement(settlement), arm);
        let contact = held.solve().unwrap();
        assert_eq!(contact.method().name, MethodName::Panels);
        let stated = contact.dimensionless().error().unwrap();
        assert!((contact.dimensionless().force() - force).abs() <= stated.force + 1e-13 * force);
        assert!(
            (contact.dimensionless().moment() - e * force).abs() <= stated.moment + 1e-13 * force
        );
        let known_to = stated.tilt + free.accuracy().unwrap().tilt;
        assert!(
            (contact.dimensionless().tilt() - tilt).abs() <= known_to,
            "{} {tilt}",
            contact.dimensionless().tilt()
        );
        assert_eq!(contact.dimensionless().zones().len(), free.zones().len());
        // The rates are the inverse of those under the force.
        let by_settlement = contact.tangent_sensitivities().unwrap().force.unwrap();
        let load = Load { vertical: Vertical::Force(force), rotational: arm };
        let [raise, _] = free.stiffness().displaced(&load, [1.0, 0.0]);
        let product = by_settlement.settlement.unwrap() * raise;
        assert!((product - 1.0).abs() < 1e-8, "{product}");
    }
}

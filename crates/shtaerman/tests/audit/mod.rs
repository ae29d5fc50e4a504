//! Audited answers against product integration on graded panels, which shares no code with the program.
//!
//! The references are from a `NumPy` program: Legendre panels of 14 nodes, graded by 1/2 towards the ends of the base and to every knot, kink and step, with exact moments of the
//! logarithm; good to about `1e-13` of the pressure, seen by changing nodes and grading.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

mod beside_bends;
mod beside_kinks;
mod beside_tips;
#[path = "../../examples/audit_survey/coarse.rs"]
mod coarse;
mod crests;
mod cross_check;
mod disks;
#[path = "../../examples/audit_survey/draw.rs"]
mod draw;
mod equations;
#[allow(dead_code, reason = "the example reports more than the test asks for")]
#[path = "../../examples/audit_survey/judge.rs"]
mod judge;
mod jumps;
mod loose_tolerances;
mod numbers;
mod survey;

use shtaerman::{
    ContactKind, ErrorKind, Foundation, Load, Problem, Profile, Punch, Rotational, Solver, Vertical,
};

/// What the reference is off by, relative to the largest pressure or displacement.
const REFERENCE: f64 = 3e-13;

struct Case {
    name: &'static str,
    profile: Profile,
    theta0: f64,
    force: f64,
    moment: f64,
    contact: ContactKind,
    settlement: f64,
    tilt: f64,
    /// Places with their pressures.
    pressures: &'static [(f64, f64)],
}

fn trace() -> Profile {
    let heights = [
        0.51, 0.399, 0.331, 0.268, 0.164, 0.09, 0.104, 0.045, 0.034, -0.022, 0.035, 0.02, 0.017,
        0.038, 0.082, 0.122, 0.174, 0.223, 0.345, 0.404, 0.501,
    ];
    let places = (0..21).map(|i| -1.0 + 0.1 * f64::from(i)).collect();
    Profile::from_points(places, heights.to_vec()).unwrap()
}

fn cases() -> Vec<Case> {
    let expression = |text| Profile::expression(text).unwrap();
    vec![
        Case {
            name: "trace of 21 points",
            profile: trace(),
            theta0: 2.0,
            force: 1.5,
            moment: 0.15,
            contact: ContactKind::Unilateral,
            settlement: 3.211_864_984_945_84,
            tilt: -0.868_532_946_849_487_3,
            pressures: &[(-1.0, 1.105_545_91), (1.0, 1.880_968_79), (0.05, 0.603_747_9)],
        },
        Case {
            name: "hidden kink",
            profile: expression("sqrt((xi+0.0802)^2)"),
            theta0: 0.816,
            force: 0.926,
            moment: 0.00739,
            contact: ContactKind::Unilateral,
            settlement: 1.598_124_783_102_062_4,
            tilt: -0.138_615_961_400_594_62,
            pressures: &[(-1.0, 0.359_560_79), (-0.0802, 0.692_556_93), (1.0, 0.447_749_31)],
        },
        Case {
            name: "scratch",
            profile: expression("0.4*xi^2-0.05*exp(-((xi-0.3123)/0.002)^2)"),
            theta0: 20.0,
            force: 0.9,
            moment: 0.0,
            contact: ContactKind::Unilateral,
            settlement: 13.390_835_265_023_068,
            tilt: 4.016_982_602_800_619e-5,
            pressures: &[(-1.0, 2.835_437_48), (0.3123, 0.357_131_66), (1.0, 2.835_418_14)],
        },
        Case {
            name: "step in full contact",
            profile: expression("sign(xi-0.3)"),
            theta0: 1.0,
            force: 0.3,
            moment: 0.0,
            contact: ContactKind::Bilateral,
            settlement: 0.133_508_968_969_950_8,
            tilt: -1.318_004_787_187_860_6,
            pressures: &[
                (-1.0, -0.169_769_36),
                (0.29, 1.088_782_71),
                (0.31, -0.748_474_94),
                (1.0, 0.372_902_46),
            ],
        },
    ]
}

impl Case {
    fn problem(&self) -> Problem {
        let (foundation, punch) =
            (Foundation::dimensionless(self.theta0).unwrap(), Punch::new(1.0).unwrap());
        let load = Load::new(Vertical::Force(self.force), Rotational::Moment(self.moment)).unwrap();
        let solver = Solver::default().with_contact(self.contact);
        Problem::new(foundation, punch.with_profile(self.profile.clone()), load)
            .unwrap()
            .with_solver(solver)
    }
}

#[test]
fn bounds_hold_where_estimates_did_not() {
    for case in cases() {
        let contact = case.problem().solve().unwrap().audited().unwrap();
        let accuracy = contact.dimensionless().error().unwrap();
        println!("{}: {accuracy:?} {:?}", case.name, contact.audited_by());
        assert_eq!(accuracy.kind, ErrorKind::Bound, "{}", case.name);
        let size = case.settlement.abs().max(case.tilt.abs());
        for (found, truth, bound) in [
            (contact.dimensionless().settlement(), case.settlement, accuracy.settlement),
            (contact.dimensionless().tilt(), case.tilt, accuracy.tilt),
        ] {
            let error = (found - truth).abs();
            assert!(error <= bound + REFERENCE * size, "{}: {error:e} {bound:e}", case.name);
        }
        let largest = contact.dimensionless().peak_pressure();
        for &(xi, truth) in case.pressures {
            // The references of pressures have nine digits.
            let error = (contact.dimensionless().pressure(xi).unwrap() - truth).abs();
            assert!(error <= accuracy.pressure + 6e-9, "{} at {xi}: {error:e}", case.name);
        }
        // And they are not idle.
        assert!(accuracy.pressure <= 1e-8 * largest.abs(), "{}: {accuracy:?}", case.name);
    }
}

/// Rough circular punches of radius 1 whose pressure is `sqrt(c^2 - r^2)`, with the potential `pi^2/8 (2 c^2 - r^2)` (Hertz), and plane ones with `pi c^2/2 (ln(2/c) + 1/2) - pi/2 x^2`.
#[test]
fn estimates_hold_against_closed_forms() {
    use std::f64::consts::PI;
    let circular = shtaerman::Geometry::Circular;
    let plane = shtaerman::Geometry::Plane;
    for (geometry, c, theta0, kappa) in [
        (circular, 1.0, 2.0, 1.0),
        (circular, 0.6, 30.0, 1.0),
        (circular, 0.7, 3.0, 0.6),
        (plane, 1.0, 2.0, 0.7),
        (plane, 0.5, 20.0, 0.5),
    ] {
        let is_circular = geometry == circular;
        let (bend, settlement, force) = if is_circular {
            let bend = theta0 * PI * PI / 8.0;
            (bend, 2.0 * bend * c * c, 2.0 * PI / 3.0 * c * c * c)
        } else {
            let level = theta0 * PI * c * c / 2.0 * (f64::ln(2.0 / c) + 0.5);
            (0.5 * theta0 * PI, level, 0.5 * PI * c * c)
        };
        let half = 0.5 * kappa;
        let text = format!("{bend}*xi^2 - max({c}^2 - xi^2, 0)^{half}");
        let (foundation, punch) = (
            Foundation::dimensionless(theta0).unwrap().with_exponent(kappa).unwrap(),
            Punch::in_geometry(geometry, 1.0).unwrap(),
        );
        let load = Load::new(Vertical::Force(force), Rotational::Tilt(0.0)).unwrap();
        let profile = Profile::expression(&text).unwrap();
        let problem = Problem::new(foundation, punch.with_profile(profile), load).unwrap();
        let contact = match problem.solve().and_then(shtaerman::Contact::audited) {
            Ok(contact) => contact,
            Err(error) => {
                assert!(error.is_numerical(), "{geometry:?} {c}: {error}");
                println!("{geometry:?} {c} {theta0} {kappa}: refused, {error}");
                continue;
            }
        };
        let stated = contact.dimensionless().error().unwrap();
        let audit = contact.audited_by().unwrap().as_ref().unwrap();
        println!("{geometry:?} {c} {theta0} {kappa}: {stated:?} {audit:?}");
        assert_eq!(stated.kind, ErrorKind::Estimate);
        let missed = (contact.dimensionless().settlement() - settlement).abs();
        assert!(missed <= stated.settlement + 1e-15 * settlement, "{missed:e}");
        for k in 0..=200 {
            let xi = 1.2 * c * f64::from(k) / 200.0;
            let exact = ((c - xi) * (c + xi)).max(0.0).sqrt();
            if xi <= 1.0 {
                let missed = (contact.dimensionless().pressure(xi).unwrap() - exact).abs();
                assert!(missed <= stated.pressure + 1e-15, "{xi}: {missed:e}");
            }
        }
        assert!(stated.pressure < 1e-5, "idle");
        // The largest pressure is that in the middle, c.
        let off = (contact.dimensionless().peak_pressure() - c).abs();
        let peak = contact.dimensionless().error().and_then(|error| error.peak_pressure).unwrap();
        assert!(off <= peak + 1e-15 && peak <= 2.0 * stated.pressure + 1e-13, "{off:e} {peak:e}");
    }
}

/// Kept in contact without a force, a parabola pulls at its edges six times as much as it presses in the middle; how much it pulls says nothing about how well that is known.
#[test]
fn the_largest_pressure_is_known_beside_larger_tension() {
    let foundation = Foundation::dimensionless(5.8).unwrap();
    let punch = Punch::new(1.0).unwrap().with_profile(Profile::expression("10*xi^2").unwrap());
    let load = Load::new(Vertical::Force(0.0), Rotational::Moment(0.0)).unwrap();
    let problem = Problem::new(foundation, punch, load).unwrap();
    let contact = problem.with_solver(Solver::bilateral()).solve().unwrap().audited().unwrap();
    let contact = contact.dimensionless();
    let (stated, peak) = (contact.error().unwrap(), contact.peak_pressure());
    assert!(peak > 0.0 && contact.pressure(1.0).unwrap() < -5.0 * peak);
    // The pressures carry no force, and the middle is the highest of many places.
    let highest = (0..=1000).map(|k| contact.pressure(f64::from(k) / 1000.0).unwrap());
    let highest = highest.fold(f64::NEG_INFINITY, f64::max);
    let known = stated.peak_pressure.unwrap();
    assert!((peak - highest).abs() <= known && known <= 1e-9 * peak, "{peak} {known:e}");
}

#[test]
fn what_is_not_covered_says_why() {
    let steel = shtaerman::Elastic::new(200e9, 0.3).unwrap();
    let (foundation, punch) =
        (Foundation::new(steel).with_roughness(0.0).unwrap(), Punch::new(1e-3).unwrap());
    let load = Load::new(Vertical::Force(1e3), Rotational::Tilt(0.0)).unwrap();
    let ball = Profile::expression("x^2/2").unwrap();
    let problem = Problem::new(foundation, punch.with_profile(ball), load).unwrap();
    let contact = problem.solve().unwrap();
    let stated = contact.dimensionless().error().unwrap();
    let audited = contact.audited().unwrap();
    let reason = audited.audited_by().unwrap().as_ref().unwrap_err().to_string();
    assert!(reason.contains("smooth"), "{reason}");
    assert_eq!(audited.dimensionless().error().unwrap(), stated);
}

/// `ceil(r^-r)` steps at the axis from one value to the next within rounding, and its enclosures have no bounds: found by random input.
#[test]
fn a_residual_without_bounds_states_nothing() {
    let disk = Punch::circular(1.0).unwrap();
    let stepped = Profile::expression("2.0055669036812495e-3*ceil(abs(xi)^(-abs(xi)))").unwrap();
    let load = Load::new(Vertical::Force(7.644171990121552), Rotational::Tilt(0.0)).unwrap();
    let solver = Solver::spectral(70).unwrap();
    let foundation = Foundation::dimensionless(2.60853748269252).unwrap();
    let problem = Problem::new(foundation, disk.with_profile(stepped), load).unwrap();
    let contact = problem.with_solver(solver).solve().unwrap();
    assert!(contact.audit().is_err());
}

#[test]
fn loads_of_every_kind_enclose_the_same_contact() {
    // One contact four ways: what one load prescribes the others find, within both their bounds.
    let stated = || (Foundation::dimensionless(7.0).unwrap(), Punch::new(1.0).unwrap());
    let profile = || Profile::expression("0.6*xi^2 + 0.1*sin(5*xi)").unwrap();
    let solve = |vertical, rotational| {
        let load = Load::new(vertical, rotational).unwrap();
        let problem = Problem::new(stated().0, stated().1.with_profile(profile()), load).unwrap();
        problem.solve().unwrap().audited().unwrap()
    };
    let first = solve(Vertical::Force(0.2), Rotational::Moment(0.03));
    let (settlement, tilt) = (first.dimensionless().settlement(), first.dimensionless().tilt());
    for (vertical, rotational) in [
        (Vertical::Settlement(settlement), Rotational::Tilt(tilt)),
        (Vertical::Force(0.2), Rotational::Tilt(tilt)),
        (Vertical::Settlement(settlement), Rotational::Moment(0.03)),
        (Vertical::Force(0.2), Rotational::Eccentricity(0.15)),
    ] {
        let other = solve(vertical, rotational);
        let (a, b) =
            (first.dimensionless().error().unwrap(), other.dimensionless().error().unwrap());
        // What is handed over is off by its bound, which the contact amplifies by at most about the stiffness.
        let allowed = 20.0 * (a.settlement + a.tilt + a.pressure) + b.settlement + b.tilt;
        assert!((other.dimensionless().settlement() - settlement).abs() <= allowed);
        assert!((other.dimensionless().tilt() - tilt).abs() <= allowed);
        assert!((other.dimensionless().force() - 0.2).abs() <= allowed + b.force);
        assert!((other.dimensionless().moment() - 0.03).abs() <= allowed + b.moment);
    }
}

#[test]
fn a_constant_in_the_profile_moves_the_settlement_alone() {
    let steel = shtaerman::Elastic::new(200e9, 0.3).unwrap();
    let (foundation, punch) =
        (Foundation::new(steel).with_roughness(1.2e-14).unwrap(), Punch::new(5e-3).unwrap());
    let load = Load::new(Vertical::Force(0.8e6), Rotational::Moment(0.0)).unwrap();
    let solver = Solver::default().with_tolerance(1e-12).unwrap();
    let solve = |text| {
        let profile = Profile::expression(text).unwrap();
        Problem::new(foundation.clone(), punch.clone().with_profile(profile), load)
            .unwrap()
            .with_solver(solver)
            .solve()
            .unwrap()
            .audited()
    };
    let (plain, raised) = (solve("x^2/40").unwrap(), solve("x^2/40 + 1").unwrap());
    let allowed = plain.dimensionless().error().unwrap().pressure
        + raised.dimensionless().error().unwrap().pressure;
    for xi in [-1.0, -0.3, 0.0, 0.8, 1.0] {
        assert!(
            (plain.dimensionless().pressure(xi).unwrap()
                - raised.dimensionless().pressure(xi).unwrap())
            .abs()
                <= allowed,
            "{xi}"
        );
    }
    assert!((raised.settlement() - plain.settlement() - 1.0).abs() < 4.0 * f64::EPSILON);
}

#[test]
fn settlement_with_eccentricity_states_the_force_that_it_finds() {
    // The force of a contact, handed back by its settlement: the errors of both must cover what comes out differently.
    let profile = || Profile::expression("0.5*xi^2").unwrap();
    let stated = || (Foundation::dimensionless(3.0).unwrap(), Punch::new(1.0).unwrap());
    let solve = |vertical| {
        let load = Load::new(vertical, Rotational::Eccentricity(0.1)).unwrap();
        let problem = Problem::new(stated().0, stated().1.with_profile(profile()), load).unwrap();
        problem.solve().unwrap().audited().unwrap()
    };
    let first = solve(Vertical::Force(0.08));
    let second = solve(Vertical::Settlement(first.dimensionless().settlement()));
    let accuracy = second.dimensionless().error().unwrap();
    assert_eq!(accuracy.kind, ErrorKind::Estimate);
    let handed_over = first.dimensionless().error().unwrap().settlement;
    assert!(accuracy.force > 0.0 && accuracy.moment > 0.0);
    assert!(
        (second.dimensionless().force() - 0.08).abs() <= accuracy.force + handed_over,
        "{accuracy:?}"
    );
    assert!(
        (second.dimensionless().moment() - 0.008).abs() <= accuracy.moment + handed_over,
        "{accuracy:?}"
    );
}

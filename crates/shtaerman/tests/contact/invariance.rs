//! What may not matter: reflection, constants and slopes of the profile, scale, the way a problem is stated.

use crate::contact::support::{assert_near, force_and_moment, load, solve, solver};
use shtaerman::{
    Contact, Elastic, Foundation, Load, Problem, Profile, Punch, Rotational, Vertical,
};

const PLACES: [f64; 7] = [-1.0, -0.83, -0.31, 0.0, 0.22, 0.9, 1.0];

fn assert_same_pressure(one: &Contact, other: &Contact, tolerance: f64, what: &str) {
    for xi in PLACES {
        assert_near(
            other.dimensionless().pressure(xi).unwrap(),
            one.dimensionless().pressure(xi).unwrap(),
            tolerance,
            what,
        );
    }
}

#[test]
fn reflection_reflects_everything() {
    for theta0 in [0.0, 3.0, 90.0] {
        let right = solve(theta0, "exp(xi) + xi^3", force_and_moment(1.7, 0.31), 100);
        let left = solve(theta0, "exp(-xi) - xi^3", force_and_moment(1.7, -0.31), 100);
        let tolerance = 1e-12 * (1.0 + theta0);
        assert_near(
            left.dimensionless().settlement(),
            right.dimensionless().settlement(),
            tolerance,
            "settlement",
        );
        assert_near(left.dimensionless().tilt(), -right.dimensionless().tilt(), tolerance, "tilt");
        for xi in PLACES {
            assert_near(
                left.dimensionless().pressure(-xi).unwrap(),
                right.dimensionless().pressure(xi).unwrap(),
                tolerance,
                "pressure",
            );
        }
        let [value, mirrored] = [&right, &left].map(|c| c.dimensionless().peak_pressure());
        let [place, mirrored_place] = [&right, &left].map(|c| c.dimensionless().peak_pressure_at());
        assert_near(mirrored, value, tolerance, "peak");
        assert_near(mirrored_place, -place, 1e-6, "place of the peak");
    }
}

#[test]
fn an_even_problem_has_an_even_answer() {
    let contact = solve(7.0, "cos(3*xi) + 2*xi^2", force_and_moment(1.0, 0.0), 64);
    assert_eq!(contact.dimensionless().tilt(), 0.0);
    for xi in PLACES {
        assert_eq!(
            contact.dimensionless().pressure(xi).unwrap(),
            contact.dimensionless().pressure(-xi).unwrap()
        );
    }
}

#[test]
fn a_constant_shifts_the_settlement_and_a_slope_the_tilt() {
    for theta0 in [0.0, 3.0, 90.0] {
        let plain = solve(theta0, "exp(xi)", force_and_moment(1.7, 0.31), 100);
        let raised = solve(theta0, "exp(xi) + 0.75", force_and_moment(1.7, 0.31), 100);
        let sloped = solve(theta0, "exp(xi) + 1.25*xi", force_and_moment(1.7, 0.31), 100);
        let tolerance = 1e-12 * (1.0 + theta0);
        assert_near(
            raised.dimensionless().settlement() - plain.dimensionless().settlement(),
            0.75,
            tolerance,
            "raised, settlement",
        );
        assert_near(
            raised.dimensionless().tilt() - plain.dimensionless().tilt(),
            0.0,
            tolerance,
            "raised, tilt",
        );
        assert_near(
            sloped.dimensionless().settlement() - plain.dimensionless().settlement(),
            0.0,
            tolerance,
            "sloped, settlement",
        );
        assert_near(
            sloped.dimensionless().tilt() - plain.dimensionless().tilt(),
            -1.25,
            tolerance,
            "sloped, tilt",
        );
        assert_same_pressure(&plain, &raised, tolerance, "raised");
        assert_same_pressure(&plain, &sloped, tolerance, "sloped");
    }
}

#[test]
fn contacts_superpose() {
    for theta0 in [0.0, 3.0, 90.0] {
        let one = solve(theta0, "exp(xi)", force_and_moment(1.7, 0.31), 80);
        let two = solve(theta0, "xi^5", force_and_moment(-0.6, 0.2), 80);
        let both =
            solve(theta0, "2*exp(xi) - 3*xi^5", force_and_moment(2.0 * 1.7 + 1.8, 0.62 - 0.6), 80);
        let tolerance = 1e-11 * (1.0 + theta0);
        assert_near(
            both.dimensionless().settlement(),
            2.0 * one.dimensionless().settlement() - 3.0 * two.dimensionless().settlement(),
            tolerance,
            "settlement",
        );
        assert_near(
            both.dimensionless().tilt(),
            2.0 * one.dimensionless().tilt() - 3.0 * two.dimensionless().tilt(),
            tolerance,
            "tilt",
        );
        for xi in PLACES {
            let sum = 2.0 * one.dimensionless().pressure(xi).unwrap()
                - 3.0 * two.dimensionless().pressure(xi).unwrap();
            assert_near(both.dimensionless().pressure(xi).unwrap(), sum, tolerance, "pressure");
        }
    }
}

#[test]
fn nothing_pressed_answers_nothing() {
    for theta0 in [0.0, 5.0] {
        let contact = solve(theta0, "0", force_and_moment(0.0, 0.0), 32);
        assert_eq!(
            [contact.dimensionless().settlement(), contact.dimensionless().tilt()],
            [0.0, 0.0]
        );
        assert!(PLACES.iter().all(|&xi| contact.dimensionless().pressure(xi).unwrap() == 0.0));
        assert!(contact.warnings().is_empty() && contact.tension().is_empty());
    }
}

struct Steel {
    modulus: f64,
    ratio: f64,
    roughness: f64,
    half_width: f64,
}

const STEEL: Steel = Steel { modulus: 200e9, ratio: 0.3, roughness: 1.2e-14, half_width: 5e-3 };

impl Steel {
    fn solve(&self, profile: &str, load: Load, body: Option<Elastic>) -> Contact {
        let foundation = Elastic::new(self.modulus, self.ratio).unwrap();
        let (foundation, punch) = (
            Foundation::new(foundation).with_roughness(self.roughness).unwrap(),
            Punch::new(self.half_width).unwrap(),
        );
        let punch = body.map_or(punch.clone(), |body| punch.with_body(body));
        let profile = Profile::expression(profile).unwrap();
        Problem::new(foundation, punch.with_profile(profile), load)
            .unwrap()
            .with_solver(solver(120))
            .solve()
            .unwrap()
    }
}

#[test]
fn physical_and_dimensionless_form_agree() {
    // The scales of (2.5) and (2.6), written out here.
    let Steel { modulus, ratio, roughness, half_width: a } = STEEL;
    let theta0 = a * 2.0 * (1.0 - ratio * ratio) / (std::f64::consts::PI * modulus) / roughness;
    let (pressure, length, angle) = (modulus, roughness * modulus, roughness * modulus / a);
    let (force, moment) = (0.8e6, 300.0);
    let physical = STEEL.solve("x^2/(2*0.8) + 2e-4*x", force_and_moment(force, moment), None);
    let curvature = a * a / 1.6 / length;
    let slope = 2e-4 * a / length;
    let plain = solve(
        theta0,
        &format!("{curvature}*xi^2 + {slope}*xi"),
        force_and_moment(force / (a * modulus), moment / (a * a * modulus)),
        120,
    );
    for (found, exact, what) in [
        (physical.theta0(), theta0, "theta0"),
        (physical.settlement(), plain.dimensionless().settlement() * length, "settlement"),
        (physical.tilt(), plain.dimensionless().tilt() * angle, "tilt"),
        (
            physical.pressure_left(),
            plain.dimensionless().pressure(-1.0).unwrap() * pressure,
            "left",
        ),
        (
            physical.pressure_middle(),
            plain.dimensionless().pressure(0.0).unwrap() * pressure,
            "mid",
        ),
        (
            physical.pressure(0.6 * a).unwrap(),
            plain.dimensionless().pressure(0.6).unwrap() * pressure,
            "inside",
        ),
        (
            physical.pressure_right(),
            plain.dimensionless().pressure(1.0).unwrap() * pressure,
            "right",
        ),
        (physical.mean_pressure(), force / (2.0 * a), "mean"),
        (
            physical.stiffness().force_settlement,
            plain.dimensionless().stiffness().force_settlement * a * modulus / length,
            "c11",
        ),
        (
            physical.stiffness().moment_tilt,
            plain.dimensionless().stiffness().moment_tilt * a * a * modulus / angle,
            "c22",
        ),
    ] {
        assert_near(found / exact, 1.0, 1e-11, what);
    }
    // Without dimensions every name means the same.
    assert_eq!(plain.settlement(), plain.dimensionless().settlement());
    assert_eq!(plain.pressure(0.6).unwrap(), plain.dimensionless().pressure(0.6).unwrap());
}

#[test]
fn what_is_prescribed_comes_back_as_given() {
    for (vertical, rotational) in [
        (Vertical::Force(0.8e6), Rotational::Moment(100.0)),
        (Vertical::Force(0.7e6), Rotational::Eccentricity(1.3e-4)),
        (Vertical::Settlement(2.9e-6), Rotational::Tilt(1.7e-5)),
    ] {
        let contact = STEEL.solve("x^2/(2*0.8)", load(vertical, rotational), None);
        match vertical {
            Vertical::Force(force) => assert_eq!(contact.force(), force),
            Vertical::Settlement(settlement) => assert_eq!(contact.settlement(), settlement),
        }
        match rotational {
            Rotational::Moment(moment) => assert_eq!(contact.moment(), moment),
            Rotational::Eccentricity(e) => assert_eq!(contact.moment(), e * contact.force()),
            Rotational::Tilt(tilt) => assert_eq!(contact.tilt(), tilt),
        }
    }
}

#[test]
fn lengths_scale() {
    // With a, chi E, f and the displacements all s times larger and P s times, M s^2 times, the pressure is the same.
    let s = 7.0;
    let large = Steel { roughness: s * STEEL.roughness, half_width: s * STEEL.half_width, ..STEEL };
    let small_contact = STEEL.solve("x^2/(2*0.8)", force_and_moment(0.8e6, 300.0), None);
    let large_contact =
        large.solve("x^2/(2*0.8*7)", force_and_moment(s * 0.8e6, s * s * 300.0), None);
    assert_near(large_contact.theta0() / small_contact.theta0(), 1.0, 1e-15, "theta0");
    assert_near(large_contact.settlement() / small_contact.settlement(), s, 1e-11, "settlement");
    assert_near(large_contact.tilt() / small_contact.tilt(), 1.0, 1e-11, "tilt");
    for xi in PLACES {
        let ratio = large_contact.pressure(s * xi * STEEL.half_width).unwrap()
            / small_contact.pressure(xi * STEEL.half_width).unwrap();
        assert_near(ratio, 1.0, 1e-11, "pressure");
    }
}

#[test]
fn two_equal_elastic_bodies_are_a_rigid_punch_on_half_the_modulus() {
    let body = Elastic::new(STEEL.modulus, STEEL.ratio).unwrap();
    let half = Steel { modulus: 0.5 * STEEL.modulus, ..STEEL };
    let loads = [
        force_and_moment(0.8e6, 300.0),
        load(Vertical::Settlement(2e-6), Rotational::Tilt(-1e-4)),
        load(Vertical::Force(0.8e6), Rotational::Eccentricity(1e-3)),
    ];
    for load in loads {
        let two = STEEL.solve("x^2/(2*0.8)", load, Some(body));
        let one = half.solve("x^2/(2*0.8)", load, None);
        for (found, exact, what) in [
            (two.settlement(), one.settlement(), "settlement"),
            (two.tilt(), one.tilt(), "tilt"),
            (two.force(), one.force(), "force"),
            (two.moment(), one.moment(), "moment"),
            (two.stiffness().force_settlement, one.stiffness().force_settlement, "c11"),
            (two.stiffness().moment_tilt, one.stiffness().moment_tilt, "c22"),
            (two.peak_pressure(), one.peak_pressure(), "peak"),
        ] {
            assert_near(found / exact, 1.0, 1e-11, what);
        }
        for xi in PLACES {
            let x = xi * STEEL.half_width;
            let ratio = two.pressure(x).unwrap() / one.pressure(x).unwrap();
            assert_near(ratio, 1.0, 1e-10, "pressure");
        }
    }
}

#[test]
fn which_body_is_called_the_foundation_does_not_matter() {
    let iron = Elastic::new(110e9, 0.26).unwrap();
    let on_steel = STEEL.solve("x^2/(2*0.8)", force_and_moment(0.8e6, 300.0), Some(iron));
    let on_iron = Steel { modulus: 110e9, ratio: 0.26, ..STEEL }.solve(
        "x^2/(2*0.8)",
        force_and_moment(0.8e6, 300.0),
        Some(Elastic::new(STEEL.modulus, STEEL.ratio).unwrap()),
    );
    assert_near(on_iron.settlement() / on_steel.settlement(), 1.0, 1e-12, "settlement");
    assert_near(on_iron.pressure_right() / on_steel.pressure_right(), 1.0, 1e-12, "pressure");
}

#[test]
fn the_same_problem_gives_the_same_bits() {
    let answer = || {
        let contact = solve(13.0, "exp(xi)", force_and_moment(1.7, -0.31), 200);
        PLACES.map(|xi| contact.dimensionless().pressure(xi).unwrap().to_bits())
    };
    assert_eq!(answer(), answer());
}

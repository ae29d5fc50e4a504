//! Valid but extreme values: an answer or an error, never a panic, and no NaN in an answer.

use crate::contact::support::{assert_near, force_and_moment, load, settlement_and_tilt, solver};
use shtaerman::{
    Answer, Contact, Elastic, Error, Foundation, Load, PressureCurve, Problem, Profile, Punch,
    Rotational, Vertical,
};

/// What is pressed into what.
type Stated = Result<(Foundation, Punch), Error>;

fn bare(theta0: f64) -> Stated {
    Ok((Foundation::dimensionless(theta0)?, Punch::new(1.0)?))
}

fn rough(material: Elastic, roughness: f64, half_width: f64) -> Stated {
    Ok((Foundation::new(material).with_roughness(roughness)?, Punch::new(half_width)?))
}

fn try_solve(stated: Stated, profile: &str, load: Load) -> Result<Contact, Error> {
    let (foundation, punch) = stated?;
    let punch = punch.with_profile(Profile::expression(profile).unwrap());
    Problem::new(foundation, punch, load)?.with_solver(solver(48)).solve()
}

/// All that an answer says is finite.
fn is_finite(contact: &Contact) -> bool {
    let curve = PressureCurve::along(contact, 33).unwrap();
    let answer = Answer::new(contact, curve);
    let d = answer.dimensionless.as_ref().unwrap();
    let mut values = vec![
        d.force,
        d.moment,
        d.settlement,
        d.tilt,
        d.pressure_left,
        d.pressure_middle,
        d.pressure_right,
    ];
    values.push(d.peak_pressure);
    values.extend(d.stiffness.as_flattened());
    values.extend(&answer.pressure.pressure);
    if let Some(p) = &answer.physical {
        values.extend([p.settlement, p.tilt, p.force, p.moment, p.peak_pressure, p.mean_pressure]);
        values.extend(p.stiffness.as_flattened());
    }
    values.iter().all(|value| value.is_finite())
}

fn loads() -> Vec<Load> {
    let mut loads = Vec::new();
    for value in [0.0, 1e-300, -1.0, 1e300, -1e300] {
        for other in [0.0, 1e-300, -1.0, 1e300] {
            for vertical in [Vertical::Force(value), Vertical::Settlement(value)] {
                for rotational in [
                    Rotational::Moment(other),
                    Rotational::Tilt(other),
                    Rotational::Eccentricity(other),
                ] {
                    loads.push(load(vertical, rotational));
                }
            }
        }
    }
    loads
}

/// Whether nothing about a load is extreme.
fn is_ordinary(load: &Load) -> bool {
    let (Vertical::Force(one) | Vertical::Settlement(one)) = load.vertical();
    let (Rotational::Moment(other) | Rotational::Tilt(other) | Rotational::Eccentricity(other)) =
        load.rotational();
    one.abs() <= 1.0 && other.abs() <= 1.0
}

/// An answer is finite; only what is beyond double precision is refused, and not what `is_due`.
fn check(result: Result<Contact, Error>, is_due: bool, what: &str) {
    match result {
        Ok(contact) => assert!(is_finite(&contact), "{what}: {contact:?}"),
        Err(error) => {
            let is_reason = matches!(error, Error::Overflow { .. } | Error::InvalidValue { .. });
            assert!(is_reason && !is_due, "{what}: {error}");
        }
    }
}

#[test]
fn extreme_dimensionless_problems_answer_or_say_why() {
    for theta0 in [0.0, 1e-300, 1e-12, 1.0, 1e8, 1e300] {
        for (profile, height) in
            [("0", 0.0), ("1e300*xi^2", 1e300), ("1e-300*xi", 1e-300), ("xi", 1.0)]
        {
            for load in loads() {
                let is_due = theta0 <= 1e8 && height <= 1.0 && is_ordinary(&load);
                let result = try_solve(bare(theta0), profile, load);
                check(result, is_due, &format!("theta0 = {theta0}, f0 = {profile}, {load:?}"));
            }
        }
    }
}

#[test]
fn extreme_physical_problems_answer_or_say_why() {
    for modulus in [1e-300, 1.0, 2e11, 1e300] {
        for roughness in [1e-300, 1e-14, 1e300] {
            for half_width in [1e-300, 1e-12, 5e-3, 1e300] {
                let is_body = (1.0..=2e11).contains(&modulus) && roughness == 1e-14;
                let is_punch = (1e-12..1.0).contains(&half_width);
                for load in [
                    force_and_moment(1e300, 0.0),
                    force_and_moment(1.0, 1e-3),
                    settlement_and_tilt(1e-6, 1e-300),
                ] {
                    let steel = Elastic::new(modulus, 0.3).unwrap();
                    let stated = rough(steel, roughness, half_width);
                    let what =
                        format!("E = {modulus}, chi = {roughness}, a = {half_width}, {load:?}");
                    let is_due = is_body && is_punch && is_ordinary(&load);
                    check(try_solve(stated, "x^2", load), is_due, &what);
                }
            }
        }
    }
}

#[test]
fn a_vanishing_theta0_is_the_layer() {
    for theta0 in [0.0, 1e-300, 1e-18] {
        let contact = try_solve(bare(theta0), "0", force_and_moment(1.0, 0.2)).unwrap();
        for xi in [-1.0, 0.0, 0.5] {
            assert_near(
                contact.dimensionless().pressure(xi).unwrap(),
                0.5 + 0.3 * xi,
                1e-15,
                &format!("theta0 = {theta0}"),
            );
        }
    }
}

#[test]
fn a_tiny_punch_is_a_punch() {
    // A nanometre and a thousandth of it: the same dimensionless problem as five millimetres with chi to suit.
    let steel = Elastic::new(200e9, 0.3).unwrap();
    let solve = |half_width: f64| {
        let stated = rough(steel, 2.4e-12 * half_width, half_width);
        try_solve(stated, "0.1*xi^2*a", force_and_moment(1e8 * half_width, 0.0)).unwrap()
    };
    let reference = solve(5e-3);
    for half_width in [1e-9, 1e-12, 1e-30] {
        let tiny = solve(half_width);
        assert_near(tiny.theta0() / reference.theta0(), 1.0, 1e-14, "theta0");
        for xi in [-1.0, 0.0, 1.0] {
            assert_near(
                tiny.pressure(xi * half_width).unwrap() / reference.pressure(xi * 5e-3).unwrap(),
                1.0,
                1e-10,
                "pressure",
            );
        }
    }
}

#[test]
fn a_degree_far_below_theta0_is_warned_of() {
    let contact = try_solve(bare(1e8), "xi^2", force_and_moment(1.0, 0.0)).unwrap();
    let codes: Vec<_> = contact.warnings().iter().map(|warning| warning.code).collect();
    assert!(codes.contains(&shtaerman::WarningCode::LowDegree), "{codes:?}");
    assert!(is_finite(&contact));
}

#[test]
fn pressure_beyond_the_punch_is_an_error() {
    let contact = try_solve(bare(1.0), "xi^2", force_and_moment(1.0, 0.0)).unwrap();
    for x in [1.0 + 1e-15, -1.1, 1e300, f64::INFINITY, f64::NAN] {
        assert!(matches!(contact.pressure(x), Err(Error::BeyondPunch { .. })), "{x}");
    }
    assert!(contact.pressure(-1.0).is_ok() && contact.pressure(1.0).is_ok());
}

//! What is no disk of contact.

use crate::smooth_disk::support::{attempt, pressed, problem, sunk};
use shtaerman::{Error, Profile, Rotational, Solver, Vertical};

#[test]
fn rings_that_tilt() {
    // A hollow base touches at its rim, a wavy one in rings.
    for profile in
        ["-x^2", "0.1*(abs(x) - 0.003)^2", "1e-6*cos(5000*x)", "where(abs(x) < 0.003, 1e-4, 0)"]
    {
        for rotational in
            [Rotational::Moment(1e-4), Rotational::Tilt(-1e-9), Rotational::Eccentricity(1e-4)]
        {
            let error = attempt(profile, (Vertical::Force(1.0), rotational)).unwrap_err();
            assert!(matches!(error, Error::Rings { variable: "x", .. }), "{profile}: {error}");
            let text = error.to_string();
            assert!(text.contains("leave out moment and tilt"), "{error}");
            // One that leans is solved on a rough surface only where all of it touches.
            assert!(!text.contains("roughness"), "{error}");
        }
    }
    // A second step that touches.
    let stepped = "where(abs(x) < 0.003, 0, 1e-7)";
    let tilted = (Vertical::Force(1e4), Rotational::Moment(1.0));
    assert!(matches!(attempt(stepped, tilted), Err(Error::Rings { .. })));
    // Enough force presses a hollow base flat.
    assert!(attempt("-1e-3*x^2", pressed(1e4)).is_ok());
}

#[test]
fn loads() {
    let refused = attempt("x^2", pressed(0.0));
    assert!(matches!(refused, Err(Error::InvalidValue { field: "force", .. })));
    let refused = attempt("x^2", pressed(-3.0));
    assert!(matches!(refused, Err(Error::InvalidValue { field: "force", value: -3.0, .. })));
    assert!(matches!(attempt("x^2", sunk(0.0)), Err(Error::NoContact)));
    assert!(matches!(attempt("x^2 + 1e-3", sunk(0.5e-3)), Err(Error::NoContact)));
    assert!(matches!(attempt("-x^2", sunk(-2.6e-5)), Err(Error::NoContact)));
    for force in [0.0, -2.0] {
        let refused = attempt("-x^2", pressed(force));
        assert!(matches!(refused, Err(Error::InvalidValue { field: "force", .. })));
    }
}

#[test]
fn bases() {
    let refused = attempt("x^2 + x", pressed(1.0)).unwrap_err();
    assert!(refused.to_string().contains("even in x"), "{refused}");
    let refused = attempt("x^2 + 1e-6*exp(-((x - 1.7003e-3)/1e-9)^2)", pressed(1.0)).unwrap_err();
    assert!(refused.to_string().contains("even in x"), "{refused}");
    let step = Profile::expression("where(abs(x) < 0.003, 0, 0.001)").unwrap();
    let load = (Vertical::Force(1.0), Rotational::Moment(0.0));
    let refused = problem(step, 0.0, load, Solver::bilateral()).solve();
    let Err(Error::InvalidValue { field: "profile", value, .. }) = refused else { panic!() };
    assert!((value - 0.003).abs() < 1e-15);
}

#[test]
fn extreme_numbers_have_answers_or_errors() {
    answers_or_errors(&[1e-30, 1.0, 1e30, 1e290]);
}

/// Contacts of which hundreds of steps come to the radius.
#[test]
fn next_to_no_force_has_answers_or_errors() {
    answers_or_errors(&[1e-300]);
}

/// The transform of a root takes a second for each radius that is tried, and a radius of 1e-200 is tried some fifty times.
const ROOT: &str = "sqrt(abs(x))";

fn answers_or_errors(forces: &[f64]) {
    for profile in [
        "x^2",
        "abs(x)",
        "1e300*x^2",
        "1e-300*x^2",
        ROOT,
        "sqrt(x^2)",
        "0.005 - sqrt(0.005^2 - x^2)",
    ] {
        for &force in forces {
            let force = if profile == ROOT { force.max(1e-30) } else { force };
            match attempt(profile, pressed(force)) {
                Ok(contact) => {
                    assert!(contact.settlement().is_finite() && contact.settlement() > 0.0);
                    assert!(contact.pressure(1e-5).unwrap() >= 0.0, "{profile} {force}");
                    for x in [1e-200, 1e-100, 1e-20] {
                        assert!(!contact.pressure(x).unwrap().is_nan(), "{profile} {force} {x}");
                    }
                }
                Err(error) => assert!(!error.to_string().is_empty()),
            }
        }
    }
}

#[test]
fn hundreds_of_rings() {
    for crests in [240, 1024, 3000] {
        let profile = format!("1e-6*cos(2*pi*{crests}*x/5e-3) + 1e-3*x^2");
        match attempt(&profile, pressed(10.0)) {
            Err(Error::TooManyZones { zones, most: 48 }) => assert!(zones > 48),
            other => panic!("{crests}: {other:?}"),
        }
    }
}

//! Extreme wishes end in an answer or in words, never in a panic or a wrong number.

use crate::inverse::support::{load, physical, unilateral};
use shtaerman::Error;
use shtaerman::inverse::{
    Goal, InverseError, Normalisation, crown, force, prescribed_pressure, roughness,
};

const EXTREMES: [f64; 5] = [-1e300, 0.0, f64::MIN_POSITIVE, 1.0, f64::MAX];

#[test]
fn extreme_wishes() {
    let problems = [physical(200e9, 1.2e-14, 5e-3, "x^2/(2*0.5)", load(8e5, 100.0))];
    for problem in &problems {
        for wanted in EXTREMES {
            for goal in
                [Goal::PeakPressure(wanted), Goal::ContactWidth(wanted), Goal::Settlement(wanted)]
            {
                for found in [force(problem, goal), roughness(problem, goal)] {
                    match found {
                        Ok(found) => assert!(found.relative_error() < 1e-6, "{goal:?}"),
                        Err(error) => assert!(!error.to_string().is_empty()),
                    }
                }
            }
        }
        // Every limit but those out of range costs the same trials.
        for limit in [-1e300, 1.0] {
            match crown(problem, Some(limit)) {
                Ok(crown) => assert!(crown.best.contact.peak_pressure() <= limit),
                Err(error) => assert!(!error.to_string().is_empty()),
            }
        }
    }
}

#[test]
fn a_settlement_of_zero_is_a_wish_like_any_other() {
    // Far off centre the middle rises as the layer gives: from positive to negative.
    let problem = physical(200e9, 1e-14, 5e-3, "0", load(8e5, 0.8e6 * 4e-3));
    let error_or_zero = roughness(&problem, Goal::Settlement(0.0));
    if let Ok(found) = error_or_zero {
        assert!(found.reached.abs() < 1e-10 * found.contact.tilt().abs() * 5e-3);
    }
}

#[test]
fn hostile_pressures() {
    let problem = unilateral(1.0, "0", load(1.0, 0.0));
    for text in [
        "",
        "(",
        "1e999",
        "exp(1000*xi)",
        "1e300",
        "1e-300",
        "tan(2*xi)",
        "abs(xi)^0.001",
        "where(xi>0,1,1/0)",
        "cos(5000*xi)+1",
        "sqrt(xi)",
        "xi^-2",
        "\u{0}",
        "1+1+",
    ] {
        match prescribed_pressure(&problem, text, Normalisation::Lowest, 65) {
            Ok(shaped) => {
                assert!(shaped.heights.iter().all(|f| f.is_finite() && *f >= 0.0), "{text}");
            }
            Err(error) => assert!(!error.to_string().is_empty()),
        }
    }
}

/// What lies beyond the end of a range by less than six digits show is told with as many digits as it takes: "no roughness gives 3.5 mm: it can be from 3.5 mm" denied itself.
#[test]
fn a_wish_just_beyond_a_range_is_told_from_its_end() {
    let problem = physical(200e9, 1e-14, 5e-3, "x^2/(2*2)", load(2e5, 0.0));
    let Err(Error::Inverse(InverseError::NoSuchValue { least, .. })) =
        roughness(&problem, Goal::ContactWidth(1e-3))
    else {
        panic!("no such width")
    };
    let wanted = least * (1.0 - 1e-9);
    let message = roughness(&problem, Goal::ContactWidth(wanted)).unwrap_err().to_string();
    let (said, range) = message.split_once(": it can be from ").unwrap();
    let (_, said) = said.split_once("contact width of ").unwrap();
    let (from, _) = range.split_once(" to ").unwrap();
    assert_ne!(said, from, "{message}");
    assert_eq!(said.get(..6), from.get(..6), "{message}");
}

//! The linearised equation against differences of complete solves.

use shtaerman::{Contact, Derivatives, Geometry, Rotational, Sensitivities, Solver, Vertical};

use crate::smooth_graded::support::Case;

/// Every derivative by the logarithm of its parameter, with the size of its quantity and its stated error.
fn rows(contact: &Contact, found: &Sensitivities) -> Vec<(String, f64, f64, f64)> {
    let graded = contact.problem().foundation().grading().map(|grading| grading.modulus());
    let modulus = graded.unwrap_or(contact.problem().scaling().unwrap().pressure());
    let turned = contact.settlement() / contact.problem().punch().half_width();
    let parts: [(&str, Option<Derivatives>, f64); 5] = [
        ("settlement", found.settlement, contact.settlement()),
        ("force", found.force, contact.force()),
        ("tilt", found.tilt, turned),
        ("pressure", found.peak_pressure, contact.peak_pressure()),
        ("width", Some(found.contact_width), contact.contact_width()),
    ];
    let mut rows = Vec::new();
    for (name, derivatives, size) in parts {
        let Some(d) = derivatives else { continue };
        assert_eq!(d.roughness, None);
        for (by, rate, at) in [
            ("modulus", d.young_modulus, modulus),
            ("force", d.force, contact.force()),
            ("settlement", d.settlement, contact.settlement()),
        ] {
            rows.extend(rate.map(|r| (format!("{name} by {by}"), r * at, size.abs(), d.error)));
        }
    }
    rows
}

#[track_caller]
fn agree(case: &Case, profile: &str, vertical: Vertical, rotational: Rotational) {
    let contact = case.solve(profile, vertical, rotational);
    let tangent = contact.tangent_sensitivities().unwrap();
    let differences = contact.difference_sensitivities().unwrap();
    assert_eq!(contact.sensitivities().unwrap(), tangent);
    assert_eq!(tangent.held, differences.held);
    let (one, two) = (rows(&contact, &tangent), rows(&contact, &differences));
    assert!(one.len() == two.len() && one.len() > 3);
    for ((name, one, size, stated), (_, two, _, other)) in one.iter().zip(&two) {
        let gap = (one - two).abs() / size.max(two.abs());
        let allowed = 3.0 * (stated + other) + 1e-10;
        assert!(
            gap <= allowed && gap < 1e-8,
            "{name} of {profile} at {}: {one} {two}, off {gap:.1e}, stated {stated:.0e} {other:.0e}",
            case.mu
        );
    }
}

const EXPONENTS: [f64; 3] = [0.2, 0.5, 0.8];

#[test]
fn strips() {
    let forced = Vertical::Force(0.05);
    for mu in EXPONENTS {
        let case = Case::plane(mu);
        agree(&case, "x^2/2", forced, Rotational::Moment(0.0));
        agree(&case, "x^2/2 + x^3/5", forced, Rotational::Moment(0.003));
        agree(&case, "x^2/2", forced, Rotational::Eccentricity(0.1));
        agree(&case, "abs(x)/3", forced, Rotational::Eccentricity(0.03));
        agree(&case, "0", forced, Rotational::Moment(0.01));
        agree(&case, "0", forced, Rotational::Eccentricity(-0.9));
        agree(&case, "x^2/200", Vertical::Force(0.5), Rotational::Moment(0.02));
        let settled = Vertical::Settlement(case.press("x^2/2", 0.05).settlement());
        agree(&case, "x^2/2", settled, Rotational::Moment(0.0));
        agree(&case, "x^2/2 + x^3/9", settled, Rotational::Tilt(0.01));
        agree(&case, "x^2/2", settled, Rotational::Eccentricity(0.01));
        let bilateral = Case { solver: Solver::bilateral(), ..case };
        agree(&bilateral, "cosh(x)", forced, Rotational::Moment(0.01));
    }
}

#[test]
fn several_zones() {
    let forced = Vertical::Force(0.004);
    for mu in EXPONENTS {
        let case = Case { half_width: 0.5, ..Case::plane(mu) };
        agree(&case, "(x^2 - 0.09)^2", forced, Rotational::Eccentricity(0.02));
        agree(&case, "(x^2 - 0.09)^2", forced, Rotational::Tilt(0.001));
        let geometry = Geometry::Pair { inner_half_gap: 0.1 };
        let pair = Case { geometry, ..case };
        agree(&pair, "0", forced, Rotational::Eccentricity(0.1));
        agree(&pair, "x^2/2", forced, Rotational::Moment(0.0));
    }
}

#[test]
fn disks() {
    let forced = Vertical::Force(0.05);
    for mu in EXPONENTS {
        let case = Case::disk(mu);
        agree(&case, "x^2/2", forced, Rotational::Moment(0.0));
        agree(&case, "abs(x)/3", forced, Rotational::Moment(0.0));
        agree(&case, "x^2/100", Vertical::Force(0.5), Rotational::Moment(0.01));
        agree(&case, "0", forced, Rotational::Eccentricity(0.1));
        agree(&case, "0", forced, Rotational::Tilt(1e-3));
        let settled = Vertical::Settlement(case.press("x^2/2", 0.05).settlement());
        agree(&case, "x^2/2", settled, Rotational::Moment(0.0));
        let bilateral = Case { solver: Solver::bilateral(), ..case };
        agree(&bilateral, "x^2/2", forced, Rotational::Moment(0.01));
    }
}

//! Kinks without a switch and features between all samples: by product integration on panels cut where they are (as `data/traces.py`), to 1e-14.

use crate::unilateral::support::force_and_moment;
use shtaerman::{Contact, ContactKind, Error, Foundation, Load, Problem, Profile, Punch, Solver};

fn solved(theta0: f64, profile: &str, load: Load, contact: ContactKind) -> Result<Contact, Error> {
    let profile = Profile::expression(profile).unwrap();
    let solver = Solver::default().with_contact(contact);
    Problem::new(
        Foundation::dimensionless(theta0).unwrap(),
        Punch::new(1.0).unwrap().with_profile(profile),
        load,
    )
    .unwrap()
    .with_solver(solver)
    .solve()
}

fn agrees(contact: &Contact, [settlement, tilt]: [f64; 2], pressures: [(f64, f64); 3]) {
    let stated = contact.dimensionless().error().unwrap();
    assert!(contact.relative_error() < 1e-11, "{stated:?}");
    // The truth is rounded, too.
    let rounding = 2e-14 * settlement;
    for (found, known, error) in [
        (contact.dimensionless().settlement(), settlement, stated.settlement),
        (contact.dimensionless().tilt(), tilt, stated.tilt),
    ] {
        assert!((found - known).abs() <= error + rounding, "{found} {known} {error:e}");
    }
    for (xi, known) in pressures {
        let off = (contact.dimensionless().pressure(xi).unwrap() - known).abs();
        assert!(off <= stated.pressure + 4.0 * rounding, "{xi}: {off:e}");
    }
}

#[test]
fn a_kink_in_hiding_is_found() {
    for contact in [ContactKind::Unilateral, ContactKind::Bilateral] {
        let load = force_and_moment(0.926, 0.00739);
        let found = solved(0.816, "sqrt((xi+0.0802)^2)", load, contact).unwrap();
        let pressures =
            [(-1.0, 0.3595607904583472), (-0.0802, 0.692556927728873), (0.5, 0.42763182157113633)];
        agrees(&found, [1.5981247831020615, -0.13861596140059443], pressures);
    }
}

#[test]
fn a_feature_between_all_samples_is_found() {
    for contact in [ContactKind::Unilateral, ContactKind::Bilateral] {
        let load = force_and_moment(4.0, 0.1);
        let profile = "0.3*xi^2+0.2*exp(-((xi-0.3137)/8e-4)^2)";
        let found = solved(3.0, profile, load, contact).unwrap();
        let pressures =
            [(-1.0, 4.946979648454064), (0.3137, 1.381313377830816), (0.5, 1.7440273012984004)];
        agrees(&found, [11.017169231343217, -0.7890256594677608], pressures);
    }
}

#[test]
fn what_no_sample_shows_is_not_said_to_be_exact() {
    let waves = solved(1.0, "cos(1e9*xi)", force_and_moment(20.0, 0.0), ContactKind::Unilateral);
    match waves {
        Ok(contact) => assert!(contact.relative_error() >= 1e-3, "{:e}", contact.relative_error()),
        Err(error) => assert!(error.is_numerical(), "{error}"),
    }
}

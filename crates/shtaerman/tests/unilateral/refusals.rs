//! What no contact can balance.

use crate::unilateral::support::{attempt, force_and_moment, load};
use shtaerman::{Elastic, Error, Foundation, Load, Problem, Punch, Rotational, Vertical};

#[test]
fn a_pull_lifts() {
    for force in [0.0, -1.0] {
        let error = attempt(1.0, "xi^2", force_and_moment(force, 0.0)).unwrap_err();
        assert!(
            error.to_string().contains("must be greater than zero in unilateral contact"),
            "{error}"
        );
    }
}

#[test]
fn a_moment_tips_over() {
    let body = Elastic::new(200e9, 0.3).unwrap();
    let (foundation, punch) =
        (Foundation::new(body).with_roughness(1e-13).unwrap(), Punch::new(5e-3).unwrap());
    let solve = |rotational| {
        let load = Load::new(Vertical::Force(1e6), rotational).unwrap();
        Problem::new(foundation.clone(), punch.clone(), load).unwrap().solve()
    };
    let error = solve(Rotational::Moment(-5001.0)).unwrap_err();
    assert!(error.to_string().contains("must be less than P a = 5000"), "{error}");
    let error = solve(Rotational::Eccentricity(6e-3)).unwrap_err();
    assert!(error.to_string().contains("must be less than a = 0.005"), "{error}");
    assert!(solve(Rotational::Moment(4999.0)).is_ok());
}

#[test]
fn a_base_that_is_clear_touches_nowhere() {
    for rotational in
        [Rotational::Tilt(0.1), Rotational::Moment(0.0), Rotational::Eccentricity(0.3)]
    {
        let load = load(Vertical::Settlement(-1.0), rotational);
        assert_eq!(attempt(1.0, "xi^2", load).unwrap_err(), Error::NoContact);
    }
    let load = load(Vertical::Settlement(0.01), Rotational::Tilt(0.0));
    assert!(attempt(1.0, "xi^2", load).is_ok());
}

#[test]
fn a_settlement_out_of_reach_of_an_eccentric_force() {
    // On a thin layer a flat punch turns about its middle once the force is at 2/3: it settles there no deeper than at first touch.
    let at = |settlement: f64, e: f64| {
        attempt(1e-6, "0", load(Vertical::Settlement(settlement), Rotational::Eccentricity(e)))
    };
    let error = at(1.0, 0.7).unwrap_err();
    assert!(matches!(error, Error::SettlementOutOfReach { .. }), "{error:?}");
    assert!(error.to_string().contains("is out of reach of a force"), "{error}");
    // Below it does, and the middle rises: p = alpha (xi - c) on c < xi < 1 has its centre at 1 - (1 - c)/3.
    let (e, settlement) = (0.8, -1.0);
    let contact = at(settlement, e).unwrap();
    let c = 3.0 * e - 2.0;
    assert!(
        (contact.dimensionless().zones()[0][0] - c).abs() < 1e-5,
        "{:?}",
        contact.dimensionless().zones()
    );
    assert!(
        (contact.dimensionless().tilt() - settlement / c).abs() < 1e-4,
        "{}",
        contact.dimensionless().tilt()
    );
    assert!((at(1.0, 0.6).unwrap().dimensionless().settlement() - 1.0).abs() < 1e-12);
}

#[test]
fn a_settlement_that_no_digits_lead_to() {
    // At 0.4 this base is touched first at f - 0.4 f' = 0.0127516 of the middle, and under any force the middle settles deeper.
    let (height, rate, e): (f64, f64, f64) =
        (0.062476686108078924, 2.314214961306721, 0.39691341704977146);
    let base = format!("{height}*exp({rate}*xi)");
    let first = height * (rate * e).exp() * (1.0 - rate * e);
    let rotational = Rotational::Eccentricity(e);
    let below = load(Vertical::Settlement(0.97 * first), rotational);
    assert!(attempt(7.267781411062088e-3, &base, below).is_err());
    for force in [1e-8, 1e-5, 1e-2, 1.0] {
        let contact =
            attempt(7.267781411062088e-3, &base, load(Vertical::Force(force), rotational));
        assert!(contact.unwrap().dimensionless().settlement() > first);
    }
    let above = load(Vertical::Settlement(1.5 * first), rotational);
    let contact = attempt(7.267781411062088e-3, &base, above).unwrap();
    assert!(contact.complementarity().unwrap().tension < 1e-9);
}

/// No size of a system that the program chose itself is a fault of the input.
#[test]
fn a_system_beyond_memory_is_no_bad_input() {
    let toml = "[dimensionless]\ngeometry = \"pair\"\ninner_half_gap = 0.3\ntheta0 = 3\nprofile = \"atan(1e7*(abs(xi)-0.5))\"\nforce = 1\nmoment = 0\n[solver]\ncontact = \"bilateral\"\n";
    let error = shtaerman::file::parse(toml, "test").unwrap().solve().unwrap_err();
    assert!(error.is_numerical(), "{error}");
}

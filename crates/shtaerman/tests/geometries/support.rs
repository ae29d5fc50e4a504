//! Problems in one line.

use shtaerman::{
    Contact, Error, Foundation, Geometry, Load, Problem, Profile, Punch, Rotational, Solver,
    Vertical,
};

pub(crate) fn attempt(
    (geometry, theta0, exponent): (Geometry, f64, f64),
    profile: &str,
    (vertical, rotational): (Vertical, Rotational),
    solver: Solver,
) -> Result<Contact, Error> {
    let (foundation, punch) = (
        Foundation::dimensionless(theta0)?.with_exponent(exponent)?,
        Punch::in_geometry(geometry, 1.0)?,
    );
    let load = Load::new(vertical, rotational)?;
    Problem::new(foundation, punch.with_profile(Profile::expression(profile).unwrap()), load)?
        .with_solver(solver)
        .solve()
}

#[track_caller]
pub(crate) fn solve(
    body: (Geometry, f64, f64),
    profile: &str,
    load: (Vertical, Rotational),
) -> Contact {
    attempt(body, profile, load, Solver::default()).unwrap()
}

#[track_caller]
pub(crate) fn solve_bilateral(
    body: (Geometry, f64, f64),
    profile: &str,
    load: (Vertical, Rotational),
) -> Contact {
    attempt(body, profile, load, Solver::bilateral()).unwrap()
}

/// A central load.
pub(crate) fn pressed(force: f64) -> (Vertical, Rotational) {
    (Vertical::Force(force), Rotational::Moment(0.0))
}

#[track_caller]
pub(crate) fn assert_near(found: f64, exact: f64, tolerance: f64) {
    let error = (found - exact).abs();
    assert!(error <= tolerance, "{found} instead of {exact}: {error:.1e} > {tolerance:.1e}");
}

/// `dP0/d delta0` of an answer against the difference quotient.
#[track_caller]
pub(crate) fn assert_stiffness(
    body: (Geometry, f64, f64),
    profile: &str,
    contact: &Contact,
    tolerance: f64,
) {
    let rotational = Rotational::Tilt(contact.dimensionless().tilt());
    let step = 1e-5 * contact.dimensionless().settlement().abs().max(1e-2);
    let force = |by: f64| {
        let vertical = Vertical::Settlement(contact.dimensionless().settlement() + by);
        solve(body, profile, (vertical, rotational)).dimensionless().force()
    };
    let slope = (force(step) - force(-step)) / (2.0 * step);
    let found = contact.dimensionless().stiffness().force_settlement;
    assert!((found / slope - 1.0).abs() < tolerance, "{found} {slope}");
}

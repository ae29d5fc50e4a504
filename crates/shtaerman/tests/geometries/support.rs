//! Problems in one line.

use shtaerman::{
    Contact, Error, Frame, Geometry, Load, Problem, Profile, Rotational, Solver, Vertical,
};

pub(crate) fn attempt(
    (geometry, theta0, exponent): (Geometry, f64, f64),
    profile: &str,
    (vertical, rotational): (Vertical, Rotational),
    solver: Solver,
) -> Result<Contact, Error> {
    let frame = Frame::dimensionless_in(geometry, theta0, exponent)?;
    let load = Load::new(vertical, rotational)?;
    Problem::new(frame, Profile::expression(profile).unwrap(), load, solver)?.solve()
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
    let rotational = Rotational::Tilt(contact.tilt0());
    let step = 1e-5 * contact.settlement0().abs().max(1e-2);
    let force = |by: f64| {
        let vertical = Vertical::Settlement(contact.settlement0() + by);
        solve(body, profile, (vertical, rotational)).force0()
    };
    let slope = (force(step) - force(-step)) / (2.0 * step);
    let found = contact.stiffness0().force_settlement;
    assert!((found / slope - 1.0).abs() < tolerance, "{found} {slope}");
}

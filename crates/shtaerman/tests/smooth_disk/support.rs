//! Circular punches in newtons, metres and pascals on steel.

use shtaerman::{
    Contact, Elastic, Error, Foundation, Load, Problem, Profile, Punch, Rotational, Solver,
    Vertical,
};

/// `E* = E/(1 - nu^2)`.
pub(crate) const MODULUS: f64 = 200e9 / (1.0 - 0.3 * 0.3);
/// Radius of the base.
pub(crate) const A: f64 = 5e-3;

pub(crate) fn problem(
    profile: Profile,
    roughness: f64,
    (vertical, rotational): (Vertical, Rotational),
    solver: Solver,
) -> Problem {
    let steel = Elastic::new(200e9, 0.3).unwrap();
    let (foundation, punch) =
        (Foundation::new(steel).with_roughness(roughness).unwrap(), Punch::circular(A).unwrap());
    Problem::new(foundation, punch.with_profile(profile), Load::new(vertical, rotational).unwrap())
        .unwrap()
        .with_solver(solver)
}

pub(crate) fn attempt(profile: &str, load: (Vertical, Rotational)) -> Result<Contact, Error> {
    problem(Profile::expression(profile).unwrap(), 0.0, load, Solver::default()).solve()
}

#[track_caller]
pub(crate) fn solve(profile: &str, load: (Vertical, Rotational)) -> Contact {
    attempt(profile, load).unwrap()
}

#[track_caller]
pub(crate) fn solve_bilateral(profile: &str, load: (Vertical, Rotational)) -> Contact {
    problem(Profile::expression(profile).unwrap(), 0.0, load, Solver::bilateral()).solve().unwrap()
}

pub(crate) fn pressed(force: f64) -> (Vertical, Rotational) {
    (Vertical::Force(force), Rotational::Moment(0.0))
}

pub(crate) fn sunk(settlement: f64) -> (Vertical, Rotational) {
    (Vertical::Settlement(settlement), Rotational::Moment(0.0))
}

/// Within a relative tolerance.
#[track_caller]
pub(crate) fn close(found: f64, exact: f64, tolerance: f64, what: &str) {
    let error = ((found - exact) / exact).abs();
    assert!(error <= tolerance, "{what}: {found} instead of {exact}: {error:.1e}");
}

/// The estimates of an answer hold against the truth, and are no larger than `most` of it.
#[track_caller]
pub(crate) fn honest(estimate: f64, error: f64, size: f64, most: f64, what: &str) {
    assert!(error.abs() <= estimate, "{what}: error {error:.1e}, estimate {estimate:.1e}");
    assert!(estimate <= most * size, "{what}: estimate {:.1e} of the size", estimate / size);
}

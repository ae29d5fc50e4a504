//! Problems in one line.

use std::f64::consts::PI;

use shtaerman::{Elastic, Foundation, Load, Problem, Profile, Punch, Rotational, Solver, Vertical};

pub(crate) fn load(force: f64, moment: f64) -> Load {
    Load::new(Vertical::Force(force), Rotational::Moment(moment)).unwrap()
}

pub(crate) fn bare(theta0: f64, profile: &str, load: Load, solver: Solver) -> Problem {
    let (foundation, punch) =
        (Foundation::dimensionless(theta0).unwrap(), Punch::new(1.0).unwrap());
    Problem::new(foundation, punch.with_profile(Profile::expression(profile).unwrap()), load)
        .unwrap()
        .with_solver(solver)
}

pub(crate) fn unilateral(theta0: f64, profile: &str, load: Load) -> Problem {
    bare(theta0, profile, load, Solver::default())
}

pub(crate) fn physical(
    modulus: f64,
    chi: f64,
    half_width: f64,
    profile: &str,
    load: Load,
) -> Problem {
    let foundation = Elastic::new(modulus, 0.3).unwrap();
    let (foundation, punch) =
        (Foundation::new(foundation).with_roughness(chi).unwrap(), Punch::new(half_width).unwrap());
    Problem::new(foundation, punch.with_profile(Profile::expression(profile).unwrap()), load)
        .unwrap()
}

/// The force that makes the smooth half-width 0.01 for `E* = R = 1`.
pub(crate) const HERTZ_FORCE: f64 = PI / 4.0 * 1e-4;

/// The rough parabola of the golden numbers: `E* = R = 1`.
pub(crate) fn parabola(chi: f64, force: f64) -> Problem {
    let body = Elastic::new(1.0, 0.0).unwrap();
    let (foundation, punch) =
        (Foundation::new(body).with_roughness(chi).unwrap(), Punch::new(0.2).unwrap());
    let profile = Profile::expression("x^2/2").unwrap();
    Problem::new(foundation, punch.with_profile(profile), load(force, 0.0)).unwrap()
}

#[track_caller]
pub(crate) fn close(found: f64, exact: f64, tolerance: f64) {
    assert!((found / exact - 1.0).abs() < tolerance, "{found} for {exact}");
}

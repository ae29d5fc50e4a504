//! Problems in one line.

use std::f64::consts::FRAC_PI_2;

use shtaerman::{
    Contact, Error, Foundation, Load, Problem, Profile, Punch, Rotational, Solver, Vertical,
};

pub(crate) fn load(vertical: Vertical, rotational: Rotational) -> Load {
    Load::new(vertical, rotational).unwrap()
}

pub(crate) fn force_and_moment(force: f64, moment: f64) -> Load {
    load(Vertical::Force(force), Rotational::Moment(moment))
}

pub(crate) fn problem(theta0: f64, profile: &str, load: Load) -> Problem {
    let (foundation, punch) =
        (Foundation::dimensionless(theta0).unwrap(), Punch::new(1.0).unwrap());
    Problem::new(foundation, punch.with_profile(Profile::expression(profile).unwrap()), load)
        .unwrap()
}

pub(crate) fn attempt(theta0: f64, profile: &str, load: Load) -> Result<Contact, Error> {
    problem(theta0, profile, load).solve()
}

#[track_caller]
pub(crate) fn solve(theta0: f64, profile: &str, load: Load) -> Contact {
    attempt(theta0, profile, load).unwrap()
}

/// The contact of the whole base, which may pull.
#[track_caller]
pub(crate) fn bilateral(theta0: f64, profile: &str, load: Load) -> Contact {
    let (foundation, punch) =
        (Foundation::dimensionless(theta0).unwrap(), Punch::new(1.0).unwrap());
    let profile = Profile::expression(profile).unwrap();
    Problem::new(foundation, punch.with_profile(profile), load)
        .unwrap()
        .with_solver(Solver::bilateral())
        .solve()
        .unwrap()
}

/// `int_left^right f(d) dxi` by the double-exponential rule, exact for logarithms at both ends.
pub(crate) fn integral(left: f64, right: f64, f: impl Fn(f64) -> f64) -> f64 {
    const HALF_COUNT: i32 = 250;
    const RANGE: f64 = 3.2;
    let step = RANGE / f64::from(HALF_COUNT);
    let length = right - left;
    (-HALF_COUNT..=HALF_COUNT)
        .map(|j| {
            let t = step * f64::from(j);
            let s = FRAC_PI_2 * t.sinh();
            let share = 1.0 / (1.0 + (-2.0 * s).exp());
            let derivative = FRAC_PI_2 * t.cosh() * 0.5 / s.cosh().powi(2);
            step * length * derivative * f((left + length * share).clamp(left, right))
        })
        .sum()
}

/// `int f dxi` over the zones, cut at a kink.
pub(crate) fn over_zones(contact: &Contact, kink: f64, f: impl Fn(f64) -> f64) -> f64 {
    (contact.dimensionless().zones().iter())
        .map(|&[left, right]| {
            let cut = kink.clamp(left, right);
            integral(left, cut, &f) + integral(cut, right, &f)
        })
        .sum()
}

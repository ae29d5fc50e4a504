//! Problems in one line, and a quadrature that shares nothing with the program.

use std::f64::consts::FRAC_PI_2;

use shtaerman::{Contact, Foundation, Load, Problem, Profile, Punch, Rotational, Solver, Vertical};

/// The spectral method with this degree.
pub(crate) fn solver(degree: usize) -> Solver {
    Solver::spectral(degree).unwrap()
}

/// The dimensionless contact with this base and load.
pub(crate) fn solve(theta0: f64, profile: &str, load: Load, degree: usize) -> Contact {
    let profile = Profile::expression(profile).unwrap();
    solve_profile(theta0, profile, load, degree)
}

pub(crate) fn solve_profile(theta0: f64, profile: Profile, load: Load, degree: usize) -> Contact {
    let (foundation, punch) =
        (Foundation::dimensionless(theta0).unwrap(), Punch::new(1.0).unwrap());
    Problem::new(foundation, punch.with_profile(profile), load)
        .unwrap()
        .with_solver(solver(degree))
        .solve()
        .unwrap()
}

pub(crate) fn load(vertical: Vertical, rotational: Rotational) -> Load {
    Load::new(vertical, rotational).unwrap()
}

pub(crate) fn force_and_moment(force: f64, moment: f64) -> Load {
    load(Vertical::Force(force), Rotational::Moment(moment))
}

pub(crate) fn settlement_and_tilt(settlement: f64, tilt: f64) -> Load {
    load(Vertical::Settlement(settlement), Rotational::Tilt(tilt))
}

/// `|found - exact| <= tolerance * scale`, with both values in the message.
#[track_caller]
pub(crate) fn assert_near(found: f64, exact: f64, tolerance: f64, what: &str) {
    assert!(
        (found - exact).abs() <= tolerance,
        "{what}: {found} instead of {exact}, {tolerance:e} allowed"
    );
}

/// `log2` of the ratio of two errors at `n` and `2 n`.
pub(crate) fn order(coarse: f64, fine: f64) -> f64 {
    (coarse / fine).log2()
}

/// `int_0^length f(d) dd` by the double-exponential rule; `d` keeps its digits near 0, where `f` may have a logarithm.
pub(crate) fn integrate(length: f64, f: impl Fn(f64) -> f64) -> f64 {
    const HALF_COUNT: i32 = 700;
    const RANGE: f64 = 3.2;
    let step = RANGE / f64::from(HALF_COUNT);
    (-HALF_COUNT..=HALF_COUNT)
        .map(|j| {
            let t = step * f64::from(j);
            let s = FRAC_PI_2 * t.sinh();
            // (1 + tanh s)/2 without cancellation at the left end.
            let place = 1.0 / (1.0 + (-2.0 * s).exp());
            let derivative = FRAC_PI_2 * t.cosh() * 0.5 / s.cosh().powi(2);
            step * length * derivative * f((length * place).min(length))
        })
        .sum()
}

/// `int_{-1}^{1} f dxi`, each half from its edge inwards.
pub(crate) fn integral(f: impl Fn(f64) -> f64) -> f64 {
    integrate(1.0, |d| f(-1.0 + d)) + integrate(1.0, |d| f(1.0 - d))
}

/// `int_{-1}^{1} ln(1/|xi - eta|) p0(eta) deta`, split at the singularity.
pub(crate) fn potential(contact: &Contact, xi: f64) -> f64 {
    let side = |length: f64, sign: f64| {
        if length == 0.0 {
            return 0.0;
        }
        integrate(length, |d| {
            -d.ln() * contact.dimensionless().pressure((xi + sign * d).clamp(-1.0, 1.0)).unwrap()
        })
    };
    side(1.0 - xi, 1.0) + side(1.0 + xi, -1.0)
}

//! Searches that their time limit ends.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use shtaerman::{Contact, Error, Problem, Profile, Punch, Solver};

/// With a limit that is over before the first step.
fn over(problem: &Problem) -> Problem {
    let solver = problem.solver().with_time_limit(Duration::from_nanos(1)).unwrap();
    problem.with_solver(solver)
}

fn limited(problem: &Problem) -> Result<Contact, Error> {
    over(problem).solve()
}

fn problem(theta0: f64, punch: Punch) -> Problem {
    let foundation = if theta0.is_finite() {
        shtaerman::Foundation::dimensionless(theta0).unwrap()
    } else {
        shtaerman::Foundation::new(shtaerman::Elastic::new(2e11, 0.3).unwrap())
    };
    Problem::new(foundation, punch, shtaerman::Load::force(1.0).unwrap()).unwrap()
}

#[test]
fn the_best_so_far_is_shown_and_its_audit_bounds_how_far_off_it_is() {
    let wavy = Profile::expression("xi^2 + 0.3*cos(9*xi)").unwrap();
    for theta0 in [0.5, 20.0] {
        let problem = problem(theta0, Punch::new(1.0).unwrap().with_profile(wavy.clone()));
        let exact = problem.solve().unwrap();
        let limit = Duration::from_nanos(1);
        assert_eq!(limited(&problem).unwrap_err(), Error::TimeLimit { limit });
        let best = over(&problem).solve_or_best().unwrap();
        assert!(best.is_unfinished() && !exact.is_unfinished());
        assert!(best.error().is_none(), "nothing is stated of it");
        assert!(best.warnings().iter().any(|warning| warning.message.contains("time limit")));
        let audited = best.clone().with_audit();
        let Some(Ok(audit)) = audited.audited_by() else { panic!("{:?}", audited.audited_by()) };
        assert!(audit.residual > 0.0);
        let bound = audited.error().unwrap().pressure;
        let off = (0..=200)
            .map(|i| f64::from(i) / 100.0 - 1.0)
            .map(|xi| (best.pressure(xi).unwrap() - exact.pressure(xi).unwrap()).abs())
            .fold(0.0, f64::max);
        assert!(off <= bound, "{theta0}: {off:e} off, {bound:e} stated");
        assert!((best.force() - 1.0).abs() < 1e-9, "the load is carried");
    }
}

#[test]
fn every_kind_of_search_ends() {
    let under =
        |punch: Punch, profile: &str| punch.with_profile(Profile::expression(profile).unwrap());
    let [plane, round, row] =
        [Punch::new(1.0), Punch::circular(1.0), Punch::periodic(1.0, 3.0)].map(Result::unwrap);
    for problem in [
        problem(3.0, under(plane.clone(), "xi^2")),
        problem(3.0, under(plane.clone(), "abs(xi)")),
        problem(3.0, under(round.clone(), "xi^2")),
        problem(3.0, under(row, "xi^2")),
        problem(f64::INFINITY, under(plane.clone(), "x^2")),
        problem(f64::INFINITY, under(round, "x^2 - 0.4*x^4")),
        problem(3.0, under(plane, "cos(40*xi)")).with_solver(Solver::bilateral()),
    ] {
        let found = limited(&problem);
        assert!(matches!(found, Err(Error::TimeLimit { .. })), "{found:?}");
        assert!(found.unwrap_err().is_numerical());
    }
}

#[test]
fn a_limit_that_is_not_reached_changes_nothing() {
    let problem = problem(
        7.0,
        Punch::new(1.0).unwrap().with_profile(Profile::expression("xi^2 - xi/3").unwrap()),
    );
    let solver = Solver::default().with_time_limit(Duration::from_secs(3600)).unwrap();
    let (one, two) = (problem.solve().unwrap(), problem.with_solver(solver).solve().unwrap());
    assert_eq!(one.settlement().to_bits(), two.settlement().to_bits());
    assert_eq!(one.error(), two.error());
    // What is asked of an answer later has time.
    let again = two.problem().with_force(0.5).unwrap();
    assert!(again.solve().is_ok());
    assert!(Solver::default().with_time_limit(Duration::ZERO).is_err());
}

#[test]
fn a_caller_who_does_not_wait_ends_a_search() {
    let wavy = Profile::expression("xi^2 + 0.3*cos(9*xi)").unwrap();
    let problem = problem(5.0, Punch::new(1.0).unwrap().with_profile(wavy));
    let exact = problem.solve().unwrap();
    let stop = Arc::new(AtomicBool::new(true));
    assert!(problem.solve_unless(&stop).is_none());
    stop.store(false, Ordering::Relaxed);
    let contact = problem.solve_unless(&stop).unwrap().unwrap();
    assert_eq!(contact.settlement().to_bits(), exact.settlement().to_bits());
    // What is asked of an answer afterwards is no search that could be ended.
    stop.store(true, Ordering::Relaxed);
    assert_eq!(contact.sensitivities(), exact.sensitivities());
    let limit = Duration::from_nanos(1);
    stop.store(false, Ordering::Relaxed);
    let late = over(&problem).solve_unless(&stop).unwrap();
    assert_eq!(late.unwrap_err(), Error::TimeLimit { limit });
}

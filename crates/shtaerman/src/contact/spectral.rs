//! Bilateral contact by the degenerate kernel, sections 2 and 3.

use fredholm::DegenerateSolver;
use fredholm::basis::{ChebyshevSeries, Function};
use fredholm::kernel::Logarithm;

use super::balance::Balance;
use super::potential::Potential;
use super::solved::{Method, Stiffness};
use super::{Draft, Target};
use crate::{Error, Problem};

/// First degree where none is given.
const FIRST_DEGREE: usize = 1024;
/// Last degree where neither a degree nor a tolerance is given.
const USUAL_DEGREE: usize = 1 << 17;
/// Last degree under an explicit tolerance.
const LAST_DEGREE: usize = 1 << 20;

/// Solves with the highest Chebyshev degree `degree`: closed-form Gram matrix (3.4), even and odd systems (3.10) and (3.11), symmetric positive form,
/// Cholesky or, for many terms, conjugate gradients with fast products.
pub(super) fn solve(problem: &Problem, function: &Function, degree: usize) -> Result<Draft, Error> {
    let kernel = Logarithm::unit();
    let solver = DegenerateSolver::new(&kernel, problem.frame().theta0(), degree)?;
    let power =
        |coefficients: &[f64]| ChebyshevSeries::new(coefficients.to_vec()).moments(degree + 1);
    let level = solver.solve(&power(&[1.0]))?;
    let tilted = solver.solve(&power(&[0.0, 1.0]))?;
    let profile = solver.solve(&function.series().moments(degree + 1))?;
    let balance = Balance {
        stiffness: Stiffness {
            force_settlement: level.projections()[0],
            coupling: tilted.projections()[0],
            moment_tilt: tilted.projections()[1],
        },
        free: [profile.projections()[0], profile.projections()[1]],
    };
    let state = balance.state(&problem.dimensionless_load());
    let potential = (level.correction().iter())
        .zip(tilted.correction())
        .zip(profile.correction())
        .map(|((level, tilted), profile)| state.settlement * level - state.tilt * tilted - profile)
        .collect();
    Ok(Draft {
        balance,
        state,
        potential: Potential::Series(ChebyshevSeries::new(potential)),
        method: Method { name: "spectral", n: degree },
        accuracy: None,
    })
}

/// The solution of a given degree with the estimate of its error: the difference from twice the degree, whose own error is a quarter at most.
pub(super) fn solve_with_estimate(
    problem: &Problem,
    function: &Function,
    degree: usize,
) -> Result<Draft, Error> {
    let mut draft = solve(problem, function, degree)?;
    // Twice a degree that just fits into memory does not: then half of it serves, which is more pessimistic.
    let other = match solve(problem, function, degree.saturating_mul(2)) {
        Err(Error::Equation(fredholm::Error::TooLarge { .. })) if degree > 1 => {
            solve(problem, function, degree / 2)?
        }
        other => other?,
    };
    draft.accuracy = Some(draft.difference(&other).scaled(4.0 / 3.0));
    Ok(draft)
}

/// Doubles the degree until the target is met, or the last degree is reached.
pub(super) fn solve_adaptively(
    problem: &Problem,
    function: &Function,
    target: Target,
) -> Result<Draft, Error> {
    let last = if target.is_explicit { LAST_DEGREE } else { USUAL_DEGREE };
    let first = (4.0 * problem.frame().theta0()).min(last as f64 / 2.0) as usize;
    let mut degree = first.max(FIRST_DEGREE).next_power_of_two();
    let mut coarse = solve(problem, function, degree)?;
    loop {
        degree *= 2;
        let mut fine = solve(problem, function, degree)?;
        // The end pressures converge slowest, as n^-2: the finer of two solutions is off by a third of their difference.
        fine.accuracy = Some(fine.difference(&coarse).scaled(0.5));
        if fine.meets(problem, target.tolerance) || 2 * degree > last {
            return Ok(fine);
        }
        coarse = fine;
    }
}

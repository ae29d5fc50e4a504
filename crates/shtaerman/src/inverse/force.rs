//! The force for a peak pressure or a contact width.

use super::search::{Range, Search};
use super::{Found, Goal, InverseError};
use crate::{Error, Load, Problem, Rotational, Scaling, Vertical};

/// How far from where it begins the search goes, as a factor.
const REACH: f64 = 1e15;
/// Least force that is tried, without dimensions: zones become too small for a solver.
const LEAST: f64 = 1e-12;

/// The force under which the contact has the peak pressure or the width wanted, keeping the tilt where the load prescribes it and the
/// eccentricity `M/P` otherwise; where the load prescribes a settlement with a moment, that of its answer.
///
/// Under a growing force both grow in all common cases, so there is one such force; where there are several, it is the one nearest to the
/// force of the problem. Where the whole base is to touch, it is the least force that makes it.
///
/// # Errors
/// [`Error::InvalidValue`] unless the goal is finite and positive; [`Error::Inverse`] when no force reaches it, with the attainable
/// range, and for a settlement as goal; what [`Problem::solve`] says of the problem itself.
pub fn force(problem: &Problem, goal: Goal) -> Result<Found, Error> {
    goal.check()?;
    if matches!(goal, Goal::Settlement(_)) {
        let words =
            "the force for a settlement needs no search: prescribe the settlement in [load]";
        return Err(InverseError::Unsuited(words).into());
    }
    let (start, rotational) = standing(problem)?;
    let posed = |force: f64| problem.with_load(Load::new(Vertical::Force(force), rotational)?);
    let unit = problem.bodies().unit(Scaling::force);
    let least = (start / REACH).max((LEAST * unit).min(start));
    Search { unknown: "force", goal, posed: &posed }
        .run(Range { start, ends: [least, start * REACH] })
}

/// A force to begin with, and what goes with every force.
fn standing(problem: &Problem) -> Result<(f64, Rotational), Error> {
    let load = problem.load();
    let force = match load.vertical {
        Vertical::Force(force) => force,
        Vertical::Settlement(_) => problem.solve()?.force(),
    };
    let requirement = "greater than zero: the search begins there";
    crate::error::require(force.is_finite() && force > 0.0, "force", force, requirement)?;
    Ok((force, load.rotational.standing(force)))
}

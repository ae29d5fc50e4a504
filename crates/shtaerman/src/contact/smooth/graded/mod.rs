//! The smooth limit on graded ground, plane: one zone of contact.
//!
//! `theta0 int |xi - eta|^-mu p0(eta) deta = delta0 - alpha0 xi - f0(xi)` on a zone. Corners hold a pressure that is singular as `d^-beta`, `beta = (1-mu)/2`, at
//! free edges it vanishes as `d^(1-beta)`.
//!
//! A [strip] with given ends is solved by the transforms of its even and odd parts, free [edges] are found by Newton's method after the
//! topology on cells, and the [check] between shows whether one zone is the answer.

mod check;
mod edges;
mod field;
mod stated;
mod strip;

use crate::Error;
use check::Check;
use field::Field;
use strip::Ground;

use super::problem::{Base, SmoothProblem};
use super::topology;
use super::zones::Zone;

/// Numbers of cells, each four times the one before.
const TOPOLOGIES: u32 = 2;
/// Tension and penetration, relative to their scales, that are rounding.
const ALLOWED: f64 = 2e-10;

/// A solved zone with what is left of complementarity.
#[derive(Debug)]
struct Solved {
    field: Field,
    left: Check,
    /// Of the slopes of a measured profile.
    tolerance: f64,
}

/// Solves a plane problem with the kernel `|d|^-mu`.
///
/// # Errors
/// Those of [`SmoothProblem::solve`]; [`Error::SeveralZones`] where one zone is no answer.
fn solve(problem: &SmoothProblem, exponent: f64) -> Result<Solved, Error> {
    let mut base = Base::new(problem)?;
    base.grading = Some(exponent);
    let ground = Ground::new(exponent, problem.theta0)?;
    let found = |zone: &Zone, settled: edges::Settled| {
        let field = Field::new(&base, &ground, *zone, &settled);
        let left = Check::new(&base, &field);
        Solved { field, left, tolerance: problem.profile.tolerance }
    };
    if !problem.is_unilateral {
        let zone = single(&base.pieces(), "a base of several pieces")?;
        return Ok(found(&zone, edges::fixed(&base, &ground, &zone)?));
    }
    let attempt = |zone: Zone| {
        let (zone, settled) = edges::settle(&base, &ground, zone)?;
        let solved = found(&zone, settled);
        solved.left.require().map(|()| solved)
    };
    // What passes the check is the answer, from wherever it was found: most need no cells.
    if let [zone] = base.pieces()[..]
        && let Ok(solved) = attempt(zone)
    {
        return Ok(solved);
    }
    let mut refused = None;
    for power in 0..TOPOLOGIES {
        let solved = from_cells(&base, power).and_then(attempt);
        match solved {
            Ok(solved) => return Ok(solved),
            Err(error) => refused = refused.or(Some(error)),
        }
    }
    Err(refused.unwrap_or(Error::NoContact))
}

/// The zone that cells show, if it is the only one.
fn from_cells(base: &Base<'_>, power: u32) -> Result<Zone, Error> {
    let intervals = topology::find(base, base.cells() * 4usize.pow(power))?;
    let zones: Vec<Zone> = intervals.iter().map(|[from, to]| base.zone(*from, *to)).collect();
    single(&zones, "a gap between zones")
}

/// The zone, if it is the only one.
fn single(zones: &[Zone], found: &'static str) -> Result<Zone, Error> {
    match zones {
        [zone] => Ok(*zone),
        [first, ..] => Err(Error::SeveralZones { variable: "xi", at: first.right(), found }),
        [] => Err(Error::NoContact),
    }
}

//! The smooth limit on graded ground, plane.
//!
//! `theta0 int |xi - eta|^-mu p0(eta) deta = delta0 - alpha0 xi - f0(xi)` on zones. Corners hold a pressure that is singular as `d^-beta`, `beta = (1-mu)/2`, at
//! free edges it vanishes as `d^(1-beta)`.
//!
//! On a [strip] with given ends the profile has [parts]: [kinks](kink), and a rest that is a [series] of the [polynomials](modes) which the kernel maps to multiples of
//! themselves or, where it bends otherwise, is solved by the transforms of its even and odd halves. Several strips are [coupled](couple) by those polynomials.
//! Free [edges] are found by Newton's method after the topology on cells, which the [check] between corrects.

mod check;
mod couple;
mod edges;
mod field;
mod kink;
mod linearised;
mod modes;
mod parts;
mod resolved;
mod series;
mod settled;
mod stated;
mod strip;

use crate::Error;
use check::Check;
use field::Field;
use settled::{Settled, fixed};
use strip::Ground;

use super::check::{Narrowing, narrowed};
use super::problem::{Base, MOST_CELLS, SmoothProblem};
use super::zones::{Zone, corrected, require_few};
use super::{FINE, MOST_ZONES, topology};
use crate::contact::valleys::require_shown;

/// Numbers of cells, each four times the one before.
const TOPOLOGIES: u32 = 2;
/// Corrections of the topology by the check, for each number of cells.
const CORRECTIONS: usize = 16;

/// Solved zones with what is left of complementarity.
#[derive(Debug)]
struct Solved {
    fields: Vec<Field>,
    left: Check,
    /// Of the slopes of a measured profile.
    tolerance: f64,
}

impl Solved {
    fn new(base: &Base<'_>, ground: &Ground, settled: &[Settled]) -> Self {
        let fields: Vec<Field> =
            settled.iter().map(|settled| Field::new(base, ground, settled)).collect();
        let left = Check::new(base, &fields);
        Self { fields, left, tolerance: base.problem.profile.tolerance }
    }
}

/// Solves a plane problem with the kernel `|d|^-mu`.
///
/// # Errors
/// Those of [`SmoothProblem::solve`].
fn solve(problem: &SmoothProblem, exponent: f64) -> Result<Solved, Error> {
    let mut base = Base::new(problem)?;
    base.grading = Some(exponent);
    let ground = Ground::new(exponent, problem.theta0)?;
    if !problem.is_unilateral {
        return Ok(Solved::new(
            &base,
            &ground,
            &fixed(&base, &ground, &base.pieces(), FINE.digits)?,
        ));
    }
    // What passes the check is the answer, from wherever it was found: a base with one valley needs no cells, and the transforms of one with many are long.
    let is_simple = base.valleys().count() <= 1;
    let mut left = [f64::NAN; 2];
    if is_simple {
        match from_whole(&base, &ground) {
            Ok(solved) => return Ok(solved),
            Err(violation) => left = violation,
        }
    }
    let mut refused = None;
    for power in 0..TOPOLOGIES {
        match from_cells(&base, &ground, power) {
            Ok(solved) => return Ok(solved),
            Err(error @ Error::TooManyZones { .. }) => return Err(error),
            Err(error) => refused = refused.or(Some(error)),
        }
    }
    if !is_simple {
        match from_whole(&base, &ground) {
            Ok(solved) => return Ok(solved),
            Err(violation) => left = violation,
        }
    }
    Err(match refused {
        // Of cells nobody has asked: that of the exact attempt tells more.
        Some(Error::Equation(fredholm::Error::NotConverged { .. })) => {
            Error::NotComplementary { tension: left[0], penetration: left[1] }
        }
        Some(error) => error,
        None => Error::NoContact,
    })
}

/// The answer from the whole base; else what is left of tension and penetration.
fn from_whole(base: &Base<'_>, ground: &Ground) -> Result<Solved, [f64; 2]> {
    let Ok(settled) = edges::settle(base, ground, &base.pieces()) else {
        return Err([f64::NAN; 2]);
    };
    let solved = Solved::new(base, ground, &settled);
    let left = [solved.left.tension, solved.left.penetration];
    if solved.left.is_clean() { Ok(solved) } else { Err(left) }
}

/// The answer from the zones that cells show, corrected where these were too coarse.
fn from_cells(base: &Base<'_>, ground: &Ground, power: u32) -> Result<Solved, Error> {
    let count = (base.cells() * 4usize.pow(power)).min(MOST_CELLS);
    let mut intervals = topology::find(base, count)?;
    require_shown(&intervals, &base.valleys().collect::<Vec<f64>>(), count, MOST_ZONES)?;
    let mut last = Error::NoContact;
    let mut narrowing = Narrowing::new();
    for _ in 0..CORRECTIONS {
        if intervals.is_empty() {
            break;
        }
        let zones: Vec<Zone> = intervals.iter().map(|[from, to]| base.zone(*from, *to)).collect();
        require_few(&zones, MOST_ZONES)?;
        let solved = Solved::new(base, ground, &edges::settle(base, ground, &zones)?);
        let left = &solved.left;
        if left.is_clean() {
            return Ok(solved);
        }
        let (tension, penetration) = (left.tension, left.penetration);
        last = Error::NotComplementary { tension, penetration };
        let zones: Vec<Zone> = solved.fields.iter().map(|field| field.strip.zone).collect();
        let Some(width) = narrowing.next(penetration) else { break };
        intervals = corrected(&zones, &left.pulling, &narrowed(&left.penetrating, width));
    }
    Err(last)
}

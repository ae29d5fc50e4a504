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
mod linearised;
mod parts;
mod settled;
mod stated;
mod strip;

use std::cell::OnceCell;

use super::detail::{COARSE, Detail, FINE};
use super::problem::{Base, SmoothProblem};
use super::topology;
use crate::Error;
use crate::contact::check::Check;
use crate::contact::edges::EndState;
use crate::contact::search::{ALLOWED, Equation, Start, complementary};
use crate::contact::valleys::MOST_CELLS;
use crate::contact::zones::{Walls, Zone};
use crate::deadline::Deadline;
use check::{Along, check};
use field::Field;
use settled::{Settled, fixed};
use strip::Ground;

/// Solved zones with what is left of complementarity.
#[derive(Debug)]
struct Solved {
    fields: Vec<Field>,
    along: Along,
    left: Check,
    /// Of the slopes of a measured profile.
    tolerance: f64,
}

/// Solves a plane problem with the kernel `|d|^-mu`.
///
/// # Errors
/// Those of [`SmoothProblem::solve`].
fn solve(problem: &SmoothProblem, exponent: f64) -> Result<Solved, Error> {
    let mut base = Base::new(problem)?;
    base.grading = Some(exponent);
    let equation = Strips { base, ground: Ground::new(exponent, problem.theta0)? };
    let (solved, left) = if problem.is_unilateral {
        complementary(&equation)?
    } else {
        let solved = equation.solve(&equation.base.whole(), &FINE, None)?;
        let left = equation.check(&solved, ALLOWED);
        (solved, left)
    };
    equation.seen(&solved);
    let Some((fields, along)) = solved.seen.into_inner() else { return Err(Error::NoContact) };
    Ok(Solved { fields, along, left, tolerance: problem.profile.tolerance })
}

/// The equation on strips of the base.
struct Strips<'p> {
    base: Base<'p>,
    ground: Ground,
}

/// The pressures on strips, with what is made of them once they are looked at.
struct OnStrips {
    settled: Vec<Settled>,
    seen: OnceCell<(Vec<Field>, Along)>,
}

impl Strips<'_> {
    fn seen<'s>(&self, solved: &'s OnStrips) -> &'s (Vec<Field>, Along) {
        solved.seen.get_or_init(|| {
            let fields: Vec<Field> = (solved.settled.iter())
                .map(|settled| Field::new(&self.base, &self.ground, settled))
                .collect();
            let along = Along::new(&self.base, &fields);
            (fields, along)
        })
    }
}

impl Equation for Strips<'_> {
    type Solved = OnStrips;
    type Effort = Detail;
    const MOST_ZONES: usize = <Base<'_> as Equation>::MOST_ZONES;

    fn may_lift(&self) -> bool {
        self.base.problem.is_unilateral
    }

    fn deadline(&self) -> &Deadline {
        &self.base.problem.deadline
    }

    fn walls(&self) -> &Walls {
        &self.base.walls
    }

    /// A base with one valley needs no cells, and the transforms of one with many are long.
    fn starts(&self) -> Vec<Start> {
        let first = self.base.cells();
        let mut starts = Start::on_cells(first, MOST_CELLS);
        let place = if self.base.valleys().count() <= 1 { 0 } else { starts.len() };
        starts.insert(place, Start::Whole);
        starts
    }

    fn pieces(&self) -> Vec<[f64; 2]> {
        self.base.problem.pieces.clone()
    }

    fn valleys(&self) -> Vec<f64> {
        self.base.valleys().collect()
    }

    fn intervals(&self, cells: usize) -> Result<Vec<[f64; 2]>, Error> {
        topology::find(&self.base, cells)
    }

    fn effort(&self, _zones: &[Zone], _before: Option<Detail>) -> Result<Detail, Error> {
        Ok(COARSE)
    }

    fn solve(
        &self,
        zones: &[Zone],
        effort: &Detail,
        _near: Option<&OnStrips>,
    ) -> Result<OnStrips, Error> {
        let settled = fixed(&self.base, &self.ground, zones, effort.digits)?;
        Ok(OnStrips { settled, seen: OnceCell::new() })
    }

    fn zones(&self, solved: &OnStrips) -> Vec<Zone> {
        solved.settled.iter().map(|settled| settled.strip.zone).collect()
    }

    fn force(&self, solved: &OnStrips, zone: usize) -> f64 {
        solved.settled[zone].strip.force
    }

    fn ends(&self, solved: &OnStrips) -> Vec<[EndState; 2]> {
        solved.settled.iter().map(|settled| edges::ends(&self.ground, settled)).collect()
    }

    fn check(&self, solved: &OnStrips, allowed: f64) -> Check {
        let (fields, along) = self.seen(solved);
        check(&self.base, fields, along, allowed)
    }

    /// The polynomials of one zone are kept to all digits from the first.
    fn refined(&self, coarse: OnStrips, _effort: &Detail) -> Result<OnStrips, Error> {
        if coarse.settled.len() == 1 {
            return Ok(coarse);
        }
        crate::contact::edges::settle(self, &self.zones(&coarse), &FINE)
    }
}

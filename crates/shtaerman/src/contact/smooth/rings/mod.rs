//! The smooth limit of a circular punch whose contact is rings, or a disk with rings about it.
//!
//! On a ring the [kernel] of the settlement is a logarithm of the radius and what is smooth beside it, so the [modes](coupling) of plane contact serve; a disk
//! inside the rings is eliminated by Galin's transforms. The zones are found as in plane contact: on [cells](topology), then free [edges] by Newton's method,
//! then a [check] between the nodes that corrects them.

use crate::contact::cells::LIMITS;
use crate::contact::intervals::SLIVER;
use crate::contact::promise::ROUGHEST;
use crate::deadline::Deadline;

mod answer;
mod base;
mod check;
mod coupling;
mod edges;
mod field;
mod ring;
mod stated;
mod system;
#[cfg(test)]
mod tests;
mod topology;

use super::disk::SmoothDisk;
use crate::Error;
use crate::contact::check::Check;
use crate::contact::edges::{EndState, settle};
use crate::contact::search::{ALLOWED, COARSELY_ALLOWED, Equation, Start, complementary};
use crate::contact::smooth::detail::{COARSE, Detail, FINE, MOST_WORK};
use crate::contact::solution::Solution;
use crate::contact::valleys;
use crate::contact::zones::{Walls, Zone};
use crate::error::require;
use answer::SmoothRingsContact;
use base::Base;
use check::check;
use system::Solved;

/// Solves for the zones of unilateral contact, a disk and rings as it comes, under a force or a settlement; in bilateral contact for the full base.
///
/// # Errors
/// [`Error::InvalidValue`] for a problem that is not one, a force that is not positive, a moment, a tilt or an exponent of grading that is not zero; [`Error::NoContact`];
/// [`Error::NotComplementary`] when no zones were found; [`Error::Equation`] where zones come too close to one another, or are too many, for the
/// modes that can be kept; [`Error::Overflow`] when the answer is not finite.
fn solve(problem: &SmoothDisk) -> Result<SmoothRingsContact, Error> {
    let base = Base::new(problem)?;
    let (field, requirement) = ("grading_exponent", "zero: rings on graded ground are not known");
    require(problem.exponent == 0.0, field, problem.exponent, requirement)?;
    let (field, turn) = problem.rotational();
    require(turn == 0.0, field, turn, "zero: rings under a moment or a tilt are not known")?;
    if !problem.is_unilateral {
        let solved = Solved::new(&base, &[Zone::new([0.0, 1.0], [false; 2]).about_axis()], FINE)?;
        let left = check(&base, &solved, ALLOWED);
        return SmoothRingsContact::new(&base, solved, &left);
    }
    let (solved, left) = complementary(&base)?;
    required(SmoothRingsContact::new(&base, solved, &left)?)
}

/// Whether contacts of rings can be solved for: without a tilt, on homogeneous ground.
fn are_possible(problem: &SmoothDisk) -> bool {
    problem.exponent == 0.0 && problem.rotational().1 == 0.0
}

/// Whether the contact is probably no single disk, so that transforms of disks can be spared: the base falls somewhere, and cells say so.
fn are_likely(problem: &SmoothDisk) -> bool {
    let is_disk = |base: Base<'_>| {
        let rises = base.samples.windows(2).all(|pair| pair[0].1 <= pair[1].1);
        if rises { Ok(true) } else { topology::is_disk(&base, base.cells()) }
    };
    are_possible(problem)
        && problem.is_unilateral
        && matches!(Base::new(problem).and_then(is_disk), Ok(false))
}

impl Equation for Base<'_> {
    type Solved = Solved;
    type Effort = Detail;
    const MOST_ZONES: usize = 48;

    fn may_lift(&self) -> bool {
        self.problem.is_unilateral
    }

    fn deadline(&self) -> &Deadline {
        &self.problem.deadline
    }

    fn walls(&self) -> &Walls {
        &self.walls
    }

    fn arranged(&self, mut zones: Vec<Zone>) -> Vec<Zone> {
        for zone in &mut zones {
            // A ring whose hole closes becomes a disk.
            if zone.left() < SLIVER * zone.right() {
                zone.ends[0] = 0.0;
            }
            *zone = zone.about_axis();
        }
        zones
    }

    fn starts(&self) -> Vec<Start> {
        Start::on_cells(self.cells(), self.cells().max(LIMITS.most))
    }

    fn pieces(&self) -> Vec<[f64; 2]> {
        vec![[0.0, 1.0]]
    }

    fn valleys(&self) -> Vec<f64> {
        valleys::valleys(&self.samples).collect()
    }

    fn intervals(&self, cells: usize) -> Result<Vec<[f64; 2]>, Error> {
        topology::find(self, cells)
    }

    fn effort(&self, _zones: &[Zone], _before: Option<Detail>) -> Result<Detail, Error> {
        Ok(COARSE)
    }

    fn solve(
        &self,
        zones: &[Zone],
        effort: &Detail,
        _near: Option<&Solved>,
    ) -> Result<Solved, Error> {
        let solved = Solved::new(self, zones, *effort)?;
        self.work.spend(solved.modes(), 0.0, MOST_WORK)?;
        Ok(solved)
    }

    fn zones(&self, solved: &Solved) -> Vec<Zone> {
        solved.zones.clone()
    }

    fn force(&self, solved: &Solved, zone: usize) -> f64 {
        solved.force(zone)
    }

    fn ends(&self, solved: &Solved) -> Vec<[EndState; 2]> {
        edges::ends(solved)
    }

    fn check(&self, solved: &Solved, allowed: f64) -> Check {
        check(self, solved, allowed)
    }

    fn refined(&self, coarse: Solved, _effort: &Detail) -> Result<Solved, Error> {
        settle(self, &coarse.zones, &FINE)
    }

    fn noise(&self, solved: &Solved, left: &Check) -> f64 {
        answer::noise(self, solved, left.largest).min(COARSELY_ALLOWED)
    }
}

/// Refuses an answer without digits.
fn required(contact: SmoothRingsContact) -> Result<SmoothRingsContact, Error> {
    let residual = contact.relative_error();
    if residual <= ROUGHEST {
        return Ok(contact);
    }
    let iterations = contact.method().n;
    Err(fredholm::Error::NotConverged { iterations, residual, tolerance: ROUGHEST }.into())
}

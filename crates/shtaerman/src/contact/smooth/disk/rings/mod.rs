//! The smooth limit of a circular punch whose contact is rings, or a disk with rings about it.
//!
//! On a ring the [kernel] of the settlement is a logarithm of the radius and what is smooth beside it, so the [modes](coupling) of plane contact serve; a disk
//! inside the rings is eliminated by Galin's transforms. The zones are found as in plane contact: on [cells](topology), then free [edges] by Newton's method,
//! then a [check] between the nodes that corrects them.

mod answer;
mod base;
mod check;
mod coupling;
mod edges;
mod field;
mod kernel;
mod ring;
mod system;
mod topology;

pub(crate) use answer::SmoothRingsContact;

use super::{ALLOWED, SmoothDisk};
use crate::Error;
use crate::contact::smooth::check::Check;
use crate::contact::smooth::search::{self, Searched};
use crate::contact::smooth::zones::Zone;
use crate::contact::smooth::{Detail, FINE};
use crate::contact::valleys;
use crate::error::require;
use base::Base;
use check::check;
use system::Solved;

/// A relative error beyond which there is no answer.
const WORST: f64 = 1e-3;

/// Solves for disk and rings of contact without a tilt.
pub(super) fn solve(problem: &SmoothDisk) -> Result<SmoothRingsContact, Error> {
    let base = Base::new(problem)?;
    let (field, requirement) = ("grading_exponent", "zero: rings on graded ground are not known");
    require(problem.exponent == 0.0, field, problem.exponent, requirement)?;
    let (field, turn) = problem.rotational();
    require(turn == 0.0, field, turn, "zero: rings under a moment or a tilt are not known")?;
    if !problem.is_unilateral {
        let solved = Solved::new(&base, &[Zone::new([0.0, 1.0], [false; 2])], FINE)?;
        let left = check(&base, &solved, ALLOWED);
        return SmoothRingsContact::new(&base, solved, &left);
    }
    let (solved, left) = search::complementary(&base)?;
    required(SmoothRingsContact::new(&base, solved, &left)?)
}

/// Whether the contact is probably no single disk, so that transforms of disks can be spared: the base falls somewhere, and cells say so.
pub(super) fn are_likely(problem: &SmoothDisk) -> bool {
    let is_disk = |base: Base<'_>| {
        let rises = base.samples.windows(2).all(|pair| pair[0].1 <= pair[1].1);
        if rises { Ok(true) } else { topology::is_disk(&base, base.cells()) }
    };
    problem.has_rings()
        && problem.is_unilateral
        && matches!(Base::new(problem).and_then(is_disk), Ok(false))
}

impl Searched for Base<'_> {
    type Solved = Solved;
    const MOST_ZONES: usize = 48;

    fn cells(&self) -> [usize; 2] {
        [self.cells(), self.cells().max(topology::MOST_CELLS)]
    }

    fn valleys(&self) -> Vec<f64> {
        valleys::valleys(&self.samples).collect()
    }

    fn intervals(&self, cells: usize) -> Result<Vec<[f64; 2]>, Error> {
        topology::find(self, cells)
    }

    fn zone(&self, left: f64, right: f64) -> Zone {
        self.zone(left, right)
    }

    fn settle(&self, zones: &[Zone], detail: Detail) -> Result<Solved, Error> {
        edges::settle(self, zones, detail)
    }

    fn check(&self, solved: &Solved, allowed: f64) -> Check {
        check(self, solved, allowed)
    }

    fn zones(solved: &Solved) -> Vec<Zone> {
        solved.zones.clone()
    }

    fn noise(&self, solved: &Solved, left: &Check) -> f64 {
        answer::noise(self, solved, left.largest)
    }
}

/// Refuses an answer without digits.
fn required(contact: SmoothRingsContact) -> Result<SmoothRingsContact, Error> {
    let residual = contact.relative_error();
    if residual <= WORST {
        return Ok(contact);
    }
    let iterations = contact.modes();
    Err(fredholm::Error::NotConverged { iterations, residual, tolerance: WORST }.into())
}

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

pub use answer::SmoothRingsContact;

use super::{ALLOWED, SmoothDisk};
use crate::Error;
use crate::contact::smooth::check::{Check, Narrowing};
use crate::contact::smooth::zones::{Zone, corrected, require_few};
use crate::contact::smooth::{COARSE, COARSELY_ALLOWED, CORRECTIONS, FINE, TOPOLOGIES};
use crate::contact::valleys::{self, require_shown};
use crate::error::require;
use base::Base;
use check::check;
use system::Solved;

/// Most rings that are solved.
const MOST_RINGS: usize = 48;
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
    complementary(&base)
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

/// The answer, with its zones corrected where all modes show what few did not.
fn complementary(base: &Base<'_>) -> Result<SmoothRingsContact, Error> {
    let mut zones = find_zones(base)?;
    let mut last = [f64::NAN; 2];
    let mut narrowing = Narrowing::new();
    for _ in 0..CORRECTIONS {
        let solved = match edges::settle(base, &zones, FINE) {
            Ok(solved) => solved,
            // What is left of an attempt says more than why the next had none.
            Err(_) if last[1].is_finite() => break,
            Err(error) => return Err(error),
        };
        let left = check(base, &solved, ALLOWED);
        if left.is_clean() {
            return required(SmoothRingsContact::new(base, solved, &left)?);
        }
        // What the modes do not resolve is no reason to correct zones.
        let noise = answer::noise(base, &solved, left.largest).min(COARSELY_ALLOWED);
        if check(base, &solved, ALLOWED.max(noise)).is_clean() {
            return required(SmoothRingsContact::new(base, solved, &left)?);
        }
        last = [left.tension, left.penetration];
        let Some(width) = narrowing.next(left.penetration) else { break };
        zones = amended(base, &solved, &left, width);
        if zones.is_empty() {
            break;
        }
    }
    Err(Error::NotComplementary { tension: last[0], penetration: last[1] })
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

/// The zones with few modes.
fn find_zones(base: &Base<'_>) -> Result<Vec<Zone>, Error> {
    let mut last = Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN };
    let valleys: Vec<f64> = valleys::valleys(&base.samples).collect();
    let counts = (0..TOPOLOGIES).map(|power| base.cells() * 4usize.pow(power as u32));
    let most = base.cells().max(topology::MOST_CELLS);
    let mut counts: Vec<usize> = counts.map(|count| count.min(most)).collect();
    counts.dedup();
    for count in counts {
        let zones = topology::find(base, count).and_then(|intervals| {
            require_shown(&intervals, &valleys, count, MOST_RINGS)?;
            Ok(intervals.iter().map(|[left, right]| base.zone(*left, *right)).collect())
        });
        match zones.and_then(|zones| corrected_zones(base, zones)) {
            Ok(zones) => return Ok(zones),
            Err(error @ Error::TooManyZones { .. }) => return Err(error),
            // What is left of an attempt says more than why the next had none.
            Err(error) => {
                let is_attempt = matches!(last, Error::NotComplementary { penetration, .. } if penetration.is_finite());
                if !is_attempt || matches!(error, Error::NotComplementary { .. }) {
                    last = error;
                }
            }
        }
    }
    Err(last)
}

fn corrected_zones(base: &Base<'_>, mut zones: Vec<Zone>) -> Result<Vec<Zone>, Error> {
    let mut last = Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN };
    let mut narrowing = Narrowing::new();
    for _ in 0..CORRECTIONS {
        if zones.is_empty() {
            break;
        }
        require_few(&zones, MOST_RINGS)?;
        let solved = edges::settle(base, &zones, COARSE)?;
        let left = check(base, &solved, COARSELY_ALLOWED);
        if left.is_clean() {
            return Ok(solved.zones);
        }
        let Check { tension, penetration, .. } = left;
        last = Error::NotComplementary { tension, penetration };
        let Some(width) = narrowing.next(left.penetration) else { break };
        zones = amended(base, &solved, &left, width);
    }
    Err(last)
}

/// The zones without tension and with what penetrates, in zones of this share.
fn amended(base: &Base<'_>, solved: &Solved, left: &Check, width: f64) -> Vec<Zone> {
    let intervals = corrected(&solved.zones, &left.pulling, &left.narrowed(width));
    intervals.iter().map(|[left, right]| base.zone(*left, *right)).collect()
}

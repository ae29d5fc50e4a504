//! The smooth limit: contact without a layer, plane, of a pair of punches, or periodic.
//!
//! `theta0 int K(xi - eta) p0(eta) deta = delta0 - alpha0 xi - f0(xi)` on the zones. The pressure is singular at the walls of the base,
//! `p0 = K/sqrt(2 pi d)` at a distance `d`, and vanishes as `sqrt(d)` at free edges.
//!
//! On given zones the [system] is solved by the spectral relation of the logarithm; in unilateral contact the [topology] is found on cells, the
//! free [edges] by Newton's method, and the [check] between nodes corrects the topology. A base that repeats without gaps has its own
//! [answer](wave) in full contact.

mod answer;
mod balance;
mod band;
mod check;
mod coupling;
mod density;
mod disk;
mod edges;
mod free_ends;
mod graded;
mod ground;
mod harmonics;
mod kernel;
mod legendre;
mod linear;
mod linearised;
mod panels;
mod problem;
mod roots;
mod search;
mod slopes;
mod stated;
mod system;
mod topology;
mod wave;
mod zones;

pub(crate) use answer::{SmoothContact, SmoothZone};
pub(crate) use kernel::SmoothKernel;
pub(crate) use problem::{Curve, SmoothProblem, SmoothProfile};

use crate::Error;
use check::check;
use problem::{Base, MOST_CELLS};
use search::Searched;
use zones::Zone;

/// How finely pressures on zones are resolved.
#[derive(Debug, Clone, Copy)]
struct Detail {
    /// Digits to which modes are kept.
    digits: f64,
    /// Panels of the slopes on a half turn before any is halved.
    panels: usize,
}

/// Detail while zones are looked for, in the answer, and for its error: with other panels rounding comes out differently, too.
const COARSE: Detail = Detail { digits: 9.0, panels: 8 };
const FINE: Detail = Detail { digits: 17.0, panels: 8 };
const COMPARED: Detail = Detail { digits: 12.0, panels: 7 };
/// Tension and penetration, relative to their scales, that are corrected at first, and in the answer.
const COARSELY_ALLOWED: f64 = 1e-6;
const ALLOWED: f64 = 2e-10;
/// Most zones that are solved: beyond, minutes go by.
const MOST_ZONES: usize = 120;

impl SmoothProblem {
    /// Solves the equation, and in unilateral contact finds the zones.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a problem that is not one, a force that is not positive in unilateral contact, a step inside a base in bilateral
    /// contact, and for a base that repeats without gaps anything but `tilt = 0`; [`Error::TipsOver`], [`Error::NoContact`];
    /// [`Error::NotComplementary`] when no zones were found; [`Error::Equation`] where zones come too close to one another, or are too
    /// many, for the modes that can be kept.
    pub(crate) fn solve(&self) -> Result<SmoothContact, Error> {
        if self.is_wave() {
            return wave::solve(self);
        }
        solve_zones(&Base::new(self)?, None)
    }
}

/// The answer on the zones of a base, for which a zone to try first may be known.
fn solve_zones(base: &Base<'_>, first: Option<Zone>) -> Result<SmoothContact, Error> {
    if base.problem.is_unilateral {
        return match first.and_then(|zone| tried(base, zone)) {
            Some(contact) => contact,
            None => {
                let (solved, left) = search::complementary(base)?;
                SmoothContact::new(base, solved, &left)
            }
        };
    }
    let solved = system::Solved::new(base, &base.pieces(), FINE)?;
    let left = check(base, &solved, ALLOWED);
    SmoothContact::new(base, solved, &left)
}

/// The answer if this zone leads there: the pressure without tension and penetration is but one.
fn tried(base: &Base<'_>, zone: Zone) -> Option<Result<SmoothContact, Error>> {
    let solved = edges::settle(base, &[zone], FINE).ok()?;
    let left = check(base, &solved, ALLOWED);
    left.is_clean().then(|| SmoothContact::new(base, solved, &left))
}

impl Searched for Base<'_> {
    type Solved = system::Solved;
    const MOST_ZONES: usize = MOST_ZONES;

    fn cells(&self) -> [usize; 2] {
        [self.cells(), MOST_CELLS]
    }

    fn valleys(&self) -> Vec<f64> {
        self.valleys().collect()
    }

    fn intervals(&self, cells: usize) -> Result<Vec<[f64; 2]>, Error> {
        topology::find(self, cells)
    }

    fn zone(&self, left: f64, right: f64) -> Zone {
        self.zone(left, right)
    }

    fn settle(&self, zones: &[Zone], detail: Detail) -> Result<Self::Solved, Error> {
        edges::settle(self, zones, detail)
    }

    fn check(&self, solved: &Self::Solved, allowed: f64) -> check::Check {
        check(self, solved, allowed)
    }

    fn zones(solved: &Self::Solved) -> Vec<Zone> {
        solved.parts.iter().map(|part| part.zone).collect()
    }
}

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
mod detail;
mod disk;
mod edges;
mod full;
mod graded;
mod kernel;
mod linearised;
mod open;
mod problem;
mod rings;
mod stated;
mod system;
mod told;
mod topology;
mod wave;

pub(crate) use answer::SmoothContact;
pub(crate) use kernel::SmoothKernel;
pub(crate) use problem::{Curve, SmoothProblem, SmoothProfile};

use crate::Error;
use crate::contact::check::Check;
use crate::contact::edges::{EndState, settle};
use crate::contact::search::{ALLOWED, Equation, Start};
use crate::contact::valleys::MOST_CELLS;
use crate::contact::zones::{Walls, Zone};
use crate::deadline::Deadline;
use check::check;
use detail::{A_PANEL, COARSE, Detail, FINE, MOST_WORK};
use open::solve_zones;
use problem::Base;
use system::Solved;

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

impl Equation for Base<'_> {
    type Solved = Solved;
    type Effort = Detail;
    // Beyond, minutes go by.
    const MOST_ZONES: usize = 120;

    fn may_lift(&self) -> bool {
        self.problem.is_unilateral
    }

    fn deadline(&self) -> &Deadline {
        &self.problem.deadline
    }

    fn walls(&self) -> &Walls {
        &self.walls
    }

    fn starts(&self) -> Vec<Start> {
        Start::on_cells(self.cells(), MOST_CELLS)
    }

    fn pieces(&self) -> Vec<[f64; 2]> {
        self.problem.pieces.clone()
    }

    fn valleys(&self) -> Vec<f64> {
        self.valleys().collect()
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
        self.work.spend(solved.modes(), A_PANEL * solved.panels() as f64, MOST_WORK)?;
        Ok(solved)
    }

    fn zones(&self, solved: &Solved) -> Vec<Zone> {
        solved.parts.iter().map(|part| part.zone).collect()
    }

    fn force(&self, solved: &Solved, zone: usize) -> f64 {
        solved.parts[zone].force()
    }

    fn ends(&self, solved: &Solved) -> Vec<[EndState; 2]> {
        edges::ends(solved)
    }

    fn check(&self, solved: &Solved, allowed: f64) -> Check {
        check(self, solved, allowed)
    }

    fn refined(&self, coarse: Solved, _effort: &Detail) -> Result<Solved, Error> {
        settle(self, &self.zones(&coarse), &FINE)
    }
}

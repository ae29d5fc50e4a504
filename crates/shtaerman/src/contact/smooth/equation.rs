//! Equations of the first kind on given zones, as the [search](crate::contact::search) knows them.

use std::sync::Arc;

use super::base::Base;
use super::check::check;
use super::pressure::Pressure;
use super::stated::noise;
use super::topology;
use crate::Error;
use crate::contact::check::Check;
use crate::contact::edges::{EndState, SMALL, settle};
use crate::contact::search::{COARSELY_ALLOWED, Equation, Start, unknown};
use crate::contact::valleys::MOST_CELLS;
use crate::contact::zones::{Walls, Zone};
use crate::deadline::{Deadline, work};

/// How finely pressures on zones are resolved.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact) struct Detail {
    /// Digits to which modes are kept.
    pub(super) digits: f64,
    /// Panels of the slopes on a half turn before any is halved.
    pub(super) panels: usize,
}

/// Detail while zones are looked for, in the answer, and for its error: with other panels rounding comes out differently, too.
pub(super) const COARSE: Detail = Detail { digits: 9.0, panels: 8 };
pub(super) const FINE: Detail = Detail { digits: 17.0, panels: 8 };
pub(super) const COMPARED: Detail = Detail { digits: 12.0, panels: 7 };

/// The equation of the first kind on one kind of ground.
pub(in crate::contact) trait FirstKind {
    type Solved: Pressure;
    /// Most zones that are coupled: beyond, minutes go by.
    const MOST_ZONES: usize = 120;

    fn base(&self) -> &Arc<Base>;

    /// The pressure on zones, from left to right.
    ///
    /// # Errors
    /// [`Error::NotComplementary`] for no zones, [`Error::Equation`] where something is not finite, [`Error::ZonesTooClose`].
    fn on_zones(&self, zones: &[Zone], detail: Detail) -> Result<Self::Solved, Error>;

    /// The same zones in another detail, or with less of each series, whose difference tells the error.
    fn compared(&self, solved: &Self::Solved) -> Option<Self::Solved>;
}

/// The pressure on zones where all of them are longer than nothing.
fn solved<F: FirstKind>(equation: &F, zones: &[Zone], detail: Detail) -> Result<F::Solved, Error> {
    let is_empty = |zone: &Zone| zone.length().is_nan() || zone.length() <= 0.0;
    if zones.is_empty() || zones.iter().any(is_empty) {
        return Err(unknown());
    }
    let solved = equation.on_zones(zones, detail)?;
    let (count, is_disk) = (solved.coupled() as f64, equation.base().ground.is_disk());
    let own = if is_disk { work::RINGS } else { work::MODES * count / zones.len() as f64 };
    equation.deadline().spend(work::SPECTRAL * count * count * (count + own));
    Ok(solved)
}

impl<F: FirstKind> Equation for F {
    type Solved = F::Solved;
    type Effort = Detail;
    const MOST_ZONES: usize = F::MOST_ZONES;

    fn may_lift(&self) -> bool {
        self.base().setting.is_unilateral()
    }

    fn deadline(&self) -> &Deadline {
        self.base().deadline()
    }

    fn walls(&self) -> &Walls {
        &self.base().walls
    }

    fn arranged(&self, zones: Vec<Zone>) -> Vec<Zone> {
        zones.into_iter().map(|zone| self.base().arranged(zone)).collect()
    }

    /// A base with one valley needs no cells.
    fn starts(&self) -> Vec<Start> {
        let base = self.base();
        let mut starts = Start::on_cells(base.cells(), MOST_CELLS);
        let place = if base.valleys().nth(1).is_none() { 0 } else { starts.len() };
        starts.insert(place, Start::Whole);
        // A settlement at an eccentricity is no problem of least energy, which more cells would come nearer to: what few do not show the forces tell.
        if base.setting.problem().settlement_at_eccentricity().is_some() {
            starts.truncate(2);
        }
        starts
    }

    fn pieces(&self) -> Vec<[f64; 2]> {
        self.base().begun()
    }

    fn valleys(&self) -> Vec<f64> {
        self.base().valleys().collect()
    }

    fn intervals(&self, cells: usize) -> Result<Vec<[f64; 2]>, Error> {
        topology::find(self.base(), cells)
    }

    fn effort(&self, _zones: &[Zone], _before: Option<Detail>) -> Result<Detail, Error> {
        Ok(COARSE)
    }

    fn solve(
        &self,
        zones: &[Zone],
        effort: &Detail,
        _near: Option<&F::Solved>,
    ) -> Result<F::Solved, Error> {
        solved(self, zones, *effort)
    }

    fn zones(&self, solved: &F::Solved) -> Vec<Zone> {
        solved.zones()
    }

    fn force(&self, solved: &F::Solved, zone: usize) -> f64 {
        solved.force(zone)
    }

    /// Those that more detail settles again are good enough where they are nearly right.
    fn ends(&self, solved: &F::Solved, effort: &Detail) -> Vec<[EndState; 2]> {
        let is_last = effort.digits >= FINE.digits || solved.is_fine();
        let sought = if is_last { 0.0 } else { SMALL };
        let end = |zone: usize, side: usize| {
            let end = solved.end(zone, side);
            let none = end.none.max(sought * end.scale);
            EndState { none, enough: none.max(end.rounding), ..end }
        };
        (0..solved.zones().len()).map(|zone| [end(zone, 0), end(zone, 1)]).collect()
    }

    fn check(&self, solved: &F::Solved, allowed: f64) -> Check {
        check(self.base(), solved, allowed)
    }

    fn refined(&self, coarse: F::Solved, _effort: &Detail) -> Result<F::Solved, Error> {
        if coarse.is_fine() {
            Ok(coarse)
        } else {
            settle(self, &coarse.zones(), &FINE, Some(&coarse))
        }
    }

    fn is_refined(&self, solved: &F::Solved) -> bool {
        solved.is_fine()
    }

    fn noise(&self, solved: &F::Solved, left: &Check) -> f64 {
        noise(self, solved, left.largest).min(COARSELY_ALLOWED)
    }
}

//! Contacts whose zones are known, or nearly, without the search for them and without a second number of nodes: companions of the expansion about the smooth limit.

use super::COARSELY_ALLOWED;
use super::answer::UnilateralContact;
use super::base::Base;
use super::check::{Check, check};
use super::edges;
use super::refinement::half_count;
use super::solved::{Solved, place};
use super::system::Resolution;
use super::zones::{End, Zone};
use crate::contact::accuracy::Accuracy;
use crate::{Error, Problem};

/// The ends of a zone, and which of them are free.
pub(in crate::contact) type KnownZone = ([f64; 2], [bool; 2]);

/// Nodes on either side of the middle of a panel that show a boundary layer to about 13 digits: as [`fredholm::collocation::first_half_count`], which is made for
/// direct solutions, but for any strength.
const NODES: f64 = 22.0;
const NODES_PER_DECADE: f64 = 16.0;
const MOST_NODES: usize = 2400;

impl Problem {
    /// The contact with zones near these, its free edges moved to where the pressure vanishes; `more` times the usual number of nodes. None where that fails.
    pub(in crate::contact) fn settled_near(
        &self,
        zones: &[KnownZone],
        more: f64,
    ) -> Option<UnilateralContact> {
        self.solved_by(zones, more, edges::settle)
    }

    /// The contact with exactly these zones, whose free edges are known better than this solution would show them.
    pub(in crate::contact) fn solved_on(
        &self,
        zones: &[KnownZone],
        more: f64,
    ) -> Option<UnilateralContact> {
        self.solved_by(zones, more, |base, resolution, zones| {
            let (solved, _) = Solved::new(base, resolution, zones, false, None)?;
            Ok((solved, 1))
        })
    }

    /// What a solver, which tells its number of solutions too, makes of zones; an answer that states no error: others tell.
    fn solved_by(
        &self,
        zones: &[KnownZone],
        more: f64,
        solve: impl Fn(&Base<'_>, &Resolution, &[Zone]) -> Result<(Solved, usize), Error>,
    ) -> Option<UnilateralContact> {
        let base = Base::new(self, self.solver().contact).ok()?;
        let zones = known(zones);
        let resolution = resolution(&base, &zones, more)?;
        let (solved, _) = solve(&base, &resolution, &zones).ok()?;
        Some(UnilateralContact::new(&base, solved, Accuracy::unstated(), 0.0, &Check::none()))
    }
}

impl UnilateralContact {
    /// Whether the pressure pulls nowhere and the base penetrates nowhere, but for what few nodes show.
    pub(in crate::contact) fn is_complementary(&self, problem: &Problem) -> bool {
        let base = Base::new(problem, problem.solver().contact);
        base.is_ok_and(|base| {
            base.is_bilateral || check(&base, self.solved(), COARSELY_ALLOWED).is_clean()
        })
    }

    /// `p0(xi)` between the ends of the panels, to about `1e-15/d` of its mean at the distance `d` from them, where [`super::Solution::pressure`] has that of `theta0` instead.
    pub(in crate::contact) fn density(&self, xi: f64) -> f64 {
        let solved = self.solved();
        let at = place(&solved.panels, &solved.hull, xi);
        solved.solution.density_at(at).unwrap_or(f64::NAN)
    }

    /// Which ends of each zone are free.
    pub(in crate::contact) fn free_ends(&self) -> Vec<[bool; 2]> {
        self.solved().zones.iter().map(|zone| zone.ends.map(|end| end.is_free)).collect()
    }

    /// Rounding of the pressure of the equation, everywhere.
    pub(in crate::contact) fn rounding(&self) -> f64 {
        self.solved().pressure_rounding()
    }

    /// Number of nodes on all panels.
    pub(in crate::contact) fn node_count(&self) -> usize {
        self.solved().positions.len()
    }
}

fn known(zones: &[KnownZone]) -> Vec<Zone> {
    let end = |at: f64, is_free: bool| End { at, is_free };
    (zones.iter())
        .map(|([left, right], free)| Zone { ends: [end(*left, free[0]), end(*right, free[1])] })
        .collect()
}

fn resolution(base: &Base<'_>, zones: &[Zone], more: f64) -> Option<Resolution> {
    let panels: Vec<(f64, f64)> = zones.iter().flat_map(|zone| zone.panels(&base.breaks)).collect();
    let longest = panels.iter().fold(0.0f64, |most, (left, right)| most.max(right - left));
    let strength = (0.5 * base.steepness() * longest).max(1.0);
    let count = half_count(more * (NODES + NODES_PER_DECADE * strength.log10()), 0);
    if 2 * count * panels.len() > MOST_NODES {
        return None;
    }
    Resolution::new(&base.medium, count).ok()
}

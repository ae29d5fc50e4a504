//! The collocated equation on zones, as the [search](crate::contact::search) knows it.

use fredholm::collocation::first_half_count;

use super::field::{RATIO, SincField};
use super::nodes::{Resolution, SincNodes};
use crate::Error;
use crate::contact::check::Check;
use crate::contact::edges::{EndState, settle};
use crate::contact::rough::base::Base;
use crate::contact::rough::check::check;
use crate::contact::rough::newton::{self, Found};
use crate::contact::rough::solved::Solved;
use crate::contact::rough::{coarse, refinement};
use crate::contact::search::{Equation, Start, Work, unknown};
use crate::contact::valleys::MOST_CELLS;
use crate::contact::zones::{Walls, Zone};
use crate::deadline::Deadline;

/// Nodes on either side of the middle of a panel for each valley of the whole base: `cos(k xi)` needs about `4 k`, and has `k/pi` valleys; and most of them. At half or twice 2 of 32 answers change, within what they state (survey).
const NODES_A_VALLEY: f64 = 12.0;
const MOST_FOR_VALLEYS: f64 = 160.0;
/// Noise of the pressure, relative to its largest, with which there is none: complementarity would be allowed everything.
const ALL_NOISE: f64 = 0.1;

/// Most nodes of all panels together, and cubes of their numbers, added up over Newton steps.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact::rough) struct Effort {
    pub(super) nodes: usize,
    pub(super) work: f64,
}

impl Effort {
    /// About ten seconds.
    pub(in crate::contact::rough) const MOST: Self = Self { nodes: 2400, work: 1e11 };
    /// About half a second, as long as an answer on panels with fast products takes.
    pub(in crate::contact::rough) const LITTLE: Self = Self { nodes: 900, work: 3e9 };
}

/// A base with what may be spent on it.
pub(in crate::contact::rough) struct Collocation<'b> {
    base: &'b Base,
    effort: Effort,
    work: Work,
}

impl<'b> Collocation<'b> {
    pub(in crate::contact::rough) fn new(base: &'b Base, effort: Effort) -> Self {
        Self { base, effort, work: Work::default() }
    }

    /// The answer on the whole base.
    pub(in crate::contact::rough) fn whole(&self) -> Result<Solved<SincField>, Error> {
        let zones = self.base.whole();
        let resolution = self.effort(&zones, None)?;
        self.finer_than(settle(self, &zones, &resolution)?, &resolution)
    }

    /// The answer on growing numbers of nodes, from one on few.
    pub(in crate::contact::rough) fn finer_than(
        &self,
        coarse: Solved<SincField>,
        resolution: &Resolution,
    ) -> Result<Solved<SincField>, Error> {
        let next = |solved: &Solved<SincField>, level: usize| {
            let strength = resolution.strength * RATIO.powi(level as i32);
            let nodes = 2.0 * strength * solved.nodes.panels.len() as f64;
            let is_spent = self.work.spent() > self.effort.work;
            // Two are compared with the first in any case.
            if level > 2 && (nodes > self.effort.nodes as f64 || is_spent) {
                return Ok(None);
            }
            let resolution = Resolution::new(&self.base.ground, strength)?;
            settle(self, &solved.nodes.zones, &resolution).map(Some)
        };
        refinement::refined(self.base, coarse, next)
    }

    /// Nodes on either side of the middle of a panel that are about right for the longest panel.
    fn strength(&self, zones: &[Zone]) -> f64 {
        let base = self.base;
        let panels = zones.iter().flat_map(|zone| zone.panels(&base.breaks));
        let longest = panels.fold(0.0f64, |most, (left, right)| most.max(right - left));
        let count = first_half_count(0.5 * base.steepness() * longest);
        // The pressure of a layer that bends ends with another power.
        let count = if base.layer.is_linear() { count } else { RATIO * count };
        // On fewer nodes a wavy base shows tension where there is none, and zones would be cut there.
        let waves = NODES_A_VALLEY * base.valleys().count() as f64 * 0.5 * longest;
        count.max(waves.min(MOST_FOR_VALLEYS)).max(base.ground.first_half_count(longest))
    }
}

impl Equation for Collocation<'_> {
    type Solved = Solved<SincField>;
    type Effort = Resolution;
    const MOST_ZONES: usize = 40;

    fn may_lift(&self) -> bool {
        !self.base.is_bilateral
    }

    fn deadline(&self) -> &Deadline {
        self.base.problem().deadline()
    }

    fn walls(&self) -> &Walls {
        &self.base.walls
    }

    fn spans_steps(&self) -> bool {
        true
    }

    fn ends_are_apart(&self) -> bool {
        true
    }

    fn zone(&self, ends: [f64; 2]) -> Zone {
        self.base.zone(ends)
    }

    fn arranged(&self, mut zones: Vec<Zone>) -> Vec<Zone> {
        if self.base.ground.is_disk() {
            zones.iter_mut().for_each(|zone| *zone = zone.about_axis());
        }
        zones
    }

    fn starts(&self) -> Vec<Start> {
        Start::on_cells(self.base.cells(), MOST_CELLS)
    }

    fn pieces(&self) -> Vec<[f64; 2]> {
        self.base.pieces.clone()
    }

    fn valleys(&self) -> Vec<f64> {
        self.base.valleys().collect()
    }

    fn intervals(&self, cells: usize) -> Result<Vec<[f64; 2]>, Error> {
        if cells == self.base.cells() {
            return Ok(self.base.coarse()?.intervals().to_vec());
        }
        Ok(coarse::loaded(self.base, cells)?.intervals().to_vec())
    }

    fn effort(&self, zones: &[Zone], before: Option<Resolution>) -> Result<Resolution, Error> {
        // Fewer than those that the answer begins with, which is compared with what was found, and so few that there is room for both and one more.
        let panels: usize = zones.iter().map(|zone| zone.panels(&self.base.breaks).len()).sum();
        let room = self.effort.nodes as f64 / (2.0 * RATIO * panels.max(1) as f64);
        let wanted = self.strength(zones).min(room) / RATIO;
        match before.filter(|known| known.strength >= wanted) {
            Some(known) => Ok(known),
            None => Resolution::new(&self.base.ground, wanted),
        }
    }

    fn finer(&self, solved: &Solved<SincField>, effort: &Resolution) -> Option<Resolution> {
        let room = self.effort.nodes as f64 / (2.0 * solved.nodes.panels.len() as f64);
        let finer = (effort.strength * RATIO).min(room);
        let is_finer = finer > effort.strength;
        if is_finer { Resolution::new(&self.base.ground, finer).ok() } else { None }
    }

    fn solve(
        &self,
        zones: &[Zone],
        effort: &Resolution,
        near: Option<&Solved<SincField>>,
    ) -> Result<Solved<SincField>, Error> {
        let nodes = SincNodes::new(self.base, effort, zones)?;
        let Found { step, inverse } = newton::solve(&nodes, near, None)?;
        let solved = Solved::new(&nodes, step).answering(&nodes, &inverse, None)?;
        self.work.spend(solved.given.len(), 0.0, self.effort.work)?;
        Ok(solved)
    }

    fn zones(&self, solved: &Solved<SincField>) -> Vec<Zone> {
        solved.nodes.zones.clone()
    }

    fn force(&self, solved: &Solved<SincField>, zone: usize) -> f64 {
        solved.zone_force(zone)
    }

    fn ends(&self, solved: &Solved<SincField>) -> Vec<[EndState; 2]> {
        solved.ends()
    }

    fn check(&self, solved: &Solved<SincField>, allowed: f64) -> Check {
        check(self.base, solved, allowed)
    }

    fn refined(
        &self,
        coarse: Solved<SincField>,
        effort: &Resolution,
    ) -> Result<Solved<SincField>, Error> {
        let solved = self.finer_than(coarse, effort)?;
        let is_noise = solved.noise() > ALL_NOISE && !self.deadline().is_past();
        if is_noise { Err(unknown()) } else { Ok(solved) }
    }

    fn noise(&self, solved: &Solved<SincField>, _left: &Check) -> f64 {
        2.0 * solved.noise()
    }
}

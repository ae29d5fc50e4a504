//! The equation of the second kind on zones of a rough surface, as the [search](crate::contact::search) knows it.

use super::base::Base;
use super::check::check;
use super::coarse;
use super::mirror::mirror;
use super::refinement::{ALL_NOISE, RATIO, refined, strength};
use super::solved::Solved;
use super::system::Resolution;
use crate::Error;
use crate::contact::check::Check;
use crate::contact::edges::EndState;
use crate::contact::search::{Equation, Start, unknown};
use crate::contact::valleys;
use crate::contact::valleys::MOST_CELLS;
use crate::contact::zones::{Walls, Zone};
use crate::deadline::Deadline;

/// Ends this close to a wall are there: the check looks just inside a wall. Half and twice change none of 20 answers (survey).
const BESIDE: f64 = 1e-11;

impl Equation for Base<'_> {
    type Solved = Solved;
    type Effort = Resolution;
    const MOST_ZONES: usize = 40;

    fn may_lift(&self) -> bool {
        !self.is_bilateral
    }

    fn deadline(&self) -> &Deadline {
        self.problem.deadline()
    }

    fn walls(&self) -> &Walls {
        &self.walls
    }

    fn spans_steps(&self) -> bool {
        true
    }

    fn ends_are_apart(&self) -> bool {
        true
    }

    /// Walls, steps of the base too, hold the contact until they pull: where the pressure rises towards one a free end would be led away from it.
    fn zone(&self, ends: [f64; 2]) -> Zone {
        let walls = [0, 1].map(|side| {
            let inwards = if side == 0 { BESIDE } else { -BESIDE };
            self.walls.near(side, ends[side] + inwards, 2.0 * BESIDE)
        });
        let zone = Zone::new(
            [0, 1].map(|side| walls[side].unwrap_or(ends[side])),
            walls.map(|wall| wall.is_none()),
        );
        if self.ground.is_disk() { zone.about_axis() } else { zone }
    }

    fn arranged(&self, mut zones: Vec<Zone>) -> Vec<Zone> {
        if self.is_mirrored {
            mirror(&mut zones);
        }
        if self.ground.is_disk() {
            zones.iter_mut().for_each(|zone| *zone = zone.about_axis());
        }
        zones
    }

    fn starts(&self) -> Vec<Start> {
        Start::on_cells(self.cells(), MOST_CELLS)
    }

    fn pieces(&self) -> Vec<[f64; 2]> {
        self.pieces.clone()
    }

    fn valleys(&self) -> Vec<f64> {
        valleys::valleys(&self.samples).collect()
    }

    fn intervals(&self, cells: usize) -> Result<Vec<[f64; 2]>, Error> {
        if cells == self.cells() {
            return Ok(self.coarse()?.intervals().to_vec());
        }
        Ok(coarse::loaded(self, cells)?.intervals().to_vec())
    }

    fn effort(&self, zones: &[Zone], before: Option<Resolution>) -> Result<Resolution, Error> {
        // Fewer than those that the answer begins with, which is compared with what was found, and so few that there is room for both and one more.
        let panels: usize = zones.iter().map(|zone| zone.panels(&self.breaks).len()).sum();
        let room = self.effort.nodes as f64 / (2.0 * RATIO * panels.max(1) as f64);
        let wanted = strength(self, zones).min(room) / RATIO;
        match before.filter(|known| known.strength >= wanted) {
            Some(known) => Ok(known),
            None => Resolution::new(&self.ground, wanted),
        }
    }

    fn finer(&self, solved: &Solved, effort: &Resolution) -> Option<Resolution> {
        let room = self.effort.nodes as f64 / (2.0 * solved.panels.len() as f64);
        let finer = (effort.strength * RATIO).min(room);
        if finer > effort.strength { Resolution::new(&self.ground, finer).ok() } else { None }
    }

    fn solve(
        &self,
        zones: &[Zone],
        effort: &Resolution,
        near: Option<&Solved>,
    ) -> Result<Solved, Error> {
        let solved = Solved::new(self, effort, zones, near)?;
        self.work.spend(solved.positions.len(), 0.0, self.effort.work)?;
        Ok(solved)
    }

    fn zones(&self, solved: &Solved) -> Vec<Zone> {
        solved.zones.clone()
    }

    fn force(&self, solved: &Solved, zone: usize) -> f64 {
        solved.zone_force(zone)
    }

    fn ends(&self, solved: &Solved) -> Vec<[EndState; 2]> {
        solved.ends()
    }

    fn check(&self, solved: &Solved, allowed: f64) -> Check {
        check(self, solved, allowed)
    }

    fn refined(&self, coarse: Solved, effort: &Resolution) -> Result<Solved, Error> {
        let solved = refined(self, &coarse, effort.strength * RATIO)?;
        if solved.noise() > ALL_NOISE { Err(unknown()) } else { Ok(solved) }
    }

    fn noise(&self, solved: &Solved, _left: &Check) -> f64 {
        2.0 * solved.noise()
    }
}

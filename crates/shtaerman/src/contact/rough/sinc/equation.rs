//! The collocated equation on zones, as the [search](crate::contact::search) knows it.

use std::cell::Cell;

use fredholm::collocation::first_half_count;

use super::nodes::{Resolution, SincField, SincNodes};
use crate::Error;
use crate::contact::accuracy::SAFETY;
use crate::contact::check::Check;
use crate::contact::edges::{CLOSE, EndState, SMALL, settle};
use crate::contact::rough::base::Base;
use crate::contact::rough::newton::{self, Found};
use crate::contact::rough::nodes::{MOST_DENSE, RATIO};
use crate::contact::rough::solved::{AtEnds, BESIDE, Solved};
use crate::contact::rough::{check, coarse, refinement};
use crate::contact::search::{Equation, Start, unknown};
use crate::contact::valleys::MOST_CELLS;
use crate::contact::zones::{Walls, Zone, mirror};
use crate::deadline::Deadline;
use crate::solver::AIM;

/// Nodes on either side of the middle of a panel for each valley of the whole base: `cos(k xi)` needs about `4 k`, and has `k/pi` valleys (survey).
const NODES_A_VALLEY: f64 = 12.0;
/// Most nodes with which the dense equation is quicker than panels (survey: `benches/plausible/run.py 5511 60`).
const QUICK: f64 = 350.0;
/// The same on disks, where products take longer: one with 564 nodes takes 0.2 s, and on panels 0.5 (`benches/plausible/run.py 9913 1 --only 54`).
const QUICK_ON_DISKS: f64 = 700.0;
/// Noise of the pressure, relative to its largest, with which there is none: complementarity would be allowed everything (one digit is the least that an answer has).
const ALL_NOISE: f64 = 0.1;
/// The least part of that: nodes crowd so much at an end that differences of the first have no digits left (rounding).
const NEAREST: f64 = 1e-3;

type OnZones = Solved<SincField>;

/// Most nodes of all panels together, and cubes of their numbers, added up over Newton steps.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact::rough) struct Effort {
    nodes: usize,
    work: f64,
}

impl Effort {
    /// Most nodes on either side of the middle of each of so many panels.
    pub(super) fn room(&self, panels: usize) -> f64 {
        self.nodes as f64 / (2.0 * panels.max(1) as f64)
    }

    /// About ten seconds.
    pub(in crate::contact::rough) const MOST: Self = Self { nodes: MOST_DENSE, work: 1e11 };
    /// About half a second, as long as an answer on panels with fast products takes.
    pub(in crate::contact::rough) const LITTLE: Self = Self { nodes: 900, work: 3e9 };
}

/// A base with what may be spent on it.
pub(in crate::contact::rough) struct Collocation<'b> {
    base: &'b Base,
    effort: Effort,
    spent: Cell<f64>,
    /// Whether the contact is its own mirror image.
    is_mirrored: bool,
}

impl<'b> Collocation<'b> {
    pub(in crate::contact::rough) fn new(base: &'b Base, effort: Effort) -> Self {
        Self { base, effort, spent: Cell::new(0.0), is_mirrored: base.is_mirrored() }
    }

    /// Whether an answer takes less time than on panels, as far as the zones tell that cells show; a layer that bends takes many steps on several of them (survey).
    pub(in crate::contact::rough) fn is_quick(&self) -> bool {
        let shown = self.base.coarse().unwrap_or_default();
        let zones: Vec<Zone> = shown.iter().map(|ends| self.base.zone(*ends)).collect();
        let panels: usize = zones.iter().map(|zone| zone.panels(&self.base.breaks).len()).sum();
        let takes_steps = !self.base.layer.is_linear() && zones.len() > 1;
        let quick = if self.base.ground.is_disk() { QUICK_ON_DISKS } else { QUICK };
        !takes_steps && 2.0 * panels as f64 * self.strength(&zones) <= quick
    }

    /// The answer on the whole base.
    pub(in crate::contact::rough) fn whole(&self) -> Result<OnZones, Error> {
        let zones = self.base.whole();
        let resolution = self.effort(&zones, None)?;
        self.finer_than(settle(self, &zones, &resolution, None)?, &resolution)
    }

    /// The answer on growing numbers of nodes, from one on few.
    fn finer_than(&self, coarse: OnZones, resolution: &Resolution) -> Result<OnZones, Error> {
        // Of ends that are off by `e` the pressure elsewhere is by `e^2`, but responses by `e`, which no `tolerance` of the pressure speaks of.
        let tolerance = self.base.problem().solver().tolerance.unwrap_or(AIM);
        let ends = tolerance.min(AIM) / (SAFETY * SAFETY);
        let next = |solved: &OnZones, level: usize| {
            let strength = resolution.strength * RATIO.powi(level as i32);
            let is_too_much = strength > self.effort.room(solved.nodes.panels.len())
                || self.spent.get() > self.effort.work;
            // Two are compared with the first in any case.
            if level > 2 && is_too_much {
                return Ok(None);
            }
            let resolution = Resolution::new(&self.base.ground, strength, ends)?;
            settle(self, &solved.nodes.zones, &resolution, Some(solved)).map(Some)
        };
        refinement::refined(self.base, coarse, false, next)
    }

    /// Nodes on either side of the middle of a panel that are about right for the longest panel.
    fn strength(&self, zones: &[Zone]) -> f64 {
        let base = self.base;
        let panels = zones.iter().flat_map(|zone| zone.panels(&base.breaks));
        let longest = panels.fold(0.0f64, |most, [left, right]| most.max(right - left));
        let count = first_half_count(0.5 * base.steepness() * longest);
        // The pressure of a layer that bends ends with another power.
        let count = if base.layer.is_linear() { count } else { RATIO * count };
        // On fewer nodes a wavy base shows tension where there is none, and zones would be cut there.
        let whole: f64 = base.pieces.iter().map(|[left, right]| right - left).sum();
        let waves = NODES_A_VALLEY * base.valleys().count() as f64 * longest / whole;
        count.max(waves).max(base.ground.first_half_count(longest))
    }
}

impl Equation for Collocation<'_> {
    type Solved = OnZones;
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
        if self.is_mirrored {
            mirror(&mut zones, CLOSE);
        }
        zones
    }

    /// Beyond the first number, which serves panels as well, no more cells than may be spent on one system: theirs is dense, too.
    fn starts(&self) -> Vec<Start> {
        let first = self.base.cells();
        let mut starts = Start::on_cells(first, MOST_CELLS);
        let fits = |cells: usize| cells == first || (cells as f64).powi(3) <= self.effort.work;
        starts.retain(|start| matches!(start, Start::Cells(cells) if fits(*cells)));
        starts
    }

    fn pieces(&self) -> Vec<[f64; 2]> {
        self.base.pieces.clone()
    }

    fn valleys(&self) -> Vec<f64> {
        self.base.valleys().collect()
    }

    fn intervals(&self, cells: usize) -> Result<Vec<[f64; 2]>, Error> {
        if cells == self.base.cells() {
            return Ok(self.base.coarse()?.to_vec());
        }
        coarse::intervals(self.base, cells)
    }

    fn effort(&self, zones: &[Zone], before: Option<Resolution>) -> Result<Resolution, Error> {
        // Fewer than those that the answer begins with, which is compared with what was found, and so few that there is room for both and one more.
        let panels: usize = zones.iter().map(|zone| zone.panels(&self.base.breaks).len()).sum();
        let room = self.effort.room(panels);
        let wanted = self.strength(zones).min(room / RATIO) / RATIO;
        match before.filter(|known| (wanted..=room).contains(&known.strength)) {
            Some(known) => Ok(known),
            None => Resolution::new(&self.base.ground, wanted, SMALL),
        }
    }

    fn finer(&self, solved: &OnZones, effort: &Resolution) -> Option<Resolution> {
        let finer = (effort.strength * RATIO).min(self.effort.room(solved.nodes.panels.len()));
        let is_finer = finer > effort.strength;
        if is_finer { Resolution::new(&self.base.ground, finer, SMALL).ok() } else { None }
    }

    fn solve(
        &self,
        zones: &[Zone],
        effort: &Resolution,
        near: Option<&OnZones>,
    ) -> Result<OnZones, Error> {
        let nodes = SincNodes::new(self.base, effort, zones)?;
        let Found { step, inverse } = newton::solve(&nodes, near)?;
        let mut solved = Solved::new(&nodes, step).answering(&nodes, &inverse, None)?;
        let free = (zones.iter().enumerate())
            .flat_map(|(j, zone)| zone.free_ends().map(move |(side, _)| (j, side)));
        solved.at_ends = free.fold(AtEnds::default(), |most, (j, side)| {
            let (layer, step) = solved.end(j, side);
            // Where the layer beside an end is flat there is no step.
            let off = if step.is_finite() { step.abs() } else { 0.0 };
            AtEnds { layer: most.layer.max(layer.abs()), off: most.off.max(off) }
        });
        self.spent.set(self.spent.get() + (solved.given.len() as f64).powi(3));
        if self.spent.get() <= self.effort.work { Ok(solved) } else { Err(unknown()) }
    }

    fn zones(&self, solved: &OnZones) -> Vec<Zone> {
        solved.nodes.zones.clone()
    }

    fn force(&self, solved: &OnZones, zone: usize) -> f64 {
        let (panels, count) = (solved.panels_of(zone), solved.nodes.a_panel());
        solved.masses[panels.start * count..panels.end * count].iter().sum()
    }

    fn ends(&self, solved: &OnZones, effort: &Resolution) -> Vec<[EndState; 2]> {
        let (rounding, scale) = (solved.rounding(), solved.deepest());
        let end = |zone: usize, side: usize| {
            let (value, step) = solved.end(zone, side);
            let none = (rounding / SAFETY).max(effort.ends * scale);
            EndState { value, rounding, scale, none, enough: rounding.max(none), step }
        };
        (0..solved.nodes.zones.len()).map(|zone| [end(zone, 0), end(zone, 1)]).collect()
    }

    fn check(&self, solved: &OnZones, allowed: f64) -> Check {
        check::check(self.base, solved, allowed)
    }

    fn refined(&self, coarse: OnZones, effort: &Resolution) -> Result<OnZones, Error> {
        let solved = self.finer_than(coarse, effort)?;
        let is_noise = solved.noise() > ALL_NOISE && !self.deadline().is_past();
        if is_noise { Err(unknown()) } else { Ok(solved) }
    }

    fn noise(&self, solved: &OnZones, _left: &Check) -> f64 {
        2.0 * solved.noise()
    }
}

impl OnZones {
    fn panels_of(&self, zone: usize) -> std::ops::Range<usize> {
        self.nodes.panels_of(&self.nodes.zones[zone])
    }

    /// The layer at an end, and Newton's step outwards to where it would vanish if it went on straight from there.
    ///
    /// The pressure vanishes at a free end as the layer does, straight; where that is so it does not change to first order when the end moves, and each end falls as the layer beside it
    /// says.
    fn end(&self, zone: usize, side: usize) -> (f64, f64) {
        let (panels, count) = (self.panels_of(zone), self.nodes.a_panel());
        let panel = if side == 0 { panels.start } else { panels.end - 1 };
        let [left, right] = self.nodes.panels[panel];
        let node = |k: usize| panel * count + if side == 0 { k } else { count - 1 - k };
        let depth = |k: usize| match side {
            0 => self.nodes.places[node(k)] - left,
            _ => right - self.nodes.places[node(k)],
        };
        // The node nearest to a distance from the end; those of a panel are in order.
        let beside = |distance: f64| -> [f64; 2] {
            let k = (1..count - 1).find(|k| depth(*k) >= distance).unwrap_or(count - 1);
            [depth(k), self.given[node(k)]]
        };
        let at_end = self.given[node(0)];
        let step = |distance: f64| {
            let first = beside(distance);
            let second = beside(2.0 * first[0]);
            let [one, two] = [first, second].map(|[depth, v]| (v - at_end) / depth);
            at_end * (second[0] - first[0]) / (one * second[0] - two * first[0])
        };
        // Within the length in which a thin layer bends, the slope far from the answer says nothing; near it that over the step itself is the one at the end.
        let far = BESIDE * (right - left);
        let first = step(far);
        let near = first.abs().max(NEAREST * far);
        (at_end, if first * at_end > 0.0 && near < far { step(near) } else { first })
    }
}

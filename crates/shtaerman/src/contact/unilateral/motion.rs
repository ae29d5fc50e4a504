//! Edges that move: how the pressure changes, and Newton's step to where it vanishes.
//!
//! An edge that moves with the velocity `V`, straight on its panel and zero elsewhere, changes the displacement `v` of the layer at points that move along by `v'`
//! with
//!
//! `v' + theta0 k K(p'(v) v') = -(alpha0 + f0') V - theta0 k int [V'(s) K + lever dK/dx] p(s) dm(s)`, `lever = V(x) - V(s)`; on a disk `V(x) - V(s) x/s`, and
//! `-mu V(s)/s` besides `V'(s)` where the body is graded.

use fredholm::SincSolution;

use super::elimination;
use super::solved::{Panel, end_node};
use super::system::{Direction, Factor, System};
use super::zones::Zone;
use crate::Error;
use crate::contact::balance::State;

/// Steps of the difference quotient of the profile, as a share of the panel: it serves Newton steps, not answers.
const DIFFERENCE: f64 = 1e-5;

/// From so many zones on each edge has a Newton step of its own; of fewer, in thin layers, such steps were seen to miss the zones.
const MANY: usize = 12;
/// Share of a panel beside its end over which the slope of the layer is taken, and share of the zone that an edge moves where no step is known.
const BESIDE: f64 = 0.02;
const STRIDE: f64 = 0.4;

/// Whether edges are taken one by one: where the pressure vanishes at all of them, it does not change to first order when they move, and each falls as the layer beside it says.
pub(super) fn are_many(zones: &[Zone]) -> bool {
    zones.len() >= MANY
}

/// A solution on the zones, with what its change needs.
pub(super) struct Tangent<'t> {
    pub(super) factor: &'t Factor<'t>,
    pub(super) solution: &'t SincSolution,
    pub(super) state: State,
}

impl System<'_, '_> {
    /// The Newton step of each end, left to right; 0 for those that are not free. `directions` are those of the level and of the slope.
    pub(super) fn steps(
        &self,
        tangent: &Tangent<'_>,
        mut directions: Vec<Direction>,
    ) -> Result<Vec<f64>, Error> {
        let free: Vec<(usize, usize)> = (0..self.zones.len())
            .flat_map(|zone| [(zone, 0), (zone, 1)])
            .filter(|&(zone, side)| self.zones[zone].ends[side].is_free)
            .collect();
        let mut steps = vec![0.0; 2 * self.zones.len()];
        if free.is_empty() {
            return Ok(steps);
        }
        if are_many(&self.zones) {
            for (zone, side) in free {
                steps[2 * zone + side] = self.own_step(tangent.solution.values(), zone, side);
            }
            return Ok(steps);
        }
        let nodes: Vec<usize> = (free.iter())
            .map(|&(zone, side)| end_node(&self.panels, self.panel_count(), zone, side))
            .collect();
        let slopes = self.profile_slopes();
        for &node in &nodes {
            directions.push(self.moved(tangent, &slopes, node)?);
        }
        let mut rows: Vec<Vec<f64>> = (0..2)
            .map(|k| {
                let mut row: Vec<f64> = directions.iter().map(|d| self.conditions(d)[k]).collect();
                row.push(0.0);
                row
            })
            .collect();
        for &node in &nodes {
            let mut row: Vec<f64> = directions.iter().map(|d| d.values[node]).collect();
            row.push(-tangent.solution.values()[node]);
            rows.push(row);
        }
        let found = elimination::solve(rows).ok_or_else(|| self.singular())?;
        for (&(zone, side), step) in free.iter().zip(&found[2..]) {
            steps[2 * zone + side] = *step;
        }
        Ok(steps)
    }

    /// The step of an end to where the layer that goes on straight from it would vanish.
    fn own_step(&self, layer: &[f64], zone: usize, side: usize) -> f64 {
        let count = self.panel_count();
        let end = end_node(&self.panels, count, zone, side);
        let panel = self.panels[end / count];
        let depth = |node: usize| match side {
            0 => self.positions[node] - panel.left,
            _ => panel.right - self.positions[node],
        };
        // The node nearest to a distance from the end; those of a panel are in order.
        let beside = |share: f64| -> [f64; 2] {
            let inside = |k: &usize| depth(if side == 0 { end + k } else { end - k }) >= share;
            let k = (1..count - 1).find(inside).unwrap_or(count - 1);
            let node = if side == 0 { end + k } else { end - k };
            [depth(node), layer[node]]
        };
        // Within the length in which a thin layer bends, the slope far from the answer says nothing.
        let first = beside(BESIDE * panel.length());
        let second = beside(2.0 * first[0]);
        let at_end = layer[end];
        let [one, two] = [first, second].map(|[depth, v]| (v - at_end) / depth);
        let slope = (one * second[0] - two * first[0]) / (second[0] - first[0]);
        let step = at_end / slope;
        let outwards = if slope > 0.0 && step.is_finite() {
            step
        } else {
            STRIDE.copysign(at_end) * self.zones[zone].length()
        };
        if side == 0 { -outwards } else { outwards }
    }

    /// The change of the layer when the end at this node moves to the right.
    fn moved(
        &self,
        tangent: &Tangent<'_>,
        slopes: &[f64],
        node: usize,
    ) -> Result<Direction, Error> {
        let Tangent { factor, solution, state } = tangent;
        let count = self.panel_count();
        let range = node / count * count..(node / count + 1) * count;
        let panel = self.panels[node / count];
        let stretch = if node == range.start { -1.0 } else { 1.0 } / panel.length();
        let fixed = if node == range.start { panel.right } else { panel.left };
        let velocity = |xi: f64| (xi - fixed) * stretch;
        let (scale, measure) = (self.medium.scale(&self.hull), self.medium.measure(&self.hull));
        let exponent = self.medium.exponent();
        let masses: Vec<f64> = solution.node_masses().iter().map(|mass| measure * mass).collect();
        let weighed = |f: &dyn Fn(f64) -> f64| -> f64 {
            range.clone().map(|j| masses[j] * f(self.positions[j])).sum()
        };
        let carried = weighed(&|_| 1.0);
        let theta = self.strength();
        let gauge = self.gauge();
        let local = self.panel_potential(solution, &range)?;
        let mut right: Vec<f64> =
            local.iter().map(|u| -theta * stretch * (scale * u - gauge * carried)).collect();
        for (i, value) in right.iter_mut().enumerate() {
            let xi = self.positions[i];
            if range.contains(&i) {
                let v = velocity(xi);
                // Of a straight V what is infinite at x = s is a multiple of K.
                let regular = weighed(&|s| self.medium.moved_along(xi, s, fixed));
                let inner = regular - exponent * scale * local[i];
                let beyond: f64 = (0..masses.len())
                    .filter(|j| !range.contains(j))
                    .map(|j| masses[j] * self.medium.moved([v, 0.0], [xi, self.positions[j]]))
                    .sum();
                *value -= theta * (stretch * inner + beyond) + (state.tilt + slopes[i]) * v;
            } else {
                *value -= theta * weighed(&|s| self.medium.moved([0.0, velocity(s)], [xi, s]));
            }
        }
        let changed = factor.solve(&right)?;
        let mut direction = self.direction(&changed, 1.0, [0.0, 0.0]);
        let spread = if self.medium.is_disk() { weighed(&|s| velocity(s) / s) } else { 0.0 };
        direction.force += self.medium.area() * (stretch * carried + spread);
        if !self.medium.is_disk() {
            direction.moment += weighed(&|s| velocity(s) + stretch * s);
        }
        Ok(direction)
    }

    /// `K p` for the pressure of one panel alone, in local coordinates.
    fn panel_potential(
        &self,
        solution: &SincSolution,
        range: &std::ops::Range<usize>,
    ) -> Result<Vec<f64>, Error> {
        if self.panels.len() == 1 {
            return Ok(solution.potential().to_vec());
        }
        let mut density = vec![0.0; self.positions.len()];
        for j in range.clone() {
            density[j] = self.base.layer.pressure(solution.values()[j]);
        }
        Ok(self.operator.apply(&density)?)
    }

    /// `f0'` at the nodes, by differences within their panels.
    fn profile_slopes(&self) -> Vec<f64> {
        let count = self.panel_count();
        let slope = |(i, &xi): (usize, &f64)| {
            let Panel { left, right, .. } = self.panels[i / count];
            let step = DIFFERENCE * (right - left);
            let (from, to) = ((xi - step).max(left.next_up()), (xi + step).min(right.next_down()));
            if to > from {
                (self.base.height(to) - self.base.height(from)) / (to - from)
            } else {
                0.0
            }
        };
        self.positions.iter().enumerate().map(slope).collect()
    }
}

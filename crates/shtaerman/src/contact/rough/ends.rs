//! The ends of zones on a rough surface: Newton's step to where the layer gives nothing.
//!
//! The pressure vanishes at a free end as the layer does, straight; where that is so it does not change to first order when the end moves, and each end falls as the layer
//! beside it says.

use super::solved::{Solved, end_node};
use crate::contact::edges::EndState;

/// Share of a panel beside its end over which the slope of the layer is taken. At half or twice 14 of 32 answers change, within what they state (survey).
const BESIDE: f64 = 0.02;

impl Solved {
    /// What is known at the ends of all zones.
    pub(super) fn ends(&self) -> Vec<[EndState; 2]> {
        let (rounding, scale) = (self.rounding(), self.deepest());
        let end = |zone: usize, side: usize| {
            let value = self.end_layer(zone, side);
            let step = self.step(zone, side);
            EndState { value, rounding, scale, none: 0.0, enough: rounding, step }
        };
        (0..self.zones.len()).map(|zone| [end(zone, 0), end(zone, 1)]).collect()
    }

    /// The step of an end outwards, to where the layer that goes on straight from it would vanish.
    fn step(&self, zone: usize, side: usize) -> f64 {
        let layer = self.solution.values();
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
        at_end / slope
    }
}

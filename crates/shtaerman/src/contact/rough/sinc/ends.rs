//! The ends of zones on a rough surface: Newton's step to where the layer gives nothing.
//!
//! The pressure vanishes at a free end as the layer does, straight; where that is so it does not change to first order when the end moves, and each end falls as the layer
//! beside it says.

use super::field::SincField;
use crate::contact::edges::EndState;
use crate::contact::rough::solved::Solved;

/// Share of a panel beside its end over which the slope of the layer is taken. At half or twice 14 of 32 answers change, within what they state (survey).
const BESIDE: f64 = 0.02;

impl Solved<SincField> {
    /// Force on a zone, but for a factor.
    pub(super) fn zone_force(&self, zone: usize) -> f64 {
        let (panels, count) = (self.nodes.panels_of(&self.nodes.zones[zone]), self.nodes.a_panel());
        self.field.solution.node_masses()[panels.start * count..panels.end * count].iter().sum()
    }

    /// What is known at the ends of all zones.
    pub(super) fn ends(&self) -> Vec<[EndState; 2]> {
        let (rounding, scale) = (self.rounding(), self.deepest());
        let end = |zone: usize, side: usize| {
            let (value, step) = self.end(zone, side);
            EndState { value, rounding, scale, none: 0.0, enough: rounding, step }
        };
        (0..self.nodes.zones.len()).map(|zone| [end(zone, 0), end(zone, 1)]).collect()
    }

    /// The layer at an end, and the step outwards to where it would vanish if it went on straight from there.
    fn end(&self, zone: usize, side: usize) -> (f64, f64) {
        let (panels, count) = (self.nodes.panels_of(&self.nodes.zones[zone]), self.nodes.a_panel());
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
        // Within the length in which a thin layer bends, the slope far from the answer says nothing.
        let first = beside(BESIDE * (right - left));
        let second = beside(2.0 * first[0]);
        let at_end = self.given[node(0)];
        let [one, two] = [first, second].map(|[depth, v]| (v - at_end) / depth);
        let slope = (one * second[0] - two * first[0]) / (second[0] - first[0]);
        (at_end, at_end / slope)
    }
}

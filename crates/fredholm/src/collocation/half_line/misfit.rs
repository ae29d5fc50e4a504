//! What the nodes of a section do not see of the right-hand side.

use super::map::Map;
use super::section::{Section, taper};
use crate::collocation::solution::sine_of_turns;

/// A point this close to a node, in steps, is that node.
const AT_NODE: f64 = 1e-13;

/// `(f - f(0)) chi` through its values at the nodes, with the taper `chi` of the section.
pub(super) struct Misfit {
    map: Map,
    step: f64,
    left: usize,
    length: f64,
    origin: f64,
    /// `(-1)^j v_j`.
    bubble: Vec<f64>,
}

impl Misfit {
    pub(super) fn new(section: &Section, f: &[f64], length: f64) -> Self {
        let origin = f.first().copied().unwrap_or(0.0);
        let mut sign = if section.left.is_multiple_of(2) { 1.0 } else { -1.0 };
        let bubble = section.positions.iter().zip(f).map(|(&x, f)| {
            let value = sign * (f - origin) * taper(x, length);
            sign = -sign;
            value
        });
        let bubble = bubble.collect();
        Self { map: section.map, step: section.step, left: section.left, length, origin, bubble }
    }

    /// What is missed at a place, in decay lengths, where the right-hand side has this value.
    pub(super) fn at(&self, x: f64, f: f64) -> f64 {
        let tau = self.map.inverse(x) / self.step;
        let nearest = tau.round();
        let (offset, place) = (tau - nearest, nearest + self.left as f64);
        if offset.abs() < AT_NODE {
            return 0.0;
        }
        let sum: f64 = (self.bubble.iter().enumerate())
            .map(|(index, value)| value / (offset + (place - index as f64)))
            .sum();
        (f - self.origin) * taper(x, self.length) - sum * sine_of_turns(tau, nearest)
    }
}

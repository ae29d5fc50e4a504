//! The unilateral answer.

use serde::Serialize;

use super::check::{Check, outside};
use super::system::Solved;
use super::zones::Zone;
use crate::contact::accuracy::Accuracy;
use crate::contact::balance::State;
use crate::contact::potential::between_nodes;
use crate::contact::solution::Solution;
use crate::contact::solved::{Method, Stiffness};
use crate::{Error, Problem};

/// Samples of a panel, for the peak of the pressure.
const SAMPLES: usize = 256;

/// What the answer leaves of tension and penetration, checked between its nodes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Complementarity {
    /// Largest tension in the zones over the largest pressure.
    pub tension: f64,
    /// Largest penetration beside the zones over the size of the displacements compared there.
    pub penetration: f64,
}

/// Zones, pressure, settlement, tilt, force and moment of a unilateral contact, without dimensions.
#[derive(Debug, Clone)]
pub(crate) struct UnilateralContact {
    solved: Solved,
    accuracy: Accuracy,
    edge_error: f64,
    complementarity: Complementarity,
}

impl UnilateralContact {
    pub(super) fn new(solved: Solved, accuracy: Accuracy, edge_error: f64, check: &Check) -> Self {
        let complementarity =
            Complementarity { tension: check.tension, penetration: check.penetration };
        Self { solved, accuracy, edge_error, complementarity }
    }

    /// The answer of a problem that is its own mirror image: what is zero by symmetry is zero.
    pub(super) fn without_skew(mut self) -> Self {
        self.solved.state.tilt = 0.0;
        self.solved.state.moment = 0.0;
        self.solved.stiffness.coupling = 0.0;
        self
    }

    /// The largest estimated error relative to its size.
    pub(crate) fn relative_error(&self) -> f64 {
        self.accuracy.relative(&self.solved.state.sizes(self.solved.largest()))
    }

    /// Refuses an answer short of an explicit tolerance.
    pub(super) fn within(self, tolerance: Option<f64>) -> Result<Self, Error> {
        match tolerance {
            Some(tolerance) if self.relative_error() > tolerance => Err(Error::ToleranceNotMet {
                tolerance,
                reached: self.relative_error(),
                method: self.method().name,
                n: self.method().n,
                settlement0: self.solved.state.settlement,
                tilt0: self.solved.state.tilt,
            }),
            _ => Ok(self),
        }
    }
}

impl Solution for UnilateralContact {
    fn state(&self) -> State {
        self.solved.state
    }

    /// Edges that move add nothing of first order, as the pressure vanishes there.
    fn stiffness(&self) -> Stiffness {
        self.solved.stiffness
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        self.solved.zones.iter().map(|zone| [zone.left(), zone.right()]).collect()
    }

    fn pressure(&self, problem: &Problem, xi: f64) -> f64 {
        let inside = |left: f64, right: f64| left <= xi && xi <= right;
        let Some(zone) = self.solved.zones.iter().find(|zone| inside(zone.left(), zone.right()))
        else {
            return if xi.is_nan() { xi } else { 0.0 };
        };
        if zone.ends.iter().any(|end| end.is_free && end.at == xi) {
            return 0.0;
        }
        // At a step of the base the height is that under pressure.
        let inside = 1e-12 * zone.length();
        let at_step = |side: usize| zone.ends[side].at == xi && xi.abs() < 1.0;
        let shift = if at_step(0) {
            inside
        } else if at_step(1) {
            -inside
        } else {
            0.0
        };
        self.solved.pressure_at(xi, problem.dimensionless_profile(xi + shift))
    }

    fn displacement(&self, xi: f64) -> f64 {
        let touches = |[left, right]: &[f64; 2]| *left <= xi && xi <= *right;
        if self.zones().iter().any(touches) {
            // Of the equation itself: the pressure without the profile, with the sign turned.
            let State { settlement, tilt, .. } = self.solved.state;
            return settlement - tilt * xi - self.solved.pressure_at(xi, 0.0);
        }
        self.solved.displacement_outside(xi)
    }

    fn sample(&self, problem: &Problem) -> (Vec<f64>, Vec<f64>) {
        let mut places: Vec<f64> = vec![-1.0, 1.0];
        for panel in &self.solved.panels {
            let (middle, half) =
                (0.5 * (panel.left + panel.right), 0.5 * (panel.right - panel.left));
            let inside =
                between_nodes(SAMPLES).map(|y| (middle + half * y).clamp(panel.left, panel.right));
            places.extend(inside);
        }
        for [left, right] in outside(&self.solved) {
            places.push(0.5 * (left + right));
        }
        places.sort_by(f64::total_cmp);
        places.dedup();
        let pressures = places.iter().map(|&xi| self.pressure(problem, xi)).collect();
        (places, pressures)
    }

    fn method(&self) -> Method {
        Method { name: "sinc", n: self.solved.positions.len() }
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.accuracy)
    }

    fn edge_error(&self) -> Option<f64> {
        let is_free = |zone: &Zone| zone.ends.iter().any(|end| end.is_free);
        self.solved.zones.iter().any(is_free).then_some(self.edge_error)
    }

    fn complementarity(&self) -> Option<Complementarity> {
        Some(self.complementarity)
    }

    fn size(&self) -> f64 {
        self.solved.largest()
    }
}

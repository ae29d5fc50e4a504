//! The answer on cells.

use super::Fine;
use crate::Problem;
use crate::contact::accuracy::Accuracy;
use crate::contact::balance::State;
use crate::contact::solution::Solution;
use crate::contact::solved::{Method, Stiffness};
use crate::contact::unilateral::Complementarity;

/// A contact on equal cells with its errors.
#[derive(Debug, Clone)]
pub(in crate::contact::unilateral) struct CellContact {
    pub(super) fine: Fine,
    pub(super) accuracy: Accuracy,
    pub(super) edge_error: f64,
    pub(super) complementarity: Complementarity,
}

impl Solution for CellContact {
    fn state(&self) -> State {
        self.fine.state
    }

    fn stiffness(&self) -> Stiffness {
        self.fine.stiffness
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        self.fine.zones.iter().map(|zone| [zone.left(), zone.right()]).collect()
    }

    fn touches(&self, xi: f64) -> bool {
        self.fine.touches(xi)
    }

    fn pressure(&self, problem: &Problem, xi: f64) -> f64 {
        if xi.is_nan() || !self.fine.touches(xi) {
            return if xi.is_nan() { xi } else { 0.0 };
        }
        self.fine.pressure_at(xi, problem.dimensionless_profile(xi)).max(0.0)
    }

    fn displacement(&self, xi: f64) -> f64 {
        self.fine.displacement(xi)
    }

    fn sample(&self, problem: &Problem) -> (Vec<f64>, Vec<f64>) {
        let count = self.fine.count();
        let places: Vec<f64> = (0..=count).map(|i| 2.0 * i as f64 / count as f64 - 1.0).collect();
        let pressures = places.iter().map(|&xi| self.pressure(problem, xi)).collect();
        (places, pressures)
    }

    fn method(&self) -> Method {
        Method { name: "cells", n: self.fine.count() }
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.accuracy)
    }

    fn edge_error(&self) -> Option<f64> {
        let is_free = |[left, right]: &[f64; 2]| *left > -1.0 || *right < 1.0;
        self.zones().iter().any(is_free).then_some(self.edge_error)
    }

    fn complementarity(&self) -> Option<Complementarity> {
        Some(self.complementarity)
    }

    fn size(&self) -> f64 {
        self.fine.largest()
    }
}

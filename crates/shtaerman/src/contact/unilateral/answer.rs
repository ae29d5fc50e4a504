//! The unilateral answer.

use super::base::Base;
use super::fine::Fine;
use super::system::Solved;
use super::zones::Zone;
use crate::contact::accuracy::Accuracy;
use crate::contact::balance::State;
use crate::contact::solved::Stiffness;
use crate::{Error, Problem, Scaling};

/// What the answer leaves of tension and penetration, checked between its nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Complementarity {
    /// Largest tension in the zones over the largest pressure.
    pub tension: f64,
    /// Largest penetration beside the zones over the size of the displacements compared there.
    pub penetration: f64,
}

/// Zones, pressure, settlement, tilt, force and moment of a unilateral contact.
///
/// Quantities with a `0` in their name are without dimensions, the others in the units of the problem.
#[derive(Debug, Clone)]
pub struct UnilateralContact {
    problem: Problem,
    solved: Surface,
    accuracy: Accuracy,
    edge_error: f64,
    complementarity: Complementarity,
}

/// The solution on zones or on cells.
#[derive(Debug, Clone)]
pub(super) enum Surface {
    Collocated(Box<Solved>),
    Cells(Box<Fine>),
}

impl Surface {
    fn zones(&self) -> &[Zone] {
        match self {
            Self::Collocated(solved) => &solved.zones,
            Self::Cells(fine) => &fine.zones,
        }
    }

    fn state(&self) -> &State {
        match self {
            Self::Collocated(solved) => &solved.state,
            Self::Cells(fine) => &fine.state,
        }
    }

    fn stiffness(&self) -> Stiffness {
        match self {
            Self::Collocated(solved) => solved.stiffness,
            Self::Cells(fine) => fine.stiffness,
        }
    }

    fn largest(&self) -> f64 {
        match self {
            Self::Collocated(solved) => solved.largest(),
            Self::Cells(fine) => fine.largest(),
        }
    }

    fn nodes(&self) -> usize {
        match self {
            Self::Collocated(solved) => solved.positions.len(),
            Self::Cells(fine) => fine.count(),
        }
    }

    fn pressure_at(&self, xi: f64, height: f64) -> f64 {
        match self {
            Self::Collocated(solved) => solved.pressure_at(xi, height),
            Self::Cells(fine) => fine.pressure_at(xi, height),
        }
    }

    fn displacement_outside(&self, xi: f64) -> f64 {
        match self {
            Self::Collocated(solved) => solved.displacement_outside(xi),
            Self::Cells(fine) => fine.displacement(xi),
        }
    }
}

impl UnilateralContact {
    pub(super) fn new(
        base: &Base<'_>,
        solved: Surface,
        accuracy: Accuracy,
        edge_error: f64,
        complementarity: Complementarity,
    ) -> Result<Self, Error> {
        let problem = base.problem.clone();
        let contact = Self { problem, solved, accuracy, edge_error, complementarity };
        for (quantity, value) in [
            ("force", contact.force0() * contact.scale(Scaling::force)),
            ("moment", contact.moment0() * contact.scale(Scaling::moment)),
            ("settlement", contact.settlement0() * contact.scale(Scaling::displacement)),
            ("tilt", contact.tilt0() * contact.scale(Scaling::angle)),
            ("pressure", contact.solved.largest() * contact.scale(Scaling::pressure)),
            ("error of the pressure", contact.accuracy.pressure),
        ] {
            if !value.is_finite() {
                return Err(Error::Overflow { quantity, value });
            }
        }
        Ok(contact)
    }

    /// The problem solved.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// `theta0`.
    #[must_use]
    pub fn theta0(&self) -> f64 {
        self.problem.frame().theta0()
    }

    /// `P0 = P/(a E)`; where it is prescribed, as given.
    #[must_use]
    pub fn force0(&self) -> f64 {
        self.solved.state().force
    }

    /// `M0 = M/(a^2 E)`; where it is prescribed, as given.
    #[must_use]
    pub fn moment0(&self) -> f64 {
        self.solved.state().moment
    }

    /// `delta0 = delta/(chi E)` in the gauge `ln(a/|x-s|)` with the half-width `a` of the punch, also where the zones are smaller.
    #[must_use]
    pub fn settlement0(&self) -> f64 {
        self.solved.state().settlement
    }

    /// `alpha0 = a alpha/(chi E)`.
    #[must_use]
    pub fn tilt0(&self) -> f64 {
        self.solved.state().tilt
    }

    /// The zones of contact from left to right, `[left, right]` in `xi`.
    #[must_use]
    pub fn edges0(&self) -> Vec<[f64; 2]> {
        self.solved.zones().iter().map(|zone| [zone.left(), zone.right()]).collect()
    }

    /// The zones of contact in the units of the problem.
    #[must_use]
    pub fn edges(&self) -> Vec<[f64; 2]> {
        let half_width = self.problem.frame().half_width();
        self.edges0().into_iter().map(|zone| zone.map(|xi| xi * half_width)).collect()
    }

    /// `p0(xi)` on the base, 0 outside the zones and at their free edges; points beyond the punch count as the nearer edge, NaN stays.
    #[must_use]
    pub fn pressure0(&self, xi: f64) -> f64 {
        let xi = xi.clamp(-1.0, 1.0);
        let inside = |left: f64, right: f64| left <= xi && xi <= right;
        let Some(zone) = self.solved.zones().iter().find(|zone| inside(zone.left(), zone.right()))
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
        self.solved.pressure_at(xi, self.problem.dimensionless_profile(xi + shift))
    }

    /// `p(x)` in the units of the problem.
    ///
    /// # Errors
    /// [`Error::BeyondPunch`] outside the closed base, also for NaN.
    pub fn pressure(&self, x: f64) -> Result<f64, Error> {
        let half_width = self.problem.frame().half_width();
        if x.abs() <= half_width {
            return Ok(self.pressure0(x / half_width) * self.scale(Scaling::pressure));
        }
        let variable = self.problem.frame().coordinate();
        Err(Error::BeyondPunch { variable, at: x, left: -half_width, right: half_width })
    }

    /// `theta0 int ln(1/|xi - eta|) p0(eta) deta`, the elastic displacement without the layer, at any `xi`.
    #[must_use]
    pub fn elastic_displacement0(&self, xi: f64) -> f64 {
        let touches = |left: f64, right: f64| left <= xi && xi <= right;
        if self.solved.zones().iter().any(|zone| touches(zone.left(), zone.right())) {
            // Of the equation itself: the pressure without the profile, with the sign turned.
            let depth = self.settlement0() - self.tilt0() * xi;
            return depth - self.solved.pressure_at(xi, 0.0);
        }
        self.solved.displacement_outside(xi)
    }

    /// The gap `f0 + alpha0 xi - delta0 + theta0 int ln(1/|xi - eta|) p0(eta) deta` between base and body outside the zones; 0 in them.
    /// Points beyond the punch count as the nearer edge.
    #[must_use]
    pub fn gap0(&self, xi: f64) -> f64 {
        let xi = xi.clamp(-1.0, 1.0);
        let touches = |left: f64, right: f64| left <= xi && xi <= right;
        if self.solved.zones().iter().any(|zone| touches(zone.left(), zone.right())) {
            return 0.0;
        }
        let depth = self.settlement0() - self.tilt0() * xi - self.problem.dimensionless_profile(xi);
        self.solved.displacement_outside(xi) - depth
    }

    /// The tangent stiffness without dimensions. Edges that move add nothing of first order, as the pressure vanishes there.
    #[must_use]
    pub fn stiffness0(&self) -> Stiffness {
        self.solved.stiffness()
    }

    /// What is left of tension and penetration.
    #[must_use]
    pub fn complementarity(&self) -> Complementarity {
        self.complementarity
    }

    /// The estimated error, without dimensions.
    #[must_use]
    pub fn accuracy(&self) -> &Accuracy {
        &self.accuracy
    }

    /// The estimated error of the edges, in `xi`.
    #[must_use]
    pub fn edge_error0(&self) -> f64 {
        self.edge_error
    }

    /// `sinc`, or `cells` for profiles of thousands of points and contacts in very many zones.
    #[must_use]
    pub fn method(&self) -> &'static str {
        match self.solved {
            Surface::Collocated(_) => "sinc",
            Surface::Cells(_) => "cells",
        }
    }

    /// Number of nodes in all zones, or of cells of the base.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.solved.nodes()
    }

    /// The largest estimated error relative to its size.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        self.accuracy.relative(&self.solved.state().sizes(self.solved.largest()))
    }

    fn scale(&self, unit: impl Fn(&Scaling) -> f64) -> f64 {
        self.problem.frame().scaling().map_or(1.0, unit)
    }
}

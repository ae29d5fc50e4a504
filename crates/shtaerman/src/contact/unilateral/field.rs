//! What carries a solution between its nodes: collocation on panels, or a Fourier series where the contact has no ends.

use fredholm::SincSolution;
use fredholm::collocation::{Place, rounding};

use super::ring::Ring;

/// The displacement `v` of the layer as the right-hand side less `theta K p`, with the integrals of the pressure.
#[derive(Debug, Clone)]
pub(super) enum Field {
    Panels(SincSolution),
    Ring(Ring),
}

impl Field {
    /// `theta`.
    pub(super) fn parameter(&self) -> f64 {
        match self {
            Self::Panels(solution) => solution.parameter(),
            Self::Ring(ring) => ring.parameter(),
        }
    }

    /// `v` at the nodes.
    pub(super) fn values(&self) -> &[f64] {
        match self {
            Self::Panels(solution) => solution.values(),
            Self::Ring(ring) => ring.values(),
        }
    }

    /// `K p` at the nodes.
    pub(super) fn potential(&self) -> &[f64] {
        match self {
            Self::Panels(solution) => solution.potential(),
            Self::Ring(ring) => ring.potential(),
        }
    }

    /// Weights times pressures at the nodes.
    pub(super) fn node_masses(&self) -> &[f64] {
        match self {
            Self::Panels(solution) => solution.node_masses(),
            Self::Ring(ring) => ring.masses(),
        }
    }

    /// `int u p dm` in local coordinates.
    pub(super) fn integral(&self, u: impl Fn(f64) -> f64) -> f64 {
        match self {
            Self::Panels(solution) => solution.integral(u),
            Self::Ring(ring) => ring.integral(u),
        }
    }

    /// `v` at a place, given the right-hand side there.
    pub(super) fn at(&self, place: Place, right_hand_side: f64) -> f64 {
        match self {
            Self::Panels(solution) => solution.evaluate_place(place, right_hand_side),
            Self::Ring(ring) => ring.at(place.position, right_hand_side),
        }
    }

    /// Rounding of `v`.
    pub(super) fn rounding(&self) -> f64 {
        match self {
            Self::Panels(solution) => rounding(solution),
            Self::Ring(ring) => ring.rounding(),
        }
    }
}

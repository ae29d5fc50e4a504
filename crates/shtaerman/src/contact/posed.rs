//! What a contact asks of the audit.

use shtaerman_audit::{Ground, Kernel};

use super::unaudited::Unaudited;
use crate::rounding::OF_A_VALUE;
use crate::{Geometry, Layering, Problem, Vertical};

/// What scaling does to the constants of graded ground, relative to them, which hold gamma functions, times `1 - mu` (tested against 30 digits).
pub(super) const GRADED: f64 = 8e-15;

/// What a contact asks of the audit.
pub(super) enum Posed {
    /// A plane contact: the kernel, what scaling may do to the numbers, and the exponent of the layer.
    Plane(Box<Kernel>, f64, f64),
    /// Plane ground described by a transfer function, and how much stronger than the foundation it is where points meet.
    Layered(Box<Ground>, f64),
    /// A circular punch: the exponent of the ground and that of the layer.
    Disk(f64, f64),
}

impl Posed {
    /// Whether the residual is bounded between all places.
    pub(super) fn is_bound(&self) -> bool {
        matches!(self, Self::Plane(_, _, layer) if *layer == 1.0)
    }

    /// The exponent of the ground.
    pub(super) fn exponent(&self) -> f64 {
        match self {
            Self::Plane(kernel, ..) => match **kernel {
                Kernel::Power { exponent } => exponent,
                _ => 0.0,
            },
            Self::Disk(exponent, _) => *exponent,
            Self::Layered(..) => 0.0,
        }
    }
}

/// What a contact asks of the audit, or why it has none.
pub(super) fn posed(problem: &Problem) -> Result<Posed, Unaudited> {
    let bodies = problem.bodies();
    if problem.profile().is_closure() {
        return Err(Unaudited::NotCovered(
            "the profile is a closure, of which nothing is known between samples",
        ));
    }
    let Some(layer) = bodies.law().exponent() else {
        return Err(Unaudited::NotCovered(
            "a smooth surface has no layer, and without it the residual bounds nothing in the mean square",
        ));
    };
    if let Some(layering) = bodies.layering() {
        return layered(problem, &layering.clone().scaled(bodies.half_width()), layer);
    }
    let exponent = bodies.grading().map_or(0.0, |grading| grading.exponent());
    let geometry = bodies.geometry().scaled(bodies.half_width());
    if geometry == Geometry::Circular {
        return Ok(Posed::Disk(exponent, layer));
    }
    let plane = |kernel, size| Posed::Plane(Box::new(kernel), size, layer);
    Ok(match geometry {
        Geometry::Periodic { period } => plane(Kernel::Row { period }, OF_A_VALUE),
        _ if exponent > 0.0 => {
            plane(Kernel::Power { exponent }, OF_A_VALUE + GRADED / (1.0 - exponent))
        }
        _ => plane(Kernel::Logarithm, OF_A_VALUE),
    })
}

/// What a contact on a layer, under a coating or on an influence function asks of the audit, or why it has none.
fn layered(problem: &Problem, layering: &Layering, layer: f64) -> Result<Posed, Unaudited> {
    if problem.bodies().geometry() == Geometry::Circular {
        return Err(Unaudited::NotCovered(
            "the residual on a layer under a circular punch is not bounded yet: its errors are estimates of the method",
        ));
    }
    if layer < 1.0 {
        return Err(Unaudited::NotCovered(
            "the residual bounds nothing for a power law of roughness on a layer, under a coating or on an influence function, whose kernels are not known to have a maximum principle: its errors are estimates of the method",
        ));
    }
    if layering.remainder().is_some() {
        return Err(Unaudited::NotCovered(
            "of an influence function given by its remainder it is not known whether it is positive, without which the residual bounds nothing: its errors are estimates of the method, and a cross-check by product integration holds them against another; with a transfer function it has an audit",
        ));
    }
    let ground = Ground::new(layering.thickness(), layering.far_share(), &|u| layering.transfer(u));
    if !ground.is_positive() && !matches!(problem.load().vertical(), Vertical::Force(_)) {
        return Err(Unaudited::NotCovered(
            "at a settlement prescribed the residual bounds nothing under a coating that is stiffer than what it lies on, whose kernel is known to be positive only for pressures without force: its errors are estimates of the method; with the force prescribed it has an audit",
        ));
    }
    Ok(Posed::Layered(Box::new(ground), layering.strength()))
}

//! Bases of circular punches are bodies of revolution.

use super::accuracy::STAGNANT;
use crate::error::require;
use crate::quantity::{Dimension, engineering};
use crate::warning::Warning;
use crate::{Error, Problem, WarningCode};

/// Refuses the base of a circular punch that is no body of revolution.
pub(super) fn require_even(problem: &Problem) -> Result<(), Error> {
    let unevenness = problem.profile().unevenness(problem.bodies().half_width(), STAGNANT);
    require(
        unevenness.found <= unevenness.negligible,
        "profile",
        unevenness.found,
        "even in x, f(-x) = f(x), for a circular punch: its base is a body of revolution, x the distance from the axis; the number is what its halves differ by",
    )?;
    Ok(())
}

impl Warning {
    /// The base of a circular punch is not proved to be even; none where it is.
    pub(super) fn evenness_not_proved(problem: &Problem) -> Option<Self> {
        let bodies = problem.bodies();
        if !bodies.is_circular() {
            return None;
        }
        let unevenness = problem.profile().unevenness(bodies.half_width(), STAGNANT);
        if unevenness.is_negligible() {
            return None;
        }
        let length = if bodies.scaling().is_some() { Dimension::LENGTH } else { Dimension::NONE };
        let bound = if unevenness.at_most.is_finite() {
            format!("at most {}", engineering(unevenness.at_most, length))
        } else {
            "any amount between them".to_owned()
        };
        let message = format!(
            "the base is not proved to be even in {}: its halves differ by {} at the places compared and by {bound} elsewhere, and the right one is taken; a formula in r or \
             rho, in even powers or in abs({0}) is proved",
            bodies.coordinate(),
            engineering(unevenness.found, length),
        );
        Some(Self { code: WarningCode::EvennessNotProved, message })
    }
}

//! The same problem by the other method.

use serde::Serialize;

use super::accuracy::Accuracy;
use super::{Contact, Draft, Target, collocated, plan, spectral};
use crate::{Error, Problem};

/// Roundings of a difference, relative to what is subtracted.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Differences between the answers of the two independent methods, without dimensions.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CrossCheck {
    /// Name of the other method.
    pub method: &'static str,
    /// Its size.
    pub n: usize,
    /// Largest difference of the pressures `p0` over the base.
    pub pressure_sup: f64,
    /// Difference of `delta0`.
    pub settlement: f64,
    /// Difference of `alpha0`.
    pub tilt: f64,
    /// Difference of `P0`.
    pub force: f64,
    /// Difference of `M0`.
    pub moment: f64,
    /// Whether no difference is larger than what both methods state of their errors together.
    pub agrees: bool,
}

impl Problem {
    /// Solves the problem by the method that `contact` was not solved by, and compares.
    ///
    /// # Errors
    /// Those of [`Problem::solve`] but for an explicit tolerance, which the other method need not meet.
    pub fn cross_check(&self, contact: &Contact) -> Result<CrossCheck, Error> {
        let Some(draft) = contact.draft() else { return Err(Error::NoOtherMethodForZones) };
        // The draft is that of the problem as it was solved.
        let problem = self.lowered().map_or_else(|| self.clone(), |(lowered, _)| lowered);
        let target = Target { tolerance: plan::AIM, is_explicit: false };
        let other = if contact.method().name == "sinc" {
            spectral::solve_adaptively(&problem, &problem.resolved_profile()?, target)?
        } else {
            collocated::solve(&problem, &problem.collocated_parts(), target)?
        };
        let difference = draft.difference(&other);
        let allowed = |part: fn(&Accuracy) -> f64, size: f64| {
            let of = |draft: &Draft| draft.accuracy.as_ref().map_or(f64::INFINITY, part);
            of(draft) + of(&other) + ROUNDING * size
        };
        let sizes = draft.state.sizes(draft.potential.size());
        let agrees = [
            (difference.pressure, allowed(|a| a.pressure, sizes.pressure)),
            (difference.settlement, allowed(|a| a.settlement, sizes.displacement)),
            (difference.tilt, allowed(|a| a.tilt, sizes.displacement)),
            (difference.force, allowed(|a| a.force, sizes.force)),
            (difference.moment, allowed(|a| a.moment, sizes.force)),
        ]
        .into_iter()
        .all(|(found, allowed)| found <= allowed);
        Ok(CrossCheck {
            method: other.method.name,
            n: other.method.n,
            pressure_sup: difference.pressure,
            settlement: difference.settlement,
            tilt: difference.tilt,
            force: difference.force,
            moment: difference.moment,
            agrees,
        })
    }
}

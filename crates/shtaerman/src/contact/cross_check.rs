//! The same problem by the other method.

use serde::Serialize;

use super::{Contact, Target, collocated, plan, spectral};
use crate::{Error, Problem};

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
        Ok(CrossCheck {
            method: other.method.name,
            n: other.method.n,
            pressure_sup: difference.pressure,
            settlement: difference.settlement,
            tilt: difference.tilt,
            force: difference.force,
            moment: difference.moment,
        })
    }
}

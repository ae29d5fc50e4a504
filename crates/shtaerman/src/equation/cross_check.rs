//! The same equation by the other method.

use serde::Serialize;

use super::SolvedEquation;
use crate::Error;

/// Points at which both solutions are compared.
const POINTS: usize = 258;

/// Differences between the solutions of the two independent methods, with the errors that both state.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EquationCheck {
    /// Name of the other method.
    pub method: &'static str,
    /// Its size.
    pub n: usize,
    /// Largest difference of the solutions, over points from end to end.
    pub solution_sup: f64,
    /// Sum of the errors that both methods state.
    pub solution_allowed: f64,
    /// Difference of the integrals; `null` where one is missing.
    pub integral: Option<f64>,
    /// Sum of their errors.
    pub integral_allowed: Option<f64>,
    /// Whether the differences are within the errors.
    pub agrees: bool,
}

impl SolvedEquation<'_> {
    /// Solves the equation by the method that did not solve it, and compares.
    ///
    /// # Errors
    /// [`Error::NoOtherMethod`] for the first kind, which has one method only; [`Error::CheckUnsolved`] where the other method states a relative error above 10 % and above the
    /// tolerance, so that hardly any difference would be too large; those of [`super::Equation::solve`] but for an explicit tolerance.
    pub fn cross_check(&self) -> Result<EquationCheck, Error> {
        let other = self.equation().solve_otherwise(self.method(), self.reach())?;
        self.equation().require_comparable(&other)?;
        let other = other.solution;
        let mut solution_sup = 0.0f64;
        for x in self.places(POINTS)? {
            let difference = self.evaluate(x)?.map(|value| (value - other.evaluate(x)).abs());
            let difference = difference.unwrap_or(0.0);
            if !difference.is_finite() {
                return Err(Error::EquationOverflow { quantity: "solution", value: difference });
            }
            solution_sup = solution_sup.max(difference);
        }
        let finite = |value: f64| Some(value).filter(|value| value.is_finite());
        let integral = self.integral().zip(other.integral.and_then(finite));
        let integral = integral.map(|(one, other)| (one - other).abs());
        let integral_allowed =
            integral.and_then(|_| finite(self.error().integral + other.error.integral));
        let solution_allowed = self.error().solution + other.error.solution;
        let integral_agrees =
            integral.zip(integral_allowed).is_none_or(|(error, allowed)| error <= allowed);
        Ok(EquationCheck {
            method: super::solved::name(other.method),
            n: other.count,
            solution_sup,
            solution_allowed,
            integral,
            integral_allowed,
            agrees: solution_sup <= solution_allowed && integral_agrees,
        })
    }
}

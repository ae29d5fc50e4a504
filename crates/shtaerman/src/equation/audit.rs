//! The error of a solution by a way that knows nothing of how it was found.

use fredholm::equation::audit;
use serde::Serialize;

use super::bounded::Bounds;
use super::family::Route;
use super::{Equation, Kind, SolvedEquation};
use crate::{Error, ErrorKind};

/// Strength of a singularity from which on the largest error is not audited: the end values then depend on what lies closer to the ends than places can be told apart.
const SQUARE_SUMMABLE: f64 = 0.5;

/// What the audit says of a solution: for a kernel that is positive semidefinite and `lambda >= 0` the error is at most the residual in the mean square, whatever way the solution was found
/// ([`fredholm::equation::audit`]). For the kernels `log`, `log-sine`, `log-square` and `power` the residual is enclosed between all places, rounding included, so that it is a bound.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EquationAudit {
    /// `bound` or `estimate`; `null` where there is no audit.
    pub kind: Option<ErrorKind>,
    /// Largest error of `phi` on the closed interval; `null` where the audit says nothing of it.
    pub solution_sup: Option<f64>,
    /// Error of the integral.
    pub integral: Option<f64>,
    /// Root of the integral of the squared error, by the measure of the kernel.
    pub mean_square: Option<f64>,
    /// Number of panels on which the solution was resampled.
    pub panels: Option<usize>,
    /// Why there is no audit, or none of the largest error; `null` where all of it is audited.
    pub reason: Option<String>,
    /// What the largest error is at least: a smaller one, even a bound, is not believed.
    #[serde(skip)]
    pub(super) least: f64,
}

impl EquationAudit {
    fn missing(reason: impl Into<String>) -> Self {
        Self {
            kind: None,
            solution_sup: None,
            integral: None,
            mean_square: None,
            panels: None,
            reason: Some(reason.into()),
            least: 0.0,
        }
    }
}

impl Equation {
    /// Why solutions are not bounded by their residuals, where they are not.
    fn unaudited(&self) -> Option<&'static str> {
        let kernel = self.kernel();
        match self.kind() {
            Kind::First => {
                return Some("an equation of the first kind has no bound by its residual");
            }
            Kind::Second { lambda } if lambda < 0.0 => {
                return Some("lambda is negative, and 1 + lambda K is not bounded below by 1");
            }
            Kind::Second { .. } => {}
        }
        if matches!(kernel.operator().route, Route::HalfLine(_)) {
            return Some(
                "on the half-line the solution is known on a section only, and the residual is needed everywhere",
            );
        }
        // Of the others only logarithms of long intervals are not positive, and it is the lowest eigenvalue that tells.
        let is_positive = kernel.operator().is_prepared
            || kernel.relation(1).is_ok_and(|relation| relation.eigenvalue(0) >= 0.0);
        (!is_positive).then_some(
            "the kernel is not positive semidefinite on so long an interval, and 1 + lambda K is not bounded below by 1",
        )
    }
}

/// Why the largest error is not audited.
const NOT_SQUARE_SUMMABLE: &str = "the kernel is not square-summable: the end values depend on what lies closer to the ends than places can be told apart";

impl SolvedEquation<'_> {
    /// Whether the solution near the ends is one that places can tell apart.
    fn is_mild(&self) -> bool {
        self.equation().kernel().kernel().singularity().exponent() < SQUARE_SUMMABLE
    }

    fn bound_by(&self, found: &Bounds) -> EquationAudit {
        let is_mild = self.is_mild();
        EquationAudit {
            kind: Some(ErrorKind::Bound),
            solution_sup: Some(found.solution).filter(|_| is_mild),
            integral: Some(found.integral).filter(|_| self.integral().is_some()),
            mean_square: Some(found.mean_square),
            panels: Some(found.panels),
            reason: (!is_mild).then(|| NOT_SQUARE_SUMMABLE.to_owned()),
            least: 0.0,
        }
    }

    /// Audits the solution, without a change of what it states; a solution with [`audited`](Self::audited) errors states the audit's bounds, or the larger ones where the audit
    /// estimates.
    #[must_use]
    pub fn audit(&self) -> EquationAudit {
        let equation = self.equation();
        if let Some(reason) = equation.unaudited() {
            return EquationAudit::missing(reason);
        }
        let Kind::Second { lambda } = equation.kind() else {
            return EquationAudit::missing("an equation of the first kind");
        };
        if let Some(found) = self.bounds() {
            return self.bound_by(&found);
        }
        let kernel = equation.kernel().kernel();
        let breaks = equation.breakpoints();
        let places = [&breaks[..], &equation.parts().cuts[..]];
        match audit(kernel, lambda, equation.function(), places, self.solution()) {
            Ok(found) => {
                let finite = |value: f64| Some(value).filter(|value| value.is_finite());
                let is_mild = self.is_mild();
                EquationAudit {
                    kind: Some(ErrorKind::Estimate),
                    least: found.least,
                    solution_sup: finite(found.solution).filter(|_| is_mild),
                    integral: self.integral().and_then(|_| finite(found.integral)),
                    mean_square: finite(found.mean_square),
                    panels: Some(found.panels),
                    reason: (!is_mild).then(|| NOT_SQUARE_SUMMABLE.to_owned()),
                }
            }
            Err(error) => EquationAudit::missing(error.to_string()),
        }
    }

    /// The same solution with an audit: it states the bounds of the audit, or where that estimates the larger of its own errors and those of the audit.
    ///
    /// # Errors
    /// [`Error::EquationTolerance`] where an explicit tolerance is not met by the larger error, [`Error::EquationUnsolved`] where that leaves no answer.
    pub fn audited(mut self) -> Result<Self, Error> {
        let audit = self.audit();
        self.raise(&audit);
        self.equation().require_error(self.solution())?;
        if audit.kind == Some(ErrorKind::Bound) && audit.solution_sup.is_some() {
            self.warn_again();
        }
        self.keep(audit);
        Ok(self)
    }
}

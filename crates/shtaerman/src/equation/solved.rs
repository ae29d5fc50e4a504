//! A solved equation.

use fredholm::bounds;
use fredholm::equation::{ErrorStatement, Method, Solution};

use super::draft::Draft;
use super::{Equation, EquationAudit, Kind, places};
use crate::error::require;
use crate::solver::AIM;
use crate::{Error, ErrorKind, Warning, WarningCode};

/// What bounds know of a solution beside its ends, in changes from one number to the next.
const BESIDE_ENDS: f64 = 16.0;

/// A solution with its equation: a function with an integral, an error and warnings.
#[derive(Debug)]
pub struct SolvedEquation<'a> {
    equation: &'a Equation,
    solution: Solution<'a>,
    reason: String,
    warnings: Vec<Warning>,
    reach: f64,
    audit: Option<EquationAudit>,
}

/// `spectral` or `sinc`, as everywhere.
pub(super) fn name(method: Method) -> &'static str {
    match method {
        Method::Spectral => "spectral",
        Method::Sinc => "sinc",
    }
}

impl<'a> SolvedEquation<'a> {
    /// The solution, unless it leaves the range of double precision.
    pub(super) fn new(equation: &'a Equation, draft: Draft<'a>, reach: f64) -> Result<Self, Error> {
        let Draft { mut solution, reason, warnings, is_truncated } = draft;
        if matches!(equation.kind(), Kind::Second { .. }) {
            // The inverse of 1 + lambda K has a norm near one: a width is twice what the right-hand side may be off by.
            let rounding = equation.rounding();
            solution.error.solution += rounding;
            let extent = equation.kernel().kernel().extent();
            solution.error.integral += rounding * 2.0 * extent.half_length();
        }
        // Of the first kind with a size of its own the solution may be infinite under a kink, and so may its error.
        let may_be_infinite = matches!(equation.kind(), Kind::First) && is_truncated;
        for (quantity, value) in
            [("solution", solution.largest), ("error of the solution", solution.error.solution)]
        {
            let is_answer = value.is_finite() || (may_be_infinite && value == f64::INFINITY);
            if !is_answer {
                return Err(Error::EquationOverflow { quantity, value });
            }
        }
        Ok(Self { equation, solution, reason, warnings, reach, audit: None })
    }

    pub(super) fn solution(&self) -> &Solution<'a> {
        &self.solution
    }

    /// Takes over the bounds of an audit; where it estimates, its errors if they are larger, as estimates.
    pub(super) fn raise(&mut self, audit: &EquationAudit) {
        let error = &mut self.solution.error;
        if let (Some(ErrorKind::Bound), Some(solution)) = (audit.kind, audit.solution_sup) {
            error.kind = bounds::Kind::Bound;
            error.solution = solution;
            error.integral = audit.integral.unwrap_or(error.integral);
            return;
        }
        // A bound is proved, and smaller than what the residual alone says, unless the residual contradicts it.
        if error.kind == bounds::Kind::Bound && audit.least <= error.solution {
            return;
        }
        let pairs =
            [(&mut error.solution, audit.solution_sup), (&mut error.integral, audit.integral)];
        for (own, audited) in pairs {
            if let Some(audited) = audited.filter(|audited| *audited > *own) {
                *own = audited;
                error.kind = bounds::Kind::Estimate;
            }
        }
    }

    /// Holds the bound of an audit against what is aimed at, which grows with the strength of the kernel as rounding does, and with its singularity: beside the ends solutions change by
    /// some `eps^(1-mu)` from one number to the next.
    pub(super) fn warn_again(&mut self) {
        self.warnings.retain(|warning| warning.code != WarningCode::ToleranceNotMet);
        let solver = self.equation.solver();
        let smoothness = 1.0 - self.equation.kernel().kernel().singularity().exponent();
        let aim = (AIM * (0.1 * self.equation.strength()).max(1.0))
            .max(BESIDE_ENDS * f64::EPSILON.powf(smoothness));
        let reached = self.solution.error.solution / self.solution.largest;
        if solver.tolerance.is_none() && reached > aim {
            self.warnings.push(Warning::tolerance_not_met(aim, reached));
        }
    }

    pub(super) fn keep(&mut self, audit: EquationAudit) {
        self.audit = Some(audit);
    }

    /// What the audit found, of a solution that is [audited](Self::audited).
    #[must_use]
    pub fn audit_report(&self) -> Option<&EquationAudit> {
        self.audit.as_ref()
    }

    /// What was solved.
    #[must_use]
    pub fn equation(&self) -> &'a Equation {
        self.equation
    }

    /// `phi(x)` at a place of the closed interval; none where a solution of the first kind is infinite.
    ///
    /// # Errors
    /// [`Error::BeyondInterval`] elsewhere; [`Error::EquationOverflow`] should the value not be a number.
    pub fn evaluate(&self, x: f64) -> Result<Option<f64>, Error> {
        let place = self.equation.place(x)?;
        if place > self.reach {
            let [left, _] = self.equation.shown();
            return Err(Error::BeyondInterval { at: x, left, right: self.reach });
        }
        let value = self.solution.evaluate(place);
        if value.is_finite() {
            return Ok(Some(value));
        }
        let interval = self.equation.kernel().kernel().interval();
        let at_end = place == interval.left() || place == interval.right();
        // Where parts of both signs meet at an end, the sum of their infinities is NaN.
        if self.equation.kind() == Kind::First && at_end {
            return Ok(None);
        }
        Err(Error::EquationOverflow { quantity: "solution", value })
    }

    /// `count` places from end to end, denser at the ends; on a half-line to `12/kappa`, denser at its beginning.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for fewer than two.
    pub fn places(&self, count: usize) -> Result<Vec<f64>, Error> {
        require(count >= 2, "points", count as f64, "at least 2")?;
        let [left, right] = self.equation.shown();
        let steps = (count - 1) as f64;
        if !self.equation.kernel().kernel().interval().is_finite() {
            let share = |i: usize| (i as f64 / steps).powi(2);
            return Ok((0..count).map(|i| left + share(i) * (right - left)).collect());
        }
        Ok(places::from_end_to_end([left, right], count))
    }

    /// The largest place at which the solution is known.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// The integral of `phi`, for a kernel of a disk of `phi x^(mu+1)`; none where it does not exist.
    #[must_use]
    pub fn integral(&self) -> Option<f64> {
        self.solution.integral.filter(|integral| integral.is_finite())
    }

    /// How far the solution may be off; for the first kind, `phi` over its weight.
    #[must_use]
    pub fn error(&self) -> &ErrorStatement {
        &self.solution.error
    }

    /// How far `phi(x)` may be off at a place of the closed interval: of the first kind the [error](Self::error) times the weight there. None where the solution is infinite.
    ///
    /// # Errors
    /// Those of [`evaluate`](Self::evaluate).
    pub fn error_at(&self, x: f64) -> Result<Option<f64>, Error> {
        if self.evaluate(x)?.is_none() {
            return Ok(None);
        }
        let error = self.solution.error.solution;
        if self.equation.kind() != Kind::First {
            return Ok(Some(error));
        }
        let (relation, place) = (self.equation.relation()?, self.equation.place(x)?);
        // Eigenfunctions of both parities may have weights of their own.
        let weight = relation.weight(0, place).max(relation.weight(1, place));
        Ok(Some(error * weight).filter(|error| error.is_finite()))
    }

    /// Whether the error is a bound or an estimate.
    #[must_use]
    pub fn error_kind(&self) -> ErrorKind {
        match self.solution.error.kind {
            bounds::Kind::Bound => ErrorKind::Bound,
            bounds::Kind::Estimate => ErrorKind::Estimate,
        }
    }

    /// Name of the method: `spectral` or `sinc`.
    #[must_use]
    pub fn method(&self) -> &'static str {
        name(self.solution.method)
    }

    /// Highest index of the eigenfunctions kept, or number of nodes.
    #[must_use]
    pub fn size(&self) -> usize {
        self.solution.count
    }

    /// Why this method.
    #[must_use]
    pub fn reason(&self) -> &str {
        &self.reason
    }

    /// What a user should know.
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}

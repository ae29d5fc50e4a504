//! The answer of an equation as data.

use serde::Serialize;

use super::{EquationAudit, EquationCheck, Kind, NamedKernel, SolvedEquation};
use crate::{Error, ErrorKind, MethodReport, Warning};

/// Version of the layout of an [`EquationAnswer`]; the JSON Schema `schema/equation.schema.json` describes it.
pub const EQUATION_SCHEMA: &str = "shtaerman-equation/1";

/// A solved equation at chosen points.
#[derive(Debug, Serialize)]
pub struct EquationAnswer<'a> {
    /// [`EQUATION_SCHEMA`].
    pub schema: &'static str,
    /// `second` or `first`.
    pub kind: &'static str,
    /// `lambda`; `null` for the first kind.
    pub lambda: Option<f64>,
    /// The right-hand side as it was written.
    pub rhs: &'a str,
    /// The kernel.
    pub kernel: &'a NamedKernel,
    /// The solution at points.
    pub solution: Samples,
    /// The integral of `integral_of`; `null` where it does not exist.
    pub integral: Option<f64>,
    /// What the integral is taken of, by `dx`.
    pub integral_of: &'static str,
    /// How it was solved.
    pub method: MethodReport,
    /// How sure the answer is.
    pub error: EquationErrors,
    /// What an audit found, where it was asked for; the error is the larger one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub audit: Option<EquationAudit>,
    /// Differences from the other method, where asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cross_check: Option<EquationCheck>,
    /// What a user should know.
    pub warnings: &'a [Warning],
}

/// A function at points.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Samples {
    /// Places.
    pub x: Vec<f64>,
    /// Values; `null` where a solution of the first kind is infinite.
    pub phi: Vec<Option<f64>>,
}

/// The error of an answer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EquationErrors {
    /// `bound` or `estimate`.
    pub kind: ErrorKind,
    /// Largest error of what `of` names, on the closed interval.
    pub solution_sup: Option<f64>,
    /// Error of the integral; `null` where there is none.
    pub integral: Option<f64>,
    /// `phi`, for the first kind `phi/w` with the weight `w`.
    pub of: &'static str,
}

impl<'a> SolvedEquation<'a> {
    /// The answer with the solution at `places`.
    ///
    /// # Errors
    /// Those of [`SolvedEquation::evaluate`].
    pub fn answer(&'a self, places: Vec<f64>) -> Result<EquationAnswer<'a>, Error> {
        let phi = places.iter().map(|&x| self.evaluate(x)).collect::<Result<Vec<_>, _>>()?;
        let kernel = self.equation().kernel();
        let (kind, lambda) = match self.equation().kind() {
            Kind::Second { lambda } => ("second", Some(lambda)),
            Kind::First => ("first", None),
        };
        Ok(EquationAnswer {
            schema: EQUATION_SCHEMA,
            kind,
            lambda,
            rhs: self.equation().right_hand_side().text(),
            kernel,
            solution: Samples { x: places, phi },
            integral: self.integral(),
            integral_of: kernel.family().integral_of,
            method: MethodReport {
                name: self.method(),
                n: self.size(),
                reason: self.reason().to_owned(),
            },
            error: EquationErrors::new(self),
            audit: self.audit_report().cloned(),
            cross_check: None,
            warnings: self.warnings(),
        })
    }
}

impl EquationErrors {
    fn new(solved: &SolvedEquation<'_>) -> Self {
        let error = solved.error();
        let finite = |value: f64| Some(value).filter(|value| value.is_finite());
        Self {
            kind: solved.error_kind(),
            solution_sup: finite(error.solution),
            integral: solved.integral().and_then(|_| finite(error.integral)),
            of: match solved.equation().kind() {
                Kind::Second { .. } => "phi",
                Kind::First => "phi/w",
            },
        }
    }
}

//! Which method solves an equation.

use fredholm::equation::{
    Solution, collocate_half_line_in_parts, collocate_in_parts, degenerate_in_parts,
    degenerate_logarithm_in_parts, first_kind_in_parts,
};
use fredholm::kernel::SpectralRelation;

use super::definition::MOST_BREAKS;
use super::draft::{Draft, relative_error};
use super::family::Route;
use super::{Equation, Kind, SolvedEquation};
use crate::expression::Line;
use crate::solver::AIM;
use crate::{Error, MethodChoice, Warning, WarningCode};

/// Degree of the degenerate kernel where none is given.
const DEGREE: usize = 400;
/// The same where the eigenfunctions are computed.
const PREPARED_DEGREE: usize = 200;
/// Most terms of a solution of the first kind where none is given.
const TERMS: usize = 1024;
/// The same where the eigenfunctions are computed.
const PREPARED_TERMS: usize = 200;
/// A slope below this share of the right-hand side is rounding.
const ROUNDING: f64 = 1e-14;
/// Strength of a singularity from which on a kernel is not square-summable.
const SQUARE_SUMMABLE: f64 = 0.5;

/// A relative error above this is no answer, unless it was asked for.
pub(super) const USEFUL: f64 = 0.01;
/// A relative error above this is nothing to compare with: under jumps the degenerate kernel has little more than a digit, and still shows whether collocation is right.
const COMPARABLE: f64 = 0.1;

/// False for NaN.
fn is_useful(reached: f64) -> bool {
    reached <= USEFUL
}

impl Equation {
    /// Solves the equation by the method of its solver: collocation unless asked otherwise for the second kind, the spectral relation for the first.
    ///
    /// # Errors
    /// [`Error::RightHandSide`] where the right-hand side is not finite; [`Error::Equation`] for a singular parameter `lambda = -1/nu`, an eigenvalue that
    /// vanishes, a system that does not fit into memory; [`Error::Overflow`] when the solution is not finite; [`Error::EquationTolerance`] when an explicit
    /// tolerance is out of reach; [`Error::EquationUnsolved`] when the error is as large as the solution.
    pub fn solve(&self) -> Result<SolvedEquation<'_>, Error> {
        self.solve_to(self.shown()[1])
    }

    /// The same, on a half-line for places up to `reach` if that is beyond what is [shown](Self::shown).
    ///
    /// # Errors
    /// Those of [`Equation::solve`].
    pub fn solve_to(&self, reach: f64) -> Result<SolvedEquation<'_>, Error> {
        let reach = reach.max(self.shown()[1]);
        let mut draft = match (self.kind(), self.solver().method) {
            (Kind::First, _) => self.first_kind()?,
            (Kind::Second { lambda }, MethodChoice::Spectral) => self.truncated(lambda)?,
            (Kind::Second { lambda }, MethodChoice::Sinc) => self.collocated(lambda, reach)?,
            (Kind::Second { lambda }, MethodChoice::Auto) => self.chosen(lambda, reach)?,
        };
        self.judge(&mut draft)?;
        self.add_notes(&mut draft);
        SolvedEquation::new(self, draft, reach)
    }

    /// By the method that did not solve it.
    pub(super) fn solve_otherwise(&self, name: &str, reach: f64) -> Result<Draft<'_>, Error> {
        match self.kind() {
            Kind::First => Err(Error::NoOtherMethod),
            Kind::Second { lambda } if name == "sinc" => self.truncated(lambda),
            Kind::Second { lambda } => self.collocated(lambda, reach),
        }
    }

    fn aim(&self) -> f64 {
        self.solver().tolerance.unwrap_or(AIM)
    }

    /// The spectral relation with as many eigenfunctions as this equation can need.
    pub(super) fn relation(&self) -> Result<&dyn SpectralRelation, Error> {
        if let Some(relation) = self.relation.get() {
            return Ok(&**relation);
        }
        let relation = self.kernel().relation(self.terms())?;
        Ok(&**self.relation.get_or_init(|| relation))
    }

    fn degree(&self) -> usize {
        let usual = if self.kernel().operator().is_prepared { PREPARED_DEGREE } else { DEGREE };
        self.solver().degree.unwrap_or(usual)
    }

    /// Number of eigenfunctions.
    fn terms(&self) -> usize {
        match (self.kind(), self.solver().degree) {
            (Kind::First, None) if self.kernel().operator().is_prepared => PREPARED_TERMS,
            (Kind::First, None) => TERMS,
            _ => self.degree() + 1,
        }
    }

    fn first_kind(&self) -> Result<Draft<'_>, Error> {
        if let Some(slope) = self.cone() {
            return Err(Error::Cone { slope });
        }
        let breaks = self.breakpoints();
        let is_finite = self.require_finite_solution(&breaks);
        if self.solver().degree.is_none() {
            is_finite.clone()?;
        }
        // A narrow feature beside an end lies between breakpoints.
        let mut cuts = breaks;
        cuts.extend(&self.parts().cuts);
        let mut solution =
            first_kind_in_parts(self.relation()?, self.function(), &cuts, self.terms())?;
        if is_finite.is_err() {
            solution.error.solution = f64::INFINITY;
        }
        Ok(Draft {
            solution,
            reason: "the first kind: straight from the spectral relation".to_owned(),
            warnings: Vec::new(),
            is_truncated: self.solver().degree.is_some(),
        })
    }

    /// The slope at the centre of a disk where it makes the solution of the first kind infinite there: the inverse operator takes `x` to `x^(2 gamma)`, to `ln x` for `gamma = 0`.
    fn cone(&self) -> Option<f64> {
        let kernel = self.kernel();
        let value = |name: &str| kernel.parameter(name);
        let is_disk = kernel.family().measure == "s ds";
        let is_mean = value("mu").or(value("m")) == Some(0.0);
        if !(is_disk && is_mean && value("gamma").unwrap_or(0.0) <= 0.0) {
            return None;
        }
        let (at_centre, slope) = self.right_hand_side().derivative_along(&Line::identity(), 0.0);
        let radius = self.shown()[1];
        let largest = (self.function())(radius).abs().max(at_centre.abs());
        (slope.is_finite() && slope.abs() * radius > ROUNDING * largest).then_some(slope)
    }

    fn truncated(&self, lambda: f64) -> Result<Draft<'_>, Error> {
        let (degree, cuts) = (self.degree(), &self.parts().cuts);
        let reason = match self.solver().method {
            MethodChoice::Spectral => "asked for",
            MethodChoice::Auto | MethodChoice::Sinc => {
                "the right-hand side has more breakpoints than can have panels: the degenerate kernel"
            }
        };
        let draft = |solution, reason: &str| Draft {
            solution,
            reason: reason.to_owned(),
            warnings: Vec::new(),
            is_truncated: true,
        };
        if let (Route::Bounds(kernel), true) = (&self.kernel().operator().route, lambda >= 0.0) {
            let solution =
                degenerate_logarithm_in_parts(kernel, lambda, self.function(), cuts, degree)?;
            if solution.error.solution.is_finite() && solution.error.integral.is_finite() {
                return Ok(draft(solution, reason));
            }
        }
        let solution =
            degenerate_in_parts(self.relation()?, lambda, self.function(), cuts, degree)?;
        Ok(draft(solution, reason))
    }

    fn collocated(&self, lambda: f64, reach: f64) -> Result<Draft<'_>, Error> {
        let mut breaks = self.breakpoints();
        if breaks.len() > MOST_BREAKS {
            breaks.clear();
        }
        let (kernel, f, aim) = (self.kernel().kernel(), self.function(), self.aim());
        let cuts = &self.parts().cuts;
        let solution = match &self.kernel().operator().route {
            Route::HalfLine(kernel) => {
                breaks.clear();
                collocate_half_line_in_parts(kernel, lambda, f, cuts, [reach, aim])?
            }
            Route::General | Route::Bounds(_) => {
                collocate_in_parts(kernel, lambda, f, [&breaks, cuts], aim)?
            }
        };
        let reason = match (self.solver().method, breaks.len()) {
            (MethodChoice::Sinc, _) => "asked for".to_owned(),
            (_, 0) => "collocation converges exponentially on every kernel".to_owned(),
            (_, count) => format!(
                "the right-hand side has {count} breakpoint(s): collocation on the panels between them"
            ),
        };
        Ok(Draft { solution, reason, warnings: Vec::new(), is_truncated: false })
    }

    fn chosen(&self, lambda: f64, reach: f64) -> Result<Draft<'_>, Error> {
        let is_half_line = matches!(self.kernel().operator().route, Route::HalfLine(_));
        if !is_half_line && self.breakpoints().len() > MOST_BREAKS {
            self.truncated(lambda)
        } else {
            self.collocated(lambda, reach)
        }
    }

    /// An explicit tolerance is met or the solve fails, and so it does where nothing is left; the error that is aimed at otherwise is met or warned of.
    fn judge(&self, draft: &mut Draft<'_>) -> Result<(), Error> {
        self.require_error(&draft.solution)?;
        if self.solver().tolerance.is_some() {
            return Ok(());
        }
        let reached = draft.relative_error();
        let fell_short = if draft.is_truncated {
            !is_useful(reached) || !draft.solution.converged
        } else {
            reached > self.aim()
        };
        if fell_short {
            draft.warnings.push(Warning::tolerance_not_met(self.aim(), reached));
        }
        Ok(())
    }

    /// Refuses an error above an explicit tolerance, or above 1 % where neither a tolerance nor a size was asked for.
    pub(super) fn require_error(&self, solution: &Solution<'_>) -> Result<(), Error> {
        let reached = relative_error(solution);
        let (method, n) = (super::solved::name(solution.method), solution.count);
        match self.solver().tolerance {
            Some(tolerance) if reached <= tolerance => Ok(()),
            Some(tolerance) => Err(Error::EquationTolerance { tolerance, reached, method, n }),
            None if is_useful(reached) || self.solver().degree.is_some() => Ok(()),
            None => Err(Error::EquationUnsolved { reached, method, n }),
        }
    }

    /// Refuses the other method of a cross-check where it is no answer: any difference would be within its error.
    pub(super) fn require_comparable(&self, draft: &Draft<'_>) -> Result<(), Error> {
        let reached = draft.relative_error();
        if reached <= self.solver().tolerance.unwrap_or(COMPARABLE).max(COMPARABLE) {
            return Ok(());
        }
        let (method, n) = (super::solved::name(draft.solution.method), draft.solution.count);
        Err(Error::CheckUnsolved { reached, method, n })
    }

    fn add_notes(&self, draft: &mut Draft<'_>) {
        let strength = self.kernel().kernel().singularity().exponent();
        if strength >= SQUARE_SUMMABLE && self.kind() != Kind::First {
            draft.warnings.push(Warning {
                code: WarningCode::NotSquareSummable,
                message: format!(
                    "the kernel is as singular as |x - s|^-{strength}: not square-summable (that takes less than 1/2), yet compact, so that the equation \
                     is solved all the same; collocation takes more nodes and the degenerate kernel converges slowly"
                ),
            });
        }
        draft.warnings.extend(self.parts().warning());
        let integral = draft.solution.integral.filter(|integral| integral.is_finite());
        if integral.is_none() {
            draft.warnings.push(Warning {
                code: WarningCode::NoIntegral,
                message: "the integral of the solution does not exist or was not found".to_owned(),
            });
        }
    }
}

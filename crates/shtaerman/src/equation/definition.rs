//! An equation on a kernel: what is to be solved, and how.

use std::sync::OnceLock;

use fredholm::Interval;
use fredholm::kernel::SpectralRelation;

use super::family::{Family, NamedKernel};
use super::parts::Parts;
use super::{places, right_hand_side};
use crate::error::require;
use crate::expression::Expression;
use crate::{Error, MethodChoice, Solver};

/// Lowest degree of the degenerate kernel: its error is judged from a quarter of it.
pub const LEAST_DEGREE: usize = 8;
/// Highest degree of the degenerate kernel, and most terms of a solution of the first kind.
pub const MOST_DEGREE: usize = 20_000;
/// Most breakpoints of the right-hand side that get panels of their own.
pub(super) const MOST_BREAKS: usize = 15;
/// On a half-line a right-hand side must be finite up to so many times what is shown: the section that is solved, with room.
const HALF_LINE_RANGE: f64 = 6.0;

/// Which kind of equation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// `phi + lambda K phi = f`.
    Second {
        /// `lambda`.
        lambda: f64,
    },
    /// `K phi = f`.
    First,
}

/// An equation on a kernel.
pub struct Equation {
    pub(super) kind: Kind,
    pub(super) kernel: NamedKernel,
    pub(super) rhs: Expression,
    pub(super) solver: Solver,
    pub(super) function: Box<dyn Fn(f64) -> f64 + Send + Sync>,
    /// The spectral relation, once a method has asked for it.
    pub(super) relation: OnceLock<Box<dyn SpectralRelation>>,
    /// What is proved of the right-hand side, once it was asked for.
    pub(super) parts: OnceLock<Parts>,
}

impl std::fmt::Debug for Equation {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter
            .debug_struct("Equation")
            .field("kind", &self.kind)
            .field("kernel", &self.kernel)
            .field("rhs", &self.rhs.text())
            .field("solver", &self.solver)
            .finish_non_exhaustive()
    }
}

impl Equation {
    /// The name of the variable of right-hand sides.
    pub const VARIABLE: &'static str = "x";

    /// An equation; `rhs` is an expression in `x`.
    ///
    /// The degree of the solver is that of the degenerate kernel, or for the first kind the highest index kept; its tolerance is relative to the largest value of the
    /// solution.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a parameter `lambda` that is not finite or a solver that does not go with the kind, [`Error::RightHandSide`] where the
    /// right-hand side is not finite on the closed interval.
    pub fn new(
        kind: Kind,
        kernel: NamedKernel,
        rhs: Expression,
        solver: Solver,
    ) -> Result<Self, Error> {
        if let Kind::Second { lambda } = kind {
            require(lambda.is_finite(), "lambda", lambda, "finite")?;
        }
        check_solver(kind, &solver)?;
        let compiled = rhs.clone();
        let function = Box::new(move |x: f64| compiled.evaluate(&[x]));
        let equation = Self {
            kind,
            kernel,
            rhs,
            solver,
            function,
            relation: OnceLock::new(),
            parts: OnceLock::new(),
        };
        right_hand_side::require_finite(&equation.rhs, equation.range())?;
        Ok(equation)
    }

    /// First or second kind.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The kernel.
    #[must_use]
    pub fn kernel(&self) -> &NamedKernel {
        &self.kernel
    }

    /// The right-hand side `f`.
    #[must_use]
    pub fn right_hand_side(&self) -> &Expression {
        &self.rhs
    }

    /// How it is to be solved.
    #[must_use]
    pub fn solver(&self) -> &Solver {
        &self.solver
    }

    /// The interval on which the solution is shown: that of the kernel, of a half-line the part to `12/kappa`.
    #[must_use]
    pub fn shown(&self) -> [f64; 2] {
        let extent = self.kernel.kernel().extent();
        [extent.left(), extent.right()]
    }

    /// The place itself, or the end from which rounding took it.
    ///
    /// # Errors
    /// [`Error::BeyondInterval`] for a place that is not in the closed interval.
    pub fn place(&self, x: f64) -> Result<f64, Error> {
        places::within(self.kernel.kernel().interval(), x)
    }

    pub(super) fn function(&self) -> &(dyn Fn(f64) -> f64 + Sync) {
        &*self.function
    }

    /// The range on which the right-hand side must be finite.
    pub(super) fn range(&self) -> Interval {
        let kernel = self.kernel.kernel();
        let (interval, extent) = (kernel.interval(), kernel.extent());
        if interval.is_finite() {
            return interval;
        }
        let end = interval.left() + 2.0 * HALF_LINE_RANGE * extent.half_length();
        Interval::new(interval.left(), end).unwrap_or(extent)
    }

    /// What rounding may make of the right-hand side ([`right_hand_side::rounding`]).
    pub(super) fn rounding(&self) -> f64 {
        right_hand_side::rounding(&self.rhs, self.range())
    }

    /// Places strictly inside the interval where the right-hand side has a kink or a jump.
    pub(super) fn breakpoints(&self) -> Vec<f64> {
        right_hand_side::breakpoints(&self.rhs, self.range())
    }
}

/// The name of a kernel that was perhaps meant.
#[must_use]
pub fn suggestion(written: &str) -> Option<&'static str> {
    shtaerman_input::nearest(written, Family::names())
}

pub(super) fn check_solver(kind: Kind, solver: &Solver) -> Result<(), Error> {
    if let Some(tolerance) = solver.tolerance {
        let sensible = tolerance > 0.0 && tolerance < 1.0;
        require(sensible, "tolerance", tolerance, "greater than 0 and less than 1")?;
    }
    if kind == Kind::First && solver.method == MethodChoice::Sinc {
        let requirement =
            "\"auto\" or \"spectral\": the first kind is solved from the spectral relation";
        require(false, "method", f64::NAN, requirement)?;
    }
    let Some(degree) = solver.degree else { return Ok(()) };
    let spectral = solver.method == MethodChoice::Spectral || kind == Kind::First;
    require(spectral, "n", degree as f64, "left out: it belongs to method = \"spectral\"")?;
    let least = if kind == Kind::First { 1 } else { LEAST_DEGREE };
    require(
        (least..=MOST_DEGREE).contains(&degree),
        "n",
        degree as f64,
        "from 8 (first kind: 1) to 20000",
    )?;
    Ok(())
}

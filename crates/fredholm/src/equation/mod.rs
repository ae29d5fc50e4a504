//! Equations of the second and of the first kind on any kernel, solved by either method, each answer with a statement of its error.
//!
//! `phi + lambda K phi = f` (1.1) by [`collocate`] (accurate, an estimate of the error) or by [`degenerate`] (the paper's method; for
//! the logarithm [`degenerate_logarithm`] adds guaranteed bounds); `K phi = f`, the smooth limit, by [`first_kind`] straight from the spectral relation.
//!
//! ```
//! use fredholm::Interval;
//! use fredholm::equation::{collocate, degenerate, first_kind};
//! use fredholm::kernel::Logarithm;
//!
//! let kernel = Logarithm::unit();
//! let sinc = collocate(&kernel, 2.0, &f64::cos, &[], 1e-12)?;
//! let spectral = degenerate(&kernel, 2.0, &f64::cos, 400)?;
//! let difference = (sinc.evaluate(1.0) - spectral.evaluate(1.0)).abs();
//! assert!(difference <= sinc.error.solution + spectral.error.solution);
//!
//! // int ln(1/|x - s|) phi(s) ds = 1: phi = 1/(pi ln 2 sqrt(1 - x^2)), unbounded at the ends.
//! let smooth = first_kind(&kernel, &|_| 1.0, 40)?;
//! assert!((smooth.evaluate(0.6) - 1.25 / (std::f64::consts::PI * 2f64.ln())).abs() < 1e-14);
//! assert!(smooth.evaluate(1.0).is_infinite());
//! # Ok::<(), fredholm::Error>(())
//! ```

mod audit;
mod collocated;
mod first_kind;
mod half_line;
mod logarithm;
mod residual;
mod truncated;

pub use audit::{Audit, audit};
pub use collocated::{collocate, collocate_in_parts};
pub use first_kind::{first_kind, first_kind_in_parts};
pub use half_line::{collocate_half_line, collocate_half_line_in_parts};
pub use logarithm::{degenerate_logarithm, degenerate_logarithm_in_parts};
pub use truncated::{degenerate, degenerate_in_parts};

use crate::bounds::Kind;

/// How an equation was solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The paper's method, or for the first kind the spectral relation itself.
    Spectral,
    /// Sinc collocation.
    Sinc,
}

/// How far an answer may be off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorStatement {
    /// A guaranteed bound, or an estimate.
    pub kind: Kind,
    /// Of the largest error of the solution on the closed interval; for an equation of the first kind of the solution over its weight, `phi/w`.
    pub solution: f64,
    /// Of the error of the integral.
    pub integral: f64,
}

/// A solution: a function with its integral and the statement of its error.
pub struct Solution<'a> {
    value: Box<dyn Fn(f64) -> f64 + 'a>,
    /// `int u phi dm` with the [mass function](crate::kernel::Kernel::mass_function) `u` of the kernel, where it exists.
    pub integral: Option<f64>,
    /// How far it may be off.
    pub error: ErrorStatement,
    /// How it was solved.
    pub method: Method,
    /// Highest index of the eigenfunctions kept, or number of nodes.
    pub count: usize,
    /// Whether the tolerance was met, or the right-hand side resolved.
    pub converged: bool,
    /// The largest value met (of `phi/w` for the first kind): what the error compares with.
    pub largest: f64,
}

impl Solution<'_> {
    /// `phi(x)`, `x` in the closed interval; infinite where the weight of a solution of the first kind is.
    #[must_use]
    pub fn evaluate(&self, x: f64) -> f64 {
        (self.value)(x)
    }
}

impl std::fmt::Debug for Solution<'_> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter
            .debug_struct("Solution")
            .field("integral", &self.integral)
            .field("error", &self.error)
            .field("method", &self.method)
            .field("count", &self.count)
            .field("converged", &self.converged)
            .finish_non_exhaustive()
    }
}

/// Points from end to end, dense at both, on which solutions are compared: cosines, the ends among them.
pub(crate) fn checks(interval: crate::Interval, count: usize) -> impl Iterator<Item = f64> {
    let (centre, half) = (interval.centre(), interval.half_length());
    (0..=count).map(move |i| match i {
        0 => interval.left(),
        i if i == count => interval.right(),
        i => centre - half * (std::f64::consts::PI * i as f64 / count as f64).cos(),
    })
}

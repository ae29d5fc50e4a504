//! A solution with the statement of its error.

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
    pub(super) value: Box<dyn Fn(f64) -> f64 + Send + Sync + 'a>,
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

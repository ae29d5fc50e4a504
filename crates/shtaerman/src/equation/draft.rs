//! A solution before it is judged.

use fredholm::equation::Solution;

use crate::Warning;

/// A solution with the reason for its method.
pub(super) struct Draft<'a> {
    pub(super) solution: Solution<'a>,
    pub(super) reason: String,
    pub(super) warnings: Vec<Warning>,
    /// Whether the size of the method was given, so that no error is aimed at.
    pub(super) is_truncated: bool,
}

impl Draft<'_> {
    pub(super) fn relative_error(&self) -> f64 {
        relative_error(&self.solution)
    }
}

/// The error over the largest value of the solution.
pub(super) fn relative_error(solution: &Solution<'_>) -> f64 {
    let (error, largest) = (solution.error.solution, solution.largest);
    if error == 0.0 { 0.0 } else { error / largest }
}

//! Both methods on one equation.

use super::Report;
use crate::Error;
use crate::equation::{Solution, collocate, degenerate};
use crate::kernel::{Kernel, SpectralRelation};

/// Degree of the degenerate kernel, where so many eigenfunctions can be had.
const DEGREE: usize = 160;
/// Intervals between the points at which solutions are compared.
const POINTS: usize = 60;
/// Tolerance of the collocation.
const TOLERANCE: f64 = 1e-12;

/// Two solutions of one equation and what they say of themselves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comparison {
    /// The largest difference over points from end to end.
    pub difference: f64,
    /// The sum of the errors that both report.
    pub allowed: f64,
    /// The difference of the integrals.
    pub integral_difference: f64,
    /// The sum of their errors.
    pub integral_allowed: f64,
    /// The largest value of the solution.
    pub largest: f64,
}

impl Comparison {
    /// Whether both differences are within the reported errors.
    #[must_use]
    pub fn agrees(&self) -> bool {
        self.difference <= self.allowed && self.integral_difference <= self.integral_allowed
    }

    /// Compares two solutions on the extent of a kernel.
    #[must_use]
    pub fn between(kernel: &dyn Kernel, one: &Solution<'_>, other: &Solution<'_>) -> Self {
        let difference = crate::equation::checks(kernel.extent(), POINTS)
            .map(|x| (one.evaluate(x) - other.evaluate(x)).abs())
            .fold(0.0, super::verification::maximum);
        let integral_difference = match (one.integral, other.integral) {
            (Some(one), Some(other)) => (one - other).abs(),
            _ => 0.0,
        };
        Self {
            difference,
            allowed: one.error.solution + other.error.solution,
            integral_difference,
            integral_allowed: one.error.integral + other.error.integral,
            largest: one.largest.max(other.largest),
        }
    }
}

/// Solves `phi + parameter K phi = f` by collocation and by the degenerate kernel of degree `degree`.
///
/// # Errors
/// Those of both methods.
pub fn compare(
    kernel: &dyn Kernel,
    relation: &dyn SpectralRelation,
    parameter: f64,
    f: &(dyn Fn(f64) -> f64 + Sync),
    degree: usize,
) -> Result<Comparison, Error> {
    let sinc = collocate(kernel, parameter, f, &[], TOLERANCE)?;
    let spectral = degenerate(relation, parameter, f, degree)?;
    Ok(Comparison::between(kernel, &sinc, &spectral))
}

/// Checks that both methods differ by no more than the errors they report, for weak and strong parameters.
///
/// # Errors
/// Those of both methods.
pub fn check_methods(
    kernel: &dyn Kernel,
    relation: &dyn SpectralRelation,
) -> Result<Report, Error> {
    let degree = DEGREE.min(relation.available() - 1).max(8);
    let extent = kernel.extent();
    let scaled = |x: f64| (x - extent.left()) / (2.0 * extent.half_length());
    let f = |x: f64| kernel.mass_function(x) * (1.0 + scaled(x).powi(2));
    let mut report = Report::default();
    let names = ["methods at a weak parameter", "methods at a strong parameter"];
    let norm = kernel_size(kernel);
    for (name, strength) in names.into_iter().zip([0.3, 20.0]) {
        let found = compare(kernel, relation, strength / norm, &f, degree)?;
        let excess = (found.difference / found.allowed)
            .max(found.integral_difference / found.integral_allowed);
        report.add(name, excess, 1.0);
    }
    Ok(report)
}

/// `int |K(x, s)| dm(s)` for `x` near the middle, roughly: the size of the operator.
fn kernel_size(kernel: &dyn Kernel) -> f64 {
    let extent = kernel.extent();
    let (left, length) = (extent.left(), 2.0 * extent.half_length());
    let x = left + 0.4 * length;
    let count = 400;
    let step = length / f64::from(count);
    (0..count)
        .map(|i| left + (f64::from(i) + 0.37) * step)
        .map(|s| step * (kernel.value(x, s) * kernel.measure(s)).abs())
        .sum()
}

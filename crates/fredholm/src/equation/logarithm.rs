//! The second kind on the logarithmic kernel, with guaranteed bounds.

use super::{ErrorStatement, Method, Solution};
use crate::basis::{ChebyshevSeries, Function};
use crate::bounds::{Given, Kind, ResidualOperator, Responses};
use crate::kernel::{Kernel, Logarithm, SpectralRelation};
use crate::quadrature::places::places_in_parts;
use crate::{DegenerateSolver, Error};

/// Rounding beside a bound, in units of the last place of the terms.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A series that is this close to its function, relative to the largest value, is the function.
const SEEN: f64 = 1e-12;

/// `phi + parameter K phi = f` on the logarithmic kernel by the degenerate kernel of degree `degree`, `parameter >= 0`, with **bounds** of its error: for exact arithmetic, and where
/// `f` is its Chebyshev series; otherwise they are estimates. That it is its series is seen from values at the nodes and at thousands of places between them: a feature that is hidden from all of
/// these is not in the bound. On intervals longer than twice the gauge the kernel is not positive; the rank-one step beside the positive
/// kernel keeps the bounds, but where its denominator may vanish there is none: the error is infinite then.
///
/// # Errors
/// [`Error::InvalidParameter`] for a negative or not finite parameter; [`Error::NotFinite`] where `f` is not finite; those of [`DegenerateSolver::new`].
pub fn degenerate_logarithm<'a>(
    kernel: &Logarithm,
    parameter: f64,
    f: &'a (dyn Fn(f64) -> f64 + Sync),
    degree: usize,
) -> Result<Solution<'a>, Error> {
    degenerate_logarithm_in_parts(kernel, parameter, f, &[], degree)
}

/// [`degenerate_logarithm`] for a right-hand side that is known to be nearly a polynomial of a degree below 32 on each of the parts into which cuts divide the interval: it is looked at in every
/// part, and where it is not its Chebyshev series there the errors are estimates.
///
/// # Errors
/// As [`degenerate_logarithm`].
pub fn degenerate_logarithm_in_parts<'a>(
    kernel: &Logarithm,
    parameter: f64,
    f: &'a (dyn Fn(f64) -> f64 + Sync),
    cuts: &[f64],
    degree: usize,
) -> Result<Solution<'a>, Error> {
    let half_length = kernel.half_length();
    let function = Function::resolve(&|xi| f(half_length * xi))?;
    let hidden = hidden(kernel, f, &function, cuts);
    let resolved = function.is_resolved() && hidden == 0.0;
    let kind = if resolved { Kind::Bound } else { Kind::Estimate };
    // On (-1, 1): phi + theta K phi + theta ln(l/a) int phi = f, K the plain logarithm; the operator of the bounds wants -f.
    let theta = parameter * half_length;
    let unit = Logarithm::unit();
    let right = ChebyshevSeries::new(function.series().coefficients().iter().map(|c| -c).collect());
    let operator = ResidualOperator::new(&unit, theta, degree.max(right.degree()))?;
    let solver = DegenerateSolver::new(&unit, theta, degree)?;
    let approximate = |series: &ChebyshevSeries| {
        let solution = solver.solve(&series.moments(degree + 1))?;
        operator.approximation(series, solution.correction(), kind)
    };
    let [one, linear] = [vec![1.0], vec![0.0, 1.0]].map(ChebyshevSeries::new);
    let responses =
        Responses::new(approximate(&one)?, approximate(&linear)?, approximate(&right)?)?;
    let offset = kernel.expansion_factor(0) - unit.expansion_factor(0);
    let combination =
        responses.combine([Given::Proportion(-theta * offset), Given::Coefficient(0.0)]);
    let approximation = combination.approximation();
    let series = approximation.density().clone();
    let values = series.values(series.degree().max(1));
    let largest = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let size = function.largest() + largest;
    let unresolved = function.error() * function.largest() + hidden;
    let integral = half_length * approximation.moments()[0];
    let projection = combination.projections()[0];
    let integral_error = half_length * projection.error_of(approximation.moments()[0])
        + half_length * (ROUNDING * size + 2.0 * unresolved);
    let solution = combination.error_supremum()
        + ROUNDING * size
        + unresolved * (1.0 + operator.amplification());
    Ok(Solution {
        integral: Some(integral),
        error: ErrorStatement { kind, solution, integral: integral_error },
        method: Method::Spectral,
        count: degree,
        converged: solution <= 0.1 * largest,
        largest,
        value: Box::new(move |x| {
            let xi = (x / half_length).clamp(-1.0, 1.0);
            let missed = if resolved { 0.0 } else { f(x) - function.series().evaluate(xi) };
            series.evaluate(xi) + missed
        }),
    })
}

/// The largest difference of the function and its series over the parts between the cuts, where it is more than rounding.
fn hidden(kernel: &Logarithm, f: &dyn Fn(f64) -> f64, function: &Function, cuts: &[f64]) -> f64 {
    if cuts.is_empty() {
        return 0.0;
    }
    let half_length = kernel.half_length();
    let worst = places_in_parts(kernel.interval(), cuts)
        .into_iter()
        .map(|x| (f(x) - function.series().evaluate(x / half_length)).abs())
        .fold(0.0, f64::max);
    if worst <= (SEEN + 4.0 * function.error()) * function.largest() { 0.0 } else { worst }
}

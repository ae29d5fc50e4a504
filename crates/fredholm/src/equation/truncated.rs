//! The second kind by the degenerate kernel.

use super::residual::residual;
use super::{ErrorStatement, Method, Solution, checks};
use crate::bounds::Kind;
use crate::kernel::{Expansion, SpectralRelation};
use crate::quadrature::{Node, double_exponential};
use crate::{DegenerateSolution, DegenerateSolver, Error};

/// Intervals between the points at which solutions are compared.
const CHECKS: usize = 257;
/// Safety on the extrapolated difference.
const SAFETY: f64 = 4.0;
/// What an error of the moments counts for in the solution.
const AMPLIFICATION: f64 = 4.0;
/// Safety on the residual.
const RESIDUAL: f64 = 2.0;
/// Rounding, in units of the last place of the terms.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// An error below this share of the solution is an answer.
const USEFUL: f64 = 0.1;

/// `phi + parameter K phi = f` by the degenerate kernel with the eigenfunctions `phi_0 .. phi_degree`.
///
/// The error is estimated from the degrees `degree`, `degree/2` and `degree/4`: the last difference, continued as it falls or as the singularity of the
/// kernel makes it fall at the ends, `degree^{-2(1-q)}`, whichever is slower, times 4; or twice the residual at the ends and
/// a few other points, where that is larger. For the logarithm [`degenerate_logarithm`](super::degenerate_logarithm) has guaranteed bounds.
///
/// # Errors
/// [`Error::InvalidParameter`] for a degree below 8 or an infinite interval; those of [`DegenerateSolver::new`] and of the moments.
pub fn degenerate<'a>(
    relation: &'a (impl SpectralRelation + ?Sized),
    parameter: f64,
    f: &'a dyn Fn(f64) -> f64,
    degree: usize,
) -> Result<Solution<'a>, Error> {
    if degree < 8 {
        return Err(Error::InvalidParameter {
            name: "degree",
            value: degree as f64,
            requirement: "at least 8: the error is judged from a quarter of it",
        });
    }
    let moments = relation.moments(f, degree + 1)?;
    let solve =
        |degree: usize| DegenerateSolver::new(relation, parameter, degree)?.solve(&moments.values);
    let (first, second, solution) = (solve(degree / 4)?, solve(degree / 2)?, solve(degree)?);
    let points: Vec<f64> = checks(relation.extent(), CHECKS).collect();
    let before = difference(relation, &first, &second, &points);
    let after = difference(relation, &second, &solution, &points);
    let values = points.iter().map(|&x| (f(x).abs(), solution.evaluate(x, f(x)).abs()));
    let (given, largest) =
        values.fold((0.0f64, 0.0f64), |(f, phi), (g, psi)| (f.max(g), phi.max(psi)));
    let rate = slowest_rate(relation);
    let rounding = ROUNDING * (given + largest) + AMPLIFICATION * moments.error * given;
    let unresolved = if relation.interval().is_finite() {
        RESIDUAL * residual(relation, parameter, f, &|x| solution.evaluate(x, f(x)), degree)
    } else {
        0.0
    };
    let error = extrapolate(before, after, rate).max(unresolved) + rounding;
    let functional = Integral::new(relation)?;
    let integrals =
        [&first, &second, &solution].map(|solution| functional.of(relation, f, solution));
    let integral_error = match integrals {
        [Some(i1), Some(i2), Some(i3)] => {
            let size = i3.abs() + (given + largest) * functional_size(relation);
            extrapolate((i2 - i1).abs(), (i3 - i2).abs(), rate)
                + rounding / (given + largest).max(f64::MIN_POSITIVE) * size
        }
        _ => f64::INFINITY,
    };
    Ok(Solution {
        integral: integrals[2],
        error: ErrorStatement { kind: Kind::Estimate, solution: error, integral: integral_error },
        method: Method::Spectral,
        count: degree,
        converged: error <= USEFUL * largest,
        largest,
        value: Box::new(move |x| solution.evaluate(x, f(x))),
    })
}

/// `int |u| dm`, roughly.
fn functional_size(relation: &(impl SpectralRelation + ?Sized)) -> f64 {
    let extent = relation.extent();
    let densities =
        checks(extent, 16).map(|x| (relation.measure(x) * relation.mass_function(x)).abs());
    2.0 * extent.half_length() * densities.fold(0.0, f64::max)
}

/// The largest difference over the points.
fn difference<K: SpectralRelation + ?Sized>(
    relation: &K,
    coarse: &DegenerateSolution<'_, K>,
    fine: &DegenerateSolution<'_, K>,
    points: &[f64],
) -> f64 {
    let mut gap = fine.correction().to_vec();
    gap.iter_mut().zip(coarse.correction()).for_each(|(gap, c)| *gap -= c);
    points.iter().map(|&x| relation.sum(&gap, x).abs()).fold(0.0, f64::max)
}

/// By how much the error at the ends falls when the degree doubles, at least: `degree^{-2(1-q)}`.
fn slowest_rate(relation: &(impl SpectralRelation + ?Sized)) -> f64 {
    let exponent = relation.singularity().exponent();
    0.5f64.powf(2.0 * (1.0 - exponent).min(2.0))
}

/// What remains after two differences of degrees that double, when it falls no faster than by `rate`.
fn extrapolate(before: f64, after: f64, rate: f64) -> f64 {
    let seen = if before > 0.0 { (after / before).min(1.0) } else { 0.0 };
    let rate = rate.max(seen).min(0.98);
    SAFETY * after * rate / (1.0 - rate)
}

/// `int u phi dm = sum c_n X_n` for `u = sum c_n phi_n`, the mass function; by quadrature of `phi` where `u` has no short expansion. None on an infinite interval where that fails.
struct Integral {
    coefficients: Option<Vec<f64>>,
}

impl Integral {
    fn new(relation: &(impl SpectralRelation + ?Sized)) -> Result<Self, Error> {
        let Expansion { coefficients, resolved, .. } =
            relation.expand(&|x| relation.mass_function(x))?;
        Ok(Self { coefficients: resolved.then_some(coefficients) })
    }

    fn of<K: SpectralRelation + ?Sized>(
        &self,
        relation: &K,
        f: &dyn Fn(f64) -> f64,
        solution: &DegenerateSolution<'_, K>,
    ) -> Option<f64> {
        let projections = solution.projections();
        match &self.coefficients {
            Some(coefficients) if coefficients.len() <= projections.len() => {
                Some(coefficients.iter().zip(projections).map(|(c, x)| c * x).sum())
            }
            _ if !relation.interval().is_finite() => None,
            _ => {
                let (centre, half) =
                    (relation.interval().centre(), relation.interval().half_length());
                let mass = |node: Node| {
                    let x = (centre + half * node.position)
                        .clamp(relation.interval().left(), relation.interval().right());
                    let density = relation.measure(x) * relation.mass_function(x);
                    half * node.weight * density * solution.evaluate(x, f(x))
                };
                Some(double_exponential(4 * projections.len() + 40).map(mass).sum())
            }
        }
    }
}

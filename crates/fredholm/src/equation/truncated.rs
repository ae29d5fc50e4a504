//! The second kind by the degenerate kernel.

use super::residual::residual;
use super::{ErrorStatement, Method, Solution, checks};
use crate::bounds::Kind;
use crate::kernel::{Moments, SpectralRelation};
use crate::quadrature::places::Sampled;
use crate::quadrature::{Node, double_exponential, gauss_legendre};
use crate::{DegenerateSolution, DegenerateSolver, Error};

/// The solution of the degenerate kernel for whatever kernel it is of.
type Truncated<'k> = DegenerateSolution<'k, dyn SpectralRelation + 'k>;

/// Intervals between the points at which solutions are compared.
const CHECKS: usize = 257;
/// Safety on the extrapolated difference.
const SAFETY: f64 = 4.0;
/// What an error of the moments counts for in the solution.
const AMPLIFICATION: f64 = 4.0;
/// Last coefficients of an expansion that must have fallen to rounding.
const TAIL: usize = 4;
/// Safety on the residual.
const RESIDUAL: f64 = 2.0;
/// Rounding, in units of the last place of the terms.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// So many moments are taken again.
const LOW: usize = 6;
/// Agreement of moments, relative to the largest that they can be.
const AGREED: f64 = 1e-12;
/// Nodes of a panel.
const PANEL_NODES: usize = 16;
/// Longest panel in `arccos`, over the inverse of the highest degree.
const RADIANS: f64 = 10.0;
/// Most panels whose places are looked at.
const MOST_PLACES: usize = 600;
/// An error below this share of the solution is an answer.
const USEFUL: f64 = 0.1;

/// `phi + parameter K phi = f` by the degenerate kernel with the eigenfunctions `phi_0 .. phi_degree`.
///
/// The error is estimated from the degrees `degree`, `degree/2` and `degree/4`: the last difference, continued as it falls or as the singularity of the
/// kernel makes it fall at the ends, `degree^{-2(1-q)}`, whichever is slower, times 4; or twice the residual at the ends and
/// a few other points, where that is larger. The first moments are taken again on panels that are cut wherever `f` asks for it at 6000 places, so that a narrow feature between the
/// nodes of their rule shows, and all are taken from these panels then; one narrower than about a 4000th of the interval may be hidden from all of these. For the logarithm [`degenerate_logarithm`](super::degenerate_logarithm) has guaranteed bounds.
///
/// # Errors
/// [`Error::InvalidParameter`] for a degree below 8; those of [`DegenerateSolver::new`] and of the moments.
pub fn degenerate<'a>(
    relation: &'a dyn SpectralRelation,
    parameter: f64,
    f: &'a (dyn Fn(f64) -> f64 + Sync),
    degree: usize,
) -> Result<Solution<'a>, Error> {
    degenerate_in_parts(relation, parameter, f, &[], degree)
}

/// [`degenerate`] for a right-hand side that is known to be nearly a polynomial of a degree below 32 on each of the parts into which cuts divide the interval: it is looked at in every part.
///
/// # Errors
/// As [`degenerate`].
pub fn degenerate_in_parts<'a>(
    relation: &'a dyn SpectralRelation,
    parameter: f64,
    f: &'a (dyn Fn(f64) -> f64 + Sync),
    cuts: &[f64],
    degree: usize,
) -> Result<Solution<'a>, Error> {
    if degree < 8 {
        return Err(Error::InvalidParameter {
            name: "degree",
            value: degree as f64,
            requirement: "at least 8: the error is judged from a quarter of it",
        });
    }
    let features = Features::new(relation, f, cuts)?;
    let moments = moments_of(relation, f, features.as_ref(), degree + 1)?;
    let solve =
        |degree: usize| DegenerateSolver::new(relation, parameter, degree)?.solve(&moments.values);
    let levels = [solve(degree / 4)?, solve(degree / 2)?, solve(degree)?];
    let mut points: Vec<f64> = checks(relation.extent(), CHECKS).collect();
    points.extend(features.iter().flat_map(Features::places));
    let sizes = Sizes::new(relation, f, &levels[2], (moments.error, &points));
    let unresolved = RESIDUAL * residual_of(relation, parameter, f, &levels[2], degree);
    let error = solution_error(relation, &levels, &points).max(unresolved) + sizes.rounding;
    let functional = Integral::new(relation, degree, features.as_ref());
    let integrals = levels.each_ref().map(|solution| functional.of(relation, f, solution));
    let integral_error = match integrals {
        [Some([i1, _]), Some([i2, _]), Some([i3, missed])] => {
            let extrapolated =
                extrapolate((i2 - i1).abs(), (i3 - i2).abs(), slowest_rate(relation));
            // A layer at an end is no wider than what the last term resolves there.
            let layer = unresolved * sizes.functional / (degree as f64).powi(2);
            extrapolated.max(layer) + missed + sizes.rounding_of_integral(i3)
        }
        _ => f64::INFINITY,
    };
    let [_, _, solution] = levels;
    Ok(Solution {
        integral: integrals[2].map(|[integral, _]| integral),
        error: ErrorStatement { kind: Kind::Estimate, solution: error, integral: integral_error },
        method: Method::Spectral,
        count: degree,
        converged: error <= USEFUL * sizes.solution,
        largest: sizes.solution,
        value: {
            let correction = solution.prepared_correction();
            Box::new(move |x| f(x) - correction(x))
        },
    })
}

/// Where a right-hand side has features that few nodes would overlook.
struct Features {
    /// Panels on which it is a polynomial, from left to right.
    panels: Vec<(f64, f64)>,
    /// Its largest value.
    largest: f64,
}

impl Features {
    /// None on an infinite interval, and where panels would be too many.
    fn new(
        relation: &dyn SpectralRelation,
        f: &dyn Fn(f64) -> f64,
        cuts: &[f64],
    ) -> Result<Option<Self>, Error> {
        if !relation.interval().is_finite() {
            return Ok(None);
        }
        let sampled = Sampled::new(relation.interval(), f, cuts)?;
        Ok(sampled.partition(f, &[], 0.0).map(|panels| {
            let panels = panels.iter().map(|panel| (panel.left, panel.right)).collect();
            Self { panels, largest: sampled.largest }
        }))
    }

    /// The ends of the panels and their middles: what a truncated expansion makes of a narrow feature shows there.
    fn places(&self) -> impl Iterator<Item = f64> + '_ {
        let stride = self.panels.len().div_ceil(MOST_PLACES).max(1);
        let places = self.panels.iter().map(|(left, right)| [*left, left.midpoint(*right)]);
        places.step_by(stride).flatten()
    }

    /// `int u f dm` on these panels, and on their halves.
    fn integrals(
        &self,
        relation: &dyn SpectralRelation,
        f: &dyn Fn(f64) -> f64,
    ) -> Option<[f64; 2]> {
        let rule = gauss_legendre(PANEL_NODES).ok()?;
        let on = |left: f64, right: f64| -> f64 {
            let (middle, radius) = (left.midpoint(right), 0.5 * (right - left));
            let nodes = rule.nodes.iter().zip(&rule.weights);
            let terms = nodes.map(|(t, weight)| {
                let x = (middle + radius * t).clamp(left, right);
                radius * weight * f(x) * relation.measure(x) * relation.mass_function(x)
            });
            terms.sum()
        };
        let whole = self.panels.iter().map(|(left, right)| on(*left, *right)).sum();
        let halves = self.panels.iter().map(|(left, right)| {
            let middle = left.midpoint(*right);
            on(*left, middle) + on(middle, *right)
        });
        Some([whole, halves.sum()])
    }
}

/// The moments of the right-hand side: those of the relation where they are right, else by panels that are cut wherever the values of `f` ask for it.
fn moments_of(
    relation: &dyn SpectralRelation,
    f: &dyn Fn(f64) -> f64,
    features: Option<&Features>,
    count: usize,
) -> Result<Moments, Error> {
    let given = relation.moments(f, count)?;
    let Some(features) = features else { return Ok(given) };
    let few = |count, share| panel_moments(relation, f, &features.panels, (count, share));
    let Some(low) = few(LOW.min(count), 1.0) else { return Ok(given) };
    let scale = features.largest * functional_size(relation);
    let differs = |one: &[f64], other: &[f64]| {
        one.iter().zip(other).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
    };
    if given.resolved && differs(&low, &given.values) <= AGREED * scale {
        return Ok(given);
    }
    let (Some(values), Some(finer)) = (few(count, 1.0), few(count, 0.6)) else { return Ok(given) };
    let change = if scale > 0.0 { differs(&values, &finer) / scale } else { 0.0 };
    let error = change + f64::EPSILON;
    // Where even panels do not settle, the relation's own moments may be the better ones, with their own error.
    if error > given.error {
        return Ok(given);
    }
    Ok(Moments { values: finer, error, resolved: error <= AGREED })
}

/// `int f phi_k dm` by panels on which both `f` and the eigenfunctions, which oscillate evenly in `arccos`, are resolved.
fn panel_moments(
    relation: &dyn SpectralRelation,
    f: &dyn Fn(f64) -> f64,
    panels: &[(f64, f64)],
    (count, share): (usize, f64),
) -> Option<Vec<f64>> {
    let (centre, half) = (relation.interval().centre(), relation.interval().half_length());
    let angle = |x: f64| ((centre - x) / half).clamp(-1.0, 1.0).acos();
    let rule = gauss_legendre(PANEL_NODES).ok()?;
    let longest = share * RADIANS / count as f64;
    let mut values = vec![0.0; count];
    let mut functions = vec![0.0; count];
    for &(left, right) in panels {
        let (from, to) = (angle(left), angle(right));
        let pieces = ((to - from) / longest).ceil().max(1.0);
        for piece in 0..pieces as usize {
            let step = (to - from) / pieces;
            // A panel that is short to the last digit keeps its ends.
            let ends = if pieces == 1.0 {
                [left, right]
            } else {
                [piece, piece + 1].map(|i| centre - half * (from + i as f64 * step).cos())
            };
            let (middle, radius) = (ends[0].midpoint(ends[1]), 0.5 * (ends[1] - ends[0]));
            for (t, weight) in rule.nodes.iter().zip(&rule.weights) {
                let x = (middle + radius * t).clamp(left, right);
                relation.eigenfunctions(x, &mut functions);
                let factor = radius * weight * f(x) * relation.measure(x);
                values.iter_mut().zip(&functions).for_each(|(value, phi)| *value += factor * phi);
            }
        }
    }
    Some(values)
}

/// Sizes against which errors are held.
struct Sizes {
    /// Largest `|f|` and `|phi|`.
    given: f64,
    solution: f64,
    /// `int |u| dm`, roughly.
    functional: f64,
    /// Rounding of the solution, and what its moments may be off.
    rounding: f64,
}

impl Sizes {
    fn new(
        relation: &dyn SpectralRelation,
        f: &dyn Fn(f64) -> f64,
        solution: &Truncated<'_>,
        (moment_error, points): (f64, &[f64]),
    ) -> Self {
        let correction = solution.prepared_correction();
        let values = points.iter().map(|&x| {
            let given = f(x);
            (given.abs(), (given - correction(x)).abs())
        });
        let (given, solution) =
            values.fold((0.0f64, 0.0f64), |(f, phi), (g, psi)| (f.max(g), phi.max(psi)));
        let rounding = ROUNDING * (given + solution) + AMPLIFICATION * moment_error * given;
        Self { given, solution, functional: functional_size(relation), rounding }
    }

    fn rounding_of_integral(&self, integral: f64) -> f64 {
        let values = (self.given + self.solution).max(f64::MIN_POSITIVE);
        self.rounding * (integral.abs() / values + self.functional)
    }
}

/// The difference of the last two levels over the points, continued.
fn solution_error(
    relation: &dyn SpectralRelation,
    [first, second, last]: &[Truncated<'_>; 3],
    points: &[f64],
) -> f64 {
    let before = difference(relation, first, second, points);
    let after = difference(relation, second, last, points);
    extrapolate(before, after, slowest_rate(relation))
}

/// The residual at single points.
fn residual_of(
    relation: &dyn SpectralRelation,
    parameter: f64,
    f: &dyn Fn(f64) -> f64,
    solution: &Truncated<'_>,
    degree: usize,
) -> f64 {
    let correction = solution.prepared_correction();
    residual(relation, parameter, f, &|x| f(x) - correction(x), degree)
}

/// `int |u| dm`, roughly.
fn functional_size(relation: &dyn SpectralRelation) -> f64 {
    let extent = relation.extent();
    let densities =
        checks(extent, 16).map(|x| (relation.measure(x) * relation.mass_function(x)).abs());
    2.0 * extent.half_length() * densities.fold(0.0, f64::max)
}

/// The largest difference over the points.
fn difference(
    relation: &dyn SpectralRelation,
    coarse: &Truncated<'_>,
    fine: &Truncated<'_>,
    points: &[f64],
) -> f64 {
    let mut gap = fine.correction().to_vec();
    gap.iter_mut().zip(coarse.correction()).for_each(|(gap, c)| *gap -= c);
    let gap = relation.combination(&gap);
    points.iter().map(|&x| gap(x).abs()).fold(0.0, f64::max)
}

/// By how much the error at the ends falls when the degree doubles, at least: `degree^{-2(1-q)}`, on a half-line `degree^{-(1-q)}`.
fn slowest_rate(relation: &dyn SpectralRelation) -> f64 {
    let power = if relation.interval().is_finite() { 2.0 } else { 1.0 };
    0.5f64.powf(power * (1.0 - relation.singularity().exponent()).min(2.0))
}

/// What remains after two differences of degrees that double, when it falls no faster than by `rate`.
fn extrapolate(before: f64, after: f64, rate: f64) -> f64 {
    let seen = if before > 0.0 { (after / before).min(1.0) } else { 0.0 };
    let rate = rate.max(seen).min(0.98);
    SAFETY * after * rate / (1.0 - rate)
}

/// `int u phi dm = sum c_n X_n` for `u = sum c_n phi_n`, the mass function; by quadrature of `phi` where `u` has no short expansion. None on an infinite interval where that fails.
struct Integral<'a> {
    coefficients: Option<Vec<f64>>,
    features: Option<&'a Features>,
}

impl<'a> Integral<'a> {
    /// `c_n = h_n^-1 int u phi_n w dm`, where they have fallen to rounding within the degree.
    fn new(relation: &dyn SpectralRelation, degree: usize, features: Option<&'a Features>) -> Self {
        let coefficients: Vec<f64> =
            (0..=degree).map(|n| relation.mass(n) / relation.norm(n)).collect();
        let largest = coefficients.iter().fold(0.0f64, |most, c| most.max(c.abs()));
        let tail = coefficients.iter().rev().take(TAIL).fold(0.0f64, |most, c| most.max(c.abs()));
        Self { coefficients: (tail <= f64::EPSILON * largest).then_some(coefficients), features }
    }

    /// And what panels are seen to miss of it.
    fn of(
        &self,
        relation: &dyn SpectralRelation,
        f: &dyn Fn(f64) -> f64,
        solution: &Truncated<'_>,
    ) -> Option<[f64; 2]> {
        let projections = solution.projections();
        match &self.coefficients {
            Some(coefficients) => {
                Some([coefficients.iter().zip(projections).map(|(c, x)| c * x).sum(), 0.0])
            }
            _ if !relation.interval().is_finite() => None,
            _ => {
                let (centre, half) =
                    (relation.interval().centre(), relation.interval().half_length());
                let correction = solution.prepared_correction();
                let mut sums = [0.0; 2];
                for Node { position, weight, .. } in double_exponential(4 * projections.len() + 40)
                {
                    let x = (centre + half * position)
                        .clamp(relation.interval().left(), relation.interval().right());
                    let mass = half * weight * relation.measure(x) * relation.mass_function(x);
                    sums[0] += mass * f(x);
                    sums[1] += mass * correction(x);
                }
                let [own, corrected] = sums;
                // Nodes for the whole overlook narrow features; panels do not see singular ends as well.
                let on_panels = self.features.and_then(|features| features.integrals(relation, f));
                let missed = on_panels.map_or(0.0, |[whole, halves]| (whole - halves).abs());
                let given = match on_panels {
                    Some([_, halves]) if (own - halves).abs() > missed => halves,
                    _ => own,
                };
                Some([given - corrected, missed])
            }
        }
    }
}

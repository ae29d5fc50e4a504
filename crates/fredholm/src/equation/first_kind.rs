//! The first kind: the smooth limit, straight from the spectral relation.

use super::remainder::Remainder;
use super::{ErrorStatement, Method, Solution, checks};
use crate::Error;
use crate::basis::expansion::{MOST_TERMS, misfit};
use crate::bounds::Kind;
use crate::kernel::{Expansion, Parity, SpectralRelation};

/// Intervals between the points at which sums are compared.
const CHECKS: usize = 257;
/// An eigenvalue below this share of the largest counts as zero.
const ZERO: f64 = 1e-14;
/// Safety on the difference of a sum from its half.
const SAFETY: f64 = 4.0;
/// An expansion that is this close between the nodes, relative to the largest value, resolves the right-hand side.
const RESOLVED: f64 = 2e-12;
/// Rounding of a coefficient of the right-hand side, in units of its largest value.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Most terms that are looked at for what those of the solution leave out, where a cosine transform sums them and where it does not.
const LOOKED_AT: [usize; 2] = [1 << 16, 1 << 12];

/// `K phi = f`: with `f = sum c_n phi_n`, by (1.2), `phi = w sum (c_n / lambda_n) phi_n`. It contains its weight, which is infinite at the ends for all our kernels; the
/// statement of the error is for `phi/w`. No more than `count` terms are used.
///
/// The error is an estimate: rounding of the coefficients divided by the eigenvalues, and where `f` is not resolved the difference from the sum of half as many terms, times 4, or what is left out
/// if that is more, by the rate at which the terms fall. It is infinite where they do not fall: under a kink the solution itself is infinite; and where values between the nodes show what no term has.
/// Whether it is resolved, its values show at the nodes and at 6000 places between them; a feature narrower than about a 4000th of the interval may be hidden from all of these.
///
/// # Errors
/// [`Error::ZeroEigenvalue`] where an eigenvalue vanishes that is needed; [`Error::InvalidParameter`] for no terms; those of
/// [`SpectralRelation::expand`].
pub fn first_kind<'a>(
    relation: &'a dyn SpectralRelation,
    f: &dyn Fn(f64) -> f64,
    count: usize,
) -> Result<Solution<'a>, Error> {
    first_kind_in_parts(relation, f, &[], count)
}

/// [`first_kind`] for a right-hand side that is known to be nearly a polynomial of a degree below 32 on each of the parts into which cuts divide the interval: it is looked at in every part.
///
/// # Errors
/// As [`first_kind`].
pub fn first_kind_in_parts<'a>(
    relation: &'a dyn SpectralRelation,
    f: &dyn Fn(f64) -> f64,
    cuts: &[f64],
    count: usize,
) -> Result<Solution<'a>, Error> {
    if count == 0 {
        return Err(Error::InvalidParameter {
            name: "count",
            value: 0.0,
            requirement: "at least 1",
        });
    }
    let Expansion { mut coefficients, mut error, resolved } = relation.expand(f)?;
    // Where the upper half of the terms that are tried is rounding, the lower half is all that they can tell.
    let is_told = resolved || 2 * coefficients.len() <= MOST_TERMS.min(relation.available());
    let hidden = if is_told { misfit(relation, f, &coefficients, cuts)? } else { 0.0 };
    error = error.max(hidden);
    let complete = resolved && error <= RESOLVED && coefficients.len() <= count;
    let kept = coefficients.len().min(count);
    let most = LOOKED_AT[usize::from(relation.largest_sum(&[0.0]).is_none())];
    let looked_at = coefficients.len().min(kept.max(most));
    let is_whole = resolved && looked_at == coefficients.len();
    let known = densities(relation, &coefficients[..looked_at]);
    coefficients.truncate(count);
    let largest_value =
        checks(relation.extent(), CHECKS).map(|x| f(x).abs()).fold(0.0, |most: f64, v| most.max(v));
    let density = densities(relation, &coefficients)?;
    let points: Vec<f64> = checks(relation.extent(), CHECKS).collect();
    let largest = largest_of(relation, &density, &points);
    let noise = noise(relation, density.len(), &points);
    let rounding =
        (ROUNDING + error) * largest_value * noise.solution + 4.0 * f64::EPSILON * largest;
    let integral: f64 = density.iter().enumerate().map(|(n, c)| c * relation.mass(n)).sum();
    let (mut solution_error, mut integral_error) = (
        rounding,
        (ROUNDING + error) * largest_value * noise.integral + 4.0 * f64::EPSILON * integral.abs(),
    );
    if !complete {
        let half = density.len().div_ceil(2)..density.len();
        let mut rest = density.clone();
        rest[..half.start].fill(0.0);
        let gap = largest_of(relation, &rest, &points);
        let integral_gap: f64 = half.map(|n| density[n] * relation.mass(n)).sum();
        // Where an eigenvalue vanishes beyond the terms of the solution, these are all that is known.
        let is_whole = is_whole && known.is_ok();
        let known = known.unwrap_or_else(|_| density.clone());
        let noise = ROUNDING * largest_value;
        let rest = Remainder { relation, density: &known, kept, is_whole, noise };
        solution_error += rest.solution().max(SAFETY * gap);
        integral_error += rest.integral().max(SAFETY * integral_gap.abs());
    }
    // What no term has may be as narrow as it likes, and the narrower it is the more it raises the solution; the integral knows its height alone.
    if hidden > RESOLVED {
        solution_error = f64::INFINITY;
    }
    Ok(Solution {
        integral: Some(integral).filter(|_| integral_error.is_finite()),
        error: ErrorStatement {
            kind: Kind::Estimate,
            solution: solution_error,
            integral: integral_error,
        },
        method: Method::Spectral,
        count: density.len() - 1,
        converged: complete,
        largest,
        value: weighted(relation, &density),
    })
}

/// The largest `|sum c_n phi_n|` over points.
fn largest_of(relation: &dyn SpectralRelation, density: &[f64], points: &[f64]) -> f64 {
    let sum = relation.combination(density);
    points.iter().map(|&x| sum(x).abs()).fold(0.0, f64::max)
}

/// `c_n / lambda_n`.
fn densities(relation: &dyn SpectralRelation, coefficients: &[f64]) -> Result<Vec<f64>, Error> {
    let largest = (0..coefficients.len().max(2).min(relation.available()))
        .map(|n| relation.eigenvalue(n).abs())
        .fold(0.0, f64::max);
    let divide = |(n, c): (usize, &f64)| {
        let eigenvalue = relation.eigenvalue(n);
        if eigenvalue.abs() > ZERO * largest {
            Ok(c / eigenvalue)
        } else {
            Err(Error::ZeroEigenvalue { index: n, eigenvalue })
        }
    };
    coefficients.iter().enumerate().map(divide).collect()
}

/// By how much errors of the right-hand side grow.
struct Noise {
    solution: f64,
    integral: f64,
}

/// Independent errors of `c_n phi_n`, of the size of one, after division by the eigenvalues.
fn noise(relation: &dyn SpectralRelation, count: usize, points: &[f64]) -> Noise {
    let mut sizes = vec![0.0f64; count];
    let mut values = vec![0.0; count];
    for &x in points {
        relation.eigenfunctions(x, &mut values);
        sizes.iter_mut().zip(&values).for_each(|(size, phi)| *size = size.max(phi.abs()));
    }
    let square =
        |term: &dyn Fn(usize) -> f64| (0..count).map(|n| term(n).powi(2)).sum::<f64>().sqrt();
    Noise {
        solution: square(&|n| 1.0 / relation.eigenvalue(n)),
        integral: square(&|n| {
            if sizes[n] > 0.0 {
                relation.mass(n) / (relation.eigenvalue(n) * sizes[n])
            } else {
                0.0
            }
        }),
    }
}

/// `sum c_n w phi_n`, by parity where the weights differ.
fn weighted<'a>(
    relation: &'a dyn SpectralRelation,
    density: &[f64],
) -> Box<dyn Fn(f64) -> f64 + Send + Sync + 'a> {
    if relation.parity() == Parity::None {
        let sum = relation.combination(density);
        return Box::new(move |x| relation.weight(0, x) * sum(x));
    }
    let parts = [0, 1].map(|parity| {
        let keep = |(n, c): (usize, &f64)| if n % 2 == parity { *c } else { 0.0 };
        let chosen: Vec<f64> = density.iter().enumerate().map(keep).collect();
        let exists = chosen.iter().any(|c| *c != 0.0);
        exists.then(|| relation.combination(&chosen))
    });
    Box::new(move |x| {
        let part = |parity: usize| {
            parts[parity].as_ref().map_or(0.0, |sum| relation.weight(parity, x) * sum(x))
        };
        part(0) + part(1)
    })
}

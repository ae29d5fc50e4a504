//! Functions expanded in the eigenfunctions of a kernel by a Gauss rule of its weight.

use crate::Error;
use crate::kernel::{Expansion, SpectralRelation};
use crate::quadrature::Rule;
use crate::quadrature::places::places_in_parts;

/// Fewest and most terms tried.
const FEWEST_TERMS: usize = 32;
pub(crate) const MOST_TERMS: usize = 1024;
/// Terms below this share of the largest value of the function count as rounding.
const ROUNDING: f64 = 4e-16;
/// An expansion that is this close between the nodes, relative to the largest value, resolves the function.
const RESOLVED: f64 = 1e-12;

/// Expands `f` in the eigenfunctions of a relation; `rule(count)` integrates the products of `phi_0 .. phi_{count-1}` with the weight exactly. The number of
/// terms doubles until the sum agrees with `f` at the nodes of the next rule, and at thousands of places that no rule has.
///
/// # Errors
/// [`Error::NotFinite`] with the place when `f` is not finite at a node; those of the rule.
pub(crate) fn expand_by_rule(
    relation: &dyn SpectralRelation,
    f: &dyn Fn(f64) -> f64,
    rule: impl Fn(usize) -> Result<Rule, Error>,
) -> Result<Expansion, Error> {
    expand_at_nodes(relation, f, rule, |x| *x, |x, values| relation.eigenfunctions(*x, values))
}

/// The same for nodes that hold their place in more digits than a number has: `place` rounds them for `f`, `functions` gives the eigenfunctions there. With a
/// weight that is large where eigenfunctions are steep, rounding of places would spoil the products of eigenfunctions, not those of smooth functions.
///
/// # Errors
/// As [`expand_by_rule`].
pub(crate) fn expand_at_nodes<Node>(
    relation: &dyn SpectralRelation,
    f: &dyn Fn(f64) -> f64,
    rule: impl Fn(usize) -> Result<Rule<Node>, Error>,
    place: impl Fn(&Node) -> f64,
    functions: impl Fn(&Node, &mut [f64]),
) -> Result<Expansion, Error> {
    let most = MOST_TERMS.min(relation.available());
    let mut count = FEWEST_TERMS.min(most);
    let mut current = rule(count)?;
    let mut values = sample(f, current.nodes.iter().map(&place))?;
    loop {
        let next = rule((2 * count).min(2 * MOST_TERMS))?;
        let checks = sample(f, next.nodes.iter().map(&place))?;
        let largest = values.iter().chain(&checks).fold(0.0, |most: f64, v| most.max(v.abs()));
        let coefficients = project(relation, &current, &functions, &values, (count, largest));
        let error = next
            .nodes
            .iter()
            .zip(&checks)
            .map(|(node, value)| (relation.sum(&coefficients, place(node)) - value).abs())
            .fold(0.0, f64::max);
        let mut error = if largest > 0.0 { error / largest } else { 0.0 };
        if error <= RESOLVED || count == most {
            error = error.max(misfit(relation, f, &coefficients, &[])?);
        }
        let resolved = error <= RESOLVED;
        if resolved || count == most {
            return Ok(Expansion { coefficients, error, resolved });
        }
        count = (2 * count).min(most);
        (current, values) = (next, checks);
    }
}

/// The largest difference between nodes, and in every part between the cuts, relative to the largest value there.
///
/// # Errors
/// [`Error::NotFinite`] where `f` is not finite.
pub(crate) fn misfit(
    relation: &dyn SpectralRelation,
    f: &dyn Fn(f64) -> f64,
    coefficients: &[f64],
    cuts: &[f64],
) -> Result<f64, Error> {
    let places = places_in_parts(relation.extent(), cuts);
    let values = sample(f, places.iter().copied())?;
    let largest = values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    let sum = relation.combination(coefficients);
    let worst = (places.iter().zip(&values)).map(|(&x, value)| (sum(x) - value).abs());
    Ok(if largest > 0.0 { worst.fold(0.0, f64::max) / largest } else { 0.0 })
}

/// The coefficients, without the trailing ones that are rounding of a function with this largest value.
fn project<Node>(
    relation: &dyn SpectralRelation,
    rule: &Rule<Node>,
    eigenfunctions: &impl Fn(&Node, &mut [f64]),
    values: &[f64],
    (count, largest): (usize, f64),
) -> Vec<f64> {
    let mut coefficients = vec![0.0; count];
    let mut sizes = vec![0.0f64; count];
    let mut functions = vec![0.0; count];
    for ((node, weight), value) in rule.nodes.iter().zip(&rule.weights).zip(values) {
        eigenfunctions(node, &mut functions);
        for ((c, size), phi) in coefficients.iter_mut().zip(&mut sizes).zip(&functions) {
            *c += weight * value * phi;
            *size = size.max(phi.abs());
        }
    }
    coefficients.iter_mut().enumerate().for_each(|(n, c)| *c /= relation.norm(n));
    let matters = |(c, size): (&f64, &f64)| c.abs() * size > ROUNDING * largest;
    let kept = coefficients.iter().zip(&sizes).rposition(matters).map_or(1, |last| last + 1);
    coefficients.truncate(kept);
    coefficients
}

fn sample(f: &dyn Fn(f64) -> f64, places: impl Iterator<Item = f64>) -> Result<Vec<f64>, Error> {
    let value = |x: f64| {
        let value = f(x);
        if value.is_finite() {
            Ok(value)
        } else {
            Err(Error::NotFinite { what: "function", at: x, value })
        }
    };
    places.map(value).collect()
}

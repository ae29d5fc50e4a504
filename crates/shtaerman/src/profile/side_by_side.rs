//! Many places of a formula, some at once: reading the formula costs as much as most of its operations.

use super::base::line;
use crate::expression::{Enclosure, Expression, Interval};

/// Places that are taken side by side.
pub(super) const BESIDE: usize = 8;
/// So many side by side take as long as this many alone (survey: two to four).
const FEW: usize = 4;

/// Results at places, most of them side by side.
pub(super) fn side_by_side<R>(
    places: &[f64],
    beside: impl Fn(&[f64; BESIDE]) -> [R; BESIDE],
    alone: impl Fn(f64) -> R,
) -> Vec<R> {
    let mut found = Vec::with_capacity(places.len());
    let (some, rest) = places.as_chunks::<BESIDE>();
    some.iter().for_each(|places| found.extend(beside(places)));
    if rest.len() < FEW {
        found.extend(rest.iter().copied().map(alone));
    } else {
        // The last of them are there for nothing.
        let mut filled = [rest[0]; BESIDE];
        filled[..rest.len()].copy_from_slice(rest);
        found.extend(beside(&filled).into_iter().take(rest.len()));
    }
    found
}

/// Encloses the values of a formula at places `xi` of a base of this half-width.
pub(super) fn enclosures(
    expression: &Expression,
    places: &[f64],
    half_width: f64,
) -> Vec<Enclosure> {
    const UNKNOWN: Enclosure = Enclosure { interval: Interval::WHOLE, may_be_undefined: true };
    let line = line(half_width);
    let point = |xi: f64| Interval::point(xi).unwrap_or(Interval::WHOLE);
    let known = |xi: f64, found: Enclosure| if xi.is_nan() { UNKNOWN } else { found };
    let beside = |places: &[f64; BESIDE]| {
        let found = expression.enclose_beside(&line, &places.map(point));
        std::array::from_fn(|k| known(places[k], found[k]))
    };
    let alone = |xi: f64| known(xi, expression.enclose_along(&line, point(xi)));
    side_by_side(places, beside, alone)
}

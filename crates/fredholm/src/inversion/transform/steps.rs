//! Gauss's rule in steps.

use super::super::powers::distant;
use super::super::rule::{ORDER, integral, integral_at_nodes};

/// Length of a step in the logarithm of `s` within which polynomials of `s` are integrated exactly. At half or twice 24 of 25 answers change, within what they state (survey).
pub(super) const STEP: f64 = 1.0;

/// Gauss's rule on parts no longer than `step`.
pub(super) fn stepwise(turn: [f64; 2], step: f64, f: impl Fn(f64) -> f64) -> f64 {
    in_parts(turn, step, |start, end| integral(start, end, &f))
}

/// The same for a function of all nodes of a part at once.
pub(super) fn stepwise_at_nodes(
    turn: [f64; 2],
    step: f64,
    f: impl Fn(&[f64; ORDER]) -> [f64; ORDER],
) -> f64 {
    in_parts(turn, step, |start, end| integral_at_nodes(start, end, &f))
}

fn in_parts([from, to]: [f64; 2], step: f64, part: impl Fn(f64, f64) -> f64) -> f64 {
    let length = to - from;
    if length <= 0.0 || !length.is_finite() {
        return if length <= 0.0 { 0.0 } else { f64::NAN };
    }
    let (mut from, mut sum) = (from, 0.0);
    while let Some(share) = distant(to - from) {
        sum += part(from, from + share);
        from += share;
    }
    let length = to - from;
    let count = (length / step).ceil().max(1.0);
    let width = length / count;
    let parts = (0..count as usize).map(|i| {
        let start = from + width * i as f64;
        part(start, start + width)
    });
    sum + parts.sum::<f64>()
}

//! Places on the interval of an equation.

use fredholm::Interval;

use crate::Error;

/// A place this far beyond an end, relative to the length, is the end.
const END_SLACK: f64 = 1e-12;

/// The place itself, or the end from which rounding took it.
pub(super) fn within(interval: Interval, x: f64) -> Result<f64, Error> {
    if interval.contains(x) && x.is_finite() {
        return Ok(x);
    }
    let (left, right) = (interval.left(), interval.right());
    let slack = END_SLACK * if right.is_finite() { right - left } else { 1.0 };
    if x.is_finite() && x < left && left - x <= slack {
        return Ok(left);
    }
    if x.is_finite() && x > right && x - right <= slack {
        return Ok(right);
    }
    Err(Error::BeyondInterval { at: x, left, right })
}

/// `count` places, two at least, from end to end of a finite interval, denser at the ends.
pub(super) fn from_end_to_end([left, right]: [f64; 2], count: usize) -> Vec<f64> {
    let (centre, half) = (left.midpoint(right), 0.5 * right - 0.5 * left);
    let mut places: Vec<f64> = fredholm::basis::chebyshev::points(count - 1)
        .into_iter()
        .rev()
        .map(|xi| (centre + half * xi).clamp(left, right))
        .collect();
    places[0] = left;
    places[count - 1] = right;
    places
}

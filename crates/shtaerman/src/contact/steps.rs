//! Steps of a base.

use super::accuracy::{ROUNDING, SAFETY};

/// Distance between the places beside a break where heights are compared; also the slit at which a wave without gaps is cut (survey).
pub(super) const BESIDE: f64 = 1e-9;
/// How far inside its side of a step a place is looked at, as a share of the base or of a zone.
pub(crate) const INSIDE: f64 = 1e-12;
/// As far from a break heights are looked at.
pub(super) const REACH: f64 = 3.0 * BESIDE;

/// By how much the base rises at a break; none where it does so by no more than its slopes and their rounding say.
pub(super) fn rise(height: impl Fn(f64) -> f64, at: f64) -> Option<f64> {
    let beside = |side: f64| [1.0, 2.0, 3.0].map(|k| height(at + side * k * BESIDE));
    let (left, right) = (beside(-1.0), beside(1.0));
    // The limit from one side, by a straight line, and what that may miss.
    let limit = |[one, two, three]: [f64; 3]| (2.0 * one - two, (one - 2.0 * two + three).abs());
    let ((below, bent_below), (above, bent_above)) = (limit(left), limit(right));
    let size = left.iter().chain(&right).fold(0.0f64, |most, height| most.max(height.abs()));
    let rise = above - below;
    // A formula rounds places as large as the base, which counts by its slope.
    let steepest = (left[2] - left[0]).abs().max((right[2] - right[0]).abs()) / (2.0 * BESIDE);
    // In second differences: beside a root the next are larger than those seen.
    let allowed = ROUNDING * (size + steepest) + SAFETY * (bent_below + bent_above);
    (rise.abs() > allowed).then_some(rise)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_told_from_kinks_and_roots() {
        let at = 0.3;
        let step = |x: f64| x * x + if x > at { 1e-8 } else { 0.0 };
        assert!(rise(step, at).is_some_and(|rise| (rise - 1e-8).abs() < 1e-15));
        assert!(rise(|x: f64| 1.0 - step(x), at).is_some_and(|rise| (rise + 1e-8).abs() < 1e-15));
        assert_eq!(rise(|x: f64| 5.0 * (x - at).abs(), at), None);
        assert_eq!(rise(|x: f64| (x - at).abs().sqrt(), at), None);
        assert_eq!(rise(|x: f64| (3.0 * x).exp(), at), None);
        // Two branches that meet but for rounding.
        let branches = |x: f64| if x < at { x * x } else { at * x };
        assert_eq!(rise(branches, at), None);
    }
}

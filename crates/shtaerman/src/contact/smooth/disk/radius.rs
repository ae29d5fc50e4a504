//! The radii at which a free edge has the load that is prescribed.

use crate::contact::iteration::crossing;

/// Radii looked at between the axis and the limit. At half or twice 2 of 18 answers change, within what they state (survey).
const RADII: usize = 64;

/// Radii up to `limit` at which the rising function `f` passes `target`, increasing; `f` tends to something smaller at the axis.
pub(super) fn crossings(
    f: &impl Fn(f64) -> f64,
    target: f64,
    breaks: &[f64],
    limit: f64,
) -> Vec<f64> {
    let excess = |radius: f64| f(radius) - target;
    let mut radii: Vec<f64> = (1..=RADII).map(|i| limit * i as f64 / RADII as f64).collect();
    radii.extend(breaks.iter().filter(|at| **at < limit));
    radii.sort_by(f64::total_cmp);
    let mut nodes: Vec<(f64, f64)> = radii.into_iter().map(|at| (at, excess(at))).collect();
    let mut least = nodes[0].0;
    while nodes[0].1 >= 0.0 && least > f64::MIN_POSITIVE {
        least *= 0.5;
        nodes.insert(0, (least, excess(least)));
    }
    (nodes.windows(2))
        .filter(|pair| pair[0].1 < 0.0 && pair[1].1 >= 0.0)
        .map(|pair| crossing(&excess, pair[0], pair[1], 0.0))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_met_however_small() {
        for (power, target) in [(3, 1e-3), (3, 1e-30), (1, 1e-200), (8, 0.999)] {
            let found = crossings(&|c: f64| c.powi(power), target, &[], 1.0);
            let exact = target.powf(1.0 / f64::from(power));
            assert!(found.len() == 1 && (found[0] / exact - 1.0).abs() < 1e-14, "{found:?}");
        }
        assert!(crossings(&|c: f64| c, 1.5, &[], 1.0).is_empty());
    }

    #[test]
    fn all_rises_are_found() {
        // sin(3 pi c) = 1/2 rises at 1/18 and 13/18
        let found = crossings(&|c: f64| (3.0 * std::f64::consts::PI * c).sin(), 0.5, &[], 1.0);
        assert_eq!(found.len(), 2);
        assert!((found[0] - 1.0 / 18.0).abs() < 1e-15 && (found[1] - 13.0 / 18.0).abs() < 1e-15);
    }
}

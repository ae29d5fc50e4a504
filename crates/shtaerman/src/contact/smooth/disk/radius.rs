//! The radii at which a free edge has the load that is prescribed.

/// Radii looked at between the axis and the limit.
const RADII: usize = 64;
/// Steps towards a root.
const STEPS: usize = 200;

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
        .map(|pair| root(&excess, pair[0], pair[1]))
        .collect()
}

/// The zero between two ends with values of different signs: regula falsi in the Illinois form, every third step a bisection.
fn root(f: &impl Fn(f64) -> f64, mut below: (f64, f64), mut above: (f64, f64)) -> f64 {
    let mut last_below = None;
    for step in 0..STEPS {
        let width = above.0 - below.0;
        if above.1 == 0.0 || width <= 2.0 * f64::EPSILON * above.0 {
            break;
        }
        let secant = above.0 - above.1 * width / (above.1 - below.1);
        let is_inside = secant > below.0 && secant < above.0;
        let at = if step % 3 == 2 || !is_inside { below.0 + 0.5 * width } else { secant };
        let value = f(at);
        let is_below = value < 0.0;
        let stays = last_below == Some(is_below);
        let (moved, other) =
            if is_below { (&mut below, &mut above) } else { (&mut above, &mut below) };
        *moved = (at, value);
        if stays {
            other.1 *= 0.5;
        }
        last_below = Some(is_below);
    }
    above.0
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

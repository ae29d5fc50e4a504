//! The slope of a smooth profile on a zone as a series, and the pressure that it makes.
//!
//! `h = sum g_k c_k` of the order `mu/2 + 1` is the slope of `f0 = sum a_n c_n` of the order `mu/2`, `a_n = b (1+mu) g_(n-1)/(n (n+mu))`, and that profile takes the
//! coefficients `a_n/l_n` of the [polynomials](super::modes) away from the pressure.

use std::f64::consts::PI;

use super::modes::{gains, inside};
use super::strip::Ground;
use crate::contact::accuracy::OF_A_VALUE;

/// Intervals between the nodes at first, doubled at most so often. At half or twice stated errors grow up to 93 times (survey).
const FIRST: usize = 8;
const DOUBLINGS: u32 = 3;

/// The coefficients of a smooth profile on a zone.
#[derive(Debug, Clone)]
pub(super) struct Series {
    /// What is taken away from `m_n`.
    pub(super) modes: Vec<f64>,
}

impl Series {
    /// From the slope by `y` in `[-1, 1]` on a zone of the half-length `half`, whose values are rounded by this share of the largest beyond that of a number; none if a few
    /// polynomials do not meet it.
    pub(super) fn new(
        ground: &Ground,
        half: f64,
        noise: f64,
        slope: &impl Fn(f64) -> f64,
    ) -> Option<Self> {
        let slopes = gegenbauer(ground, &chebyshev(slope, noise)?);
        let mu = ground.powers.exponent();
        let mut heights = vec![0.0];
        heights.extend(slopes.iter().enumerate().map(|(k, g)| {
            let n = k as f64 + 1.0;
            half * (1.0 + mu) * g / (n * (n + mu))
        }));
        let middle = inside(0.5 * mu, heights.len(), 0.0);
        // The depth is measured from the height in the middle.
        heights[0] = -heights.iter().zip(middle).map(|(a, c)| a * c).sum::<f64>();
        let gains = gains(ground, heights.len());
        Some(Self { modes: heights.iter().zip(gains).map(|(a, l)| a / l).collect() })
    }

    /// Of the first two polynomials: `G_e(b)` and `b G_o(b)` of these.
    pub(super) fn lowest(&self) -> [f64; 2] {
        [0, 1].map(|n| self.modes.get(n).copied().unwrap_or(0.0))
    }
}

/// Coefficients by `T_n` between nodes that are doubled until those between are met.
fn chebyshev(f: &impl Fn(f64) -> f64, noise: f64) -> Option<Vec<f64>> {
    let mut count = FIRST;
    let place = |j: usize, count: usize| {
        // From the middle, whose two sides mirror each other.
        (PI * (0.5 - j as f64 / count as f64)).sin()
    };
    let mut values: Vec<f64> = (0..=count).map(|j| f(place(j, count))).collect();
    for _ in 0..=DOUBLINGS {
        let size = values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
        if !size.is_finite() || values.iter().any(|value| value.is_nan()) {
            return None;
        }
        let mut coefficients = transformed(&values);
        let rounding = f64::EPSILON.max(noise) * size;
        while coefficients.last().is_some_and(|c| c.abs() <= rounding) {
            coefficients.pop();
        }
        let twice = 2 * count;
        let between: Vec<f64> = (0..count).map(|j| f(place(2 * j + 1, twice))).collect();
        let allowed = (4.0 * noise).max(OF_A_VALUE) * size;
        let meets = between.iter().enumerate().all(|(j, value)| {
            (value - sum(&coefficients, place(2 * j + 1, twice))).abs() <= allowed
        });
        if meets {
            return Some(coefficients);
        }
        let mut all = Vec::with_capacity(twice + 1);
        for (one, other) in values.iter().zip(&between) {
            all.extend([*one, *other]);
        }
        all.push(values[count]);
        (values, count) = (all, twice);
    }
    None
}

/// The coefficients by `T_n` of values at `cos(pi j/count)`.
fn transformed(values: &[f64]) -> Vec<f64> {
    let count = values.len() - 1;
    let cosines: Vec<f64> = (0..2 * count).map(|j| (PI * j as f64 / count as f64).cos()).collect();
    let last = |j: usize| if j == 0 || j == count { 0.5 } else { 1.0 };
    let scale = 2.0 / count as f64;
    (0..=count)
        .map(|n| {
            let terms = values.iter().enumerate();
            let terms = terms.map(|(j, value)| last(j) * value * cosines[n * j % (2 * count)]);
            scale * last(n) * terms.sum::<f64>()
        })
        .collect()
}

/// `sum c_n T_n(y)`.
fn sum(coefficients: &[f64], y: f64) -> f64 {
    let (mut one, mut two) = (0.0, 0.0);
    for c in coefficients.iter().skip(1).rev() {
        (one, two) = (c + 2.0 * y * one - two, one);
    }
    coefficients.first().map_or(0.0, |c| c + y * one - two)
}

/// The same function by the polynomials `c_n` of the order `mu/2 + 1`: the sum above with the multiplication of coefficients in the place of `y`.
fn gegenbauer(ground: &Ground, coefficients: &[f64]) -> Vec<f64> {
    let order = 0.5 * ground.powers.exponent() + 1.0;
    let count = coefficients.len();
    let raised = |series: &[f64]| {
        // y c_k = ((k + 2 order) c_(k+1) + k c_(k-1)) / (2 (k + order))
        let mut product = vec![0.0; count];
        for (k, value) in series.iter().enumerate().filter(|(_, value)| **value != 0.0) {
            let n = k as f64;
            let share = value / (2.0 * (n + order));
            if let Some(above) = product.get_mut(k + 1) {
                *above += (n + 2.0 * order) * share;
            }
            if k > 0 {
                product[k - 1] += n * share;
            }
        }
        product
    };
    let (mut one, mut two) = (vec![0.0; count], vec![0.0; count]);
    for c in coefficients.iter().skip(1).rev() {
        let mut next = raised(&one);
        next.iter_mut().zip(&two).for_each(|(value, two)| *value = 2.0 * *value - two);
        next[0] += c;
        (one, two) = (next, one);
    }
    let mut found = raised(&one);
    found.iter_mut().zip(&two).for_each(|(value, two)| *value -= two);
    if let (Some(value), Some(c)) = (found.first_mut(), coefficients.first()) {
        *value += c;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_functions_are_met_and_others_refused() {
        let ground = Ground::new(0.3, 1.0).unwrap();
        let f = |y: f64| (5.0 * y).sin() + (-y).exp();
        let slopes = gegenbauer(&ground, &chebyshev(&f, 0.0).unwrap());
        assert!(slopes.len() < 40);
        for i in 0..100 {
            let y = -1.0 + 0.02 * f64::from(i);
            let found: f64 =
                inside(1.15, slopes.len(), y).iter().zip(&slopes).map(|(c, g)| c * g).sum();
            assert!((found - f(y)).abs() < 1e-14, "{y}: {found}");
        }
        assert!(chebyshev(&f64::abs, 0.0).is_none());
        assert!(chebyshev(&|_| f64::NAN, 0.0).is_none());
        assert!(chebyshev(&|y| 1.0 / (1.0 + y), 0.0).is_none());
        assert!(chebyshev(&|_| 0.0, 0.0).unwrap().is_empty());
        assert_eq!(chebyshev(&|y| 2.0 * y, 0.0).unwrap().len(), 2);
    }

    #[test]
    fn the_density_of_a_parabola() {
        // y^2/2 over b = 1: x^2/2 = a_0 + a_2 c_2 with c_2 = ((2+mu) y^2 - 1)/(1+mu), and 0 in the middle
        for mu in [0.02, 0.5, 0.9] {
            let ground = Ground::new(mu, 1.0).unwrap();
            let series = Series::new(&ground, 1.0, 0.0, &|y| y).unwrap();
            let a = 0.5 * (1.0 + mu) / (2.0 + mu);
            let gains = gains(&ground, 3);
            let exact = [a / (1.0 + mu) / gains[0], 0.0, a / gains[2]];
            for (found, exact) in series.modes.iter().zip(exact) {
                assert!((found - exact).abs() < 1e-14 * a / gains[2], "{mu}: {found} {exact}");
            }
        }
    }
}

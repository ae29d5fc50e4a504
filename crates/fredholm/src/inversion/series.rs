//! The slope of a smooth profile on a zone as a series, and the pressure that it makes.
//!
//! `h = sum g_k c_k` of the order `mu/2 + 1` is the slope of `f0 = sum a_n c_n` of the order `mu/2`, `a_n = b (1+mu) g_(n-1)/(n (n+mu))`, and that profile takes the
//! coefficients `a_n/l_n` of the [polynomials](super::modes) away from the pressure.

use super::accuracy::OF_A_VALUE;
use super::powers::Powers;
use super::ultraspherical::{gains, inside};
use crate::basis::ChebyshevSeries;
use crate::basis::chebyshev::{points, sum};

/// Intervals between the nodes at first, doubled at most so often. At half or twice stated errors grow up to 93 times (survey).
const FIRST: usize = 8;
const DOUBLINGS: u32 = 3;

/// The coefficients of a smooth profile on a zone.
#[derive(Debug, Clone)]
pub struct Series {
    /// What is taken away from `m_n`.
    pub modes: Vec<f64>,
}

impl Series {
    /// From the slope by `y` in `[-1, 1]` on a zone of the half-length `half`, whose values are rounded by this share of the largest beyond that of a number; none if a few
    /// polynomials do not meet it.
    pub fn new(
        powers: &Powers,
        half: f64,
        noise: f64,
        slope: &impl Fn(f64) -> f64,
    ) -> Option<Self> {
        let slopes = gegenbauer(powers, &chebyshev(slope, noise)?);
        let mu = powers.exponent();
        let mut heights = vec![0.0];
        heights.extend(slopes.iter().enumerate().map(|(k, g)| {
            let n = k as f64 + 1.0;
            half * (1.0 + mu) * g / (n * (n + mu))
        }));
        let middle = inside(0.5 * mu, heights.len(), 0.0);
        // The depth is measured from the height in the middle.
        heights[0] = -heights.iter().zip(middle).map(|(a, c)| a * c).sum::<f64>();
        let gains = gains(powers, heights.len());
        Some(Self { modes: heights.iter().zip(gains).map(|(a, l)| a / l).collect() })
    }

    /// Of the first two polynomials: `G_e(b)` and `b G_o(b)` of these.
    pub fn lowest(&self) -> [f64; 2] {
        [0, 1].map(|n| self.modes.get(n).copied().unwrap_or(0.0))
    }

    /// `G_e(b)` and `G_o(b)` of these on a zone of the half-length `half`.
    pub fn transforms(&self, half: f64) -> [f64; 2] {
        let [even, odd] = self.lowest();
        [even, odd / half]
    }
}

/// Coefficients by `T_n` between nodes that are doubled until those between are met.
fn chebyshev(f: &impl Fn(f64) -> f64, noise: f64) -> Option<Vec<f64>> {
    let mut values: Vec<f64> = points(FIRST).into_iter().map(f).collect();
    for _ in 0..=DOUBLINGS {
        let size = values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
        if !size.is_finite() || values.iter().any(|value| value.is_nan()) {
            return None;
        }
        let mut coefficients = ChebyshevSeries::through(values.clone()).coefficients().to_vec();
        let rounding = f64::EPSILON.max(noise) * size;
        while coefficients.last().is_some_and(|c| c.abs() <= rounding) {
            coefficients.pop();
        }
        let finer = points(2 * (values.len() - 1));
        let allowed = (4.0 * noise).max(OF_A_VALUE) * size;
        let mut meets = true;
        let value = |(j, y): (usize, &f64)| {
            if j % 2 == 0 {
                return values[j / 2];
            }
            let value = f(*y);
            meets &= (value - sum(&coefficients, *y)).abs() <= allowed;
            value
        };
        let all: Vec<f64> = finer.iter().enumerate().map(value).collect();
        if meets {
            return Some(coefficients);
        }
        values = all;
    }
    None
}

/// The same function by the polynomials `c_n` of the order `mu/2 + 1`: the sum above with the multiplication of coefficients in the place of `y`.
fn gegenbauer(powers: &Powers, coefficients: &[f64]) -> Vec<f64> {
    let order = 0.5 * powers.exponent() + 1.0;
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
        let powers = Powers::new(0.3).unwrap();
        let f = |y: f64| (5.0 * y).sin() + (-y).exp();
        let slopes = gegenbauer(&powers, &chebyshev(&f, 0.0).unwrap());
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
            let powers = Powers::new(mu).unwrap();
            let series = Series::new(&powers, 1.0, 0.0, &|y| y).unwrap();
            let a = 0.5 * (1.0 + mu) / (2.0 + mu);
            let gains = gains(&powers, 3);
            let exact = [a / (1.0 + mu) / gains[0], 0.0, a / gains[2]];
            for (found, exact) in series.modes.iter().zip(exact) {
                assert!((found - exact).abs() < 1e-14 * a / gains[2], "{mu}: {found} {exact}");
            }
        }
    }
}

//! Chebyshev polynomials of the first kind `T_n(cos t) = cos n t` on `[-1, 1]`.

use std::f64::consts::PI;

use fredholm_transforms::cosine_sums;

/// Highest degree of a series whose moments are summed term by term: cheaper than the transforms, and each to its own rounding.
const DIRECT_DEGREE: usize = 32;

/// Fills `values` with `T_0(x), T_1(x), ...` by the three-term recurrence; `x` in `[-1, 1]`.
pub fn polynomials(x: f64, values: &mut [f64]) {
    let (mut previous, mut current) = (1.0, x);
    for value in values {
        *value = previous;
        (previous, current) = (current, 2.0 * x * current - previous);
    }
}

/// `sum_m coefficients[m] T_m(x)`: Clenshaw's recurrence, in Reinsch's form near the ends where the plain one loses
/// digits; `x` in `[-1, 1]`. Cost: 3 operations a coefficient.
#[must_use]
pub fn sum(coefficients: &[f64], x: f64) -> f64 {
    let Some((&first, rest)) = coefficients.split_first() else {
        return 0.0;
    };
    if x.abs() < 0.5 {
        let (mut b1, mut b2) = (0.0, 0.0);
        for &c in rest.iter().rev() {
            (b1, b2) = (2.0 * x * b1 - b2 + c, b1);
        }
        return first + x * b1 - b2;
    }
    // b_k - s b_{k+1} is carried along instead of b_k alone, s = sign x.
    let sign = x.signum();
    let slope = 2.0 * (x - sign);
    let (mut b, mut difference) = (0.0, 0.0);
    for &c in rest.iter().rev() {
        difference = slope * b + sign * difference + c;
        b = sign * b + difference;
    }
    first + 0.5 * slope * b + sign * difference
}

/// The points `cos(j pi / degree)`, `j = 0 .. degree`, from 1 down to -1, exactly antisymmetric.
///
/// ```
/// let points = fredholm::basis::chebyshev::points(4);
/// assert_eq!(points[0], 1.0);
/// assert_eq!(points[2], 0.0);
/// assert_eq!(points[1], -points[3]);
/// ```
#[must_use]
pub fn points(degree: usize) -> Vec<f64> {
    let n = degree as f64;
    (0..=degree).map(|j| (PI * (n - 2.0 * j as f64) / (2.0 * n.max(1.0))).sin()).collect()
}

/// A polynomial as `sum_m coefficients[m] T_m(x)` on `[-1, 1]`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ChebyshevSeries {
    coefficients: Vec<f64>,
}

impl ChebyshevSeries {
    /// The series with these coefficients.
    #[must_use]
    pub fn new(coefficients: Vec<f64>) -> Self {
        Self { coefficients }
    }

    /// The polynomial through `values[j]` at [`points`]`(values.len() - 1)`, by one discrete cosine transform. Exactly even or odd
    /// values give an exactly even or odd series.
    #[must_use]
    pub fn through(mut values: Vec<f64>) -> Self {
        if values.len() > 1 {
            let degree = values.len() - 1;
            let vanishing = vanishing_parity(&values);
            cosine_sums(&mut values);
            let scale = 2.0 / degree as f64;
            values.iter_mut().for_each(|value| *value *= scale);
            values[0] *= 0.5;
            values[degree] *= 0.5;
            if let Some(parity) = vanishing {
                values
                    .iter_mut()
                    .skip(parity)
                    .step_by(2)
                    .for_each(|coefficient| *coefficient = 0.0);
            }
        }
        Self { coefficients: values }
    }

    /// The coefficients.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// Highest degree; 0 for the empty series.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// The value at `x` in `[-1, 1]`.
    #[must_use]
    pub fn evaluate(&self, x: f64) -> f64 {
        sum(&self.coefficients, x)
    }

    /// The values at [`points`]`(degree)`; `degree` at least that of the series. One discrete cosine transform.
    #[must_use]
    pub fn values(&self, degree: usize) -> Vec<f64> {
        let mut values = self.coefficients.clone();
        values.resize(degree.max(self.degree()) + 1, 0.0);
        if let Some((first, rest)) = values.split_first_mut() {
            *first *= 2.0;
            if let Some(last) = rest.last_mut() {
                *last *= 2.0;
            }
        }
        if values.len() > 1 {
            cosine_sums(&mut values);
        }
        values
    }

    /// The unweighted moments `int_{-1}^{1} f T_k dx`, `k < count`, exact to rounding: by the closed form for low degrees; else the
    /// products are integrated by Clenshaw and Curtis on a grid that is fine enough for all of them, in one cosine transform each way.
    #[must_use]
    pub fn moments(&self, count: usize) -> Vec<f64> {
        if self.degree() <= DIRECT_DEGREE {
            return (0..count).map(|k| self.moment(k)).collect();
        }
        let degree = (self.degree() + count).max(2).next_power_of_two();
        let mut weighted = self.values(degree);
        for (value, weight) in weighted.iter_mut().zip(clenshaw_curtis_weights(degree)) {
            *value *= weight;
        }
        // The transform halves the two ends.
        weighted[0] *= 2.0;
        weighted[degree] *= 2.0;
        cosine_sums(&mut weighted);
        weighted.truncate(count);
        // An even or odd series has exactly zero moments of the other parity; the transforms leave rounding there.
        for parity in 0..2 {
            if self.coefficients.iter().skip(parity).step_by(2).all(|&c| c == 0.0) {
                weighted.iter_mut().skip(parity).step_by(2).for_each(|moment| *moment = 0.0);
            }
        }
        weighted
    }

    /// `int_{-1}^{1} f T_k dx` term by term, with `2 T_k T_m = T_{k+m} + T_{|k-m|}`.
    fn moment(&self, k: usize) -> f64 {
        let terms = self.coefficients.iter().enumerate().skip(k % 2).step_by(2);
        terms.fold(0.0, |sum, (m, c)| sum + 0.5 * c * (integral(k + m) + integral(k.abs_diff(m))))
    }
}

/// `int_{-1}^{1} T_m dx` for even `m`.
fn integral(m: usize) -> f64 {
    let m = m as f64;
    -2.0 / ((m - 1.0) * (m + 1.0))
}

/// The parity (0 even, 1 odd) of the coefficients that vanish because the values are exactly odd or even.
fn vanishing_parity(values: &[f64]) -> Option<usize> {
    let mirrored = || values.iter().zip(values.iter().rev());
    if mirrored().all(|(left, right)| left == right) {
        Some(1)
    } else if mirrored().all(|(left, right)| *left == -right) {
        Some(0)
    } else {
        None
    }
}

/// Weights of the rule of Clenshaw and Curtis at [`points`]`(degree)`, `degree` even: `int f dx = sum w_j f(x_j)`, exact
/// to that degree.
fn clenshaw_curtis_weights(degree: usize) -> Vec<f64> {
    let mut weights: Vec<f64> = (0..=degree)
        .map(|k| if k % 2 == 0 { -2.0 / ((k as f64 - 1.0) * (k as f64 + 1.0)) } else { 0.0 })
        .collect();
    cosine_sums(&mut weights);
    let scale = 2.0 / degree as f64;
    weights.iter_mut().for_each(|weight| *weight *= scale);
    weights[0] *= 0.5;
    weights[degree] *= 0.5;
    weights
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_agree_with_cosines() {
        let coefficients: Vec<f64> =
            (0..40).map(|m| (1.3 * f64::from(m)).sin() / (1.0 + f64::from(m))).collect();
        for i in 0..=200 {
            let t = PI * f64::from(i) / 200.0;
            let exact: f64 =
                coefficients.iter().enumerate().map(|(m, c)| c * (m as f64 * t).cos()).sum();
            assert!((sum(&coefficients, t.cos()) - exact).abs() < 2e-14, "t = {t}");
        }
        assert_eq!(sum(&[], 0.3), 0.0);
        assert_eq!(sum(&[2.5], 0.9), 2.5);
    }

    #[test]
    fn interpolates_polynomials_exactly() {
        let f = |x: f64| 3.0 - x + 4.0 * x.powi(5);
        let series = ChebyshevSeries::through(points(8).into_iter().map(f).collect());
        // 4 x^5 = (10 T_1 + 5 T_3 + T_5) / 4
        let expected = [3.0, 1.5, 0.0, 1.25, 0.0, 0.25, 0.0, 0.0, 0.0];
        for (found, exact) in series.coefficients().iter().zip(expected) {
            assert!((found - exact).abs() < 1e-15);
        }
        let values = series.values(16);
        for (x, value) in points(16).into_iter().zip(values) {
            assert!((value - f(x)).abs() < 1e-14);
        }
    }

    #[test]
    fn parity_is_kept_exactly() {
        for (f, vanishing) in [((|x: f64| x.cos()) as fn(f64) -> f64, 1), (|x: f64| x.sin(), 0)] {
            let series = ChebyshevSeries::through(points(32).into_iter().map(f).collect());
            assert!(series.coefficients().iter().skip(vanishing).step_by(2).all(|&c| c == 0.0));
            assert!(series.moments(20).iter().skip(vanishing).step_by(2).all(|&m| m == 0.0));
        }
    }

    #[test]
    fn moments_agree_with_the_closed_form() {
        // int x^2 T_k = (R_k0 + R_k2) / 2 with (3.4)
        let series = ChebyshevSeries::new(vec![0.5, 0.0, 0.5]);
        let gram = |k: f64, m: f64| {
            if (k + m) % 2.0 == 0.0 {
                -1.0 / ((k + m).powi(2) - 1.0) - 1.0 / ((k - m).powi(2) - 1.0)
            } else {
                0.0
            }
        };
        // Trailing zeros make the series take the route through the transforms.
        let mut padded = series.coefficients().to_vec();
        padded.resize(DIRECT_DEGREE + 2, 0.0);
        let transformed = ChebyshevSeries::new(padded).moments(200);
        for (k, found) in series.moments(200).into_iter().enumerate() {
            let exact = 0.5 * (gram(k as f64, 0.0) + gram(k as f64, 2.0));
            assert!((found - exact).abs() <= 1e-15 * exact.abs(), "k = {k}: {found} {exact}");
            assert!((transformed[k] - exact).abs() < 1e-15, "k = {k}: {} {exact}", transformed[k]);
        }
    }
}

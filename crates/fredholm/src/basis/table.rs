//! A long Chebyshev series by a table of its values.

use std::f64::consts::PI;

use super::chebyshev::ChebyshevSeries;

/// Values for each degree of the series, at least, and those that take part in an interpolation.
///
/// A wave `cos n t` is met by the polynomial through `2 m` values at distances `h`, between the middle two, to `((2m-1)!!)^2 (n h/2)^(2m) / (2m)!`: 2e-18 for `2 m = 24`, `n h = pi/8`.
const OVERSAMPLING: usize = 8;
const LOCAL: usize = 24;

/// A Chebyshev series tabulated in `t = arccos x`, evaluated by local interpolation: its cost does not depend on the degree, 24 operations where Clenshaw's sum needs three a coefficient.
///
/// Errors are roundings of the largest value, as those of the sum.
///
/// ```
/// use fredholm::basis::{ChebyshevSeries, ChebyshevTable};
///
/// let series = ChebyshevSeries::new((0..5000).map(|m| 1.0 / (1.0 + (m * m) as f64)).collect());
/// let table = ChebyshevTable::new(&series);
/// assert!((table.evaluate(0.3) - series.evaluate(0.3)).abs() < 1e-14);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ChebyshevTable {
    /// At `t = j pi / N`, `j = 0 .. N`.
    values: Vec<f64>,
}

impl ChebyshevTable {
    /// One discrete cosine transform.
    #[must_use]
    pub fn new(series: &ChebyshevSeries) -> Self {
        let length = OVERSAMPLING * series.degree().max(LOCAL).next_power_of_two();
        Self { values: series.values(length) }
    }

    /// The value at `x` in `[-1, 1]`.
    #[must_use]
    pub fn evaluate(&self, x: f64) -> f64 {
        let last = self.values.len() - 1;
        // In cells from the nearer end: an even series is even to the last digit.
        let position = x.abs().acos() * last as f64 / PI;
        let first = position.floor() as isize - (LOCAL as isize / 2 - 1);
        let value = |j: isize| {
            let j = j.unsigned_abs();
            self.values[if x < 0.0 { last - j } else { j }]
        };
        let offset = position - first as f64;
        let (mut above, mut below) = (0.0, 0.0);
        for (j, weight) in WEIGHTS.iter().enumerate() {
            let distance = offset - j as f64;
            if distance == 0.0 {
                return value(first + j as isize);
            }
            above += weight / distance * value(first + j as isize);
            below += weight / distance;
        }
        above / below
    }
}

/// Barycentric weights of equally spaced places: `(-1)^j` times the binomial coefficients.
const WEIGHTS: [f64; LOCAL] = {
    let mut weights = [1.0; LOCAL];
    let mut j = 1;
    while j < LOCAL {
        weights[j] = -weights[j - 1] * (LOCAL - j) as f64 / j as f64;
        j += 1;
    }
    weights
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::chebyshev;

    /// Numbers between -1 and 1, the same on every run.
    fn noise(count: usize) -> Vec<f64> {
        let mut state = 0x2545_f491_4f6c_dd1du64;
        let mut next = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        (0..count).map(|_| next()).collect()
    }

    #[test]
    fn the_sum() {
        let places = [noise(200), vec![-1.0, 1.0, 0.0, 1.0 - 1e-16, -1.0 + 1e-13, 1e-300]].concat();
        for degree in [1, 5, 300, 4097] {
            // Flat coefficients up to the last are the hardest: a place that is off by a rounding moves the value by the degree times that.
            let coefficients = noise(degree + 1);
            let size: f64 = coefficients.iter().map(|c| c.abs()).sum();
            let table = ChebyshevTable::new(&ChebyshevSeries::new(coefficients.clone()));
            for x in &places {
                let missed = (table.evaluate(*x) - chebyshev::sum(&coefficients, *x)).abs();
                let allowed = 2e-16 * size * (8.0 + degree as f64);
                assert!(missed <= allowed, "{degree} {x}: {missed:e}, allowed {allowed:e}");
            }
        }
    }

    #[test]
    fn closed_forms_and_parity() {
        // |x| is T_0 2/pi and the sum of (-1)^(k+1) 4/(pi (4 k^2 - 1)) T_2k.
        let degree = 1 << 13;
        let mut coefficients = vec![0.0; degree + 1];
        coefficients[0] = 2.0 / PI;
        for k in 1..=degree / 2 {
            let sign = if k % 2 == 1 { 1.0 } else { -1.0 };
            coefficients[2 * k] = sign * 4.0 / (PI * (4.0 * (k * k) as f64 - 1.0));
        }
        let table = ChebyshevTable::new(&ChebyshevSeries::new(coefficients));
        for x in [0.3, 0.7, 0.99, 1.0] {
            assert_eq!(table.evaluate(x), table.evaluate(-x));
            // What is left out is at most 1/(pi m sin t) times two.
            assert!((table.evaluate(x) - x).abs() < 2.0 / (degree * degree / 4) as f64 / 0.1);
        }
    }
}

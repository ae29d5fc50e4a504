//! A smooth function on an interval as short polynomials on equal parts of it, which take fewer steps than one long series.

use crate::basis::chebyshev::{ChebyshevSeries, points};
use crate::linear::vectorised;

/// Coefficients of a polynomial: so many that eight parts are enough for most panels, and so few that one is summed in a dozen steps.
const TERMS: usize = 12;
/// How many parts are tried.
const COUNTS: [usize; 5] = [4, 8, 16, 32, 64];
/// The last coefficients of each part, which are to be below this share of the largest value: less than rounding.
const TAIL: usize = 2;
const RESOLVED: f64 = 2e-16;

/// The polynomials of the parts, by the place on each from -1 to 1.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Local(Vec<[f64; TERMS]>);

impl Local {
    /// The function on `[-1, 1]`, next to `scale`, the largest value that counts; none where so many parts do not resolve it.
    pub(super) fn new(value: impl Fn(f64) -> f64, scale: f64) -> Option<Self> {
        COUNTS.into_iter().find_map(|count| {
            let part = |index: usize| {
                let half = 1.0 / count as f64;
                let middle = (2 * index + 1) as f64 * half - 1.0;
                let nodes = points(TERMS - 1);
                let values = nodes.iter().map(|y| value(middle + half * y)).collect();
                let series = ChebyshevSeries::through(values);
                let tail = series.coefficients().iter().skip(TERMS - TAIL);
                tail.map(|c| c.abs()).all(|c| c <= RESOLVED * scale).then(|| powers(&series))
            };
            (0..count).map(part).collect::<Option<Vec<_>>>().map(Self)
        })
    }

    /// The value at `-1 <= x <= 1`.
    pub(super) fn at(&self, x: f64) -> f64 {
        let index = self.part(x);
        polynomial(&self.0[index], self.place(x, index))
    }

    /// Adds the values at many places to sums, by runs of neighbours on one part, which take the polynomial side by side: best where places are in order.
    pub(super) fn add(&self, places: &[f64], sums: &mut [f64]) {
        vectorised(
            #[inline(always)]
            || {
                let mut from = 0;
                while let Some(first) = places.get(from) {
                    let index = self.part(*first);
                    let run = places[from..].iter().take_while(|x| self.part(**x) == index).count();
                    let run = from..from + run;
                    let coefficients = &self.0[index];
                    for (sum, x) in sums[run.clone()].iter_mut().zip(&places[run.clone()]) {
                        *sum += polynomial(coefficients, self.place(*x, index));
                    }
                    from = run.end;
                }
            },
        );
    }

    /// The part on which `x` lies.
    #[inline(always)]
    fn part(&self, x: f64) -> usize {
        ((0.5 * (x + 1.0) * self.0.len() as f64) as usize).min(self.0.len() - 1)
    }

    /// The place on a part, from -1 to 1.
    #[inline(always)]
    fn place(&self, x: f64, index: usize) -> f64 {
        2.0 * (0.5 * (x + 1.0) * self.0.len() as f64 - index as f64) - 1.0
    }
}

/// The sum of the powers of `y`, in chains that do not wait for each other.
#[inline(always)]
fn polynomial(coefficients: &[f64; TERMS], y: f64) -> f64 {
    let [a, b, c, d, e, f, g, h, i, j, k, l] = *coefficients;
    let (square, fourth) = (y * y, (y * y) * (y * y));
    let low = (a + b * y) + (c + d * y) * square;
    let middle = (e + f * y) + (g + h * y) * square;
    let high = (i + j * y) + (k + l * y) * square;
    low + fourth * (middle + fourth * high)
}

/// The coefficients of the powers, by `T_(k+1) = 2 x T_k - T_(k-1)`. They fall about as those of the series do, so that no digits are lost.
fn powers(series: &ChebyshevSeries) -> [f64; TERMS] {
    let (mut before, mut now) = ([0.0; TERMS], [0.0; TERMS]);
    let mut sum = [0.0; TERMS];
    now[0] = 1.0;
    for (k, coefficient) in series.coefficients().iter().take(TERMS).enumerate() {
        for (sum, power) in sum.iter_mut().zip(now) {
            *sum += coefficient * power;
        }
        let factor = if k == 0 { 1.0 } else { 2.0 };
        let mut next = before.map(|power| -power);
        for (next, power) in next.iter_mut().skip(1).zip(now) {
            *next += factor * power;
        }
        (before, now) = (now, next);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_polynomials_are_the_function_to_rounding() {
        // Poles at +-2 i from the middle of an end, as those of a layer are.
        let smooth = |x: f64| 1.0 / (4.0 + (x + 1.0).powi(2)) + 0.1 * (3.0 * x).cos();
        let local = Local::new(smooth, 0.35).unwrap();
        for i in 0..=1000 {
            let x = 2.0 * f64::from(i) / 1000.0 - 1.0;
            assert!((local.at(x) - smooth(x)).abs() < 4e-16, "{x}: {:e}", local.at(x) - smooth(x));
        }
        // In order, against it and in none, from end to end.
        for step in [1, 1000, 377] {
            let places: Vec<f64> =
                (0..=1000).map(|i| f64::from(i * step % 1001) / 500.0 - 1.0).collect();
            let mut sums = vec![0.5; places.len()];
            local.add(&places, &mut sums);
            for (x, sum) in places.iter().zip(&sums) {
                assert_eq!(*sum, 0.5 + local.at(*x), "{x}");
            }
        }
        assert_eq!(Local::new(|x| (x - 0.1).abs(), 1.0), None, "a kink inside of a part");
    }
}

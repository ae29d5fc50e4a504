//! A function resolved by a Chebyshev series.

use super::chebyshev::{ChebyshevSeries, points};
use super::table::ChebyshevTable;
use crate::Error;

/// First degree tried; high enough that a feature of a hundredth of the interval is seen at once.
const FIRST_DEGREE: usize = 256;
/// Coefficients below this, relative to the largest value, count as rounding.
const ROUNDING: f64 = 4e-16;
/// Highest level, relative to the largest value, at which flat coefficients are taken for rounding.
const PLATEAU: f64 = 1e-6;
/// Highest level of rounding at which a function still counts as resolved.
const RESOLVED: f64 = 1e-12;
/// Highest level of a plateau that is believed at any degree; a higher one may be a fast oscillation of small amplitude, which ends further on.
const PLAIN_PLATEAU: f64 = 1e-13;
/// Degree from which on every plateau is believed.
const BELIEVED_FROM: usize = 1 << 14;
/// Points between the nodes at which a resolved series is checked.
const CHECKS: usize = 4093;
/// Series of a higher degree are checked by a table: its value costs as much as Clenshaw's sum of so many terms, in time (measured).
const LARGEST_SUMMED: usize = 64;

/// A function on `[-1, 1]` with a Chebyshev series found by doubling the degree until the coefficients reach rounding
/// *and* the series agrees with the function between the nodes.
#[derive(Debug, Clone, PartialEq)]
pub struct Function {
    series: ChebyshevSeries,
    largest: f64,
    error: f64,
    resolved: bool,
}

impl Function {
    /// Last degree tried.
    pub const LAST_DEGREE: usize = 1 << 17;

    /// Resolves `f`, as far as its values show: it is asked at the nodes, and at four thousand points between them. A feature that lies between all of these
    /// is hidden, and the series is that of the function without it. A function that is not resolved at degree 131072 (a kink, a jump) comes back with its best series and
    /// [`is_resolved`](Self::is_resolved) false.
    ///
    /// # Errors
    /// [`Error::NotFinite`] with the place when `f` gives NaN or an infinity at a node.
    pub fn resolve(f: &dyn Fn(f64) -> f64) -> Result<Self, Error> {
        Self::resolve_from(f, FIRST_DEGREE)
    }

    /// As [`resolve`](Self::resolve), beginning at a degree that shows the finest feature known of `f`.
    ///
    /// # Errors
    /// As [`resolve`](Self::resolve).
    pub fn resolve_from(f: &dyn Fn(f64) -> f64, degree: usize) -> Result<Self, Error> {
        let mut degree = degree.clamp(FIRST_DEGREE, Self::LAST_DEGREE).next_power_of_two();
        let mut values = sample(f, &points(degree))?;
        loop {
            let largest = values.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
            let series = ChebyshevSeries::through(values.clone());
            if let Some(floor) = floor(series.coefficients(), largest) {
                let series = trimmed(&series, floor);
                let error = error_between_nodes(f, &series)?;
                if error <= 64.0 * floor * (degree as f64).sqrt() {
                    let resolved = floor <= RESOLVED * largest;
                    return Ok(Self { series, largest, error: relative(error, largest), resolved });
                }
            }
            if degree == Self::LAST_DEGREE {
                let error = error_between_nodes(f, &series)?.max(tail(series.coefficients()));
                return Ok(Self {
                    series,
                    largest,
                    error: relative(error, largest),
                    resolved: false,
                });
            }
            degree *= 2;
            values = refine(f, values, degree)?;
        }
    }

    /// The series.
    #[must_use]
    pub fn series(&self) -> &ChebyshevSeries {
        &self.series
    }

    /// The largest absolute value met.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.largest
    }

    /// Largest difference between function and series found between the nodes, relative to the largest value: an
    /// estimate.
    #[must_use]
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Whether the series represents the function to rounding.
    #[must_use]
    pub fn is_resolved(&self) -> bool {
        self.resolved
    }
}

fn relative(error: f64, largest: f64) -> f64 {
    if largest > 0.0 { error / largest } else { 0.0 }
}

fn sample(f: &dyn Fn(f64) -> f64, nodes: &[f64]) -> Result<Vec<f64>, Error> {
    nodes.iter().map(|&x| finite(f, x)).collect()
}

fn finite(f: &dyn Fn(f64) -> f64, x: f64) -> Result<f64, Error> {
    let value = f(x);
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::NotFinite { what: "function", at: x, value })
    }
}

/// Values on the grid of twice the degree; the old ones are every second of the new.
fn refine(f: &dyn Fn(f64) -> f64, old: Vec<f64>, degree: usize) -> Result<Vec<f64>, Error> {
    let nodes = points(degree);
    let mut old = old.into_iter();
    let mut values = Vec::with_capacity(nodes.len());
    for (j, &x) in nodes.iter().enumerate() {
        let known = if j % 2 == 0 { old.next() } else { None };
        values.push(match known {
            Some(value) => value,
            None => finite(f, x)?,
        });
    }
    Ok(values)
}

/// The largest of the last eighth of the coefficients.
fn tail(coefficients: &[f64]) -> f64 {
    let start = coefficients.len() - coefficients.len() / 8;
    coefficients[start..].iter().fold(0.0, |largest, c| largest.max(c.abs()))
}

/// The level at which the coefficients have come down to rounding, if they have: that of the machine, or a higher plateau left by the
/// conditioning of `f` itself (`cos(400 x)` loses three digits in its argument, a difference of large numbers more), which no degree
/// removes. A plateau is told from the slow decay behind a jump (`1/m`) or a kink by comparing far ends of the spectrum.
fn floor(coefficients: &[f64], largest: f64) -> Option<f64> {
    let tail = tail(coefficients);
    if tail <= ROUNDING * largest {
        return Some(ROUNDING * largest);
    }
    let n = coefficients.len();
    let earlier = coefficients[n / 4..3 * n / 8].iter().fold(0.0f64, |most, c| most.max(c.abs()));
    let believed = if n > BELIEVED_FROM { PLATEAU } else { PLAIN_PLATEAU };
    (tail <= believed * largest && tail > 0.5 * earlier).then_some(tail)
}

fn trimmed(series: &ChebyshevSeries, negligible: f64) -> ChebyshevSeries {
    let keep =
        series.coefficients().iter().rposition(|c| c.abs() > negligible).map_or(1, |last| last + 1);
    let mut coefficients = series.coefficients().to_vec();
    coefficients.truncate(keep);
    ChebyshevSeries::new(coefficients)
}

/// Largest difference at a golden-ratio sequence of points, which no Chebyshev grid resonates with.
fn error_between_nodes(f: &dyn Fn(f64) -> f64, series: &ChebyshevSeries) -> Result<f64, Error> {
    const STEP: f64 = 0.618_033_988_749_894_9;
    let table = (series.degree() > LARGEST_SUMMED).then(|| ChebyshevTable::new(series));
    let value = |x: f64| table.as_ref().map_or_else(|| series.evaluate(x), |t| t.evaluate(x));
    let mut worst = 0.0f64;
    for i in 1..=CHECKS {
        let x = 2.0 * (i as f64 * STEP).fract() - 1.0;
        worst = worst.max((finite(f, x)? - value(x)).abs());
    }
    Ok(worst)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn resolves_smooth_functions_and_says_how_well() {
        for f in [
            (&|x: f64| x * x / 1.6) as &dyn Fn(f64) -> f64,
            &|x| (5.0 * x).exp(),
            &|x| (400.0 * x).cos(),
            &|x| 1.0 / (1.0 + 900.0 * x * x),
            &|_| 0.0,
        ] {
            let function = Function::resolve(f).unwrap();
            assert!(function.is_resolved() && function.error() < 2e-12);
            for x in [-1.0, -0.377, 0.0, 0.123, 0.9999, 1.0] {
                assert!((function.series().evaluate(x) - f(x)).abs() <= 2e-12 * function.largest());
            }
        }
    }

    #[test]
    fn takes_no_small_oscillation_for_noise() {
        for f in [
            (&|x: f64| 2e-6 * (600.0 * x).cos() + x * x / 1.6) as &dyn Fn(f64) -> f64,
            &|x| 1.0 + 1e-7 * (300.0 * x).cos(),
            &|x| 1.0 + 1e-9 * (5000.0 * x).sin(),
        ] {
            let function = Function::resolve(f).unwrap();
            assert!(function.is_resolved() && function.error() < 1e-12, "{}", function.error());
        }
    }

    #[test]
    fn owns_up_to_kinks_and_jumps() {
        let kink = Function::resolve(&f64::abs).unwrap();
        assert!(!kink.is_resolved() && kink.error() > 1e-9);
        let jump = Function::resolve(&|x| if x < 0.3 { 0.0 } else { 1.0 }).unwrap();
        assert!(!jump.is_resolved() && jump.error() > 1e-6);
    }

    #[test]
    fn stops_at_the_noise_of_cancellation() {
        // 20 - sqrt(400 - x^2) is of the order 1 / 40 but carries the rounding of 20, times 1e4 here.
        let noisy = Function::resolve(&|x| 20.0 - (400.0 - 1e-8 * x * x).sqrt()).unwrap();
        assert!(!noisy.is_resolved() && noisy.series().degree() < Function::LAST_DEGREE);
        assert!((1e-8..1e-3).contains(&noisy.error()), "{}", noisy.error());
    }

    #[test]
    fn refuses_values_that_are_not_finite() {
        let error = Function::resolve(&|x| 1.0 / x).unwrap_err();
        assert!(matches!(error, Error::NotFinite { at: 0.0, .. }));
    }
}

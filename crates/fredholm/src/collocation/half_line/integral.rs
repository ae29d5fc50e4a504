//! Integrals of functions over the half-line, where they converge.

use std::f64::consts::FRAC_PI_2;

/// Range of `t` in `x = scale exp(pi/2 sinh t)`: from `x = 1e-280` to `1e280`.
const RANGE: f64 = 6.7;
/// First number of steps in the range on either side of 0, and how often it is doubled.
const FIRST_COUNT: usize = 48;
const DOUBLINGS: usize = 8;
/// Agreement of two levels, relative to the integral of the absolute value.
const SETTLED: f64 = 1e-13;
/// Terms at both ends of the range that are larger than this, relative to the sum, mean that the integral does not converge there.
const NEGLIGIBLE: f64 = 1e-15;

/// `int_0^inf f dx` and an estimate of its error, by the double-exponential rule `x = scale exp(pi/2 sinh t)` at growing numbers of nodes; `None`
/// where the terms do not die out (`f = 1`, `f = 1/(1+x)`) or the levels do not settle (a slowly decaying oscillation).
///
/// (H. Takahasi and M. Mori, Publ. RIMS 9 (1974) 721.)
pub(super) fn over_half_line(f: &dyn Fn(f64) -> f64, scale: f64) -> Option<[f64; 2]> {
    let mut previous: Option<f64> = None;
    let mut count = FIRST_COUNT;
    for _ in 0..=DOUBLINGS {
        let [sum, absolute] = level(f, scale, count)?;
        if let Some(previous) = previous {
            let difference = (sum - previous).abs();
            if difference <= SETTLED * absolute {
                return Some([sum, difference + f64::EPSILON * absolute]);
            }
        }
        previous = Some(sum);
        count *= 2;
    }
    None
}

/// The sums of `f` and `|f|` with `2 count + 1` nodes.
fn level(f: &dyn Fn(f64) -> f64, scale: f64, count: usize) -> Option<[f64; 2]> {
    let step = RANGE / count as f64;
    let term = |j: f64| {
        let t = j * step;
        let x = scale * (FRAC_PI_2 * t.sinh()).exp();
        step * FRAC_PI_2 * t.cosh() * x * f(x)
    };
    let middle = term(0.0);
    let mut sums = [middle, middle.abs()];
    for direction in [-1.0, 1.0] {
        let mut last = 0.0;
        for j in 1..=count {
            let value = term(direction * j as f64);
            if !value.is_finite() {
                // Far out a quotient of two overflowing numbers, after all has died out.
                break;
            }
            sums[0] += value;
            sums[1] += value.abs();
            last = value;
        }
        // Also for NaN.
        let dies_out = f64::abs(last) <= NEGLIGIBLE * sums[1];
        if !dies_out {
            return None;
        }
    }
    sums[0].is_finite().then_some(sums)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integrals_that_exist() {
        for (f, exact) in [
            (&(|x: f64| (-x).exp()) as &dyn Fn(f64) -> f64, 1.0),
            (&|x| (-0.001 * x).exp(), 1000.0),
            (&|x| x * x * (-x).exp(), 2.0),
            (&|x| x.exp() * (1.0 + x) / (2.0 * x).exp(), 2.0),
            (&|x| 1.0 / (1.0 + x * x), FRAC_PI_2),
            (&|x| x.sqrt().recip() / (1.0 + x), std::f64::consts::PI),
            (&|x| (-0.3 * x).exp() * (2.0 * x).cos(), 0.3 / 4.09),
            (&|_| 0.0, 0.0),
        ] {
            let [found, error] = over_half_line(f, 1.0).unwrap();
            assert!((found - exact).abs() <= 2e-13 * (1.0 + exact), "{found} {exact}");
            assert!(error < 1e-12 * (1.0 + exact));
        }
    }

    #[test]
    fn integrals_that_do_not() {
        for f in [
            (&|_| 1.0) as &dyn Fn(f64) -> f64,
            &|x| 1.0 / (1.0 + x),
            &|x| x.sin(),
            &|x| 1.0 / x,
            &|x| (1.0 + x).sqrt().recip(),
            &|_| f64::NAN,
            &|x| x.exp(),
        ] {
            assert_eq!(over_half_line(f, 1.0), None);
        }
    }
}

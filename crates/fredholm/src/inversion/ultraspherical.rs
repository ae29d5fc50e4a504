//! The polynomials that the kernel maps to multiples of themselves, and their displacements beside the zone.
//!
//! With `c_n = C_n^(mu/2)/C_n^(mu/2)(1)` and `y = (xi - c)/b` the pressure `(e/pi) c_n(y) (b^2 - s^2)^-beta` displaces its zone by `l_n c_n(y)`, `l_n = (mu)_n/(n! mu B)`, and
//! the surface beside by `l_n d_n(y)`: the solution of the same recurrence that falls as `y^-(n+mu)`, 1 at the end of the zone.

use super::powers::Powers;
use crate::basis::gegenbauer;

/// From where on the ratio of neighbours is as good as its limit, in logarithms of their ratio; and at most, where it is that of Bessel's functions: with five times as many searches that find no zones took up to 2.6 times as long. Half and twice change none of 32 answers (survey).
const SETTLED: f64 = 20.0;
const MOST: f64 = 2e4;
/// Step of the trapezoidal rule for Bessel's functions, which leaves out `e^(-pi^2/STEP)`, and the logarithm of what its last term is (theory).
const STEP: f64 = 0.2;
const LAST: f64 = 40.0;
/// What is below `e^-ROUNDING` of the first is not felt beside it (rounding), and nothing is of what is below `e^-VANISHING`, from which nothing overflows for `y < 1e20` (theory).
const ROUNDING: f64 = 36.0;
const VANISHING: f64 = 500.0;

/// `c_n(y)` of the order `lambda = mu/2`, or `mu/2 + 1`, for `n < count`.
#[must_use]
pub fn inside(lambda: f64, count: usize, y: f64) -> Vec<f64> {
    let mut values = vec![0.0; count];
    gegenbauer::polynomials(2.0 * lambda, y, &mut values);
    values
}

/// `d_n(1 + excess)`; 0 where that is so small that its products with numbers of usual size are.
pub fn outside(powers: &Powers, count: usize, excess: f64) -> Vec<f64> {
    let mut values = vec![0.0; count];
    let scale = descend(powers, (VANISHING, count), excess, |n, value| values[n] = value);
    values.iter_mut().for_each(|value| *value *= scale);
    values
}

/// `sum a_n d_n(1 + excess)` on the side of a sign, the displacement beside the zone by a pressure that displaces it by `sum a_n c_n`.
pub fn displaced(powers: &Powers, heights: &[f64], excess: f64, sign: f64) -> f64 {
    let mut sums = [0.0; 2];
    let scale = descend(powers, (ROUNDING, heights.len()), excess, |n, value| {
        sums[n % 2] += heights[n] * value;
    });
    (sums[0] + sign * sums[1]) * scale
}

/// How many of the `d_n(1 + excess)` are felt: they fall as `e^(-n growth)`.
pub fn felt(excess: f64) -> f64 {
    ROUNDING / growth(excess)
}

/// `ln(y + sqrt(y^2 - 1))` by `y - 1`.
fn growth(excess: f64) -> f64 {
    (excess + (excess * (2.0 + excess)).sqrt()).ln_1p()
}

/// Gives those multiples of `d_n(1 + excess)` that are above `e^-fall`, at most so many, from the last to the first, and returns by what they are to be multiplied.
fn descend(
    powers: &Powers,
    (fall, most): (f64, usize),
    excess: f64,
    mut each: impl FnMut(usize, f64),
) -> f64 {
    let (mu, growth) = (powers.exponent(), growth(excess));
    let count = (fall / growth + 2.0).min(most as f64) as usize;
    let start = count + 2 + (SETTLED / growth).min(MOST) as usize;
    // Of n d_(n-1) = 2 (n + lambda) y d_n - (n + 2 lambda) d_(n+1), lambda = mu/2, the differences d_(n-1) - d_n: nothing in them cancels however near the zone is.
    let (mut value, mut step) = (1.0, -(-growth).exp_m1());
    if growth > 0.0 && SETTLED > MOST * growth {
        let z = (start as f64 + 0.5 * (mu - 1.0)) * growth;
        step = -(-growth * quotient(0.5 * (1.0 - mu), z)).exp_m1();
    }
    for n in (0..start).rev() {
        if n < count {
            each(n, value);
        }
        if n > 0 {
            let k = n as f64;
            step = ((k + mu) * step + (2.0 * k + mu) * excess * value) * (1.0 / k);
            value += step;
        }
    }
    powers.flat_beside((excess * (2.0 + excess)).sqrt()) / value
}

/// `K_(1-b)(z)/K_b(z)`: as `d_n(cosh g)` goes as `z^b K_b(z)`, `z = (n + mu/2) g` and `b = (1 - mu)/2`, for many `n` and small `g`, this is by what it falls from one `n` to the next, over `g`. Both are
/// `int_0^inf e^(-z cosh t) cosh(b t) dt`.
fn quotient(b: f64, z: f64) -> f64 {
    let falls = |t: f64| z * 2.0 * (0.5 * t).sinh().powi(2);
    let places = (0..).map(|k| STEP * f64::from(k)).take_while(|t| falls(*t) - t < LAST);
    let sums = places.fold([0.0; 2], |[above, below], t| {
        let weight = if t == 0.0 { 0.5 } else { 1.0 } * (-falls(t)).exp();
        [above + weight * ((1.0 - b) * t).cosh(), below + weight * (b * t).cosh()]
    });
    sums[0] / sums[1]
}

/// `l_n`.
pub fn gains(powers: &Powers, count: usize) -> Vec<f64> {
    let mu = powers.exponent();
    let mut gain = 1.0 / (mu * powers.total());
    (0..count)
        .map(|n| {
            let own = gain;
            gain *= (mu + n as f64) / (n as f64 + 1.0);
            own
        })
        .collect()
}

/// `int_{-1}^{1} c_n^2 (1 - y^2)^-beta dy`.
pub fn norms(powers: &Powers, count: usize) -> Vec<f64> {
    let lambda = 0.5 * powers.exponent();
    let mut norm = 2.0 * powers.total();
    (0..count)
        .map(|n| {
            let k = n as f64;
            norm *= match n {
                0 => 1.0,
                1 => 0.5 / (1.0 + lambda),
                _ => k * (k - 1.0 + lambda) / ((k + lambda) * (k + 2.0 * lambda - 1.0)),
            };
            norm
        })
        .collect()
}

/// What the profile, as far as it is a series, and other zones add to the pressure of a zone: `sum m_n c_n`, from `n = 2` on.
#[derive(Debug, Clone, Default)]
pub struct Ripple {
    lambda: f64,
    /// `m_n`, the first two zero, and those of them that other zones make.
    coefficients: Vec<f64>,
    others: Vec<f64>,
    /// Of `q = [sum m_n c_n(y) - its line between the ends]/(1 - y^2)` by the polynomials of the next order.
    bends: Vec<f64>,
}

impl Ripple {
    /// From what the profile takes away and what others add.
    pub fn new(powers: &Powers, profile: &[f64], others: Vec<f64>) -> Self {
        let lambda = 0.5 * powers.exponent();
        let mut coefficients = others.clone();
        coefficients.resize(others.len().max(profile.len()), 0.0);
        coefficients.iter_mut().zip(profile).for_each(|(m, own)| *m -= own);
        coefficients.iter_mut().take(2).for_each(|m| *m = 0.0);
        // c_n - c_(n-2) = -2 (n-1+lambda)/(2 lambda + 1) (1 - y^2) c_(n-2) of the next order
        let mut sums = coefficients.clone();
        for n in (2..sums.len().saturating_sub(2)).rev() {
            sums[n] += sums[n + 2];
        }
        let bend =
            |(n, sum): (usize, &f64)| -2.0 * (n as f64 - 1.0 + lambda) / (2.0 * lambda + 1.0) * sum;
        let bends = sums.iter().enumerate().skip(2).map(bend).collect();
        Self { lambda, coefficients, others, bends }
    }

    /// The same with less of what others add; of the profile there is no more than is felt.
    pub fn truncated(&self, powers: &Powers) -> Self {
        let sums = self.coefficients.iter().enumerate();
        let profile: Vec<f64> =
            sums.map(|(n, m)| self.others.get(n).map_or(0.0, |other| *other) - m).collect();
        let mut others = self.others.clone();
        others.iter_mut().rev().take(2).for_each(|m| *m = 0.0);
        Self::new(powers, &profile, others)
    }

    /// Whether others add something.
    pub fn is_moved(&self) -> bool {
        !self.others.is_empty()
    }

    /// At the left and the right end.
    pub fn ends(&self) -> [f64; 2] {
        let sum = |from: usize| self.coefficients.iter().skip(from).step_by(2).sum::<f64>();
        let (even, odd) = (sum(0), sum(1));
        [even - odd, even + odd]
    }

    /// `q(y)`.
    pub fn bend(&self, y: f64) -> f64 {
        let values = inside(self.lambda + 1.0, self.bends.len(), y);
        values.iter().zip(&self.bends).map(|(c, m)| c * m).sum()
    }

    /// Number of coefficients.
    #[must_use]
    pub fn count(&self) -> usize {
        self.coefficients.len()
    }

    /// Size of what is added up.
    pub fn size(&self) -> f64 {
        self.coefficients.iter().map(|m| m.abs()).sum()
    }

    /// Rounding of `q` at the ends.
    pub fn bend_rounding(&self) -> f64 {
        let size: f64 = self.bends.iter().map(|m| m.abs()).sum();
        8.0 * f64::EPSILON * self.bends.len() as f64 * size
    }

    /// `a_n` of the displacement of the zone, with these coefficients in the place of the first two.
    pub fn heights(&self, powers: &Powers, lowest: [f64; 2]) -> Vec<f64> {
        let count = self.coefficients.len().max(2);
        let all = lowest.iter().chain(self.coefficients.iter().skip(2));
        gains(powers, count).into_iter().zip(all).map(|(l, m)| l * m).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    #[test]
    fn polynomials_and_their_line() {
        // C_2 = 2 l (1+l) y^2 - l, C_3 = 4/3 l (1+l) (2+l) y^3 - 2 l (1+l) y
        let powers = Powers::new(0.6).unwrap();
        let (l, y) = (0.3, 0.37);
        let two = |y: f64| (2.0 * (1.0 + l) * y * y - 1.0) / (2.0 * (1.0 + l) - 1.0);
        let three =
            |y: f64| (4.0 / 3.0 * (2.0 + l) * y.powi(3) - 2.0 * y) / (4.0 / 3.0 * (2.0 + l) - 2.0);
        let found = inside(l, 4, y);
        assert!((found[2] - two(y)).abs() < 1e-15 && (found[3] - three(y)).abs() < 1e-15);
        let ripple = Ripple::new(&powers, &[1.0, 0.0, 0.3], vec![9.0, 9.0, 1.0, -0.4]);
        let sum = 0.7 * two(y) - 0.4 * three(y);
        let [left, right] = ripple.ends();
        let line = 0.5 * (left * (1.0 - y) + right * (1.0 + y));
        assert!((line + (1.0 - y * y) * ripple.bend(y) - sum).abs() < 1e-15);
        assert!((right - 0.3).abs() < 1e-15 && (left - 1.1).abs() < 1e-15);
    }

    #[test]
    fn displacements_beside_a_zone_are_integrals_of_the_kernel() {
        // int |y - t|^-mu c_n(t) (1 - t^2)^-beta dt over its value pi/cos(pi mu/2) (mu)_n/n! at the end, t = cos v
        for mu in [0.1, 0.5, 0.9] {
            let powers = Powers::new(mu).unwrap();
            for y in [1.2, 3.0, 40.0] {
                let found = outside(&powers, 6, y - 1.0);
                let mut gain = std::f64::consts::PI / (FRAC_PI_2 * mu).cos();
                for (n, d) in found.iter().enumerate() {
                    let half = |sign: f64| {
                        let f = |v: f64| {
                            let t = sign * v.cos();
                            (y - t).powf(-mu) * inside(0.5 * mu, 6, t)[n] * v.sin().powf(mu)
                        };
                        powers.graded(0, [0.0, FRAC_PI_2], [0.2, f64::INFINITY], f)
                    };
                    let exact = (half(1.0) + half(-1.0)) / gain;
                    // The quadrature adds terms of the size 1, whatever is left of them.
                    let rounding = 4e-15 / gain.min(1.0);
                    assert!((d - exact).abs() < rounding, "{mu} {y} {n}: {d} {exact}");
                    gain *= (mu + n as f64) / (n as f64 + 1.0);
                }
            }
            let heights: Vec<f64> = (0..300).map(|n| f64::from(n).sin()).collect();
            for excess in [1e-6, 1e-3, 0.2, 40.0, 1e9] {
                // By the ratios of neighbours, continued fractions.
                let (lambda, growth) = (0.5 * mu, growth(excess));
                let start = 300 + (2.0 * SETTLED / growth) as usize;
                let mut ratios = vec![0.0; start + 1];
                for n in (1..start).rev() {
                    let k = n as f64;
                    let twice = 2.0 * (k + lambda) * (1.0 + excess);
                    ratios[n] = k / (twice - (k + 2.0 * lambda) * ratios[n + 1]);
                }
                ratios[0] = powers.flat_beside((excess * (2.0 + excess)).sqrt());
                let (mut d, mut sum) = (1.0, 0.0);
                for (n, (height, ratio)) in heights.iter().zip(&ratios).enumerate() {
                    d *= ratio;
                    sum += if n % 2 == 0 { height * d } else { -height * d };
                }
                let found = displaced(&powers, &heights, excess, -1.0);
                // Ratios near 1 lose digits.
                let rounding = 1e-14 + 1e-16 / excess;
                assert!((found - sum).abs() < rounding, "{mu} {excess}: {found} {sum}");
                let last = outside(&powers, 300, excess)[299];
                assert!((last - d).abs() < rounding, "{mu} {excess}: {last} {d}");
            }
            let near = outside(&powers, 6, 1e-14);
            assert!(near.iter().all(|d| (d - 1.0).abs() < 1e-5_f64.powf(1.0 - mu)), "{near:?}");
        }
    }

    #[test]
    fn places_next_to_a_zone_are_told_without_all_polynomials() {
        // The same recurrence from where neighbours have the ratio of their limit.
        for mu in [0.05, 0.4, 0.6, 0.95] {
            let powers = Powers::new(mu).unwrap();
            for excess in [1e-7, 1e-9, 1e-11] {
                let growth = growth(excess);
                let start = (2.0 * SETTLED / growth) as usize;
                let (mut value, mut step) = (1.0, -(-growth).exp_m1());
                let mut values = [0.0; 40];
                for n in (0..start).rev() {
                    if n < values.len() {
                        values[n] = value;
                    }
                    if n > 0 {
                        let k = n as f64;
                        step = ((k + mu) * step + (2.0 * k + mu) * excess * value) / k;
                        value += step;
                    }
                }
                let found = outside(&powers, values.len(), excess);
                for (n, (one, of_all)) in found.iter().zip(&values).enumerate() {
                    let [fall, exact] = [1.0 - one / found[0], 1.0 - of_all / value];
                    assert!((fall - exact).abs() < 1e-11, "{mu} {excess} {n}: {fall:e} {exact:e}");
                }
            }
        }
    }
}

//! The factor of the singular function far from the diagonal.

use super::coefficients::Coefficients;
use super::dyadic::Dyadic;

/// From this order on the power series about `w = 1` suffices.
const DIRECT_FROM: f64 = 3.0;
/// Terms enough for that order at `w = 0`.
const MOST_TERMS: f64 = 3000.0;
/// Terms of a Taylor series taken at half of its radius of convergence.
const TAYLOR_TERMS: usize = 60;

/// A table of `e^((1/2-mu) r) F_1`, `F_1 = F(1/2-mu, 1/2+mu; 1-gamma; -sinh^2(r/2))`, which is of moderate size, by `r/reach`; down to `r = nearest`.
pub(super) fn table(coefficients: &Coefficients, reach: f64, nearest: f64) -> Dyadic {
    // With w = 1/cosh^2(r/2): F_1 = w^(1/2-mu) f.
    let solution = Solution::new(coefficients, (0.5 * reach).cosh().powi(-2));
    let pieces = 1 + (reach / nearest).log2().max(0.0) as usize;
    Dyadic::new(pieces, |share| {
        let r = reach * share;
        let scaled = 2.0 / (1.0 + (-r).exp());
        let (tangent, secant) = ((0.5 * r).tanh(), (0.5 * r).cosh().recip());
        let value = solution.value(secant * secant, tangent * tangent);
        // w e^r
        (scaled * scaled).powf(0.5 - coefficients.order) * value
    })
}

/// `f = F(1/2-mu, 1/2-mu-gamma; 1-gamma; 1-w)`.
///
/// The terms of its power series fall as `(1-w)^k k^(-2 mu-1)`: it serves for `w >= 1/2`, and everywhere for higher orders. For lower ones the differential
/// equation is stepped from there by Taylor series about `w = 1/2, 1/4, ...`, in the direction where the solution in demand dominates; the other one, `w^(2 mu)`, would
/// spoil the Taylor series of higher orders.
struct Solution {
    equation: Equation,
    /// About `2^-1, 2^-2, ...`.
    steps: Vec<Series>,
}

impl Solution {
    fn new(coefficients: &Coefficients, smallest: f64) -> Self {
        let equation = Equation::new(coefficients);
        let mut steps: Vec<Series> = Vec::new();
        let mut centre = 0.5;
        while coefficients.order < DIRECT_FROM && centre > smallest {
            let (value, slope) = match steps.last() {
                None => equation.start(centre),
                Some(series) => series.value_and_slope(centre),
            };
            steps.push(equation.series(centre, value, slope));
            centre *= 0.5;
        }
        Self { equation, steps }
    }

    /// At `w = 1 - rest`.
    fn value(&self, w: f64, rest: f64) -> f64 {
        match self.steps.iter().rev().find(|series| w < series.centre) {
            Some(series) => series.value_and_slope(w).0,
            None => self.equation.start(rest).0,
        }
    }
}

/// `w (1-w) f'' + [c - (a+b+1) w] f' - a b f = 0`.
struct Equation {
    a: f64,
    b: f64,
    /// `c` of the power series about `w = 1`.
    at_one: f64,
    /// `c` of the expansions about `w = 0`.
    at_zero: f64,
}

impl Equation {
    fn new(coefficients: &Coefficients) -> Self {
        let (mu, gamma) = (coefficients.order, coefficients.exponent);
        Self { a: 0.5 - mu, b: 0.5 - gamma - mu, at_one: 1.0 - gamma, at_zero: 1.0 - 2.0 * mu }
    }

    /// `f` and `df/dw` at `w = 1 - rest`.
    fn start(&self, rest: f64) -> (f64, f64) {
        let (mut coefficient, mut power, mut value, mut slope) = (1.0f64, 1.0, 1.0, 0.0);
        let mut k = 0.0;
        // Beyond k = mu the terms fall.
        while k < 1.0 - self.a || (k < MOST_TERMS && (coefficient * power).abs() > 1e-18 * value) {
            coefficient *= (self.a + k) * (self.b + k) / ((self.at_one + k) * (k + 1.0));
            k += 1.0;
            slope -= k * coefficient * power;
            power *= rest;
            value += coefficient * power;
        }
        (value, slope)
    }

    /// The solution about `w = centre` by powers of `u = w/centre - 1`.
    fn series(&self, centre: f64, value: f64, slope: f64) -> Series {
        let product = self.a * self.b * centre;
        let sum = (self.a + self.b + 1.0) * centre;
        let mut terms = [0.0; TAYLOR_TERMS];
        terms[0] = value;
        terms[1] = slope * centre;
        for k in 0..TAYLOR_TERMS - 2 {
            let n = k as f64;
            let here = (centre * n * (n - 1.0) + sum * n + product) * terms[k];
            let next = (n + 1.0) * ((1.0 - 2.0 * centre) * n + self.at_zero - sum) * terms[k + 1];
            terms[k + 2] = (here - next) / ((1.0 - centre) * (n + 2.0) * (n + 1.0));
        }
        Series { centre, terms }
    }
}

struct Series {
    centre: f64,
    terms: [f64; TAYLOR_TERMS],
}

impl Series {
    fn value_and_slope(&self, w: f64) -> (f64, f64) {
        let u = w / self.centre - 1.0;
        let (mut value, mut slope) = (0.0, 0.0);
        for term in self.terms.iter().rev() {
            slope = slope * u + value;
            value = value * u + term;
        }
        (value, slope / self.centre)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// mpmath, 50 digits: order, exponent, `r`, `e^((1/2-mu) r) F_1`.
    const VALUES: [[f64; 4]; 40] = include!("../../../tests/data/weber_sonine_factors.txt");

    #[test]
    fn factors_agree_with_mpmath() {
        for [order, gamma, r, exact] in VALUES {
            let found = table(&Coefficients::new(order, gamma), 40.0, 0.01).evaluate(r / 40.0);
            assert!((found / exact - 1.0).abs() < 1e-12, "{order} {gamma} {r}: {found} {exact}");
        }
    }

    #[test]
    fn order_one_half_is_constant_and_zero_an_elliptic_integral() {
        let [half, zero] = [0.5, 0.0].map(|mu| table(&Coefficients::new(mu, 0.0), 80.0, 0.1));
        for i in 0..80 {
            let r = 0.1 + f64::from(i);
            assert!((half.evaluate(r / 80.0) - 1.0).abs() < 1e-13, "{r}");
            // F(1/2, 1/2; 1; -sinh^2(r/2)) = 1/agm(1, cosh(r/2))
            let (mut a, mut b) = (1.0, (0.5 * r).cosh());
            for _ in 0..12 {
                (a, b) = (0.5 * (a + b), (a * b).sqrt());
            }
            let found = zero.evaluate(r / 80.0) * (-0.5 * r).exp();
            assert!((found * a - 1.0).abs() < 1e-12, "{r}: {found} {a}");
        }
    }
}

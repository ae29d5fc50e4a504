//! The factor of the singular function far from the diagonal.

use super::coefficients::Coefficients;
use super::dyadic::Dyadic;

/// Terms of a Taylor series taken at half of its radius of convergence.
const TAYLOR_TERMS: usize = 60;

/// A table of `F_1 = F(1/2-mu, 1/2+mu; 1-gamma; 1 - 1/w)` as a function of `w = 1/(1 + delta^2/4)`, down to `2^-pieces`.
///
/// `F_1 = w^(1/2-mu) f`, `f = F(1/2-mu, 1/2-mu-gamma; 1-gamma; 1-w)`. Its power series serves for `w >= 1/2`; from there the differential equation is
/// stepped by Taylor series about `w = 1/2, 1/4, ...`, in the direction where the solution in demand dominates.
pub(super) fn table(coefficients: &Coefficients, pieces: usize) -> Dyadic {
    let equation = Equation::new(coefficients);
    let power = 0.5 - coefficients.order;
    let mut series = Series { centre: 1.0, terms: [0.0; TAYLOR_TERMS] };
    let mut at = 0;
    Dyadic::new(pieces, |piece, w| {
        if piece == 0 {
            return w.powf(power) * equation.start(1.0 - w).0;
        }
        while at < piece {
            at += 1;
            let (value, slope) = if at == 1 {
                equation.start(0.5)
            } else {
                series.value_and_slope(0.5 * series.centre)
            };
            series = equation.series(0.5f64.powi(at as i32), value, slope);
        }
        w.powf(power) * series.value_and_slope(w).0
    })
}

/// `w (1-w) f'' + [c - (a+b+1) w] f' - a b f = 0`.
struct Equation {
    a: f64,
    b: f64,
    /// Of the power series about `w = 1`.
    at_one: f64,
    /// Of the expansions about `w = 0`.
    at_zero: f64,
}

impl Equation {
    fn new(coefficients: &Coefficients) -> Self {
        let (mu, gamma) = (coefficients.order, coefficients.exponent);
        Self { a: 0.5 - mu, b: 0.5 - gamma - mu, at_one: 1.0 - gamma, at_zero: 1.0 - 2.0 * mu }
    }

    /// `f` and `df/dw` at `w = 1 - y`, `0 <= y <= 1/2`.
    fn start(&self, y: f64) -> (f64, f64) {
        let (mut coefficient, mut power, mut value, mut slope) = (1.0, 1.0, 1.0, 0.0);
        let mut k = 0.0;
        // Beyond k = mu the terms fall as y^k.
        while k < 70.0 - self.a {
            coefficient *= (self.a + k) * (self.b + k) / ((self.at_one + k) * (k + 1.0));
            k += 1.0;
            slope -= k * coefficient * power;
            power *= y;
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

    #[test]
    fn order_one_half_is_constant_and_three_halves_linear() {
        // F(0, ..) = 1; F(-1, 2; 1-gamma; v) = 1 - 2 v/(1-gamma), v = 1 - 1/w
        for gamma in [-0.45, 0.0, 0.3] {
            let half = table(&Coefficients::new(0.5, gamma), 60);
            let next = table(&Coefficients::new(1.5, gamma), 60);
            for i in 0..50 {
                let w = 0.5f64.powi(i) * 0.9;
                let exact = 1.0 - 2.0 * (1.0 - 1.0 / w) / (1.0 - gamma);
                assert!((half.evaluate(w) - 1.0).abs() < 1e-13, "{gamma} {w}");
                assert!((next.evaluate(w) / exact - 1.0).abs() < 1e-12, "{gamma} {w}");
            }
        }
    }

    #[test]
    fn order_zero_is_an_elliptic_integral() {
        // F(1/2, 1/2; 1; -delta^2/4) = (2/pi) K(i delta/2) = 1/agm(1, sqrt(1 + delta^2/4))
        let found = table(&Coefficients::new(0.0, 0.0), 60);
        for i in 0..50 {
            let w = 0.5f64.powi(i) * 0.7;
            let (mut a, mut b) = (1.0, w.sqrt().recip());
            for _ in 0..10 {
                (a, b) = (0.5 * (a + b), (a * b).sqrt());
            }
            assert!((found.evaluate(w) * a - 1.0).abs() < 1e-13, "{w}");
        }
    }
}

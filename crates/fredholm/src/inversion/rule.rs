//! Legendre polynomials on a panel: Gauss's rule, coefficients, and the functions of the second kind.

use std::sync::LazyLock;

use crate::quadrature::gauss_legendre;

/// Nodes of a panel.
pub(crate) const ORDER: usize = 16;
/// Up to here the recurrence upwards loses nothing that matters for [`ORDER`] functions.
const UPWARD: f64 = 1.03;

/// Gauss's rule with the polynomials at its nodes.
pub(crate) struct Rule {
    pub(crate) nodes: [f64; ORDER],
    pub(crate) weights: [f64; ORDER],
    /// `P_n` at node `i`.
    polynomials: [[f64; ORDER]; ORDER],
}

pub(crate) static RULE: LazyLock<Rule> = LazyLock::new(|| {
    let mut rule =
        Rule { nodes: [0.0; ORDER], weights: [0.0; ORDER], polynomials: [[0.0; ORDER]; ORDER] };
    if let Ok(gauss) = gauss_legendre(ORDER) {
        rule.nodes.copy_from_slice(&gauss.nodes);
        rule.weights.copy_from_slice(&gauss.weights);
        rule.polynomials = rule.nodes.map(polynomials);
    }
    rule
});

impl Rule {
    /// The coefficients of the polynomial through values at the nodes.
    pub(crate) fn coefficients(&self, values: &[f64; ORDER]) -> [f64; ORDER] {
        let mut coefficients = [0.0; ORDER];
        for (i, value) in values.iter().enumerate() {
            for (n, c) in coefficients.iter_mut().enumerate() {
                *c += (n as f64 + 0.5) * self.weights[i] * value * self.polynomials[i][n];
            }
        }
        coefficients
    }

    /// The sizes of the last two of these together.
    pub(crate) fn last(&self, values: &[f64; ORDER]) -> f64 {
        let size = |n: usize| {
            let nodes = self.weights.iter().zip(&self.polynomials);
            let terms = nodes.zip(values).map(|((weight, row), value)| weight * value * row[n]);
            (n as f64 + 0.5) * terms.sum::<f64>().abs()
        };
        size(ORDER - 2) + size(ORDER - 1)
    }

    /// The values at the nodes of a polynomial with these coefficients.
    pub(crate) fn values(&self, coefficients: &[f64; ORDER]) -> [f64; ORDER] {
        self.polynomials.map(|row| row.iter().zip(coefficients).map(|(p, c)| p * c).sum())
    }
}

/// `P_0 .. P_(ORDER - 1)`.
pub(crate) fn polynomials(x: f64) -> [f64; ORDER] {
    let mut values = [1.0; ORDER];
    values[1] = x;
    for n in 1..ORDER - 1 {
        let k = n as f64;
        values[n + 1] = ((2.0 * k + 1.0) * x * values[n] - k * values[n - 1]) / (k + 1.0);
    }
    values
}

/// `sum c_n P_n(x)` of at most [`ORDER`] terms, by Clenshaw's recurrence.
pub(crate) fn series(coefficients: &[f64], x: f64) -> f64 {
    let (mut one, mut two) = (0.0, 0.0);
    let factors = RECURRENCE.iter().zip(coefficients).rev();
    for ([own, next], c) in factors {
        (one, two) = (c + own * x * one - next * two, one);
    }
    one
}

/// The same at several places at once, which waits less for each sum; to the last bit.
pub(crate) fn series_at(coefficients: &[f64], places: &[f64; ORDER]) -> [f64; ORDER] {
    let (mut one, mut two) = ([0.0; ORDER], [0.0; ORDER]);
    let factors = RECURRENCE.iter().zip(coefficients).rev();
    for ([own, next], c) in factors {
        for ((x, one), two) in places.iter().zip(&mut one).zip(&mut two) {
            (*one, *two) = (c + own * x * *one - next * *two, *one);
        }
    }
    one
}

/// `(2n+1)/(n+1)`, `(n+1)/(n+2)`.
const RECURRENCE: [[f64; 2]; ORDER] = {
    let mut factors = [[0.0; 2]; ORDER];
    let mut n = 0;
    while n < ORDER {
        let k = n as f64;
        factors[n] = [(2.0 * k + 1.0) / (k + 1.0), (k + 1.0) / (k + 2.0)];
        n += 1;
    }
    factors
};

/// The coefficients of the derivative.
pub(crate) fn derivative(coefficients: &[f64; ORDER]) -> [f64; ORDER] {
    // P_n' = sum of (2k + 1) P_k over k = n-1, n-3, ..
    std::array::from_fn(|k| {
        let above = coefficients.iter().skip(k + 1).step_by(2);
        (2.0 * k as f64 + 1.0) * above.sum::<f64>()
    })
}

/// `p.v. int_{-1}^{1} P_n(u)/(u - x) du = -2 Q_n(x)` summed with coefficients; `x` by its distances `x + 1` and `x - 1`, which are not zero.
pub(crate) fn cauchy(coefficients: &[f64; ORDER], from_left: f64, from_right: f64) -> f64 {
    let x = 0.5 * (from_left + from_right);
    // Far away the quotient is 1 but for its last digits.
    let first = match x.abs() {
        size if size > 2.0 => 0.5 * (2.0 / from_right).ln_1p(),
        _ => 0.5 * (from_left / from_right).abs().ln(),
    };
    if x.abs() <= UPWARD {
        let (mut below, mut value) = (first, x * first - 1.0);
        let mut sum = coefficients[0] * below + coefficients[1] * value;
        for (n, coefficient) in coefficients.iter().enumerate().skip(2) {
            let k = n as f64;
            (below, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * below) / k);
            sum += coefficient * value;
        }
        return -2.0 * sum;
    }
    // Downwards: the ratio of neighbours settles from any start.
    let growth = (x.abs() + (x * x - 1.0).sqrt()).ln();
    let start = ORDER + 2 + (20.0 / growth) as usize;
    let mut ratio = 0.0;
    let mut ratios = [0.0; ORDER];
    for n in (1..start).rev() {
        // Q_n / Q_(n-1) = n / ((2n+1) x - (n+1) Q_(n+1)/Q_n)
        let k = n as f64;
        ratio = k / ((2.0 * k + 1.0) * x - (k + 1.0) * ratio);
        if n < ORDER {
            ratios[n] = ratio;
        }
    }
    let mut value = first;
    let mut sum = coefficients[0] * value;
    for n in 1..ORDER {
        value *= ratios[n];
        sum += coefficients[n] * value;
    }
    -2.0 * sum
}

/// `int_start^end f`, by Gauss's rule of 16 nodes.
///
/// ```
/// let found = fredholm::inversion::integral(0.0, 1.0, |x| x.powi(31));
/// assert!((32.0 * found - 1.0).abs() < 1e-14);
/// ```
#[must_use]
pub fn integral(start: f64, end: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
    let terms = RULE.nodes.iter().zip(&RULE.weights);
    half * terms.map(|(u, weight)| weight * f(middle + half * u)).sum::<f64>()
}

/// The same for a function of all nodes at once.
pub(crate) fn integral_at_nodes(
    start: f64,
    end: f64,
    f: impl Fn(&[f64; ORDER]) -> [f64; ORDER],
) -> f64 {
    let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
    let values = f(&RULE.nodes.map(|u| middle + half * u));
    half * RULE.weights.iter().zip(values).map(|(weight, value)| weight * value).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_is_exact_for_polynomials() {
        for degree in 0..2 * ORDER as i32 {
            let found: f64 = (0..ORDER).map(|i| RULE.weights[i] * RULE.nodes[i].powi(degree)).sum();
            let exact = if degree % 2 == 0 { 2.0 / f64::from(degree + 1) } else { 0.0 };
            assert!((found - exact).abs() < 4e-15, "{degree}");
            let shifted = integral_at_nodes(0.0, 1.0, |x| x.map(|x| x.powi(degree)));
            assert!((shifted - 1.0 / f64::from(degree + 1)).abs() < 4e-15, "{degree}");
        }
    }

    #[test]
    fn cauchy_integrals_of_powers() {
        // u^5/(u - x) = u^4 + x u^3 + x^2 u^2 + x^3 u + x^4 + x^5/(u - x)
        let values = RULE.nodes.map(|u| u.powi(5));
        let coefficients = RULE.coefficients(&values);
        for x in [-3.9f64, -1.01, -0.999, 0.0, 0.3, 1.0299, 1.0301, 1.2, 2.0] {
            let logarithm = ((1.0 - x) / (1.0 + x)).abs().ln();
            let exact = 0.4 + 2.0 / 3.0 * x * x + 2.0 * x.powi(4) + x.powi(5) * logarithm;
            let found = cauchy(&coefficients, x + 1.0, x - 1.0);
            // The closed form itself cancels far outside.
            let size = 1.0 + x.powi(5).abs();
            assert!((found - exact).abs() < 2e-14 * size, "{x}: {found} {exact}");
        }
    }

    #[test]
    fn derivatives_of_a_polynomial() {
        let coefficients = RULE.coefficients(&RULE.nodes.map(|u| u.powi(7) - u));
        let slopes = RULE.values(&derivative(&coefficients));
        for (u, slope) in RULE.nodes.iter().zip(slopes) {
            assert!((slope - (7.0 * u.powi(6) - 1.0)).abs() < 1e-12);
        }
        for u in [-1.0, -0.3, 0.0, 0.8, 1.0f64] {
            assert!((series(&coefficients, u) - (u.powi(7) - u)).abs() < 4e-15);
            assert!((series(&coefficients[..2], u) + 2.0 / 3.0 * u).abs() < 4e-15);
        }
        for (u, value) in RULE.nodes.iter().zip(series_at(&coefficients, &RULE.nodes)) {
            assert!((value - (u.powi(7) - u)).abs() < 4e-15);
        }
    }
}

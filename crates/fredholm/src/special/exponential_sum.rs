//! Integrals `int rho^j dm` for all exponents `j` by one rule.

/// `S_j = sum_k weights[k] ratios[k]^j`: a rule for `int rho^j dm`, `0 <= rho <= 1`, that serves every `j`.
///
/// Contour integration turns the oscillating integrals of Chebyshev polynomials against algebraic functions into such moments of a positive
/// measure, which no cancellation harms at any degree.
#[derive(Debug, Clone, Default)]
pub(crate) struct ExponentialSum {
    terms: Vec<Term>,
}

#[derive(Debug, Clone, Copy)]
struct Term {
    weight: f64,
    ratio: f64,
}

impl ExponentialSum {
    /// From pairs of a weight and the rate `r` in `rho = e^-r`.
    pub(crate) fn new(terms: impl Iterator<Item = (f64, f64)>) -> Self {
        let terms = terms.map(|(weight, rate)| Term { weight, ratio: (-rate).exp() });
        Self { terms: terms.collect() }
    }

    /// `S_1, S_2, ..., S_count`; `2 count` operations for each term of the rule.
    pub(crate) fn moments(&self, count: usize) -> Vec<f64> {
        let mut powers: Vec<Term> = self
            .terms
            .iter()
            .map(|&Term { weight, ratio }| Term { weight: weight * ratio, ratio })
            .collect();
        let next = |_| {
            // Terms that have died out would go through the slow arithmetic of denormal numbers.
            powers.retain(|term| term.weight > f64::MIN_POSITIVE);
            powers.iter_mut().fold(0.0, |sum, Term { weight, ratio }| {
                let value = *weight;
                *weight *= *ratio;
                sum + value
            })
        };
        (0..count).map(next).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_powers() {
        let sum = ExponentialSum::new([(2.0, 0.5), (1e-3, 1e-4), (5.0, f64::INFINITY)].into_iter());
        for (j, found) in (1..).zip(sum.moments(3000)) {
            let j = f64::from(j);
            let exact = 2.0 * (-0.5 * j).exp() + 1e-3 * (-1e-4 * j).exp();
            assert!((found - exact).abs() < 1e-12 * exact, "{j}: {found} {exact}");
        }
        assert!(ExponentialSum::default().moments(2).iter().all(|&s| s == 0.0));
    }
}

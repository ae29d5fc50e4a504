//! The spectral relation of the kernel of Weber and Sonine.

use super::WeberSonine;
use crate::Error;
use crate::basis::expansion::{Rule, expand_by_rule};
use crate::basis::jacobi::Argument;
use crate::kernel::{EndExponents, Expansion, Gram, Kernel, Parity, SpectralRelation};
use crate::quadrature::gauss_jacobi;
use crate::special::gamma_quotient;

impl WeberSonine {
    /// `Gamma(n+gamma+1/2) / n!`.
    fn first_quotient(&self, n: f64) -> f64 {
        gamma_quotient(n + (self.exponent + 0.5), n + 1.0)
    }

    /// `Gamma(n+mu+gamma+1/2) / Gamma(n+mu+1)`.
    fn second_quotient(&self, n: f64) -> f64 {
        gamma_quotient(n + self.order + (self.exponent + 0.5), n + self.order + 1.0)
    }

    /// `2n + mu + gamma + 1/2`.
    fn degree(&self, n: f64) -> f64 {
        2.0 * n + self.order + (self.exponent + 0.5)
    }

    /// `h_n` for `a = 1`.
    pub(super) fn unit_norm(&self, n: usize) -> f64 {
        let n = n as f64;
        0.5 / self.degree(n) * (self.first_quotient(n) / self.second_quotient(n))
    }

    /// `1 - 2 x^2/a^2`; points outside count as the nearer end.
    fn argument(&self, x: f64) -> Argument {
        let place = x / self.radius;
        let from_rim = ((self.radius - x) / self.radius).max(0.0);
        Argument {
            from_one: (place * place).min(1.0),
            from_minus_one: (from_rim * (1.0 + place)).min(1.0),
        }
    }

    /// A rule for `int_0^a g w s ds`, `g` being a product of two of `phi_0 .. phi_{count-1}`.
    ///
    /// In `z = s^2/a^2` it is `z^mu (1-z)^(gamma-1/2)` times a polynomial. The rule has the weight `z^e (1-z)^(gamma-1/2)` with `e` in `[-1/2, 1/2]`, `mu - e` an
    /// integer: weights beside `z^mu` are tiny near 0, where only their absolute error is small.
    fn rule(&self, count: usize) -> Result<Rule, Error> {
        let whole = self.order.round();
        let part = self.order - whole;
        let nodes = count + (0.5 * whole) as usize + 1;
        let rule = gauss_jacobi(nodes, self.exponent - 0.5, part)?;
        // s ds = a^2 dz/2, w = a^(2 gamma-1) (1-z)^(gamma-1/2), z = (1+t)/2
        let scale = 0.5
            * self.radius.powf(2.0 * self.exponent + 1.0)
            * 0.5f64.powf(self.exponent + 0.5 + part);
        let squares: Vec<f64> = rule.nodes.iter().map(|t| 0.5 + 0.5 * t).collect();
        let weight = |(z, w): (&f64, &f64)| w * scale * z.powf(-part);
        Ok(Rule {
            weights: squares.iter().zip(&rule.weights).map(weight).collect(),
            nodes: squares.iter().map(|z| self.radius * z.sqrt()).collect(),
        })
    }
}

impl SpectralRelation for WeberSonine {
    fn weight_exponents(&self) -> EndExponents {
        EndExponents { left: 0.0, right: self.exponent - 0.5 }
    }

    fn weight_rest(&self, _n: usize, x: f64) -> f64 {
        (self.radius + x).powf(self.exponent - 0.5)
    }

    fn eigenvalue(&self, n: usize) -> f64 {
        let n = n as f64;
        0.5 * 4f64.powf(self.exponent) * (self.first_quotient(n) * self.second_quotient(n))
    }

    fn norm(&self, n: usize) -> f64 {
        self.unit_norm(n) * self.radius.powf(2.0 * (self.order + self.exponent) + 1.0)
    }

    // 2^(2 gamma) (2n+mu+gamma+1/2) [Gamma(n+mu+gamma+1/2)/Gamma(n+mu+1)]^2 a^(-2 mu-2 gamma-1)
    fn expansion_factor(&self, n: usize) -> f64 {
        let n = n as f64;
        let quotient = self.second_quotient(n);
        4f64.powf(self.exponent)
            * self.degree(n)
            * (quotient * quotient)
            * self.radius.powf(-2.0 * (self.order + self.exponent) - 1.0)
    }

    fn parity(&self) -> Parity {
        Parity::None
    }

    fn eigenfunctions(&self, x: f64, values: &mut [f64]) {
        let functions = self.polynomials().values(self.argument(x), self.mass_function(x));
        values.iter_mut().zip(functions).for_each(|(value, function)| *value = function);
    }

    fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        self.polynomials().sum(coefficients, self.argument(x), self.mass_function(x))
    }

    fn gram(&self, count: usize) -> Result<Gram, Error> {
        self.gram_matrix(count)
    }

    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error> {
        expand_by_rule(self, f, |count| self.rule(count))
    }
}

//! The spectral relation of the kernel of Weber and Sonine.

use super::WeberSonine;
use crate::Error;
use crate::basis::expansion::expand_at_nodes;
use crate::kernel::{EndExponents, Expansion, Gram, Kernel, Parity, SpectralRelation};
use crate::quadrature::Rule;
use crate::quadrature::jacobi::{Argument, GaussNode, Jacobi};
use crate::special::half_gamma_quotient;

impl WeberSonine {
    /// `Gamma(n+gamma+1/2) / n!`.
    fn first_quotient(&self, n: f64) -> f64 {
        half_gamma_quotient(n, self.exponent)
    }

    /// `Gamma(n+mu+gamma+1/2) / Gamma(n+mu+1)`.
    pub(super) fn second_quotient(&self, n: f64) -> f64 {
        half_gamma_quotient(n + self.order, self.exponent)
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
    /// In `z = s^2/a^2` it is `z^mu (1-z)^(gamma-1/2)` times a polynomial. The rule has the weight `z^e (1-z)^(gamma-1/2)` with the broken part `e` of `mu`, so
    /// that it can be divided by its power.
    fn rule(&self, count: usize) -> Result<Rule<Argument>, Error> {
        let part = self.order.fract();
        let nodes = count + (0.5 * self.order) as usize + 1;
        let rule = Jacobi::new(part, self.exponent - 0.5).gauss(nodes)?;
        // s ds = a^2 dz/2, w = a^(2 gamma-1) (1-z)^(gamma-1/2)
        let scale = 0.5 * self.radius.powf(2.0 * self.exponent + 1.0);
        let weight = |node: &GaussNode| node.weight * scale * node.argument.from_one.powf(-part);
        Ok(Rule {
            weights: rule.iter().map(weight).collect(),
            nodes: rule.iter().map(|node| node.argument).collect(),
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
        let place = |node: &Argument| self.radius * node.from_one.sqrt();
        let functions = |node: &Argument, values: &mut [f64]| {
            let functions = self.polynomials().values(*node, self.mass_function(place(node)));
            values.iter_mut().zip(functions).for_each(|(value, function)| *value = function);
        };
        expand_at_nodes(self, f, |count| self.rule(count), place, functions)
    }
}

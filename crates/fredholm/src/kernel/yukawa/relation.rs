//! The spectral relation of kernel 7.

use std::f64::consts::FRAC_1_PI;

use super::Yukawa;
use super::eigenvalues::eigenvalues;
use crate::Error;
use crate::basis::expansion::expand_by_rule;
use crate::basis::legendre::strengths;
use crate::basis::spheroidal::Spheroidal;
use crate::kernel::{
    EndExponents, Expansion, Gram, Kernel, Moments, Parity, SpectralRelation, forward_kernel,
};
use crate::quadrature::Rule;
use crate::quadrature::gauss_legendre;

/// Most doublings of the rule for moments.
const DOUBLINGS: usize = 4;
/// A difference of moments, relative to the largest value of the function, that counts as none.
const RESOLVED: f64 = 1e-12;

/// The spectral relation of the [`Yukawa`] kernel, computed for `phi_0 .. phi_{count-1}`.
///
/// `phi_n(x) = S_n(sqrt(1 - x^2/a^2))` with the angular prolate spheroidal functions of order `m`, degree `m + 2n` and parameter `kappa = chi a`, `int_0^1 S_n^2 d eta = 1`, `phi_n(a)` of the sign
/// `(-1)^n`; `w = 1/sqrt(a^2 - s^2)` with respect to `s ds`, `h_n = a`. In oblate spheroidal coordinates the potential of the density `w phi_n` separates, whence the relation; the eigenvalues are Rayleigh quotients
/// of the exact matrix of the operator in Legendre functions (`docs/src/kernels-screened.md`).
///
/// All eigenvalues are positive and fall with `n`: `lambda_n ~ pi/n`.
///
/// ```
/// use fredholm::kernel::{SpectralRelation, Yukawa};
///
/// let relation = Yukawa::new(1.0, 1.0, 0)?.relation(20)?;
/// // mpmath, 25 digits.
/// assert!((relation.eigenvalue(0) - 5.864_298_563_676_795).abs() < 1e-13);
/// # Ok::<(), fredholm::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct YukawaRelation {
    kernel: Yukawa,
    functions: Spheroidal,
    eigenvalues: Vec<f64>,
}

impl Yukawa {
    /// The spectral relation for `phi_0 .. phi_{count-1}`.
    ///
    /// Cost, with `J = count + 30` and more for large `kappa = chi a`: some `J count (60 + 8 sqrt(kappa))` operations; 5 ms for `count = 100`, `kappa = 10`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for `count = 0`, [`Error::TooLarge`] beyond memory.
    pub fn relation(&self, count: usize) -> Result<YukawaRelation, Error> {
        let kappa = self.screening() * self.radius();
        let functions = Spheroidal::new(self.harmonic(), kappa, count)?;
        let eigenvalues = eigenvalues(self.harmonic(), kappa, &functions)?;
        Ok(YukawaRelation { kernel: self.clone(), functions, eigenvalues })
    }
}

impl YukawaRelation {
    /// The kernel.
    #[must_use]
    pub fn kernel(&self) -> &Yukawa {
        &self.kernel
    }

    /// The separation constants `Lambda_n`, `lambda + kappa^2` of DLMF 30.3: `Lambda_n - kappa^2` are the eigenvalues of the differential operator that commutes with the integral operator.
    #[must_use]
    pub fn separation_constants(&self) -> &[f64] {
        self.functions.separation()
    }

    /// The coefficients of `phi_n` in `sqrt(2)` times the normalised Legendre functions `P^m_{m+2j}(sqrt(1 - x^2/a^2))`; none for an index that is not available.
    #[must_use]
    pub fn legendre_coefficients(&self, n: usize) -> &[f64] {
        if n < self.available() { self.functions.coefficients(n) } else { &[] }
    }

    /// The Gauss rule `int_0^1 g d eta = sum w g` with `nodes` nodes, exact for even polynomials of degree `4 nodes - 2`, as pairs of `x = a sqrt(1 - eta^2)` and the weight.
    fn even_rule(&self, nodes: usize) -> Result<Rule, Error> {
        let rule = gauss_legendre(2 * nodes)?;
        let radius = self.kernel.radius();
        let position = |eta: &f64| radius * ((1.0 - eta) * (1.0 + eta)).sqrt();
        Ok(Rule {
            nodes: rule.nodes[nodes..].iter().map(position).collect(),
            weights: rule.weights[nodes..].to_vec(),
        })
    }

    /// `int_0^1 f(x) S_k eta d eta` by a rule on the half, and the largest value of `f` met.
    fn products(&self, f: &dyn Fn(f64) -> f64, nodes: usize) -> Result<(Vec<f64>, f64), Error> {
        let rule = gauss_legendre(nodes)?;
        let mut products = vec![0.0; self.functions.order()];
        let mut largest = 0.0f64;
        for (t, weight) in rule.nodes.iter().zip(&rule.weights) {
            let eta = 0.5 + 0.5 * t;
            let xi = (0.5 * (1.0 - t) * (1.0 + eta)).sqrt();
            let x = self.kernel.radius() * xi;
            let value = f(x);
            if !value.is_finite() {
                return Err(Error::NotFinite { what: "function", at: x, value });
            }
            largest = largest.max(value.abs());
            let scaled = 0.5 * weight * eta * value;
            self.functions.basis().at(xi, |j, e| products[j] += scaled * e);
        }
        Ok((self.functions.project(&products), largest))
    }
}

impl Kernel for YukawaRelation {
    forward_kernel!(self => self.kernel);
}

impl SpectralRelation for YukawaRelation {
    fn available(&self) -> usize {
        self.functions.count()
    }

    fn weight_exponents(&self) -> EndExponents {
        EndExponents { left: 0.0, right: -0.5 }
    }

    fn weight_rest(&self, _n: usize, x: f64) -> f64 {
        1.0 / (self.kernel.radius() + x).sqrt()
    }

    fn eigenvalue(&self, n: usize) -> f64 {
        self.eigenvalues.get(n).copied().unwrap_or(f64::NAN)
    }

    fn norm(&self, n: usize) -> f64 {
        if n < self.available() { self.kernel.radius() } else { f64::NAN }
    }

    fn parity(&self) -> Parity {
        Parity::None
    }

    fn eigenfunctions(&self, x: f64, values: &mut [f64]) {
        let mut basis = vec![0.0; self.functions.order()];
        self.functions.basis().at(self.share(x), |j, value| basis[j] = value);
        let known = values.len().min(self.available());
        values[known..].fill(f64::NAN);
        for (n, value) in values[..known].iter_mut().enumerate() {
            *value = crate::linear::dot(self.functions.coefficients(n), &basis);
        }
    }

    fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        if coefficients.len() > self.available() {
            return f64::NAN;
        }
        let combined = self.functions.combine(coefficients);
        let mut sum = 0.0;
        self.functions.basis().at(self.share(x), |j, value| sum += combined[j] * value);
        sum
    }

    fn gram(&self, count: usize) -> Result<Gram, Error> {
        if count > self.available() {
            return Err(Error::TooFew { needed: count, available: self.available() });
        }
        let order = self.functions.order();
        let square = self.kernel.radius() * self.kernel.radius();
        // R^ d^(k), column by column.
        let heights = heights(self.kernel.harmonic(), order);
        let mut entries = vec![0.0; count * count];
        for k in 0..count {
            let row = crate::linear::multiply_rows(&heights, self.functions.coefficients(k));
            for m in 0..=k {
                let entry = square * crate::linear::dot(&row, self.functions.coefficients(m));
                entries[k * count + m] = entry;
                entries[m * count + k] = entry;
            }
        }
        Ok(Gram::Dense { order: count, entries })
    }

    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error> {
        // Products of two functions of the basis are polynomials of degree 2 m + 4 j in eta.
        let beyond =
            self.functions.order() - self.available() + self.kernel.harmonic() as usize / 2;
        let radius = self.kernel.radius();
        expand_by_rule(self, f, |count| {
            let mut rule = self.even_rule(count + beyond + 2)?;
            rule.weights.iter_mut().for_each(|weight| *weight *= radius);
            Ok(rule)
        })
    }

    // Not by the expansion: few eigenfunctions of a strong screening do not resolve even a constant.
    fn moments(&self, f: &dyn Fn(f64) -> f64, count: usize) -> Result<Moments, Error> {
        if count > self.available() {
            return Err(Error::TooFew { needed: count, available: self.available() });
        }
        let square = self.kernel.radius() * self.kernel.radius();
        let mut nodes = 2 * self.functions.order() + self.kernel.harmonic() as usize + 32;
        let (mut values, _) = self.products(f, nodes)?;
        let mut error = f64::INFINITY;
        for _ in 0..DOUBLINGS {
            nodes *= 2;
            let (finer, largest) = self.products(f, nodes)?;
            let change =
                finer.iter().zip(&values).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
            error = if largest > 0.0 { change / largest } else { 0.0 };
            values = finer;
            if error <= RESOLVED {
                break;
            }
        }
        values.truncate(count);
        values.iter_mut().for_each(|value| *value *= square);
        Ok(Moments { values, error, resolved: error <= RESOLVED })
    }

    fn mass(&self, n: usize) -> f64 {
        // x^m = a^m e_0/first, and the e_j are orthonormal.
        let coefficient = self.legendre_coefficients(n).first().copied().unwrap_or(f64::NAN);
        let radius = self.kernel.radius();
        radius.powi(self.kernel.harmonic() as i32 + 1) * coefficient
            / self.functions.basis().first()
    }
}

impl YukawaRelation {
    /// `x/a`.
    fn share(&self, x: f64) -> f64 {
        (x / self.kernel.radius()).clamp(0.0, 1.0)
    }
}

/// The matrix `int_0^1 e_i e_j eta d eta`, in closed form with the strengths `C_j`:
/// `(2/pi) (-1)^(i+j+1) C_i C_j [4 (i^2 + j^2) + (4m+2)(i+j) + 2m] / ([4 (i-j)^2 - 1] 4 (i+j+m) (i+j+m+1))`.
fn heights(harmonic: u32, order: usize) -> Vec<f64> {
    let m = f64::from(harmonic);
    let strengths = strengths(harmonic, order);
    let entry = |i: usize, j: usize| {
        let (x, y) = (i as f64, j as f64);
        let product = FRAC_1_PI * strengths[i] * strengths[j];
        if i + j == 0 {
            // 2m/4m, for m = 0 too.
            return product / (m + 1.0);
        }
        let sign = if (i + j).is_multiple_of(2) { -1.0 } else { 1.0 };
        let numerator = 2.0 * (x * x + y * y) + (2.0 * m + 1.0) * (x + y) + m;
        let gap = 2.0 * (x - y);
        sign * product * numerator / ((gap - 1.0) * (gap + 1.0) * (x + y + m) * (x + y + m + 1.0))
    };
    (0..order * order).map(|place| entry(place / order, place % order)).collect()
}

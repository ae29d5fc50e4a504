//! The eigenvalues, from the matrix of the integral operator in Legendre functions.

use std::f64::consts::FRAC_PI_2;

use super::waves::inner_quotients;
use crate::Error;
use crate::basis::legendre::strengths;
use crate::basis::spheroidal::Spheroidal;
use crate::quadrature::gauss_legendre;

/// Nodes of Gauss's rule on a panel, and the far end of one over that of the panel before. The integrand has no singularities, but away from the axis it goes as `1/sqrt(nu^2 + q^2)`: as if there were
/// some at 0, which for these panels leave `(3 + sqrt 8)^-20`.
const NODES: usize = 20;
const GROWTH: f64 = 4.0;
/// The first panel reaches to this `q`, where the integrand goes as `exp(-2q)`.
const FIRST: f64 = 2.0;
/// Nodes for which a row of coefficients is read once.
const TOGETHER: usize = 8;
/// Coefficients of functions of unit length below this do not count.
const NEGLIGIBLE: f64 = 1e-20;

/// `lambda_n = d^T A d` with the coefficients `d` of `S_n` in the basis `e_j` and
///
/// `A_ij = 4 C_i C_j (-1)^(i-j) int_0^(pi/2) I_(nu_max)(q) K_(nu_min)(q) d theta`, `q = kappa sin theta`, `nu_j = m + 2j + 1/2`:
///
/// the transform of `1/sqrt(t^2 + kappa^2)` with Bessel functions, turned to the imaginary axis. The error is of second order in that of `d`. The matrix itself is not needed: the sums over `i < j` run along with
/// the quotients `I_(nu+1)/I_nu`, which neither overflow nor underflow.
pub(super) fn eigenvalues(
    harmonic: u32,
    kappa: f64,
    functions: &Spheroidal,
) -> Result<Vec<f64>, Error> {
    let rows = Rows::new(harmonic, functions);
    let mut eigenvalues = vec![0.0; functions.count()];
    for nodes in nodes(kappa)?.chunks(TOGETHER) {
        let mut sums: Vec<Sum> =
            nodes.iter().map(|[q, weight]| Sum::new(harmonic, *q, *weight, &rows)).collect();
        for j in 0..functions.order() {
            let (first, row) = rows.at(j);
            for sum in &mut sums {
                sum.add(j, row, first, &mut eigenvalues);
            }
        }
    }
    Ok(eigenvalues)
}

/// `q` and the weights, with the factor 4, of the rule for the integral over `theta`.
fn nodes(kappa: f64) -> Result<Vec<[f64; 2]>, Error> {
    let rule = gauss_legendre(NODES)?;
    let mut nodes = Vec::new();
    let (mut left, mut right) = (0.0, FIRST / kappa.max(FIRST));
    while left < FRAC_PI_2 {
        // Not a short last one.
        right = if 2.0 * right < FRAC_PI_2 { right } else { FRAC_PI_2 };
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        let node =
            |(t, weight): (&f64, &f64)| [kappa * (middle + half * t).sin(), 4.0 * half * weight];
        nodes.extend(rule.nodes.iter().zip(&rule.weights).map(node));
        (left, right) = (right, GROWTH * right);
    }
    Ok(nodes)
}

/// `(-1)^j C_j d_j^{(n)}`, `n` running fastest, without the functions that end before `j`.
struct Rows {
    count: usize,
    order: usize,
    entries: Vec<f64>,
    /// The first function that goes on at `j` or beyond.
    first: Vec<usize>,
}

impl Rows {
    fn new(harmonic: u32, functions: &Spheroidal) -> Self {
        let (count, order) = (functions.count(), functions.order());
        let mut entries = vec![0.0; count * order];
        let mut first = vec![count; order];
        for n in 0..count {
            for (j, entry) in functions.coefficients(n).iter().enumerate() {
                entries[j * count + n] = *entry;
                if entry.abs() > NEGLIGIBLE {
                    first[j] = first[j].min(n);
                }
            }
        }
        for j in (1..order).rev() {
            first[j - 1] = first[j - 1].min(first[j]);
        }
        let strengths = strengths(harmonic, order);
        for (j, (row, strength)) in entries.chunks_exact_mut(count).zip(strengths).enumerate() {
            let factor = if j.is_multiple_of(2) { strength } else { -strength };
            row.iter_mut().for_each(|entry| *entry *= factor);
        }
        Self { count, order, entries, first }
    }

    /// The first function at `j`, and the entries from that on.
    fn at(&self, j: usize) -> (usize, &[f64]) {
        let first = self.first[j];
        (first, &self.entries[j * self.count + first..(j + 1) * self.count])
    }
}

/// The sum at one node, along `j`.
struct Sum {
    weight: f64,
    /// `I_nu(q) K_nu(q)` at `j`, and what takes `I_nu` from there to the next `j` and `K_nu` along.
    products: Vec<f64>,
    ratios: Vec<f64>,
    /// The sums over `i < j`, for each function.
    carried: Vec<f64>,
}

impl Sum {
    fn new(harmonic: u32, q: f64, weight: f64, rows: &Rows) -> Self {
        let square = q * q;
        let mut quotients = vec![0.0; harmonic as usize + 2 * rows.order + 1];
        inner_quotients(square, &mut quotients);
        let mut diagonal = Diagonal::new(q, harmonic, &quotients);
        let l = |j: usize| harmonic as usize + 2 * j;
        let products = (0..rows.order).map(|j| diagonal.at(l(j))).collect();
        let ratio = |j: usize| square * quotients[l(j)] * quotients[l(j) + 1];
        let ratios = (0..rows.order).map(ratio).collect();
        Self { weight, products, ratios, carried: vec![0.0; rows.count] }
    }

    /// Adds the terms of `j` for the functions from `first` on.
    fn add(&mut self, j: usize, row: &[f64], first: usize, sums: &mut [f64]) {
        let (product, ratio) = (self.products[j], self.ratios[j]);
        let running = sums[first..].iter_mut().zip(&mut self.carried[first..]).zip(row);
        for ((sum, carried), entry) in running {
            let own = product * entry;
            *sum += self.weight * entry * (own + 2.0 * *carried);
            *carried = ratio * (*carried + own);
        }
    }
}

/// The products `I_nu(q) K_nu(q) = 1/(q k + q i)`, `nu = l + 1/2`, with the quotients `k = K_(nu+1)/K_nu` upwards and `i = I_(nu+1)/I_nu`; `1/(2 nu)` at `q = 0`.
struct Diagonal<'q> {
    square: f64,
    inner: &'q [f64],
    /// `q K_(nu+1)/K_nu` at `l`.
    outer: f64,
    l: usize,
}

impl<'q> Diagonal<'q> {
    fn new(argument: f64, harmonic: u32, inner: &'q [f64]) -> Self {
        let mut diagonal = Self { square: argument * argument, inner, outer: argument + 1.0, l: 0 };
        diagonal.rise(harmonic as usize);
        diagonal
    }

    fn rise(&mut self, l: usize) {
        while self.l < l {
            self.l += 1;
            self.outer = (2 * self.l + 1) as f64 + self.square / self.outer;
        }
    }

    fn at(&mut self, l: usize) -> f64 {
        self.rise(l);
        1.0 / (self.outer + self.square * self.inner[l])
    }
}

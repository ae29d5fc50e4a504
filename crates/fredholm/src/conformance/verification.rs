//! The spectral relation against quadrature.

use super::Report;
use super::bilinear::bilinear_error;
use crate::Error;
use crate::kernel::{Parity, SpectralRelation};
use crate::quadrature::panels::{kernel_rule, panel, tail, weighted};

/// Where the relation (1.2) is checked, as shares of the extent.
const PLACES: [f64; 4] = [0.02, 0.31, 0.58, 0.93];
/// Indices checked, beside the last.
const INDICES: [usize; 9] = [0, 1, 2, 3, 5, 10, 21, 60, 130];

/// Rounds with half as many nodes again.
const ROUNDS: usize = 5;
/// An error that needs no more of them.
const SMALL: f64 = 1e-13;

/// The worst error of each part of a spectral relation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Verification {
    /// Of `int K phi_n w dm - lambda_n phi_n`, (1.2), over the largest eigenvalue and the largest value of `phi_n`.
    pub relation: f64,
    /// Of `int phi_n phi_m w dm`, `n != m`, (1.3), over the root of the norms.
    pub orthogonality: f64,
    /// Of `int phi_n^2 w dm / h_n - 1`.
    pub norms: f64,
    /// Of the bilinear sum (1.5) off the diagonal, summed with a smooth cutoff, over the largest of the values compared and one near the diagonal. It takes several hundred terms to make it small.
    pub bilinear_sum: f64,
    /// Of the entries `R_km` of the Gram matrix, over `sqrt(R_kk R_mm)`.
    pub gram: f64,
    /// Terms that were summed in the bilinear sum.
    pub terms: usize,
}

impl Verification {
    /// The checks with a common limit; that of the bilinear sum is a thousand times as large, since its truncation counts.
    #[must_use]
    pub fn report(&self, limit: f64) -> Report {
        let mut report = Report::default();
        report.add("relation", self.relation, limit);
        report.add("orthogonality", self.orthogonality, limit);
        report.add("norms", self.norms, limit);
        report.add("Gram matrix", self.gram, limit);
        report.add("bilinear sum", self.bilinear_sum, 1e3 * limit);
        report
    }
}

/// Verifies the spectral relation for a sample of `phi_0 .. phi_{count-1}`, the last among them, by double-exponential quadrature.
///
/// Cost: some thousands of values of the kernel, more for many eigenfunctions.
///
/// # Errors
/// [`Error::TooFew`] for more eigenfunctions than can be had, [`Error::InvalidParameter`] for none; those of [`SpectralRelation::gram`].
pub fn verify(relation: &dyn SpectralRelation, count: usize) -> Result<Verification, Error> {
    if count == 0 {
        return Err(Error::InvalidParameter {
            name: "count",
            value: 0.0,
            requirement: "at least 1",
        });
    }
    if count > relation.available() {
        return Err(Error::TooFew { needed: count, available: relation.available() });
    }
    let mut indices: Vec<usize> = INDICES.iter().copied().filter(|n| *n < count - 1).collect();
    indices.push(count - 1);
    let (bilinear_sum, terms) = bilinear_error(relation);
    let mut half_count = 60 + 2 * count;
    let at = |half_count| by_quadrature(relation, &indices, count, half_count);
    let mut best = at(half_count)?;
    for _ in 0..ROUNDS {
        if best.iter().all(|error| *error <= SMALL) {
            break;
        }
        half_count += half_count / 2;
        // More nodes mend the quadrature, never the relation.
        best.iter_mut().zip(at(half_count)?).for_each(|(error, new)| {
            if error.is_nan() || new < *error {
                *error = new;
            }
        });
    }
    let [relation, orthogonality, norms, gram] = best;
    Ok(Verification { relation, orthogonality, norms, bilinear_sum, gram, terms })
}

/// Errors of the relation, orthogonality, norms and Gram matrix by a rule of so many nodes.
fn by_quadrature(
    relation: &dyn SpectralRelation,
    indices: &[usize],
    count: usize,
    half_count: usize,
) -> Result<[f64; 4], Error> {
    let products = Products::new(relation, indices, half_count);
    Ok([
        relation_error(relation, indices, count, half_count),
        products.orthogonality(relation),
        products.norms(relation),
        products.gram_error(relation, count)?,
    ])
}

fn largest_eigenvalue(relation: &dyn SpectralRelation, count: usize) -> f64 {
    (0..count).map(|n| relation.eigenvalue(n).abs()).fold(0.0, f64::max)
}

fn relation_error(
    relation: &dyn SpectralRelation,
    indices: &[usize],
    count: usize,
    half_count: usize,
) -> f64 {
    let extent = relation.extent();
    let places = PLACES.map(|share| extent.left() + share * 2.0 * extent.half_length());
    let largest = largest_eigenvalue(relation, count);
    let sizes = sizes(relation, count);
    let mut phi = vec![0.0; count];
    let mut worst = 0.0f64;
    for x in places {
        let mut integrals = vec![0.0; indices.len()];
        for (s, weight) in kernel_rule(relation, relation.weight_exponents(), x, half_count) {
            if weight == 0.0 {
                continue;
            }
            relation.eigenfunctions(s, &mut phi);
            for (integral, &n) in integrals.iter_mut().zip(indices) {
                *integral += weight * relation.weight_rest(n, s) * phi[n];
            }
        }
        relation.eigenfunctions(x, &mut phi);
        for (integral, &n) in integrals.iter().zip(indices) {
            let error = (integral - relation.eigenvalue(n) * phi[n]).abs();
            worst = maximum(worst, error / (largest * sizes[n]));
        }
    }
    worst
}

/// The largest values of the eigenfunctions met on the extent.
fn sizes(relation: &dyn SpectralRelation, count: usize) -> Vec<f64> {
    let extent = relation.extent();
    let mut sizes = vec![0.0f64; count];
    let mut phi = vec![0.0; count];
    for i in 0..=64 {
        let x = extent.left() + f64::from(i) / 64.0 * (extent.right() - extent.left());
        relation.eigenfunctions(x, &mut phi);
        sizes.iter_mut().zip(&phi).for_each(|(size, phi)| *size = size.max(phi.abs()));
    }
    sizes
}

/// Keeps NaN, which `f64::max` would drop.
pub(super) fn maximum(one: f64, other: f64) -> f64 {
    if other.is_nan() || other > one { other } else { one }
}

/// Integrals of the products of two eigenfunctions, with and without the weight.
struct Products {
    indices: Vec<usize>,
    weighted: Vec<f64>,
    plain: Vec<f64>,
}

impl Products {
    fn new(relation: &dyn SpectralRelation, indices: &[usize], half_count: usize) -> Self {
        let count = indices.len();
        let most = indices.iter().max().map_or(0, |most| most + 1);
        let mut phi = vec![0.0; most];
        let (mut with, mut plain) = (vec![0.0; count * count], vec![0.0; count * count]);
        for (x, weight) in weighted(relation, half_count) {
            if weight == 0.0 {
                continue;
            }
            relation.eigenfunctions(x, &mut phi);
            let density = weight * relation.measure(x);
            for (i, &n) in indices.iter().enumerate() {
                let term = density * relation.weight_rest(n, x) * phi[n];
                with[i * count..(i + 1) * count]
                    .iter_mut()
                    .zip(indices)
                    .for_each(|(sum, &m)| *sum += term * phi[m]);
            }
        }
        for (x, weight) in plain_rule(relation, half_count) {
            if weight == 0.0 {
                continue;
            }
            relation.eigenfunctions(x, &mut phi);
            let density = weight * relation.measure(x);
            for (i, &n) in indices.iter().enumerate() {
                let term = density * phi[n];
                plain[i * count..(i + 1) * count]
                    .iter_mut()
                    .zip(indices)
                    .for_each(|(sum, &m)| *sum += term * phi[m]);
            }
        }
        Self { indices: indices.to_vec(), weighted: with, plain }
    }

    fn pairs(&self) -> impl Iterator<Item = (usize, usize, usize)> + '_ {
        let count = self.indices.len();
        (0..count * count).map(move |i| (self.indices[i / count], self.indices[i % count], i))
    }

    fn orthogonality(&self, relation: &dyn SpectralRelation) -> f64 {
        self.pairs().filter(|(n, m, _)| n != m).fold(0.0, |worst, (n, m, i)| {
            let size = (relation.norm(n) * relation.norm(m)).sqrt();
            // With two weights by parity the products across parities are odd.
            maximum(worst, self.weighted[i].abs() / size)
        })
    }

    fn norms(&self, relation: &dyn SpectralRelation) -> f64 {
        self.pairs().filter(|(n, m, _)| n == m).fold(0.0, |worst, (n, _, i)| {
            maximum(worst, (self.weighted[i] / relation.norm(n) - 1.0).abs())
        })
    }

    fn gram_error(&self, relation: &dyn SpectralRelation, count: usize) -> Result<f64, Error> {
        let gram = relation.gram(count)?;
        let entry = |k: usize, m: usize| {
            let apart = relation.parity() == Parity::Alternating && (k + m) % 2 == 1;
            if apart { 0.0 } else { gram.entry(k, m) }
        };
        Ok(self.pairs().fold(0.0, |worst, (k, m, i)| {
            let size = (entry(k, k) * entry(m, m)).sqrt();
            maximum(worst, (self.plain[i] - entry(k, m)).abs() / size)
        }))
    }
}

/// The rule for `int_L g dx`, without the weight.
fn plain_rule(relation: &dyn SpectralRelation, half_count: usize) -> Vec<(f64, f64)> {
    let interval = relation.interval();
    let middle = relation.extent().centre();
    let rule =
        |start: f64| panel(start, middle, 0.0, half_count).map(|node| (node.position, node.weight));
    let mut nodes: Vec<(f64, f64)> = rule(interval.left()).collect();
    if interval.is_finite() {
        nodes.extend(rule(interval.right()));
    } else {
        let scale = relation.extent().half_length();
        nodes.extend(tail(middle, scale, half_count));
    }
    nodes
}

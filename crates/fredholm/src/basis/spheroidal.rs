//! Angular prolate spheroidal functions of even degree difference.

use super::legendre::{LegendreBasis, square_of_height};
use crate::linear::{SymmetricTridiagonal, VECTORS};
use crate::{Error, memory};

/// The inverse of the size at which coefficients are cut off.
const CUT_OFF: f64 = 2e17;

/// The functions `S_0 .. S_{count-1}`: the bounded even solutions, with `n` zeros in `(0, 1)`, of
///
/// `((1 - eta^2) S')' + [Lambda - kappa^2 eta^2 - m^2/(1 - eta^2)] S = 0`,
///
/// with `int_0^1 S_n S_k d eta = delta_nk` and the sign `S_n(0) = (-1)^n`: `S_n` is proportional to `Ps^m_{m+2n}(eta, kappa^2)` of DLMF 30.4, `Lambda_n` is `lambda + kappa^2` of DLMF 30.3.
///
/// In the [`LegendreBasis`] the equation is a tridiagonal eigenvalue problem, `l (l + 1) + kappa^2 eta^2`, `l = m + 2j`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Spheroidal {
    basis: LegendreBasis,
    separation: Vec<f64>,
    /// `S_n = sum_j coefficients[n order + j] e_j`.
    coefficients: Vec<f64>,
}

impl Spheroidal {
    /// The first `count` functions for `kappa >= 0`.
    ///
    /// Cost: `60 count order` divisions; `order` is the number of basis functions, `count + 30` for small `kappa`, about `sqrt(kappa count) + 3 sqrt(kappa)` where `kappa` is larger than `count`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for no functions, [`Error::TooLarge`] beyond memory.
    pub(crate) fn new(harmonic: u32, kappa: f64, count: usize) -> Result<Self, Error> {
        if count == 0 {
            return Err(Error::InvalidParameter {
                name: "count",
                value: 0.0,
                requirement: "at least 1",
            });
        }
        let generous = count as f64 + 24.0 + 0.6 * kappa + 4.0 * kappa.sqrt();
        memory::admit(count, 32.0 * count as f64 * generous)?;
        let matrix = matrix(harmonic, kappa, generous as usize);
        let highest = matrix.eigenvalues(count - 1..count).into_iter().fold(0.0, f64::max);
        let order = sufficient_order(harmonic, kappa, highest, matrix.order()).max(count + 2);
        let matrix = matrix.truncated(order);
        let separation = matrix.eigenvalues(0..count);
        let strengths = super::legendre::strengths(harmonic, order);
        let mut coefficients = vec![0.0; count * order];
        let rows = coefficients.chunks_mut(VECTORS * order);
        for ((group, values), rows) in separation.chunks(VECTORS).enumerate().zip(rows) {
            // The lower functions have fewer coefficients; the rest of their rows stays untouched.
            let highest = values.iter().fold(0.0, |most: f64, value| most.max(*value));
            let enough = sufficient_order(harmonic, kappa, highest, order);
            let enough = enough.max(VECTORS * (group + 1) + 2).min(order);
            matrix.eigenvectors(values, enough, rows.chunks_exact_mut(order));
            for (n, row) in (VECTORS * group..).zip(rows.chunks_exact_mut(order)) {
                orient(n, &mut row[..enough], &strengths);
            }
        }
        Ok(Self { basis: LegendreBasis::new(harmonic, order), separation, coefficients })
    }

    /// Number of functions.
    pub(crate) fn count(&self) -> usize {
        self.separation.len()
    }

    /// Number of basis functions.
    pub(crate) fn order(&self) -> usize {
        self.basis.order()
    }

    pub(crate) fn basis(&self) -> &LegendreBasis {
        &self.basis
    }

    /// `Lambda_n`.
    pub(crate) fn separation(&self) -> &[f64] {
        &self.separation
    }

    /// The coefficients of `S_n` in the basis.
    pub(crate) fn coefficients(&self, n: usize) -> &[f64] {
        &self.coefficients[n * self.order()..(n + 1) * self.order()]
    }

    /// The coefficients in the basis of `sum_n weights[n] S_n`.
    pub(crate) fn combine(&self, weights: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; self.order()];
        for (weight, row) in weights.iter().zip(self.coefficients.chunks_exact(self.order())) {
            sum.iter_mut().zip(row).for_each(|(sum, entry)| *sum += weight * entry);
        }
        sum
    }

    /// `sum_j c_j d_j^{(n)}` for every `n`: products with the functions from products with the basis.
    pub(crate) fn project(&self, products: &[f64]) -> Vec<f64> {
        let row = |row: &[f64]| row.iter().zip(products).map(|(d, c)| d * c).sum();
        self.coefficients.chunks_exact(self.order()).map(row).collect()
    }
}

fn matrix(harmonic: u32, kappa: f64, order: usize) -> SymmetricTridiagonal {
    let square = kappa * kappa;
    let diagonal = |j: usize| {
        let l = f64::from(harmonic) + 2.0 * j as f64;
        l * (l + 1.0) + square * square_of_height(harmonic, j).0
    };
    let beside = |j: usize| square * square_of_height(harmonic, j).1;
    SymmetricTridiagonal::new(
        (0..order).map(diagonal).collect(),
        (0..order.saturating_sub(1)).map(beside).collect(),
    )
}

/// How many basis functions the highest function needs: beyond the turning point its coefficients fall by the larger root of `b r^2 - (T_jj - Lambda) r + b = 0` from one to the next.
fn sufficient_order(harmonic: u32, kappa: f64, highest: f64, most: usize) -> usize {
    let mut fallen = 1.0;
    for j in 0..most {
        let l = f64::from(harmonic) + 2.0 * j as f64;
        let (height, beside) = square_of_height(harmonic, j);
        let gap = 0.5 * (l * (l + 1.0) + kappa * kappa * height - highest);
        let beside = kappa * kappa * beside;
        if gap > beside {
            fallen *= (gap + ((gap - beside) * (gap + beside)).sqrt()) / beside;
        }
        if fallen > CUT_OFF {
            return j + 2;
        }
    }
    most
}

/// Gives `S_n(0)`, the sum of `(-1)^j d_j` with the strengths of the basis, the sign `(-1)^n`.
fn orient(n: usize, vector: &mut [f64], strengths: &[f64]) {
    let at_equator: f64 = (vector.iter().zip(strengths).enumerate())
        .map(|(j, (d, c))| if j.is_multiple_of(2) { d * c } else { -d * c })
        .sum();
    if (at_equator < 0.0) == n.is_multiple_of(2) {
        vector.iter_mut().for_each(|d| *d = -*d);
    }
}

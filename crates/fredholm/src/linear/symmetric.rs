//! Symmetric systems and eigenvalue problems.

use std::ops::Deref;

use faer::{MatRef, Side};

use super::dense::multiply_rows;
use super::{Cholesky, Elimination, dot, small_cholesky, vectorised};
use crate::Error;

/// Up to this order our own factorisation is faster than the library (order 51: 6 against 12 us; order 101: slower).
const SMALL: usize = 80;
/// A positive definite matrix `1 + lambda K` with a pivot below this is looked at for being singular.
const SUSPICIOUS_PIVOT: f64 = 0.5;
/// An eigenvalue below this share of the largest counts as zero.
const ZERO: f64 = 1e-13;
/// Steps of the inverse iteration that finds the smallest eigenvalue; its magnitude is all that matters.
const STEPS: usize = 4;

/// A factored symmetric matrix `1 + lambda S`.
#[derive(Debug, Clone)]
pub(crate) enum Factored {
    Small { order: usize, factor: Vec<f64> },
    Large(Cholesky),
    Indefinite(Elimination),
}

impl Factored {
    /// Factors `1 + parameter S` for `S` with all its entries stored: by Cholesky where it is positive definite,
    /// otherwise by elimination with pivots.
    pub(crate) fn shifted(matrix: &[f64], order: usize, parameter: f64) -> Result<Self, Error> {
        let column = |j: usize, target: &mut [f64]| {
            let source = &matrix[j * order + j..(j + 1) * order];
            target.iter_mut().zip(source).for_each(|(target, entry)| *target = parameter * entry);
        };
        match Self::positive(order, column) {
            Some((factored, pivot)) if pivot >= SUSPICIOUS_PIVOT => Ok(factored),
            _ => Self::indefinite(matrix, order, parameter),
        }
    }

    /// The same of `1 + parameter R S R` with the diagonal matrix `R` of these entries; of `S` the columns are asked for, from the diagonal on, and all of it only where it is not positive.
    pub(crate) fn weighted<M: Deref<Target = [f64]>>(
        entries: impl Fn(usize, &mut [f64]),
        whole: impl FnOnce() -> M,
        roots: &[f64],
        parameter: f64,
    ) -> Result<Self, Error> {
        let order = roots.len();
        let column = |j: usize, target: &mut [f64]| {
            entries(j, target);
            for (entry, root) in target.iter_mut().zip(&roots[j..]) {
                *entry = parameter * (*entry * (roots[j] * root));
            }
        };
        match Self::positive(order, column) {
            Some((factored, pivot)) if pivot >= SUSPICIOUS_PIVOT => Ok(factored),
            _ => {
                let mut weighted = whole().to_vec();
                for (row, root) in weighted.chunks_exact_mut(order).zip(roots) {
                    row.iter_mut().zip(roots).for_each(|(entry, column)| *entry *= root * column);
                }
                Self::indefinite(&weighted, order, parameter)
            }
        }
    }

    /// The Cholesky factor of one and the matrix with these columns, from the diagonal on, and its smallest pivot.
    fn positive(order: usize, column: impl Fn(usize, &mut [f64])) -> Option<(Self, f64)> {
        let shifted = |j: usize, target: &mut [f64]| {
            column(j, target);
            target[0] += 1.0;
        };
        if order > SMALL {
            let cholesky = Cholesky::of_columns(order, shifted).ok()?;
            let pivot = cholesky.smallest_pivot();
            return Some((Self::Large(cholesky), pivot));
        }
        let mut factor = vec![0.0; order * order];
        for (j, target) in factor.chunks_exact_mut(order).enumerate() {
            shifted(j, &mut target[j..]);
        }
        small_cholesky::factor(&mut factor, order).ok()?;
        let pivot = factor.iter().step_by(order + 1).fold(f64::INFINITY, |least, &l| least.min(l));
        Some((Self::Small { order, factor }, pivot * pivot))
    }

    /// Factors `1 + parameter S` by elimination with pivots, for `S` by columns, symmetric or not.
    pub(crate) fn indefinite(matrix: &[f64], order: usize, parameter: f64) -> Result<Self, Error> {
        let shifted =
            |i: usize, j: usize| f64::from(u8::from(i == j)) + parameter * matrix[j * order + i];
        let factored = Self::Indefinite(Elimination::new(order, shifted));
        let largest = (0..order)
            .map(|i| (0..order).map(|j| shifted(i, j).abs()).sum::<f64>())
            .fold(0.0, f64::max);
        let smallest = factored.smallest_eigenvalue(order);
        if smallest > ZERO * largest {
            Ok(factored)
        } else {
            Err(Error::Singular { parameter, smallest })
        }
    }

    /// Magnitude of the smallest eigenvalue, by inverse iteration; 0 for an exactly singular or not finite matrix.
    fn smallest_eigenvalue(&self, order: usize) -> f64 {
        // Irrational turns of a circle: a start with a share of every eigenvector.
        let mut vector: Vec<f64> =
            (1..=order).map(|i| (i as f64 * 2.399_963_229_728_653).sin() + 0.1).collect();
        let mut smallest = 0.0;
        for _ in 0..STEPS {
            let before = norm(&vector);
            vector.iter_mut().for_each(|value| *value /= before);
            self.solve(&mut vector);
            let after = norm(&vector);
            if !after.is_finite() {
                return 0.0;
            }
            smallest = 1.0 / after;
        }
        smallest
    }

    /// Whether Cholesky served.
    pub(crate) fn is_positive(&self) -> bool {
        !matches!(self, Self::Indefinite(_))
    }

    /// Overwrites `right` with the solution.
    pub(crate) fn solve(&self, right: &mut [f64]) {
        match self {
            Self::Small { order, factor } => small_cholesky::solve(factor, *order, right),
            Self::Large(cholesky) => cholesky.solve(right),
            Self::Indefinite(elimination) => elimination.solve(right),
        }
    }
}

fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|value| value * value).sum::<f64>().sqrt()
}

/// `S = V diag(values) V^T`, eigenvalues ascending, eigenvectors as the columns of `V`, one after the other.
#[derive(Debug, Clone)]
pub(crate) struct Eigensystem {
    pub(crate) values: Vec<f64>,
    pub(crate) vectors: Vec<f64>,
}

impl Eigensystem {
    pub(crate) fn new(matrix: &[f64], order: usize) -> Result<Self, Error> {
        let decomposition = MatRef::from_column_major_slice(matrix, order, order)
            .self_adjoint_eigen(Side::Lower)
            .map_err(|_| Error::EigenvaluesNotFound { order })?;
        let values = (0..order).map(|k| decomposition.S()[k]).collect();
        let vectors = (0..order)
            .flat_map(|k| (0..order).map(move |i| (i, k)))
            .map(|place| decomposition.U()[place])
            .collect::<Vec<f64>>();
        // The library's products leave the upper halves of the vector registers in use, and on some processors all scalar operations of the thread then take up to 30 times as long, until
        // a vectorised function of the compiler has ended.
        let length = vectorised(
            #[inline(always)]
            || dot(&vectors, &vectors),
        );
        if !length.is_finite() {
            return Err(Error::EigenvaluesNotFound { order });
        }
        Ok(Self { values, vectors })
    }

    /// `V^T x`.
    pub(crate) fn coefficients(&self, x: &[f64]) -> Vec<f64> {
        multiply_rows(&self.vectors, x)
    }

    /// `V c`.
    pub(crate) fn combine(&self, coefficients: &[f64]) -> Vec<f64> {
        let order = self.values.len();
        let mut sum = vec![0.0; order];
        for (column, coefficient) in self.vectors.chunks_exact(order.max(1)).zip(coefficients) {
            super::dense::subtract_column(&mut sum, column, -coefficient);
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_without_symmetry_are_undone_whatever_their_pivots() {
        for order in [1, 2, 3, 4, 5, 8, 9, 23, 40, 130] {
            // Zeros on the diagonal of 1 + S, but for the last entry.
            let entry = |i: usize, j: usize| match i == j {
                true => f64::from(u8::from(i + 1 == order)) - 1.0,
                false => ((3 * i + 5 * j) as f64).sin() + 2.0 * f64::from(u8::from(i == j + 1)),
            };
            let columns: Vec<f64> =
                (0..order * order).map(|k| entry(k % order, k / order)).collect();
            let exact: Vec<f64> = (0..order).map(|i| (i as f64).cos()).collect();
            let mut right: Vec<f64> = (0..order)
                .map(|i| exact[i] + (0..order).map(|j| entry(i, j) * exact[j]).sum::<f64>())
                .collect();
            Factored::indefinite(&columns, order, 1.0).unwrap().solve(&mut right);
            for (found, exact) in right.iter().zip(&exact) {
                assert!((found - exact).abs() < 1e-11, "{order}: {found} {exact}");
            }
        }
    }
}

//! Products with dense matrices, written so that the compiler vectorises them without reordering sums by chance.

use super::vector::dot;
use super::vectorised::vectorised;

/// Columns taken at once.
pub(super) const COLUMNS: usize = 4;

/// `target -= sum_k factors[k] columns[k]` for four columns.
#[inline(always)]
pub(crate) fn subtract_columns(target: &mut [f64], columns: [&[f64]; COLUMNS], factors: [f64; 4]) {
    let length = target.len();
    let [c0, c1, c2, c3] = columns.map(|column| &column[..length]);
    let [f0, f1, f2, f3] = factors;
    for i in 0..length {
        target[i] -= (f0 * c0[i] + f1 * c1[i]) + (f2 * c2[i] + f3 * c3[i]);
    }
}

/// `target -= factor column`.
#[inline(always)]
pub(crate) fn subtract_column(target: &mut [f64], column: &[f64], factor: f64) {
    for (target, value) in target.iter_mut().zip(column) {
        *target -= factor * value;
    }
}

/// The scalar products of the rows of a square matrix with `x`.
pub(crate) fn multiply_rows(matrix: &[f64], x: &[f64]) -> Vec<f64> {
    let rows = matrix.chunks_exact(x.len().max(1));
    let mut products = vec![0.0; rows.len()];
    vectorised(
        #[inline(always)]
        || {
            for (product, row) in products.iter_mut().zip(rows) {
                *product = dot(row, x);
            }
        },
    );
    products
}

//! Cholesky factorisation where a library's overhead would exceed the work.

use super::dense::{subtract_column, subtract_columns};
use super::substitution::substitute;
use super::vectorised::vectorised;

/// Overwrites the lower triangle of the matrix, column by column, with `L` of `A = L L^T`.
///
/// Column `j` takes the updates of the finished columns four at a time, so that it is read and written a quarter as often.
/// Gives the index of the pivot that is not positive.
pub(crate) fn factor(matrix: &mut [f64], order: usize) -> Result<(), usize> {
    vectorised(
        #[inline(always)]
        || factor_columns(matrix, order),
    )
}

#[inline(always)]
fn factor_columns(matrix: &mut [f64], order: usize) -> Result<(), usize> {
    for j in 0..order {
        let (done, rest) = matrix.split_at_mut(j * order);
        let column = &mut rest[j..order];
        let part = |k: usize| &done[k * order + j..(k + 1) * order];
        let mut k = 0;
        while k + 4 <= j {
            let columns = [part(k), part(k + 1), part(k + 2), part(k + 3)];
            subtract_columns(column, columns, columns.map(|column| column[0]));
            k += 4;
        }
        while k < j {
            subtract_column(column, part(k), part(k)[0]);
            k += 1;
        }
        let pivot = column[0];
        if !(pivot > 0.0 && pivot.is_finite()) {
            return Err(j);
        }
        let root = pivot.sqrt();
        let inverse = 1.0 / root;
        column[0] = root;
        column[1..].iter_mut().for_each(|value| *value *= inverse);
    }
    Ok(())
}

/// Overwrites `right` with `A^{-1} right`.
pub(crate) fn solve(factor: &[f64], order: usize, right: &mut [f64]) {
    substitute(|j| &factor[j * order + j..(j + 1) * order], order, right);
}

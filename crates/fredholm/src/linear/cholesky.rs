//! Cholesky factorisation of a symmetric positive definite matrix.

use faer::Par;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{LltError, cholesky_in_place, cholesky_in_place_scratch};

use super::columns::Columns;
use super::substitution::substitute;
use crate::Error;

/// `A = L L^T`, kept in the storage of `A`.
#[derive(Debug, Clone)]
pub(crate) struct Cholesky {
    factor: Columns,
}

impl Cholesky {
    /// Factors the symmetric matrix of this order whose lower triangle is given entry by entry.
    pub(crate) fn new(
        order: usize,
        mut entry: impl FnMut(usize, usize) -> f64,
    ) -> Result<Self, Error> {
        Self::of_columns(order, |column, entries| {
            entries.iter_mut().zip(column..).for_each(|(target, row)| *target = entry(row, column));
        })
    }

    /// The same with the columns of the lower triangle, each from the diagonal on.
    pub(crate) fn of_columns(
        order: usize,
        mut column: impl FnMut(usize, &mut [f64]),
    ) -> Result<Self, Error> {
        let mut matrix = Columns::zeros(order);
        for j in 0..order {
            column(j, &mut matrix.column_mut(j)[j..]);
        }
        let scratch = cholesky_in_place_scratch::<f64>(order, Par::Seq, Default::default());
        let mut buffer = MemBuffer::new(scratch);
        cholesky_in_place(
            matrix.as_library(),
            Default::default(),
            Par::Seq,
            MemStack::new(&mut buffer),
            Default::default(),
        )
        .map_err(|LltError::NonPositivePivot { index }| Error::NotPositiveDefinite {
            order,
            pivot: index,
        })?;
        Ok(Self { factor: matrix })
    }

    /// Order of the matrix.
    pub(crate) fn order(&self) -> usize {
        self.factor.order()
    }

    /// The smallest pivot.
    pub(crate) fn smallest_pivot(&self) -> f64 {
        (0..self.order()).map(|i| self.factor.column(i)[i].powi(2)).fold(f64::INFINITY, f64::min)
    }

    /// Overwrites `right` with `A^{-1} right`.
    pub(crate) fn solve(&self, right: &mut [f64]) {
        substitute(|j| &self.factor.column(j)[j..], self.order(), right);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_a_moment_matrix() {
        // Hilbert matrix of order 4 plus the identity, against the residual.
        let entry = |i: usize, j: usize| 1.0 / (i + j + 1) as f64 + f64::from(u8::from(i == j));
        let exact = [1.0, -2.0, 3.0, 0.5];
        let mut right: Vec<f64> =
            (0..4).map(|i| (0..4).map(|j| entry(i, j) * exact[j]).sum()).collect();
        Cholesky::new(4, entry).unwrap().solve(&mut right);
        for (found, exact) in right.iter().zip(exact) {
            assert!((found - exact).abs() < 1e-14);
        }
    }

    #[test]
    fn refuses_an_indefinite_matrix() {
        let error = Cholesky::new(2, |i, j| if i == j { 1.0 } else { 2.0 }).unwrap_err();
        assert_eq!(error, Error::NotPositiveDefinite { order: 2, pivot: 1 });
    }
}

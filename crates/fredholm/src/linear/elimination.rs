//! Elimination with pivots, for matrices without any structure.

use faer::Par;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::factor::{lu_in_place, lu_in_place_scratch};

use super::columns::Columns;
use super::substitution::eliminate;

/// `L U`, the rows in the order of the pivots; `L` has ones on its diagonal, and both share a matrix.
#[derive(Debug, Clone)]
pub(crate) struct Elimination {
    factors: Columns,
    pivots: Vec<usize>,
}

impl Elimination {
    /// Factors the matrix of this order that is given entry by entry. Of a singular one the solutions are not finite.
    pub(crate) fn new(order: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let mut factors = Columns::zeros(order);
        for j in 0..order {
            let column = factors.column_mut(j);
            column.iter_mut().enumerate().for_each(|(i, target)| *target = entry(i, j));
        }
        let mut pivots = vec![0; order];
        let mut inverse = vec![0; order];
        let scratch = lu_in_place_scratch::<usize, f64>(order, order, Par::Seq, Default::default());
        lu_in_place(
            factors.as_library(),
            &mut pivots,
            &mut inverse,
            Par::Seq,
            MemStack::new(&mut MemBuffer::new(scratch)),
            Default::default(),
        );
        Self { factors, pivots }
    }

    /// Overwrites `right` with the solution. The method of the library underneath is made for many right-hand sides.
    pub(crate) fn solve(&self, right: &mut [f64]) {
        let given = right.to_vec();
        for (entry, pivot) in right.iter_mut().zip(&self.pivots) {
            *entry = given[*pivot];
        }
        eliminate(|j| self.factors.column(j), right);
    }
}

//! Symmetric matrices whose rows begin late: bands, and what they become where nodes crowd.

use super::dot;
use crate::Error;

/// A pivot below this counts as zero.
const VANISHING: f64 = 1e-13;

/// The lower triangle of a symmetric matrix, each row from its first entry that is not zero to the diagonal. The first
/// columns must not decrease from row to row.
#[derive(Debug, Clone)]
pub(crate) struct Skyline {
    /// First column of each row.
    firsts: Vec<usize>,
    /// Where each row starts among the entries, and their end.
    starts: Vec<usize>,
    entries: Vec<f64>,
}

impl Skyline {
    /// The zero matrix with rows that begin at these columns, none right of the diagonal.
    pub(crate) fn zeros(firsts: Vec<usize>) -> Self {
        let mut starts = Vec::with_capacity(firsts.len() + 1);
        let mut total = 0;
        for (row, &first) in firsts.iter().enumerate() {
            starts.push(total);
            total += row + 1 - first.min(row);
        }
        starts.push(total);
        Self { firsts, starts, entries: vec![0.0; total] }
    }

    pub(crate) fn order(&self) -> usize {
        self.firsts.len()
    }

    /// First column of a row and its entries up to the diagonal.
    pub(crate) fn row(&self, row: usize) -> (usize, &[f64]) {
        (self.firsts[row], &self.entries[self.starts[row]..self.starts[row + 1]])
    }

    /// The same to be filled.
    pub(crate) fn row_mut(&mut self, row: usize) -> (usize, &mut [f64]) {
        (self.firsts[row], &mut self.entries[self.starts[row]..self.starts[row + 1]])
    }

    /// The product with a vector.
    pub(crate) fn multiply(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; self.order()];
        for i in 0..self.order() {
            let (first, entries) = self.row(i);
            let (below, diagonal) = entries.split_at(entries.len() - 1);
            for (target, entry) in product[first..i].iter_mut().zip(below) {
                *target += entry * x[i];
            }
            product[i] += dot(below, &x[first..i]) + diagonal[0] * x[i];
        }
        product
    }

    /// `1 + parameter` times the matrix as `L D L^T`, which has the same zeros. Meant for matrices that are positive definite, or would be but for a
    /// few eigenvalues that an approximation made slightly negative: there are no exchanges of rows.
    ///
    /// # Errors
    /// [`Error::Singular`] when a pivot vanishes.
    pub(crate) fn factor_shifted(&self, parameter: f64) -> Result<SkylineFactor, Error> {
        let mut factor = self.clone();
        let mut pivots = Vec::with_capacity(self.order());
        factor.entries.iter_mut().for_each(|entry| *entry *= parameter);
        for i in 0..self.order() {
            let (done, rest) = factor.entries.split_at_mut(factor.starts[i]);
            let first = factor.firsts[i];
            let (row, diagonal) = rest[..=i - first].split_at_mut(i - first);
            // L_ij D_j, from left to right.
            for j in first..i {
                // Firsts do not decrease, so that row j begins no later than row i.
                let row_j = &done[factor.starts[j]..factor.starts[j + 1]];
                let shared = &row_j[first - factor.firsts[j]..j - factor.firsts[j]];
                row[j - first] -= dot(&row[..j - first], shared);
            }
            let mut pivot = 1.0 + diagonal[0];
            for (entry, other) in row.iter_mut().zip(&pivots[first..]) {
                let scaled = *entry / other;
                pivot -= scaled * *entry;
                *entry = scaled;
            }
            if !(pivot.abs() > VANISHING && pivot.is_finite()) {
                return Err(Error::Singular { parameter, smallest: pivot });
            }
            pivots.push(pivot);
        }
        Ok(SkylineFactor { factor, pivots })
    }
}

/// `1 + parameter A = L D L^T`.
#[derive(Debug, Clone)]
pub(crate) struct SkylineFactor {
    factor: Skyline,
    pivots: Vec<f64>,
}

impl SkylineFactor {
    /// Overwrites `right` with the solution.
    pub(crate) fn solve(&self, right: &mut [f64]) {
        for i in 0..self.factor.order() {
            let (first, entries) = self.factor.row(i);
            right[i] -= dot(&entries[..i - first], &right[first..i]);
        }
        right.iter_mut().zip(&self.pivots).for_each(|(value, pivot)| *value /= pivot);
        for i in (0..self.factor.order()).rev() {
            let (first, entries) = self.factor.row(i);
            let value = right[i];
            for (target, entry) in right[first..i].iter_mut().zip(&entries[..i - first]) {
                *target -= entry * value;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_against_the_residual() {
        let firsts: Vec<usize> =
            (0..40usize).map(|i| i.saturating_sub(3 + i / 5) * 3 / 4).collect();
        let mut matrix = Skyline::zeros(firsts);
        for i in 0..40 {
            let (first, row) = matrix.row_mut(i);
            for (j, entry) in (first..).zip(row) {
                *entry = if i == j { 3.0 } else { (1.0 + (i * 7 + j) as f64).sin() / 5.0 };
            }
        }
        let exact: Vec<f64> = (0..40).map(|i| (0.7 * f64::from(i)).cos()).collect();
        let product = matrix.multiply(&exact);
        // The product entry by entry.
        for (i, found) in product.iter().enumerate() {
            let entry = |a: usize, b: usize| {
                let (first, row) = matrix.row(a.max(b));
                if a.min(b) < first { 0.0 } else { row[a.min(b) - first] }
            };
            let sum: f64 = (0..40).map(|j| entry(i, j) * exact[j]).sum();
            assert!((sum - found).abs() < 1e-13);
        }
        let mut right: Vec<f64> = exact.iter().zip(&product).map(|(x, y)| x + 0.5 * y).collect();
        matrix.factor_shifted(0.5).unwrap().solve(&mut right);
        for (found, exact) in right.iter().zip(&exact) {
            assert!((found - exact).abs() < 1e-14, "{found} {exact}");
        }
        // Indefinite, and singular in the first row.
        let mut right: Vec<f64> = exact.iter().zip(&product).map(|(x, y)| x - 0.4 * y).collect();
        matrix.factor_shifted(-0.4).unwrap().solve(&mut right);
        for (found, exact) in right.iter().zip(&exact) {
            assert!((found - exact).abs() < 1e-12, "{found} {exact}");
        }
        let error = matrix.factor_shifted(-1.0 / 3.0).unwrap_err();
        assert!(matches!(error, Error::Singular { .. }));
    }
}

//! The logarithm on equal cells: products by Fourier transforms.

use std::cell::RefCell;

use rustfft::FftPlanner;

use super::cells::mean_logarithm;
use crate::Error;
use crate::basis::transform::{Complex, fast_length};
use crate::degenerate::{Product, Workspace};

/// Fewest and most cells.
const COUNTS: std::ops::RangeInclusive<usize> = 2..=1 << 22;

/// `A = 1 + theta S` for mean values on equal cells of `(-1, 1)`: `S_ij = h^(-1) int_i int_j ln 1/|x - s| ds dx`, `h = 2/N`.
///
/// `S` depends on `|i - j|` alone, so a product costs `O(N log N)`; symmetric and positive.
#[derive(Debug)]
pub struct EqualCells {
    count: usize,
    parameter: f64,
    logarithm: Product,
    inverse: Product,
    workspaces: RefCell<[Workspace; 2]>,
}

impl EqualCells {
    /// For so many cells and `theta >= 0`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `2 <= count <= 2^22` and the parameter is finite and not negative.
    pub fn new(count: usize, parameter: f64) -> Result<Self, Error> {
        if !COUNTS.contains(&count) {
            return Err(Error::InvalidParameter {
                name: "number of cells",
                value: count as f64,
                requirement: "between 2 and 2^22",
            });
        }
        if !(parameter >= 0.0 && parameter.is_finite()) {
            return Err(Error::InvalidParameter {
                name: "parameter",
                value: parameter,
                requirement: "finite and not negative",
            });
        }
        let width = 2.0 / count as f64;
        let first = [0.0, width];
        let entries: Vec<f64> = (0..count)
            .map(|j| width * mean_logarithm(first, [j as f64 * width, (j + 1) as f64 * width]))
            .collect();
        let inverses = inverse_entries(&entries, parameter);
        let mut planner = FftPlanner::new();
        let logarithm = Product::new(&mut planner, count, |j| entries[j], |_| 0.0);
        let inverse = Product::new(&mut planner, count, |j| inverses[j], |_| 0.0);
        let workspaces = RefCell::new([logarithm.workspace(), inverse.workspace()]);
        Ok(Self { count, parameter, logarithm, inverse, workspaces })
    }

    /// Number of cells.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// `theta`.
    #[must_use]
    pub fn parameter(&self) -> f64 {
        self.parameter
    }

    /// `S phi`: the means over the cells of `int ln(1/|x - s|) phi(s) ds`. Values beyond the number of cells are ignored, missing ones are zero.
    #[must_use]
    pub fn potential(&self, means: &[f64]) -> Vec<f64> {
        let [workspace, _] = &mut *self.workspaces.borrow_mut();
        apply(&self.logarithm, workspace, means, self.count)
    }

    /// `A phi`.
    pub(super) fn product(&self, means: &[f64]) -> Vec<f64> {
        let mut product = self.potential(means);
        product.iter_mut().zip(means).for_each(|(u, p)| *u = p + self.parameter * *u);
        product
    }

    /// About `A^-1 phi`, by a positive operator: the inverse of the symbol.
    pub(super) fn roughly_inverted(&self, means: &[f64]) -> Vec<f64> {
        let [_, workspace] = &mut *self.workspaces.borrow_mut();
        apply(&self.inverse, workspace, means, self.count)
    }
}

fn apply(product: &Product, workspace: &mut Workspace, means: &[f64], count: usize) -> Vec<f64> {
    let mut result = vec![0.0; count];
    let input = |q: usize| means.get(q).copied().unwrap_or(0.0);
    product.apply(workspace, input, |p, value| result[p] = value);
    result
}

/// The first row of the Toeplitz matrix whose symbol is that of `1/(1 + theta S)` on a cycle that is long enough.
fn inverse_entries(entries: &[f64], parameter: f64) -> Vec<f64> {
    let count = entries.len();
    let length = fast_length(2 * count);
    let mut planner = FftPlanner::new();
    let plan = planner.plan_fft_forward(length);
    let mut cycle = vec![Complex::default(); length];
    for (j, entry) in entries.iter().enumerate() {
        cycle[j].re = *entry;
        if j > 0 {
            cycle[length - j].re = *entry;
        }
    }
    plan.process(&mut cycle);
    // The logarithm, cut off at its longest distance, keeps a positive symbol but for rounding.
    cycle.iter_mut().for_each(|s| *s = Complex::new(1.0 / (1.0 + parameter * s.re.max(0.0)), 0.0));
    // Even and real: both directions are the same.
    plan.process(&mut cycle);
    cycle[..count].iter().map(|entry| entry.re / length as f64).collect()
}

#[cfg(test)]
mod tests {
    use super::super::logarithm_cells;
    use super::*;

    #[test]
    fn products_agree_with_the_dense_matrix() {
        for (count, parameter) in [(2, 1.0), (7, 0.0), (48, 30.0), (129, 1e4)] {
            let boundaries: Vec<f64> =
                (0..=count).map(|i| 2.0 * i as f64 / count as f64 - 1.0).collect();
            let dense = logarithm_cells(&boundaries).unwrap();
            let cells = EqualCells::new(count, parameter).unwrap();
            let x: Vec<f64> = (0..count).map(|i| (1.3 * i as f64).sin() + 0.2).collect();
            for (i, (row, found)) in dense.chunks_exact(count).zip(cells.product(&x)).enumerate() {
                let sum: f64 = row.iter().zip(&x).map(|(s, x)| s * x).sum();
                let exact = x[i] + parameter * sum;
                assert!((found - exact).abs() < 1e-12 * (1.0 + parameter), "{count}: {found}");
            }
            let energy: f64 = cells.roughly_inverted(&x).iter().zip(&x).map(|(y, x)| x * y).sum();
            assert!(energy > 0.0);
        }
    }

    #[test]
    fn refuses_what_has_no_meaning() {
        assert!(EqualCells::new(1, 1.0).is_err());
        assert!(EqualCells::new(8, f64::NAN).is_err());
        assert!(EqualCells::new(8, -1.0).is_err());
    }
}

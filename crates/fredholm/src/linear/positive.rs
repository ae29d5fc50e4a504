//! Symmetric positive definite systems.

use super::{Cholesky, small_cholesky};
use crate::Error;

/// Up to this order our own factorisation is faster than the library (see [`super::symmetric`]).
const SMALL: usize = 80;

/// Overwrites each right-hand side `b` with the solution of `A x = b`, `A` symmetric and positive definite, row by row, of which the lower triangle counts.
///
/// ```
/// let mut rights = [vec![3.0, 3.0]];
/// fredholm::eliminate_positive(&[2.0, 1.0, 1.0, 2.0], &mut rights)?;
/// assert!((rights[0][0] - 1.0).abs() < 1e-15);
/// # Ok::<(), fredholm::Error>(())
/// ```
///
/// # Errors
/// [`Error::WrongLength`] where a right-hand side has not as many values as the matrix has rows; [`Error::NotPositiveDefinite`].
pub fn eliminate_positive(matrix: &[f64], rights: &mut [Vec<f64>]) -> Result<(), Error> {
    let order = matrix.len().isqrt();
    for right in &*rights {
        if right.len() != order || order * order != matrix.len() {
            let what = "right-hand side";
            return Err(Error::WrongLength { what, found: right.len(), expected: order });
        }
    }
    let entry = |i: usize, j: usize| matrix[i * order + j];
    if order > SMALL {
        let factor = Cholesky::new(order, entry)?;
        rights.iter_mut().for_each(|right| factor.solve(right));
        return Ok(());
    }
    let columns = (0..order).flat_map(|j| (0..order).map(move |i| (i, j)));
    let mut factor: Vec<f64> = columns.map(|(i, j)| entry(i, j)).collect();
    small_cholesky::factor(&mut factor, order)
        .map_err(|pivot| Error::NotPositiveDefinite { order, pivot })?;
    rights.iter_mut().for_each(|right| small_cholesky::solve(&factor, order, right));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solutions_come_back() {
        for order in [1, 3, 40, SMALL + 1, 300] {
            let entry = |i: usize, j: usize| {
                0.5f64.powi(i.abs_diff(j) as i32) + if i == j { 1.0 } else { 0.0 }
            };
            let matrix: Vec<f64> =
                (0..order * order).map(|k| entry(k / order, k % order)).collect();
            let exact: Vec<f64> = (0..order).map(|i| (i as f64).cos()).collect();
            let right =
                matrix.chunks(order).map(|row| row.iter().zip(&exact).map(|(a, x)| a * x).sum());
            let mut rights = [right.collect::<Vec<f64>>(), vec![0.0; order]];
            eliminate_positive(&matrix, &mut rights).unwrap();
            let worst = rights[0].iter().zip(&exact).fold(0.0f64, |w, (a, b)| w.max((a - b).abs()));
            assert!(worst < 1e-14, "{order}: {worst:e}");
            assert!(rights[1].iter().all(|x| *x == 0.0));
        }
        let indefinite = eliminate_positive(&[1.0, 2.0, 2.0, 1.0], &mut [vec![1.0, 1.0]]);
        assert_eq!(indefinite, Err(Error::NotPositiveDefinite { order: 2, pivot: 1 }));
    }
}

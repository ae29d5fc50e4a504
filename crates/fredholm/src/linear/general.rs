//! Systems without any structure.

use super::Elimination;
use crate::Error;

/// Overwrites each right-hand side `b` with the solution of `A x = b`, by elimination with pivots in blocks; `matrix` is `A` row by row.
///
/// ```
/// let mut rights = [vec![4.0, 3.0]];
/// fredholm::eliminate(&[0.0, 2.0, 1.0, 1.0], &mut rights)?;
/// assert_eq!(rights[0], [1.0, 2.0]);
/// # Ok::<(), fredholm::Error>(())
/// ```
///
/// # Errors
/// [`Error::WrongLength`] where a right-hand side has not as many values as the matrix has rows; [`Error::Singular`] where a solution is not finite.
pub fn eliminate(matrix: &[f64], rights: &mut [Vec<f64>]) -> Result<(), Error> {
    let order = matrix.len().isqrt();
    for right in &*rights {
        if right.len() != order || order * order != matrix.len() {
            let what = "right-hand side";
            return Err(Error::WrongLength { what, found: right.len(), expected: order });
        }
    }
    if order == 0 {
        return Ok(());
    }
    let factored = Elimination::new(order, |i, j| matrix[i * order + j]);
    for right in rights {
        factored.solve(right);
        if right.iter().any(|value| !value.is_finite()) {
            return Err(Error::Singular { parameter: 0.0, smallest: 0.0 });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solutions_come_back() {
        for order in [1, 3, 40, 300] {
            let entry = |i: usize, j: usize| {
                (1.0 + (7 * i + 13 * j) as f64).sin() + if (i + 1) % order == j { 3.0 } else { 0.0 }
            };
            let matrix: Vec<f64> =
                (0..order * order).map(|k| entry(k / order, k % order)).collect();
            let exact: Vec<f64> = (0..order).map(|i| (i as f64).cos()).collect();
            let right =
                matrix.chunks(order).map(|row| row.iter().zip(&exact).map(|(a, x)| a * x).sum());
            let mut rights = [right.collect::<Vec<f64>>(), vec![0.0; order]];
            eliminate(&matrix, &mut rights).unwrap();
            let worst = rights[0].iter().zip(&exact).fold(0.0f64, |w, (a, b)| w.max((a - b).abs()));
            assert!(worst < 1e-10, "{order}: {worst:e}");
            assert!(rights[1].iter().all(|x| *x == 0.0));
        }
    }

    #[test]
    fn what_has_no_solution_is_refused() {
        let singular = eliminate(&[1.0, 1.0, 1.0, 1.0], &mut [vec![1.0, 2.0]]);
        assert!(matches!(singular, Err(Error::Singular { .. })));
        let short = eliminate(&[1.0, 0.0, 0.0, 1.0], &mut [vec![1.0]]);
        assert!(matches!(short, Err(Error::WrongLength { .. })));
    }
}

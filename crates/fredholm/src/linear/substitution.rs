//! Solution with triangular factors.

use super::dense::{COLUMNS, subtract_column, subtract_columns};
use super::vector::dot;
use super::vectorised::vectorised;

/// Overwrites `right` with `A^{-1} right` for `A = L L^T`: `column` gives those of `L`, each from the diagonal on.
///
/// Four columns are taken at a time, so that `right` is read and written a quarter as often. The method of the library underneath is made for many right-hand sides.
pub(crate) fn substitute<'f>(column: impl Fn(usize) -> &'f [f64], order: usize, right: &mut [f64]) {
    vectorised(
        #[inline(always)]
        || {
            forwards(&column, order, right);
            backwards(&column, order, right);
        },
    );
}

/// `L^{-1} right`.
#[inline(always)]
fn forwards<'f>(column: &impl Fn(usize) -> &'f [f64], order: usize, right: &mut [f64]) {
    let blocks = order - order % COLUMNS;
    for j in (0..blocks).step_by(COLUMNS) {
        let columns = [0, 1, 2, 3].map(|k| column(j + k));
        let (heads, tail) = right[j..order].split_at_mut(COLUMNS);
        for k in 0..COLUMNS {
            heads[k] /= columns[k][0];
            for below in k + 1..COLUMNS {
                heads[below] -= columns[k][below - k] * heads[k];
            }
        }
        let heads = [heads[0], heads[1], heads[2], heads[3]];
        subtract_columns(tail, below(columns), heads);
    }
    for j in blocks..order {
        let column = column(j);
        let (head, tail) = right[j..order].split_at_mut(1);
        head[0] /= column[0];
        subtract_column(tail, &column[1..], head[0]);
    }
}

/// `L^{-T} right`.
#[inline(always)]
fn backwards<'f>(column: &impl Fn(usize) -> &'f [f64], order: usize, right: &mut [f64]) {
    let blocks = order - order % COLUMNS;
    for j in (blocks..order).rev() {
        let column = column(j);
        let sum = dot(&column[1..], &right[j + 1..order]);
        right[j] = (right[j] - sum) / column[0];
    }
    for j in (0..blocks).step_by(COLUMNS).rev() {
        let columns = [0, 1, 2, 3].map(|k| column(j + k));
        let (heads, tail) = right[j..order].split_at_mut(COLUMNS);
        let [c0, c1, c2, c3] = below(columns);
        let sums = [dot(c0, tail), dot(c1, tail), dot(c2, tail), dot(c3, tail)];
        for k in (0..COLUMNS).rev() {
            let known: f64 =
                (k + 1..COLUMNS).map(|other| columns[k][other - k] * heads[other]).sum();
            heads[k] = (heads[k] - sums[k] - known) / columns[k][0];
        }
    }
}

/// What neighbouring columns have below all of their diagonals.
#[inline(always)]
fn below(columns: [&[f64]; COLUMNS]) -> [&[f64]; COLUMNS] {
    let [c0, c1, c2, c3] = columns;
    [&c0[COLUMNS..], &c1[COLUMNS - 1..], &c2[COLUMNS - 2..], &c3[COLUMNS - 3..]]
}

/// Overwrites `right` with `U^{-1} L^{-1} right`: `column` gives those of the matrix that holds `L` below its diagonal, where `L` has ones, and `U` above and on it.
///
/// Four columns at a time, as above.
pub(crate) fn eliminate<'f>(column: impl Fn(usize) -> &'f [f64], right: &mut [f64]) {
    let order = right.len();
    let blocks = order - order % COLUMNS;
    vectorised(
        #[inline(always)]
        || {
            for j in (0..blocks).step_by(COLUMNS) {
                let columns = [0, 1, 2, 3].map(|k| column(j + k));
                let (heads, tail) = right[j..order].split_at_mut(COLUMNS);
                for k in 0..COLUMNS {
                    for below in k + 1..COLUMNS {
                        heads[below] -= columns[k][j + below] * heads[k];
                    }
                }
                let heads = [heads[0], heads[1], heads[2], heads[3]];
                let [c0, c1, c2, c3] = columns;
                let next = j + COLUMNS;
                let below = [&c0[next..], &c1[next..], &c2[next..], &c3[next..]];
                subtract_columns(tail, below, heads);
            }
            for j in blocks..order {
                let head = right[j];
                subtract_column(&mut right[j + 1..], &column(j)[j + 1..], head);
            }
            for j in (blocks..order).rev() {
                let column = column(j);
                right[j] /= column[j];
                let head = right[j];
                subtract_column(&mut right[..j], column, head);
            }
            for j in (0..blocks).step_by(COLUMNS).rev() {
                let columns = [0, 1, 2, 3].map(|k| column(j + k));
                let (above, heads) = right[..j + COLUMNS].split_at_mut(j);
                for k in (0..COLUMNS).rev() {
                    for later in k + 1..COLUMNS {
                        heads[k] -= columns[later][j + k] * heads[later];
                    }
                    heads[k] /= columns[k][j + k];
                }
                subtract_columns(above, columns, [heads[0], heads[1], heads[2], heads[3]]);
            }
        },
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_with_the_factor_are_undone() {
        for order in [1, 2, 3, 4, 5, 7, 8, 9, 23, 40] {
            let entry = |i: usize, j: usize| {
                if i == j { 2.0 + i as f64 / 9.0 } else { ((3 * i + 5 * j) as f64).sin() / 7.0 }
            };
            let columns: Vec<Vec<f64>> =
                (0..order).map(|j| (j..order).map(|i| entry(i, j)).collect()).collect();
            let lower = |i: usize, j: usize| if i < j { 0.0 } else { columns[j][i - j] };
            let exact: Vec<f64> = (0..order).map(|i| (i as f64).cos()).collect();
            let times = |of: &dyn Fn(usize, usize) -> f64, x: &[f64]| -> Vec<f64> {
                (0..order).map(|i| (0..order).map(|j| of(i, j) * x[j]).sum()).collect()
            };
            let mut right = times(&lower, &times(&|i, j| lower(j, i), &exact));
            substitute(|j| &columns[j], order, &mut right);
            for (found, exact) in right.iter().zip(&exact) {
                assert!((found - exact).abs() < 1e-13, "{order}: {found} {exact}");
            }
        }
    }
}

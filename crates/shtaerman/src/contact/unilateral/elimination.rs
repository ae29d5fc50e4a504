//! Small dense systems.

/// Solves `A x = b` for rows `[A | b]` by elimination with pivots; `None` when `A` is singular or something is not finite.
pub(super) fn solve(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let count = rows.len();
    for row in &mut rows {
        // Rows of very different units: each by its largest entry.
        let size = row[..count].iter().fold(0.0f64, |most, value| most.max(value.abs()));
        row.iter_mut().for_each(|value| *value /= size);
    }
    for k in 0..count {
        let pivot = (k..count).max_by(|&i, &j| rows[i][k].abs().total_cmp(&rows[j][k].abs()))?;
        rows.swap(k, pivot);
        let (above, below) = rows.split_at_mut(k + 1);
        let top = &above[k];
        for row in below {
            let factor = row[k] / top[k];
            row.iter_mut().zip(top).skip(k).for_each(|(value, top)| *value -= factor * top);
        }
    }
    let mut solution = vec![0.0; count];
    for k in (0..count).rev() {
        let known: f64 = (k + 1..count).map(|l| rows[k][l] * solution[l]).sum();
        solution[k] = (rows[k][count] - known) / rows[k][k];
    }
    solution.iter().all(|value| value.is_finite()).then_some(solution)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_and_refuses() {
        let rows = vec![vec![0.0, 2.0, 4.0], vec![1e9, 1e9, 3e9]];
        assert_eq!(solve(rows).unwrap(), [1.0, 2.0]);
        assert_eq!(solve(vec![vec![1.0, 1.0, 1.0], vec![1.0, 1.0, 2.0]]), None);
    }
}

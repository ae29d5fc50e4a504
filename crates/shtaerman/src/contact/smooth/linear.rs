//! Symmetric positive systems of the modes.

use super::density::LANES;

/// Up to this order the matrix is factored, beyond it the method of conjugate gradients costs less. At half or twice 2 of 32 answers change, within what they state (survey).
const FACTORED: usize = 500;

/// A symmetric matrix with ones on most of its diagonal.
pub(super) struct Symmetric {
    order: usize,
    /// Row by row.
    entries: Vec<f64>,
}

impl Symmetric {
    pub(super) fn zero(order: usize) -> Self {
        Self { order, entries: vec![0.0; order * order] }
    }

    pub(super) fn add(&mut self, i: usize, j: usize, value: f64) {
        self.entries[i * self.order + j] += value;
        if i != j {
            self.entries[j * self.order + i] += value;
        }
    }

    /// Solves for several right-hand sides; `None` unless the matrix is positive.
    pub(super) fn solve(mut self, rights: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
        if self.order > FACTORED {
            return rights.iter().map(|right| self.descend(right)).collect();
        }
        self.factor()?;
        Some(rights.into_iter().map(|right| self.substituted(right)).collect())
    }

    fn row(&self, i: usize) -> &[f64] {
        &self.entries[i * self.order..(i + 1) * self.order]
    }

    /// Cholesky's factor in the lower triangle.
    fn factor(&mut self) -> Option<()> {
        for i in 0..self.order {
            let (above, below) = self.entries.split_at_mut(i * self.order);
            let row = &mut below[..self.order];
            for j in 0..i {
                let other = &above[j * self.order..j * self.order + j + 1];
                row[j] = (row[j] - dot(&row[..j], &other[..j])) / other[j];
            }
            let square = row[i] - dot(&row[..i], &row[..i]);
            if square.is_nan() || square <= 0.0 {
                return None;
            }
            row[i] = square.sqrt();
        }
        Some(())
    }

    fn substituted(&self, mut x: Vec<f64>) -> Vec<f64> {
        for i in 0..self.order {
            let row = self.row(i);
            x[i] = (x[i] - dot(&row[..i], &x[..i])) / row[i];
        }
        for i in (0..self.order).rev() {
            x[i] /= self.row(i)[i];
            let (before, value) = x.split_at_mut(i);
            let row = &self.entries[i * self.order..i * self.order + i];
            before.iter_mut().zip(row).for_each(|(b, l)| *b -= l * value[0]);
        }
        x
    }

    /// Conjugate gradients until rounding: in exact arithmetic as many steps as unknowns at most (theory).
    fn descend(&self, right: &[f64]) -> Option<Vec<f64>> {
        let mut x = vec![0.0; self.order];
        let mut residual = right.to_vec();
        let mut direction = residual.clone();
        let mut square = dot(&residual, &residual);
        let goal = square * 1e-32;
        for _ in 0..2 * self.order {
            if square <= goal {
                return Some(x);
            }
            let image: Vec<f64> = (0..self.order).map(|i| dot(self.row(i), &direction)).collect();
            let curvature = dot(&direction, &image);
            if curvature.is_nan() || curvature <= 0.0 {
                return None;
            }
            let step = square / curvature;
            x.iter_mut().zip(&direction).for_each(|(x, d)| *x += step * d);
            residual.iter_mut().zip(&image).for_each(|(r, d)| *r -= step * d);
            let next = dot(&residual, &residual);
            let keep = next / square;
            square = next;
            direction.iter_mut().zip(&residual).for_each(|(d, r)| *d = r + keep * *d);
        }
        None
    }
}

fn dot(one: &[f64], two: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let (chunks, others) = (one.chunks_exact(LANES), two.chunks_exact(LANES));
    let rest: f64 = chunks.remainder().iter().zip(others.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in chunks.zip(others) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    rest + sums.iter().sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ways_solve() {
        for order in [3, 40, FACTORED + 20] {
            let mut matrix = Symmetric::zero(order);
            for i in 0..order {
                matrix.add(i, i, 1.0);
                for j in 0..=i {
                    matrix.add(i, j, 0.5f64.powi((i - j) as i32) / (1.0 + i as f64));
                }
            }
            let exact: Vec<f64> = (0..order).map(|i| (i as f64).sin()).collect();
            let right = (0..order).map(|i| dot(matrix.row(i), &exact)).collect();
            let found = matrix.solve(vec![right]).unwrap();
            let worst = found[0].iter().zip(&exact).fold(0.0f64, |w, (a, b)| w.max((a - b).abs()));
            assert!(worst < 1e-13, "{order}: {worst:e}");
        }
        let mut matrix = Symmetric::zero(2);
        matrix.add(0, 1, 1.0);
        assert!(matrix.solve(vec![vec![1.0, 1.0]]).is_none());
    }
}

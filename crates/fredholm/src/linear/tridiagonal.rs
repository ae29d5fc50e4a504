//! Symmetric positive definite tridiagonal matrices, eliminated from the last row upwards.

/// `T = U D U^T` with a unit upper bidiagonal `U`; `6` operations a row to solve.
#[derive(Debug, Clone)]
pub(crate) struct Tridiagonal {
    /// `1 / D_i`.
    inverse: Vec<f64>,
    /// `U_{i, i+1}`; the last is not used.
    upper: Vec<f64>,
}

impl Tridiagonal {
    /// Factors the matrix with `T_ii = diagonal(i)` and `T_{i,i+1} = off(i)`; `None` where a pivot loses more than the
    /// share `1 - margin` of its diagonal entry, so that the matrix may not be positive definite.
    pub(crate) fn new(
        order: usize,
        margin: f64,
        diagonal: impl Fn(usize) -> f64,
        off: impl Fn(usize) -> f64,
    ) -> Option<Self> {
        let mut inverse = vec![0.0; order];
        let mut upper = vec![0.0; order];
        let mut below = 0.0;
        for i in (0..order).rev() {
            let (entry, neighbour) = (diagonal(i), if i + 1 < order { off(i) } else { 0.0 });
            upper[i] = neighbour * below;
            let pivot = entry - neighbour * upper[i];
            if !(pivot > margin * entry && entry > 0.0) {
                return None;
            }
            below = 1.0 / pivot;
            inverse[i] = below;
        }
        Some(Self { inverse, upper })
    }

    /// `1 / D_0`: what elimination adds to a row above, coupled by `c`, is `- c^2 / D_0` on its diagonal.
    pub(crate) fn first_inverse(&self) -> f64 {
        self.inverse.first().copied().unwrap_or(0.0)
    }

    /// First half of the solution: `right` becomes `U^{-1} right`.
    pub(crate) fn eliminate(&self, right: &mut [f64]) {
        let mut below = 0.0;
        for (value, upper) in right.iter_mut().zip(&self.upper).rev() {
            below = *value - upper * below;
            *value = below;
        }
    }

    /// Second half: `U^{-T} (D^{-1} right - coupling e_0)`, `coupling` what the row above brings in.
    pub(crate) fn substitute(&self, right: &mut [f64], coupling: f64) {
        let mut carried = coupling;
        for ((value, inverse), upper) in right.iter_mut().zip(&self.inverse).zip(&self.upper) {
            let solved = *value * inverse - carried;
            *value = solved;
            carried = upper * solved;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_against_the_residual() {
        let (diagonal, off) =
            (|i: usize| 2.0 + (i as f64).sin(), |i: usize| 0.4 * (1.0 + i as f64).cos());
        for order in [1usize, 2, 3, 50] {
            let matrix = Tridiagonal::new(order, 0.0, diagonal, off).unwrap();
            let right: Vec<f64> = (0..order).map(|i| (0.3 * i as f64).cos()).collect();
            let mut x = right.clone();
            matrix.eliminate(&mut x);
            matrix.substitute(&mut x, 0.0);
            for i in 0..order {
                let mut sum = diagonal(i) * x[i];
                if i > 0 {
                    sum += off(i - 1) * x[i - 1];
                }
                if i + 1 < order {
                    sum += off(i) * x[i + 1];
                }
                assert!((sum - right[i]).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn refuses_what_may_be_indefinite() {
        assert!(Tridiagonal::new(2, 0.0, |_| 1.0, |_| 2.0).is_none());
        assert!(Tridiagonal::new(2, 0.5, |_| 1.0, |_| 0.9).is_none());
        assert!(Tridiagonal::new(1, 0.0, |_| f64::NAN, |_| 0.0).is_none());
    }
}

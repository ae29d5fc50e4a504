//! The lowest eigenvalues of symmetric tridiagonal matrices and their eigenvectors.

/// Eigenvalues sought at once: their divisions do not wait for each other.
const LANES: usize = 8;
/// Steps of bisection after which the interval is as small as it gets, whatever it was.
const STEPS: usize = 1100;

/// A symmetric tridiagonal matrix with the diagonal `a_i` and `b_i` beside it.
#[derive(Debug, Clone)]
pub(crate) struct SymmetricTridiagonal {
    diagonal: Vec<f64>,
    /// `b_i = T_{i,i+1}`; one less than the diagonal has entries.
    beside: Vec<f64>,
}

impl SymmetricTridiagonal {
    pub(crate) fn new(diagonal: Vec<f64>, beside: Vec<f64>) -> Self {
        Self { diagonal, beside }
    }

    pub(crate) fn order(&self) -> usize {
        self.diagonal.len()
    }

    /// The matrix of the first rows and columns.
    pub(crate) fn truncated(mut self, order: usize) -> Self {
        self.diagonal.truncate(order);
        self.beside.truncate(order.saturating_sub(1));
        self
    }

    /// The eigenvalues with the indices of a range, ascending, by bisection on the number of negative pivots (W. Barth, R. S. Martin, J. H. Wilkinson, Numer. Math. 9 (1967) 386): the
    /// error is a few units in the last place of the entries that matter for the eigenvalue, small ones of a graded matrix included.
    pub(crate) fn eigenvalues(&self, indices: std::ops::Range<usize>) -> Vec<f64> {
        let bounds = self.bounds();
        let indices: Vec<usize> = indices.take_while(|&index| index < self.order()).collect();
        indices.chunks(LANES).flat_map(|lanes| self.bisect(lanes, bounds)).collect()
    }

    /// An interval with all eigenvalues inside (Gershgorin).
    fn bounds(&self) -> [f64; 2] {
        let coupling = |i: usize| self.beside.get(i).copied().unwrap_or(0.0).abs();
        let mut bounds = [f64::INFINITY, f64::NEG_INFINITY];
        for (i, entry) in self.diagonal.iter().enumerate() {
            let radius = coupling(i) + if i > 0 { coupling(i - 1) } else { 0.0 };
            bounds = [bounds[0].min(entry - radius), bounds[1].max(entry + radius)];
        }
        let room = 4.0 * f64::EPSILON;
        [bounds[0] - room * bounds[0].abs(), bounds[1] + room * bounds[1].abs()]
    }

    fn bisect(&self, indices: &[usize], bounds: [f64; 2]) -> Vec<f64> {
        let (mut low, mut high) = ([bounds[0]; LANES], [bounds[1]; LANES]);
        for _ in 0..STEPS {
            let mut middle = [0.0; LANES];
            let mut done = true;
            for lane in 0..LANES {
                middle[lane] = 0.5 * low[lane] + 0.5 * high[lane];
                done &= !(low[lane] < middle[lane] && middle[lane] < high[lane]);
            }
            if done {
                break;
            }
            let below = self.count_below(middle);
            for (lane, index) in indices.iter().enumerate() {
                if below[lane] > *index {
                    high[lane] = middle[lane];
                } else {
                    low[lane] = middle[lane];
                }
            }
            // Idle lanes must not keep the others waiting.
            low[indices.len()..].copy_from_slice(&high[indices.len()..]);
        }
        indices.iter().zip(high).map(|(_, value)| value).collect()
    }

    /// How many eigenvalues lie below each shift.
    fn count_below(&self, shifts: [f64; LANES]) -> [usize; LANES] {
        let mut pivots = [1.0f64; LANES];
        let mut counts = [0usize; LANES];
        let mut coupling = 0.0;
        for (i, entry) in self.diagonal.iter().enumerate() {
            for lane in 0..LANES {
                let pivot = (entry - shifts[lane]) - coupling / pivots[lane];
                pivots[lane] = apart_from_zero(pivot);
                counts[lane] += usize::from(pivots[lane] < 0.0);
            }
            let beside = self.beside.get(i).copied().unwrap_or(0.0);
            coupling = beside * beside;
        }
        counts
    }

    /// The eigenvector of unit length that belongs to an eigenvalue apart from the others: from both ends to the row where elimination downwards and upwards meet with the smallest
    /// rest (K. V. Fernando, SIAM J. Matrix Anal. Appl. 18 (1997) 1013), so that small components are as accurate as large ones.
    pub(crate) fn eigenvector(&self, value: f64) -> Vec<f64> {
        let order = self.order();
        let (down, up) = (self.pivots_down(value), self.pivots_up(value));
        let rest = |i: usize| (down[i] + up[i] - (self.diagonal[i] - value)).abs();
        let meeting = (0..order).fold(0, |best, i| if rest(i) < rest(best) { i } else { best });
        let mut vector = vec![0.0; order];
        vector[meeting] = 1.0;
        for i in (0..meeting).rev() {
            vector[i] = -self.beside[i] * vector[i + 1] / down[i];
        }
        for i in meeting + 1..order {
            vector[i] = -self.beside[i - 1] * vector[i - 1] / up[i];
        }
        let length = vector.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        vector.iter_mut().for_each(|entry| *entry /= length);
        vector
    }

    fn pivots_down(&self, value: f64) -> Vec<f64> {
        let mut pivots = Vec::with_capacity(self.order());
        let mut coupled = 0.0;
        for (i, entry) in self.diagonal.iter().enumerate() {
            let pivot = apart_from_zero((entry - value) - coupled);
            coupled = self.beside.get(i).map_or(0.0, |beside| beside * beside / pivot);
            pivots.push(pivot);
        }
        pivots
    }

    fn pivots_up(&self, value: f64) -> Vec<f64> {
        let mut pivots = vec![0.0; self.order()];
        let mut coupled = 0.0;
        for (i, entry) in self.diagonal.iter().enumerate().rev() {
            let pivot = apart_from_zero((entry - value) - coupled);
            if i > 0 {
                coupled = self.beside[i - 1] * self.beside[i - 1] / pivot;
            }
            pivots[i] = pivot;
        }
        pivots
    }
}

/// A pivot that vanishes is moved by less than rounding.
fn apart_from_zero(pivot: f64) -> f64 {
    if pivot.abs() < f64::MIN_POSITIVE { f64::MIN_POSITIVE } else { pivot }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn second_differences() {
        // Eigenvalues 4 sin^2(pi (k+1)/(2 (n+1))), eigenvectors sin(pi (k+1)(i+1)/(n+1)).
        for order in [1usize, 2, 5, 40] {
            let matrix = SymmetricTridiagonal::new(vec![2.0; order], vec![-1.0; order - 1]);
            let values = matrix.eigenvalues(0..order + 3);
            assert_eq!(values.len(), order);
            for (k, value) in values.iter().enumerate() {
                let angle = std::f64::consts::PI * (k as f64 + 1.0) / (order as f64 + 1.0);
                let exact = 4.0 * (0.5 * angle).sin().powi(2);
                assert!((value - exact).abs() < 4e-15, "{order} {k}: {value} {exact}");
                let vector = matrix.eigenvector(*value);
                let scale = vector[0] / angle.sin();
                for (i, entry) in vector.iter().enumerate() {
                    assert!((entry - scale * ((i as f64 + 1.0) * angle).sin()).abs() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn small_eigenvalues_of_graded_matrices_keep_their_digits() {
        // det = 1e-16 (1 - 1e-20) and the trace 1 + 1e-16.
        let matrix = SymmetricTridiagonal::new(vec![1e-16, 1.0], vec![1e-18]);
        let values = matrix.eigenvalues(0..2);
        assert!((values[0] / 1e-16 - 1.0).abs() < 1e-15 && (values[1] - 1.0).abs() < 1e-15);
        let vector = matrix.eigenvector(values[0]);
        assert!((vector[1] / vector[0] / -1e-18 - 1.0).abs() < 1e-14);
        // Nothing beside the diagonal.
        let matrix = SymmetricTridiagonal::new(vec![0.0, 3.0, 7.0], vec![0.0; 2]);
        for (value, exact) in matrix.eigenvalues(0..3).iter().zip([0.0, 3.0, 7.0]) {
            assert!((value - exact).abs() <= 2e-16 * exact + 1e-300, "{value} {exact}");
        }
        assert_eq!(matrix.eigenvector(3.0), [0.0, 1.0, 0.0]);
    }
}

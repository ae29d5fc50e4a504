//! The small least-squares problem of GMRES.

/// The small least-squares problem of GMRES, by Givens rotations.
pub(super) struct LeastSquares {
    /// Columns of the triangle.
    columns: Vec<Vec<f64>>,
    rotations: Vec<[f64; 2]>,
    right: Vec<f64>,
}

impl LeastSquares {
    pub(super) fn new(norm: f64) -> Self {
        Self { columns: Vec::new(), rotations: Vec::new(), right: vec![norm] }
    }

    pub(super) fn residual(&self) -> f64 {
        self.right[self.right.len() - 1]
    }

    pub(super) fn add(&mut self, mut column: Vec<f64>) {
        for (k, [c, s]) in self.rotations.iter().enumerate() {
            let [above, below] = [column[k], column[k + 1]];
            (column[k], column[k + 1]) = (c * above + s * below, c * below - s * above);
        }
        let last = column.len() - 2;
        let radius = column[last].hypot(column[last + 1]);
        let [c, s] = if radius > 0.0 {
            [column[last] / radius, column[last + 1] / radius]
        } else {
            [1.0, 0.0]
        };
        column.pop();
        column[last] = radius;
        self.columns.push(column);
        self.rotations.push([c, s]);
        let residual = self.right[last];
        self.right[last] = c * residual;
        self.right.push(-s * residual);
    }

    pub(super) fn factors(&self) -> Vec<f64> {
        let count = self.columns.len();
        let mut factors = self.right[..count].to_vec();
        for k in (0..count).rev() {
            let pivot = self.columns[k][k];
            factors[k] = if pivot > 0.0 { factors[k] / pivot } else { 0.0 };
            for i in 0..k {
                factors[i] -= self.columns[k][i] * factors[k];
            }
        }
        factors
    }
}

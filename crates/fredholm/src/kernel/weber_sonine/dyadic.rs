//! A function on `(0, 1]`, smooth but for 0, by polynomials on `(1/2, 1]`, `(1/4, 1/2]`, ...

use crate::basis::{ChebyshevSeries, chebyshev};

/// Coefficients of a piece. The singularity at 0 makes those of Chebyshev's polynomials fall as `5.8^-n`.
const TERMS: usize = 24;
/// Coefficients side by side: one chain of dependent operations each.
const LANES: usize = 4;

/// The polynomials. One evaluation costs about 10 ns.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Dyadic {
    /// `pieces[j]` holds `p(u)`, `u = 2^(j+2) w - 3`, by powers of `u`.
    pieces: Vec<[[f64; LANES]; TERMS / LANES]>,
}

impl Dyadic {
    /// The function down to `2^-pieces`.
    pub(super) fn new(pieces: usize, value: impl Fn(f64) -> f64) -> Self {
        let piece = |j: usize| {
            let scale = 0.5f64.powi(j as i32 + 2);
            powers(|u| value(scale * (u + 3.0)))
        };
        Self { pieces: (0..pieces).map(piece).collect() }
    }

    /// The value at `w` in `(0, 1]`; below the last piece that piece is continued.
    pub(super) fn evaluate(&self, w: f64) -> f64 {
        // 1/2 <= w < 1 has the biased exponent 1022.
        let exponent = 1022_usize.saturating_sub((w.to_bits() >> 52) as usize);
        let index = exponent.min(self.pieces.len() - 1);
        let scale = f64::from_bits((1025 + index as u64) << 52);
        let u = w * scale - 3.0;
        polynomial(&self.pieces[index], u)
    }
}

/// `sum_n c_n u^n` with the coefficients `c_n` row by row.
pub(super) fn polynomial<const ROWS: usize>(rows: &[[f64; LANES]; ROWS], u: f64) -> f64 {
    let square = u * u;
    let fourth = square * square;
    let mut sums = [0.0; LANES];
    for row in rows.iter().rev() {
        for (sum, c) in sums.iter_mut().zip(row) {
            *sum = *sum * fourth + c;
        }
    }
    (sums[0] + sums[1] * u) + (sums[2] + sums[3] * u) * square
}

/// The coefficients of the powers of `u` in the polynomial through the values of a function at Chebyshev points of `[-1, 1]`, row by row; it loses no more
/// than `(1 + sqrt 2)^n` at the `n`-th.
pub(super) fn powers<const ROWS: usize>(function: impl Fn(f64) -> f64) -> [[f64; LANES]; ROWS] {
    let terms = ROWS * LANES;
    let points = chebyshev::points(terms - 1);
    let series = ChebyshevSeries::through(points.into_iter().map(function).collect());
    let mut sum = vec![0.0; terms];
    let (mut before, mut current) = (vec![0.0; terms], vec![0.0; terms]);
    before[0] = 1.0;
    current[1] = 1.0;
    for c in series.coefficients() {
        for (sum, power) in sum.iter_mut().zip(&before) {
            *sum += c * power;
        }
        // T_(n+1) = 2 u T_n - T_(n-1)
        for k in (0..terms).rev() {
            let raised = if k == 0 { 0.0 } else { 2.0 * current[k - 1] };
            before[k] = raised - before[k];
        }
        std::mem::swap(&mut before, &mut current);
    }
    let mut rows = [[0.0; LANES]; ROWS];
    for (row, chunk) in rows.iter_mut().zip(sum.chunks_exact(LANES)) {
        row.copy_from_slice(chunk);
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_functions_with_a_singularity_at_zero() {
        for power in [-0.7, 0.5, 3.3] {
            let table = Dyadic::new(40, |w| w.powf(power));
            for i in 0..400 {
                let w = 0.935f64.powi(i);
                let (found, exact) = (table.evaluate(w), w.powf(power));
                assert!((found / exact - 1.0).abs() < 2e-15 * 2f64.powf(power.abs()), "{w}");
            }
        }
    }
}

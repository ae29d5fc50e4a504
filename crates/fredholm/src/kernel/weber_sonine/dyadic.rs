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
    /// The function down to `2^-pieces`; `value(j, w)` is asked for in piece `j`, piece after piece.
    pub(super) fn new(pieces: usize, mut value: impl FnMut(usize, f64) -> f64) -> Self {
        let points = chebyshev::points(TERMS - 1);
        let piece = |j: usize| {
            let scale = 0.5f64.powi(j as i32 + 2);
            let values = points.iter().map(|u| value(j, scale * (u + 3.0))).collect();
            powers(ChebyshevSeries::through(values).coefficients())
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

/// The coefficients of the powers of a sum of Chebyshev polynomials; it loses no more than `(1 + sqrt 2)^n` at the `n`-th.
fn powers(coefficients: &[f64]) -> [[f64; LANES]; TERMS / LANES] {
    let mut sum = [0.0; TERMS];
    let (mut before, mut current) = ([0.0; TERMS], [0.0; TERMS]);
    before[0] = 1.0;
    current[1] = 1.0;
    for c in coefficients {
        for (sum, power) in sum.iter_mut().zip(before) {
            *sum += c * power;
        }
        let mut next = before.map(|power| -power);
        for k in 1..TERMS {
            next[k] += 2.0 * current[k - 1];
        }
        (before, current) = (current, next);
    }
    let mut rows = [[0.0; LANES]; TERMS / LANES];
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
            let table = Dyadic::new(40, |_, w| w.powf(power));
            for i in 0..400 {
                let w = 0.935f64.powi(i);
                let (found, exact) = (table.evaluate(w), w.powf(power));
                assert!((found / exact - 1.0).abs() < 2e-15 * 2f64.powf(power.abs()), "{w}");
            }
        }
    }
}

//! A function on `(0, 1]`, smooth but for 0, by polynomials on `(1/2, 1]`, `(1/4, 1/2]`, ...

use crate::basis::{ChebyshevSeries, chebyshev};

/// Coefficients of a piece. The singularity at 0 makes those of Chebyshev's polynomials fall as `5.8^-n`.
const TERMS: usize = 24;
/// Coefficients side by side: one chain of dependent operations each.
const LANES: usize = 4;
/// Places side by side: their sums fill half of the registers of a processor with vectors of four.
const BESIDE: usize = 8;

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
        let index = self.piece(w);
        polynomial(&self.pieces[index], local(index, w))
    }

    /// Puts the values at many places there, the same to the last bit for less: those of a piece that follow each other are taken side by side.
    #[inline(always)]
    pub(super) fn evaluate_all(&self, mut places: &mut [f64]) {
        while let Some(first) = places.first() {
            let index = self.piece(*first);
            let count = places.iter().take_while(|w| self.piece(**w) == index).count();
            let (own, others) = places.split_at_mut(count);
            for w in own.iter_mut() {
                *w = local(index, *w);
            }
            polynomials(&self.pieces[index], own);
            places = others;
        }
    }

    #[inline(always)]
    fn piece(&self, w: f64) -> usize {
        // 1/2 <= w < 1 has the biased exponent 1022.
        let exponent = 1022_usize.saturating_sub((w.to_bits() >> 52) as usize);
        exponent.min(self.pieces.len() - 1)
    }
}

/// `u` of a piece.
#[inline(always)]
fn local(piece: usize, w: f64) -> f64 {
    w * f64::from_bits((1025 + piece as u64) << 52) - 3.0
}

/// `sum_n c_n u^n` with the coefficients `c_n` row by row.
#[inline(always)]
pub(super) fn polynomial<const ROWS: usize>(rows: &[[f64; LANES]; ROWS], u: f64) -> f64 {
    let mut sum = [u];
    polynomials_of(rows, &mut sum);
    sum[0]
}

/// Puts the sums at many places there, those of [`polynomial`] to the last bit.
#[inline(always)]
pub(super) fn polynomials<const ROWS: usize>(rows: &[[f64; LANES]; ROWS], places: &mut [f64]) {
    let (blocks, rest) = places.as_chunks_mut::<BESIDE>();
    for block in blocks {
        polynomials_of(rows, block);
    }
    // A block that is not full takes no longer than one place.
    let mut block = [0.0; BESIDE];
    block[..rest.len()].copy_from_slice(rest);
    polynomials_of(rows, &mut block);
    rest.copy_from_slice(&block[..rest.len()]);
}

#[inline(always)]
fn polynomials_of<const ROWS: usize, const COUNT: usize>(
    rows: &[[f64; LANES]; ROWS],
    places: &mut [f64; COUNT],
) {
    let (mut squares, mut fourths) = ([0.0; COUNT], [0.0; COUNT]);
    for k in 0..COUNT {
        squares[k] = places[k] * places[k];
        fourths[k] = squares[k] * squares[k];
    }
    let mut sums = [[0.0; COUNT]; LANES];
    for row in rows.iter().rev() {
        for (sums, c) in sums.iter_mut().zip(row) {
            for (sum, fourth) in sums.iter_mut().zip(&fourths) {
                *sum = *sum * fourth + c;
            }
        }
    }
    for (k, u) in places.iter_mut().enumerate() {
        let [zero, one, two, three] = [sums[0][k], sums[1][k], sums[2][k], sums[3][k]];
        *u = (zero + one * *u) + (two + three * *u) * squares[k];
    }
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

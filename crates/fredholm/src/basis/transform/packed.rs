//! The Fourier transform of a real sequence of even length.

use std::fmt;
use std::sync::Arc;

use rustfft::{Fft, FftPlanner};

use super::Complex;
use super::rotation::Rotation;

/// `X_k = sum_{j < 2h} x_j exp(-2 pi i j k / 2h)` of a real sequence, kept as `h` complex numbers `x_2j + i x_2j+1`.
///
/// The spectrum is never stored: [`filter`](Self::filter) turns the packed transform into that of the filtered
/// sequence in one pass over pairs `k, h - k`. The way back uses the forward plan on conjugates, so one plan does.
#[derive(Clone)]
pub(crate) struct PackedTransform {
    plan: Arc<dyn Fft<f64>>,
    rotation: Arc<Rotation>,
}

impl fmt::Debug for PackedTransform {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("PackedTransform").field("half", &self.half()).finish()
    }
}

impl PackedTransform {
    /// The transform of real sequences of length `2 half`, `half >= 1`; the planner shares what equal lengths need.
    pub(crate) fn new(planner: &mut FftPlanner<f64>, half: usize) -> Self {
        let plan = planner.plan_fft_forward(half);
        Self { plan, rotation: Arc::new(Rotation::new(2 * half)) }
    }

    /// Half of the length.
    pub(crate) fn half(&self) -> usize {
        self.plan.len()
    }

    /// Scratch for [`forward`](Self::forward) and [`backward`](Self::backward).
    pub(crate) fn scratch(&self) -> Vec<Complex> {
        vec![Complex::default(); self.plan.get_inplace_scratch_len()]
    }

    /// From the packed sequence to its complex transform.
    pub(crate) fn forward(&self, packed: &mut [Complex], scratch: &mut [Complex]) {
        self.plan.process_with_scratch(packed, scratch);
    }

    /// From what [`filter`](Self::filter) left to the conjugates `h (y_2j - i y_2j+1)` of the filtered sequence.
    pub(crate) fn backward(&self, filtered: &mut [Complex], scratch: &mut [Complex]) {
        self.plan.process_with_scratch(filtered, scratch);
    }

    /// Calls `visit(k, X_k, X_{h-k})` for `k = 0 ..= h/2`.
    pub(crate) fn visit(&self, packed: &[Complex], mut visit: impl FnMut(usize, Complex, Complex)) {
        let half = self.half();
        for k in 0..=half / 2 {
            let (low, high) = split(packed[k], packed[(half - k) % half], self.rotation.at(k));
            visit(k, low, high);
        }
    }

    /// Replaces the spectrum by `(Y_k, Y_{h-k}) = map(k, X_k, X_{h-k})`, `k = 0 ..= h/2`; conjugated for
    /// [`backward`](Self::backward).
    pub(crate) fn filter(
        &self,
        packed: &mut [Complex],
        mut map: impl FnMut(usize, Complex, Complex) -> (Complex, Complex),
    ) {
        let half = self.half();
        let mut pair = |k: usize, low: Complex, high: Complex| {
            let root = self.rotation.at(k);
            let (x, mirrored) = split(low, high, root);
            let (y, mirrored) = map(k, x, mirrored);
            join(y, mirrored, root)
        };
        let (low, high) = packed.split_at_mut(half / 2 + 1);
        low[0] = pair(0, low[0], low[0]).0;
        if half.is_multiple_of(2) {
            low[half / 2] = pair(half / 2, low[half / 2], low[half / 2]).0;
        }
        for (k, (low, high)) in low.iter_mut().skip(1).zip(high.iter_mut().rev()).enumerate() {
            (*low, *high) = pair(k + 1, *low, *high);
        }
    }
}

/// `X_k` and `X_{h-k}` from the packed transform there, `root = exp(-2 pi i k / 2h)`.
fn split(low: Complex, high: Complex, root: Complex) -> (Complex, Complex) {
    let even = 0.5 * (low + high.conj());
    let difference = 0.5 * (low - high.conj());
    let odd = root * Complex::new(difference.im, -difference.re);
    (even + odd, (even - odd).conj())
}

/// The inverse of [`split`], conjugated.
fn join(low: Complex, high: Complex, root: Complex) -> (Complex, Complex) {
    let even = 0.5 * (low + high.conj());
    let odd = root.conj() * (0.5 * (low - high.conj()));
    let turned = Complex::new(-odd.im, odd.re);
    ((even + turned).conj(), even - turned)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    fn sequence(length: usize) -> Vec<f64> {
        (0..length).map(|j| (1.7 * j as f64 + 0.3).sin() + 0.2).collect()
    }

    fn packed(sequence: &[f64]) -> Vec<Complex> {
        sequence.chunks(2).map(|pair| Complex::new(pair[0], pair[1])).collect()
    }

    #[test]
    fn agrees_with_the_sum() {
        for half in [1, 2, 3, 4, 5, 9, 30, 64] {
            let transform = PackedTransform::new(&mut FftPlanner::new(), half);
            let x = sequence(2 * half);
            let mut buffer = packed(&x);
            transform.forward(&mut buffer, &mut transform.scratch());
            let sum = |k: usize| -> Complex {
                let angle = |j: usize| -TAU * ((j * k) % (2 * half)) as f64 / (2 * half) as f64;
                x.iter().enumerate().map(|(j, x)| Complex::from_polar(*x, angle(j))).sum()
            };
            let mut visited = 0;
            transform.visit(&buffer, |k, low, high| {
                visited += 1;
                assert!((low - sum(k)).norm() < 1e-13 * half as f64);
                assert!((high - sum(half - k)).norm() < 1e-13 * half as f64);
            });
            assert_eq!(visited, half / 2 + 1);
        }
    }

    #[test]
    fn comes_back() {
        for half in [1, 2, 3, 4, 5, 9, 30, 64, 1000] {
            let transform = PackedTransform::new(&mut FftPlanner::new(), half);
            let x = sequence(2 * half);
            let mut buffer = packed(&x);
            let mut scratch = transform.scratch();
            transform.forward(&mut buffer, &mut scratch);
            transform.filter(&mut buffer, |_, low, high| (low, high));
            transform.backward(&mut buffer, &mut scratch);
            for (pair, back) in x.chunks(2).zip(buffer) {
                assert!((pair[0] - back.re / half as f64).abs() < 1e-14);
                assert!((pair[1] + back.im / half as f64).abs() < 1e-14);
            }
        }
    }
}

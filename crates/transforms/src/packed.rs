//! The Fourier transform of a real sequence of even length.

use std::fmt;
use std::sync::Arc;

use rustfft::Fft;

use crate::rotation::Rotation;
use crate::{Complex, Planner};

/// `X_k = sum_{j < 2h} x_j exp(-2 pi i j k / 2h)` of a real sequence, kept as `h` complex numbers `x_2j + i x_2j+1`.
///
/// The spectrum is never stored: [`filter`](Self::filter) turns the packed transform into that of the filtered
/// sequence in one pass over pairs `k, h - k`. The way back uses the forward plan on conjugates, so one plan does.
#[derive(Clone)]
pub struct PackedTransform {
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
    #[must_use]
    pub fn new(planner: &mut Planner, half: usize) -> Self {
        let plan = planner.forward(half);
        Self { plan, rotation: Arc::new(Rotation::new(2 * half)) }
    }

    /// Half of the length.
    #[must_use]
    #[inline]
    pub fn half(&self) -> usize {
        self.plan.len()
    }

    /// Scratch for [`forward`](Self::forward) and [`backward`](Self::backward).
    #[must_use]
    pub fn scratch(&self) -> Vec<Complex> {
        vec![Complex::default(); self.plan.get_inplace_scratch_len()]
    }

    /// From the packed sequence to its complex transform.
    pub fn forward(&self, packed: &mut [Complex], scratch: &mut [Complex]) {
        self.plan.process_with_scratch(packed, scratch);
    }

    /// From what [`filter`](Self::filter) left to the conjugates `h (y_2j - i y_2j+1)` of the filtered sequence.
    pub fn backward(&self, filtered: &mut [Complex], scratch: &mut [Complex]) {
        self.plan.process_with_scratch(filtered, scratch);
    }

    /// Calls `visit(k, X_k, X_{h-k})` for `k = 0 ..= h/2`.
    pub fn visit(&self, packed: &[Complex], mut visit: impl FnMut(usize, Complex, Complex)) {
        let half = self.half();
        for k in 0..=half / 2 {
            let (low, high) = split(packed[k], packed[(half - k) % half], self.rotation.at(k));
            visit(k, low, high);
        }
    }

    /// Replaces the spectrum by `(Y_k, Y_{h-k}) = map(k, X_k, X_{h-k})`, `k = 0 ..= h/2`; conjugated for
    /// [`backward`](Self::backward).
    pub fn filter(
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
#[inline]
fn split(low: Complex, high: Complex, root: Complex) -> (Complex, Complex) {
    let even = 0.5 * (low + high.conj());
    let difference = 0.5 * (low - high.conj());
    let odd = root * Complex::new(difference.im, -difference.re);
    (even + odd, (even - odd).conj())
}

/// The inverse of [`split`], conjugated.
#[inline]
fn join(low: Complex, high: Complex, root: Complex) -> (Complex, Complex) {
    let even = 0.5 * (low + high.conj());
    let odd = root.conj() * (0.5 * (low - high.conj()));
    let turned = Complex::new(-odd.im, odd.re);
    ((even + turned).conj(), even - turned)
}

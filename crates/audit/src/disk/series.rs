//! Hypergeometric series of several numbers together.

/// Most terms: where the kernels are split they fall as `1 - (s/r)^2`, which is 8/9 at most.
const TERMS: usize = 400;
/// Terms are left out where they have fallen by `exp(-FALLEN)`: coefficients do not grow.
const FALLEN: f64 = 39.2;

/// The coefficients of `2F1(a, b; c; z)`.
#[derive(Debug, Clone, Default)]
pub(super) struct Series(Vec<f64>);

impl Series {
    /// `(a)_n (b)_n/((c)_n n!)`.
    pub(super) fn new(a: f64, b: f64, c: f64) -> Self {
        let mut term = 1.0f64;
        let mut coefficients = Vec::with_capacity(TERMS);
        for k in 0..TERMS {
            coefficients.push(term);
            let n = k as f64;
            term *= (a + n) * (b + n) / ((c + n) * (n + 1.0));
        }
        Self(coefficients)
    }

    /// Its sums for `0 <= z <= largest < 1`.
    #[inline(always)]
    pub(super) fn sums<const N: usize>(&self, z: &[f64; N], largest: f64) -> [f64; N] {
        let count = (FALLEN / -largest.ln()).ceil() as usize + 2;
        let mut found = [0.0; N];
        for coefficient in self.0[..count.min(self.0.len())].iter().rev() {
            for i in 0..N {
                found[i] = found[i] * z[i] + coefficient;
            }
        }
        found
    }
}

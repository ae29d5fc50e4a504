//! Sums and products without rounding.

/// `a + b` and what it loses (D. E. Knuth).
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let other = sum - a;
    (sum, (a - (sum - other)) + (b - other))
}

/// `a b` and what it loses (G. W. Veltkamp, T. J. Dekker); exact where neither overflows nor falls below the normal numbers.
pub(crate) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let split = |x: f64| {
        let scaled = 134_217_729.0 * x;
        let high = scaled - (scaled - x);
        (high, x - high)
    };
    let ((high, low), (other_high, other_low)) = (split(a), split(b));
    let error =
        ((high * other_high - product) + high * other_low + low * other_high) + low * other_low;
    (product, error)
}

/// A sum with what its additions lose (A. Neumaier, ZAMM 54 (1974) 39): off by one rounding of its value, and by `n^2 u^2` of its terms' sizes.
#[derive(Debug, Clone, Default)]
pub(crate) struct Sum {
    value: f64,
    lost: f64,
}

impl Sum {
    pub(crate) fn add(&mut self, term: f64) {
        let (sum, lost) = two_sum(self.value, term);
        self.lost += lost;
        self.value = sum;
    }

    pub(crate) fn value(&self) -> f64 {
        self.value + self.lost
    }

    /// The value, and what is lost by it.
    pub(crate) fn parts(&self) -> (f64, f64) {
        two_sum(self.value, self.lost)
    }
}

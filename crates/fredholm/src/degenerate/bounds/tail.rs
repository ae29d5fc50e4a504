//! The modes of the residual beyond those computed one by one.

/// Terms of the expansion in `1/m^2` that are kept.
const TERMS: usize = 14;
/// Terms of a sum that are added one by one.
const ONE_BY_ONE: usize = 32;

/// Moments and residual of `q = sum_{j<=n} c_j T_j` beyond degree `M >= 4 (n + 1)`. For `m > n + 1`
///
/// `<q, T_m> = -sum_j c_j [a/(m^2 - a^2) - b/(m^2 - b^2)] = -m^-2 sum_k B_k (M/m)^2k`, `a = j + 1`, `b = j - 1`,
///
/// `B_k = sum_j c_j [a (a/M)^2k - b (b/M)^2k]` over the `j` of the parity of `m`. What the kept terms leave is at most
/// `remainder / m^2`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tail {
    last: usize,
    parts: [Part; 2],
}

/// The even or the odd modes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Part {
    terms: [f64; TERMS],
    remainder: f64,
}

impl Tail {
    /// Of the polynomial with these coefficients beyond degree `last`, at least four times their number.
    pub(super) fn new(coefficients: &[f64], last: usize) -> Self {
        let mut parts = [Part::default(); 2];
        let scale = last as f64;
        for (j, &c) in coefficients.iter().enumerate() {
            let (a, b) = (j as f64 + 1.0, j as f64 - 1.0);
            let ratios = [(a / scale).powi(2), (b / scale).powi(2)];
            let mut powers = [c * a, c * b];
            let part = &mut parts[j % 2];
            for term in &mut part.terms {
                *term += powers[0] - powers[1];
                powers = [powers[0] * ratios[0], powers[1] * ratios[1]];
            }
            part.remainder += c.abs();
        }
        // a^(2k+1) - b^(2k+1) <= 2 (2k+1) a^2k, summed over k >= TERMS.
        let square = (coefficients.len() as f64 / scale).powi(2);
        let rest = 1.0 - square;
        let factor = 2.0
            * square.powi(TERMS as i32)
            * ((2 * TERMS + 1) as f64 / rest + 2.0 * square / (rest * rest));
        parts.iter_mut().for_each(|part| part.remainder *= factor);
        Self { last, parts }
    }

    /// `<q, T_m>` for `m > M`, but for the remainder.
    pub(super) fn moment(&self, m: usize) -> f64 {
        let square = (m as f64).powi(-2);
        let ratio = (self.last as f64).powi(2) * square;
        let terms = &self.parts[m % 2].terms;
        -square * terms.iter().rev().fold(0.0, |sum, term| sum * ratio + term)
    }

    /// What the kept terms may leave, times `m^2`.
    pub(super) fn remainder(&self, parity: usize) -> f64 {
        self.parts[parity].remainder
    }

    /// `M`.
    pub(super) fn last(&self) -> usize {
        self.last
    }

    /// `Phi` with `|<q, T_m>| <= Phi / m^2` for `m > M` of this parity.
    pub(super) fn size(&self, parity: usize) -> f64 {
        let part = &self.parts[parity];
        part.terms.iter().map(|term| term.abs()).sum::<f64>() + part.remainder
    }

    /// An upper bound of `sum_{m>M} |r_m|`, `r_m = -theta (2/m) <q, T_m>`, of one parity.
    pub(super) fn supremum(&self, theta: f64, parity: usize) -> f64 {
        // sum_{m = M+1, M+3, ..} m^-3 <= 1/2 int_M m^-3, the function being convex.
        2.0 * theta * self.size(parity) / (4.0 * (self.last as f64).powi(2))
    }

    /// An upper bound of the unweighted norm of `sum_{m>M} r_m T_m` of one parity.
    ///
    /// Every term of the expansion has coefficients that fall monotonically, so by Abel's summation the sum is at most the first of
    /// them over `sin t`, besides the sum of all: `|r(cos t)| <= 2 theta Phi min(S, w / sin t)`.
    pub(super) fn norm(&self, theta: f64, parity: usize) -> f64 {
        let last = self.last as f64;
        let (sum, first) = (1.0 / (4.0 * last * last), (last + 1.0).powi(-3));
        2.0 * theta * self.size(parity) * peaked_norm(sum, first)
    }

    /// An upper bound of `sum_{m>M} |r_m| int T_m|`, even modes; and of the first moment, odd modes.
    pub(super) fn projection(&self, theta: f64, parity: usize) -> f64 {
        // |int T_m| <= 2/(m^2 - 1), |int x T_m| <= 2/(m^2 - 4), both below 2.1/m^2; sum m^-5 <= 1/(8 M^4)
        2.0 * theta * self.size(parity) * 2.1 / (8.0 * (self.last as f64).powi(4))
    }

    /// `sum_{m>M} r_m <u, T_m>` with the tail of another polynomial `u`, and how far it may be off.
    pub(super) fn product(&self, theta: f64, other: &Self) -> (f64, f64) {
        let (mut value, mut radius) = (0.0, 0.0);
        let last = self.last as f64;
        for parity in 0..2 {
            let first = self.last + 1 + (self.last + 1 + parity) % 2;
            let (own, others) = (&self.parts[parity], &other.parts[parity]);
            for power in 0..2 * TERMS - 1 {
                let from = power.saturating_sub(TERMS - 1);
                let coefficient: f64 = (from..=power.min(TERMS - 1))
                    .map(|i| own.terms[i] * others.terms[power - i])
                    .sum();
                value -= 2.0 * theta * coefficient * scaled_sum(first, last, 2 * power);
            }
            let left_out =
                self.size(parity) * others.remainder + own.remainder * other.size(parity);
            radius += 2.0 * theta * left_out / (8.0 * last.powi(4));
        }
        (value, radius)
    }
}

/// The norm in `L2(-1, 1)` of `min(sum, first / sin t)` as a function of `cos t`.
pub(super) fn peaked_norm(sum: f64, first: f64) -> f64 {
    // int_0^pi min(S, w / sin t)^2 sin t dt
    let turn = (first / sum).min(1.0).asin();
    let ends = 4.0 * (sum * (0.5 * turn).sin()).powi(2);
    let middle = -2.0 * first * first * (0.5 * turn).tan().ln();
    (ends + middle.max(0.0)).sqrt()
}

/// `sum_{m = first, first + 2, ..} m^-5 (scale/m)^power`: the first terms one by one, the rest by Euler and Maclaurin.
fn scaled_sum(first: usize, scale: f64, power: usize) -> f64 {
    let term = |m: f64| m.powi(-5) * (scale / m).powi(power as i32);
    let leading: f64 = (0..ONE_BY_ONE).map(|i| term((first + 2 * i) as f64)).sum();
    let m = (first + 2 * ONE_BY_ONE) as f64;
    let p = (power + 5) as f64;
    let ratio = |k: f64| (p + k) / m;
    // Steps of 2: B_2j 2^(2j-1) / (2j)! before the odd derivatives.
    let cubic = ratio(0.0) * ratio(1.0) * ratio(2.0);
    let quintic = cubic * ratio(3.0) * ratio(4.0);
    let series = m / (2.0 * (p - 1.0)) + 0.5 + ratio(0.0) / 6.0 - cubic / 90.0 + quintic / 945.0;
    leading + term(m) * series
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::ChebyshevSeries;

    fn coefficients() -> Vec<f64> {
        (0..=12).map(|j| (1.3 * f64::from(j) + 0.4).cos() / (1.0 + f64::from(j))).collect()
    }

    #[test]
    fn moments_beyond_follow_the_expansion() {
        let (c, last) = (coefficients(), 52);
        let tail = Tail::new(&c, last);
        for (m, exact) in ChebyshevSeries::new(c).moments(4000).into_iter().enumerate().skip(53) {
            let (square, error) = ((m as f64).powi(-2), (tail.moment(m) - exact).abs());
            assert!(error <= (tail.remainder(m % 2) + 1e-15) * square);
            assert!(exact.abs() <= tail.size(m % 2) * square);
        }
    }

    #[test]
    fn sums_beyond_agree_with_addition() {
        for (first, scale, power) in [(65usize, 64.0, 0), (66, 64.0, 2), (65, 64.0, 20)] {
            let exact: f64 = (0..2_000_000)
                .rev()
                .map(|i| {
                    let m = (first + 2 * i) as f64;
                    m.powi(-5) * (scale / m).powi(power)
                })
                .sum();
            let found = scaled_sum(first, scale, power as usize);
            assert!((found / exact - 1.0).abs() < 1e-9, "{power}: {found} {exact}");
        }
    }

    #[test]
    fn norm_and_supremum_hold_for_the_summed_tail() {
        let (c, last) = (coefficients(), 60);
        let tail = Tail::new(&c, last);
        let moments = ChebyshevSeries::new(c).moments(1 << 12);
        for parity in 0..2 {
            let r: Vec<f64> = (moments.iter().enumerate())
                .map(|(m, b)| if m > last && m % 2 == parity { -2.0 * b / m as f64 } else { 0.0 })
                .collect();
            let series = ChebyshevSeries::new(r.clone());
            let gram = series.moments(r.len());
            let norm: f64 = r.iter().zip(&gram).map(|(r, g)| r * g).sum::<f64>().sqrt();
            let sum: f64 = r.iter().map(|r| r.abs()).sum();
            let (bound, supremum) = (tail.norm(1.0, parity), tail.supremum(1.0, parity));
            assert!(norm <= bound && bound < 4.0 * norm, "{norm} {bound}");
            assert!(sum <= supremum && supremum < 2.0 * sum, "{sum} {supremum}");
        }
    }
}

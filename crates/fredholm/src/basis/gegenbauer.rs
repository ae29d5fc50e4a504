//! Gegenbauer polynomials in the normalisation that has a limit for vanishing index.
//!
//! `Q_n = C_n^(mu/2)/C_n^(mu/2)(1)`, `-1 < mu < 1`, orthogonal on `(-1, 1)` with the weight `(1 - t^2)^((mu-1)/2)`: `Q_n(1) = 1`, and `Q_n -> T_n` as
//! `mu -> 0`, where `C_n` itself vanishes. With `C_n^(mu/2)(1) = (mu)_n/n!` the recurrence of `C_n` (DLMF 18.9.1) becomes
//!
//! `t Q_n = alpha_n Q_{n+1} + beta_n Q_{n-1}`, `alpha_n = (n + mu)/(2n + mu)`, `beta_n = n/(2n + mu)`, `alpha_0 = 1`, `beta_0 = 0`.

/// `alpha_n`; 1 at `n = 0`, also for `mu = 0`.
fn up(index: f64, n: usize) -> f64 {
    let n_real = n as f64;
    if n == 0 { 1.0 } else { (n_real + index) / (2.0 * n_real + index) }
}

/// `beta_n`.
fn down(index: f64, n: usize) -> f64 {
    let n_real = n as f64;
    if n == 0 { 0.0 } else { n_real / (2.0 * n_real + index) }
}

/// Fills `values` with `Q_0(t), Q_1(t), ...` for the index `mu`.
pub(crate) fn polynomials(index: f64, t: f64, values: &mut [f64]) {
    let (mut before, mut current) = (0.0, 1.0);
    for (n, value) in values.iter_mut().enumerate() {
        *value = current;
        let next = (t * current - down(index, n) * before) / up(index, n);
        (before, current) = (current, next);
    }
}

/// Fills `values` with `Q_n(1 - u)`, to all digits also where `u` is small: the recurrence of the differences,
/// `alpha_n (Q_{n+1} - Q_n) = beta_n (Q_n - Q_{n-1}) - u Q_n`.
pub(crate) fn polynomials_near_the_end(index: f64, u: f64, values: &mut [f64]) {
    let (mut difference, mut current) = (0.0, 1.0);
    for (n, value) in values.iter_mut().enumerate() {
        *value = current;
        difference = (down(index, n) * difference - u * current) / up(index, n);
        current += difference;
    }
}

/// `sum_n coefficients[n] Q_n(t)`, by Clenshaw's recurrence.
pub(crate) fn sum(index: f64, coefficients: &[f64], t: f64) -> f64 {
    // b_n = c_n + (t/alpha_n) b_{n+1} - (beta_{n+1}/alpha_{n+1}) b_{n+2}
    let (mut first, mut second) = (0.0, 0.0);
    for (n, c) in coefficients.iter().enumerate().rev() {
        let ratio = down(index, n + 1) / up(index, n + 1);
        let next = c + t / up(index, n) * first - ratio * second;
        (first, second) = (next, first);
    }
    first
}

/// `R_km = int_{-1}^{1} Q_k Q_m dt` for `k, m < count`, row by row; 0 for odd `k + m`.
///
/// Row 0 is `2 (mu - 1)/((m + 1)(m + mu - 1))` for even `m`. The rows below follow from `int (t Q_k) Q_m = int Q_k (t Q_m)`:
/// `alpha_k R_{k+1,m} = alpha_m R_{k,m+1} + beta_m R_{k,m-1} - beta_k R_{k-1,m}`.
pub(crate) fn gram(index: f64, count: usize) -> Vec<f64> {
    let mut entries = vec![0.0; count * count];
    let length = (2 * count).saturating_sub(1);
    let coefficients: Vec<[f64; 2]> = (0..length).map(|m| [up(index, m), down(index, m)]).collect();
    let mut before = vec![0.0; length];
    let mut row: Vec<f64> = (0..length)
        .map(|m| {
            let m_real = m as f64;
            let value = 2.0 * (index - 1.0) / ((m_real + 1.0) * (m_real + index - 1.0));
            if m.is_multiple_of(2) { value } else { 0.0 }
        })
        .collect();
    for k in 0..count {
        for m in (k..count).step_by(2) {
            entries[k * count + m] = row[m];
            entries[m * count + k] = row[m];
        }
        // Row k + 1 is needed from its diagonal to the column length - 2 - k; what lies left of the diagonal is never read.
        let [rise, fall] = coefficients[k];
        let mut next = vec![0.0; length];
        for m in (k + 1..length.saturating_sub(1 + k)).step_by(2) {
            let [up, down] = coefficients[m];
            let sum = up * row[m + 1] + down * row[m - 1] - fall * before[m];
            next[m] = sum / rise;
        }
        before = std::mem::replace(&mut row, next);
    }
    entries
}

/// The orthonormal polynomials `p_j` with the weight `(1 - t^2)^(mu - 1/2)`, `-1/2 < mu < 1/2`: `t p_j = b_{j+1} p_{j+1} + b_j p_{j-1}` with
/// `b_j^2 = j (j + 2 mu - 1)/(4 (j + mu)(j + mu - 1))`, `b_1^2 = 1/(2 (1 + mu))` (DLMF 18.3, 18.9).
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Orthonormal {
    /// `p_0`.
    first: f64,
    /// `b_0 = 0, b_1, b_2, ...`.
    coefficients: Vec<f64>,
}

impl Orthonormal {
    /// `p_0 .. p_{count-1}` for the order `mu`.
    pub(crate) fn new(order: f64, count: usize) -> Self {
        let coefficient = |j: usize| {
            let n = j as f64;
            match j {
                0 => 0.0,
                // 0/0 at mu = 0 in the general formula.
                1 => 0.5 / (1.0 + order),
                // The factor that vanishes as mu -> -1/2 keeps its digits as the exact (1/2 + mu) 2.
                2 => (0.5 + order) / ((2.0 + order) * (1.0 + order)),
                _ => n * (n + 2.0 * order - 1.0) / (4.0 * (n + order) * (n + order - 1.0)),
            }
            .sqrt()
        };
        Self {
            first: total_weight(order).sqrt().recip(),
            coefficients: (0..=count).map(coefficient).collect(),
        }
    }

    /// `p_0`, a constant.
    pub(crate) fn first(&self) -> f64 {
        self.first
    }

    /// `b_j`.
    pub(crate) fn coefficient(&self, j: usize) -> f64 {
        self.coefficients[j]
    }

    /// Fills `values` with `p_0(t), p_1(t), ...`, no more than there are.
    pub(crate) fn polynomials(&self, t: f64, values: &mut [f64]) {
        let (mut before, mut current) = (0.0, self.first);
        for (value, b) in values.iter_mut().zip(self.coefficients.windows(2)) {
            *value = current;
            let next = (t * current - b[0] * before) / b[1];
            (before, current) = (current, next);
        }
    }
}

/// `int_{-1}^{1} (1 - t^2)^(mu - 1/2) dt = sqrt(pi) Gamma(mu + 1/2)/Gamma(mu + 1)`.
pub(crate) fn total_weight(order: f64) -> f64 {
    std::f64::consts::PI.sqrt() * libm::tgamma(order + 0.5) / libm::tgamma(order + 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadrature::gauss_jacobi;

    /// Integrals with the weight 1 of products of polynomials, exact.
    fn products(index: f64, count: usize) -> Vec<f64> {
        let rule = bilby::GaussLegendre::new(count + 1).unwrap();
        let mut sums = vec![0.0; count * count];
        let mut values = vec![0.0; count];
        for (t, weight) in rule.nodes().iter().zip(rule.weights()) {
            polynomials(index, *t, &mut values);
            for (k, row) in sums.chunks_exact_mut(count).enumerate() {
                let factor = weight * values[k];
                row.iter_mut().zip(&values).for_each(|(sum, value)| *sum += factor * value);
            }
        }
        sums
    }

    #[test]
    fn the_gram_matrix_agrees_with_quadrature() {
        for index in [-0.98, -0.6, 0.0, 1e-9, 0.3, 0.49, 0.9, 0.999] {
            let count = 240;
            let (found, exact) = (gram(index, count), products(index, count));
            let mut worst = 0.0f64;
            for k in 0..count {
                for m in 0..count {
                    let size = (exact[k * count + k] * exact[m * count + m]).sqrt();
                    worst = worst.max((found[k * count + m] - exact[k * count + m]).abs() / size);
                }
            }
            println!("mu = {index}: {worst:e}");
            assert!(worst < 1e-12, "mu = {index}: {worst:e}");
        }
    }

    #[test]
    fn sums_are_sums() {
        let coefficients: Vec<f64> = (0..50).map(|n| (1.7 * f64::from(n)).cos()).collect();
        for index in [-0.7, 0.0, 1e-9, 0.9] {
            for t in [-1.0, -0.73, 0.0, 0.2, 0.999, 1.0] {
                let mut values = vec![0.0; 50];
                polynomials(index, t, &mut values);
                let exact: f64 = values.iter().zip(&coefficients).map(|(q, c)| q * c).sum();
                let size: f64 = values.iter().zip(&coefficients).map(|(q, c)| (q * c).abs()).sum();
                let error = (sum(index, &coefficients, t) - exact).abs();
                assert!(error < 1e-14 * size, "mu = {index}, t = {t}: {error:e} of {size}");
                let mut near = vec![0.0; 50];
                polynomials_near_the_end(index, 1.0 - t, &mut near);
                for (q, near) in values.iter().zip(&near) {
                    assert!((q - near).abs() < 1e-12 * size, "mu = {index}, t = {t}");
                }
            }
        }
        assert_eq!(sum(0.3, &[], 0.5), 0.0);
    }

    #[test]
    fn without_index_they_are_chebyshev_polynomials() {
        let mut values = [0.0; 40];
        polynomials(0.0, 0.3, &mut values);
        for (n, value) in values.iter().enumerate() {
            assert!((value - (n as f64 * 0.3f64.acos()).cos()).abs() < 1e-14);
        }
    }

    #[test]
    fn the_orthonormal_ones_are_orthonormal() {
        for order in [-0.49, -0.3, 0.0, 1e-9, 0.2, 0.45] {
            let count = 30;
            let basis = Orthonormal::new(order, count);
            let rule = gauss_jacobi(count, order - 0.5, order - 0.5).unwrap();
            let mut products = vec![0.0; count * count];
            let mut values = vec![0.0; count];
            for (t, weight) in rule.nodes.iter().zip(&rule.weights) {
                basis.polynomials(*t, &mut values);
                for k in 0..count {
                    for m in 0..count {
                        products[k * count + m] += weight * values[k] * values[m];
                    }
                }
            }
            for (place, product) in products.iter().enumerate() {
                let exact = f64::from(u8::from(place % (count + 1) == 0));
                assert!((product - exact).abs() < 1e-12, "mu = {order}: {place} {product}");
            }
        }
    }
}

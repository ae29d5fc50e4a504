//! The Gram matrix of the eigenfunctions on a disk.

use super::WeberSonine;
use crate::kernel::{Gram, SpectralRelation};
use crate::linear::dot;
use crate::special::half_gamma_quotient;
use crate::{Error, memory};

impl WeberSonine {
    /// `R_km = int_0^a phi_k phi_m x dx`. For `gamma = 0` by the closed form
    ///
    /// `R_km = (-1)^(k+m+1) a^(2 mu+2) b_k b_m [4 (k^2+m^2) + (4 mu+2)(k+m) + 2 mu] / {[4 (k-m)^2 - 1] 4 (k+m+mu)(k+m+mu+1)}`, `b_k = (1/2)_k/k!`,
    ///
    /// otherwise, `R` without closed form, as the sum `R_km = sum_{l <= min} c_kl c_ml / (2 (2l+mu+1))` over the connection coefficients to `P_l^(mu,0)`
    ///
    /// `c_nl = (-1)^(n-l) (mu+2l+1)/(mu+n+l+1) (beta)_(n-l)/(n-l)! Gamma(n+l+mu+gamma+1/2) Gamma(n+mu+1) / [Gamma(n+l+mu+1) Gamma(n+mu+gamma+1/2)]`,
    ///
    /// `beta = gamma - 1/2` (DLMF 18.18.14), in `count^3/6` multiplications. The recurrence `J R = R J` with the Jacobi matrix from the
    /// first row would take `count^2`, but loses a factor `count^mu`.
    pub(super) fn gram_matrix(&self, count: usize) -> Result<Gram, Error> {
        memory::admit(count, 16.0 * (count as f64).powi(2))?;
        let mut entries =
            if self.exponent == 0.0 { self.closed_form(count) } else { self.by_connection(count) };
        // Both are the compression of multiplication by (1 - x^2)^(1/2-gamma) for a = 1.
        let size = self.radius.powf(0.5 - self.exponent);
        let roots: Vec<f64> = (0..count).map(|n| self.norm(n).sqrt() * size).collect();
        for (row, root) in entries.chunks_exact_mut(count.max(1)).zip(&roots) {
            row.iter_mut().zip(&roots).for_each(|(entry, column)| *entry *= root * column);
        }
        Ok(Gram::Dense { order: count, entries })
    }

    /// `1/sqrt(h_n)` for `a = 1`.
    fn inverse_root_of_norm(&self, n: usize) -> f64 {
        self.unit_norm(n).sqrt().recip()
    }

    fn closed_form(&self, count: usize) -> Vec<f64> {
        let mu = self.order;
        let share = |k: usize| {
            let n = k as f64;
            let b = half_gamma_quotient(n, 0.0) / std::f64::consts::PI.sqrt();
            b * self.inverse_root_of_norm(k)
        };
        let shares: Vec<f64> = (0..count).map(share).collect();
        let entry = |index: usize| {
            let (k, m) = (index / count, index % count);
            if index == 0 {
                return shares[0] * shares[0] / (2.0 * (mu + 1.0));
            }
            let (sum, difference) = ((k + m) as f64, k.abs_diff(m) as f64);
            let (k_part, m_part) = (k as f64, m as f64);
            let numerator =
                4.0 * (k_part * k_part + m_part * m_part) + (4.0 * mu + 2.0) * sum + 2.0 * mu;
            let denominator =
                (4.0 * difference * difference - 1.0) * 4.0 * ((sum + mu) * (sum + mu + 1.0));
            let sign = if (k + m).is_multiple_of(2) { -1.0 } else { 1.0 };
            sign * shares[k] * shares[m] * (numerator / denominator)
        };
        (0..count * count).map(entry).collect()
    }

    /// `R = C C^T` with the coefficients `C` of the eigenfunctions in the orthonormal polynomials without weight.
    fn by_connection(&self, count: usize) -> Vec<f64> {
        let mut connection = vec![0.0; count * count];
        let quotients: Vec<f64> = (0..2 * count).map(|j| self.second_quotient(j as f64)).collect();
        let steps: Vec<f64> = (0..count).map(|j| self.step(j)).collect();
        for (n, row) in connection.chunks_exact_mut(count.max(1)).enumerate() {
            let scale = self.inverse_root_of_norm(n) / quotients[n];
            for (l, entry) in row[..=n].iter_mut().enumerate() {
                let degree = (2 * l + 1) as f64 + self.order;
                let quotient = quotients[n + l] / ((n + l + 1) as f64 + self.order);
                *entry = (0.5 * degree).sqrt() * quotient * steps[n - l] * scale;
            }
        }
        let row = |n: usize, length: usize| &connection[n * count..n * count + length];
        let mut entries = vec![0.0; count * count];
        for k in 0..count {
            for m in 0..=k {
                let entry = dot(row(k, m + 1), row(m, m + 1));
                entries[k * count + m] = entry;
                entries[m * count + k] = entry;
            }
        }
        entries
    }

    /// `(-1)^j (beta)_j / j!`, `beta = gamma - 1/2`.
    fn step(&self, j: usize) -> f64 {
        if j == 0 {
            return 1.0;
        }
        // (beta)_j / j! = beta/j Gamma(j+beta) / (Gamma(1+beta) Gamma(j))
        let strength = (self.exponent - 0.5) / libm::tgamma(self.exponent + 0.5);
        let sign = if j.is_multiple_of(2) { 1.0 } else { -1.0 };
        sign * strength / j as f64 * half_gamma_quotient((j - 1) as f64, self.exponent)
    }
}

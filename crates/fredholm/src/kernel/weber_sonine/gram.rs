//! The Gram matrix of the eigenfunctions on a disk.

use super::WeberSonine;
use crate::kernel::{Gram, SpectralRelation};
use crate::special::gamma_quotient;
use crate::{Error, memory};

/// Share of the memory that one matrix may take.
const SHARE: f64 = 0.4;

impl WeberSonine {
    /// `R_km = int_0^a phi_k phi_m x dx`. For `gamma = 0` by the closed form
    ///
    /// `R_km = (-1)^(k+m+1) a^(2 mu+2) b_k b_m [4 (k^2+m^2) + (4 mu+2)(k+m) + 2 mu] / {[4 (k-m)^2 - 1] 4 (k+m+mu)(k+m+mu+1)}`, `b_k = (1/2)_k/k!`,
    ///
    /// otherwise from the first row `R_0m = (-1)^m (beta)_m / (2 m! (m+mu+1))`, `beta = gamma - 1/2`, by the recurrence `J R = R J` with the Jacobi matrix of the
    /// orthonormal polynomials, which is stable (4e-15 of the largest entry at order 1000).
    pub(super) fn gram_matrix(&self, count: usize) -> Result<Gram, Error> {
        admit(count)?;
        let mut entries =
            if self.exponent == 0.0 { self.closed_form(count) } else { self.by_recurrence(count) };
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
            let b = gamma_quotient(n + 0.5, n + 1.0) / std::f64::consts::PI.sqrt();
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

    /// Row `k + 1` at the columns from `k + 1` on follows from the rows `k` and `k - 1`; each row is two shorter than the one before.
    fn by_recurrence(&self, count: usize) -> Vec<f64> {
        let mut entries = vec![0.0; count * count];
        if count == 0 {
            return entries;
        }
        let length = 2 * count;
        let polynomials = self.polynomials();
        let (diagonal, off): (Vec<f64>, Vec<f64>) =
            (0..length).map(|n| polynomials.recurrence(n)).unzip();
        let mut row = self.first_row(length);
        let mut before = vec![0.0; length];
        for k in 0..count {
            for m in k..count {
                entries[k * count + m] = row[m];
                entries[m * count + k] = row[m];
            }
            let mut next = vec![0.0; length];
            let above = if k == 0 { 0.0 } else { off[k - 1] };
            for m in k + 1..length - k - 1 {
                let product = off[m] * row[m + 1]
                    + (diagonal[m] - diagonal[k]) * row[m]
                    + off[m - 1] * row[m - 1]
                    - above * before[m];
                next[m] = product / off[k];
            }
            before = std::mem::replace(&mut row, next);
        }
        entries
    }

    fn first_row(&self, length: usize) -> Vec<f64> {
        let (mu, beta) = (self.order, self.exponent - 0.5);
        let root = self.inverse_root_of_norm(0);
        // (beta)_m / m! = beta/m Gamma(m+beta) / (Gamma(1+beta) Gamma(m))
        let strength = beta / libm::tgamma(self.exponent + 0.5);
        let entry = |m: usize| {
            let n = m as f64;
            let quotient = if m == 0 {
                1.0
            } else {
                strength / n * gamma_quotient(n - 0.5 + self.exponent, n)
            };
            let sign = if m.is_multiple_of(2) { 1.0 } else { -1.0 };
            sign * quotient / (2.0 * (n + mu + 1.0)) * (root * self.inverse_root_of_norm(m))
        };
        (0..length).map(entry).collect()
    }
}

/// Refuses a matrix that would not fit into memory.
fn admit(count: usize) -> Result<(), Error> {
    let needed = 8 * (count as u64).saturating_mul(count as u64);
    // Small ones fit; asking the system takes longer than computing them.
    if needed <= 16 << 20 {
        return Ok(());
    }
    let available = memory::available();
    if needed as f64 > SHARE * available as f64 {
        return Err(Error::TooLarge { degree: count, needed, available });
    }
    Ok(())
}

//! The paper's bounds of the row sums, as printed and as they should read.
//!
//! All values are per unit `theta0`. The printed figures are kept because the paper's conclusions quote them.
//!
//! | equation | printed | true |
//! |---|---|---|
//! | (4.2), (4.4), (4.5) | `S1 <= (1/2) ln(2/sqrt e) = 0.0965736` for all `p`; `S2_0` equal to it | `2 ln(2/sqrt e) = 2 ln 2 - 1 = 0.3862944`; the printed bound fails at `p = 0`, and holds for `p >= 1` |
//! | (4.7) | `theta0 < 1/2.9074 = 0.34395` | the chain gives `theta0 < 1/3.1971 = 0.31278`; the printed condition is nevertheless sufficient, as the sharp one is `theta0 < 0.463202` |
//! | after (4.8) | `S1 = O(1/p^2)` | `S1 = O(ln p/p^2)`: `p^2 S1 = (ln p + gamma - 1)/4 + o(1)` |
//! | before (4.10) | `1 < p_* < p-1` for `p >= 3` | for `p >= 4`; at `p = 3`, `p_* = 0.959`; (4.10) itself holds |
//! | (4.12), `U` | `ln[(2p-3)/(3(2p-1))]` in the last term | `ln[(2p-1)/(3(2p-3))]`; the printed bound is larger by `(2p/(4p^2-1)) ln[(2p-1)/(2p-3)]`, about `1/(2p^2)`: it holds, but is not the integral in (4.10) |
//! | (4.12), `V` | `(4p+1)/2` before `ln 3` | `(2p+1)/2`; the printed bound is larger by `p ln 3/(4p^2-1)`: it holds, but is not the integral in (4.11) |
//!
//! (4.1), (4.3), (4.6), (4.8), (4.10) and (4.11) are right as printed.

use std::f64::consts::{LN_2, PI};

use super::harmonic::{harmonic, odd_harmonic};
use super::row::{Parity, Row};

/// The printed bound of `S1` in (4.2), (4.4) and (4.5), `(1/2) ln(2/sqrt e) = 0.0965736`. Too small at `p = 0`.
pub const FIRST_SUM_BOUND_PRINTED: f64 = 0.5 * (LN_2 - 0.5);

/// The least upper bound of `S1` over all rows, its value at the first row.
///
/// Even system: `sum_{q>=1} 1/(q(4q^2-1)) = 2 ln 2 - 1`, what (4.2) and (4.5) should read.
/// Odd system, in the same manner: `sum_{q>=1} 2/((2q-1)(4q^2-1)) = pi^2/8 - 1/2`.
#[must_use]
pub fn first_sum_bound(parity: Parity) -> f64 {
    match parity {
        Parity::Even => 2.0 * LN_2 - 1.0,
        Parity::Odd => PI * PI / 8.0 - 0.5,
    }
}

/// The bound (4.3) of `S1` by the Cauchy-Bunyakovsky inequality, `pi sqrt(pi^2-8)/(4 sqrt 6) = 0.4384`; in the
/// odd system `pi sqrt(pi^2-8)/(4 sqrt 2) = 0.7593`.
#[must_use]
pub fn first_sum_cauchy_bound(parity: Parity) -> f64 {
    let root = match parity {
        Parity::Even => 6.0_f64.sqrt(),
        Parity::Odd => 2.0_f64.sqrt(),
    };
    PI * (PI * PI - 8.0).sqrt() / (4.0 * root)
}

/// The bound (4.6) of `S2` by the Cauchy-Bunyakovsky inequality, `pi^2/(4 sqrt 3) = 1.4246`; in the odd system
/// `pi^2/4 = 2.4674`, from `sum_{q>=1} (2/(2q-1))^2 = pi^2/2` in place of `sum 1/q^2 = pi^2/6`.
#[must_use]
pub fn second_sum_bound(parity: Parity) -> f64 {
    match parity {
        Parity::Even => PI * PI / (4.0 * 3.0_f64.sqrt()),
        Parity::Odd => PI * PI / 4.0,
    }
}

/// The paper's bound of all row sums of the even system as printed before (4.7),
/// `2 ln 2 + (1/2) ln(2/sqrt e) + pi^2/(4 sqrt 3) = 2.9074`.
#[must_use]
pub fn supremum_bound_printed() -> f64 {
    2.0 * LN_2 + FIRST_SUM_BOUND_PRINTED + second_sum_bound(Parity::Even)
}

/// The bound of all row sums by the paper's chain with its constant corrected.
///
/// Even system: `2 ln 2 + (2 ln 2 - 1) + pi^2/(4 sqrt 3) = 3.1971`. Odd system, in the same manner:
/// `(pi^2/8 - 1/2) + pi^2/4 = 3 pi^2/8 - 1/2 = 3.2011`.
#[must_use]
pub fn supremum_bound(parity: Parity) -> f64 {
    Row::first(parity).constant_share() + first_sum_bound(parity) + second_sum_bound(parity)
}

/// The right side of (4.8), which bounds `S1` of the even system for `p >= 1`: first term plus integral.
#[must_use]
pub fn first_sum_integral_bound(row: u64) -> f64 {
    let p = row as f64;
    let (low, middle, high) = (2.0 * p - 1.0, 2.0 * p + 1.0, 2.0 * p + 3.0);
    let logarithms = (0.25 * middle * high).ln() - 2.0 * p * (2.0 / middle).ln_1p();
    1.0 / (middle * high) + logarithms / (2.0 * low * middle)
}

/// The split (4.9) `S2 = U + V`, `U = 1/p + W` of one row of the even system, with the paper's bounds of its parts.
///
/// Each bound is valid from the row given beside it in the paper; all are from `p = 4` on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SplitEstimates {
    /// The row's index `p`.
    pub row: u64,
    /// `S1` of (4.1).
    pub first_sum: f64,
    /// Its bound (4.8).
    pub first_sum_bound: f64,
    /// `U` of (4.9), the terms `1 <= q <= p` of `S2`.
    pub near_sum: f64,
    /// Its bound in (4.12) as printed.
    pub near_bound_printed: f64,
    /// Its bound in (4.12) as it follows from (4.10).
    pub near_bound: f64,
    /// `V` of (4.9), the terms `q > p` of `S2`.
    pub far_sum: f64,
    /// Its bound in (4.12) as printed.
    pub far_bound_printed: f64,
    /// Its bound in (4.12) as it follows from (4.11).
    pub far_bound: f64,
}

impl SplitEstimates {
    /// The split of row `p` of the even system, for `4 <= p <=` [`super::LAST_ROW`]; `None` outside, where the
    /// paper gives no bound of `U`.
    #[must_use]
    pub fn new(row: u64) -> Option<Self> {
        let first_sum = Row::new(Parity::Even, row).ok()?.first_sum();
        (row >= 4).then(|| Self {
            row,
            first_sum,
            first_sum_bound: first_sum_integral_bound(row),
            near_sum: near_sum(row),
            near_bound_printed: near_bound(row) + near_bound_excess(row),
            near_bound: near_bound(row),
            far_sum: far_sum(row),
            far_bound_printed: far_bound(row) + far_bound_excess(row),
            far_bound: far_bound(row),
        })
    }
}

/// `U_p = 2/p + (2 O_p + H_p)/(4p^2-1) - 1/(2p-1)^2 - 1/(2p-1)`, `p >= 1`, by partial fractions.
fn near_sum(row: u64) -> f64 {
    let p = row as f64;
    let (low, high) = (2.0 * p - 1.0, 2.0 * p + 1.0);
    let harmonics = (2.0 * odd_harmonic(row) + harmonic(row)) / (low * high);
    1.0 / p + (p - 1.0) / (p * low) + harmonics - low.powi(-2)
}

/// `V_p = 1/(2p-1) - (H_p + 2 ln 2)/(4p^2-1)`, `p >= 1`, by partial fractions.
fn far_sum(row: u64) -> f64 {
    let p = row as f64;
    let (low, high) = (2.0 * p - 1.0, 2.0 * p + 1.0);
    1.0 / low - (harmonic(row) + 2.0 * LN_2) / (low * high)
}

/// `1/p` plus the right side of (4.10), its integral in closed form; `p >= 2`.
fn near_bound(row: u64) -> f64 {
    let p = row as f64;
    let (before, low, high) = (2.0 * p - 3.0, 2.0 * p - 1.0, 2.0 * p + 1.0);
    let logarithms =
        (before * low * (p - 1.0) * (p - 1.0) / 3.0).ln() + 2.0 * p * (3.0 * before / low).ln();
    1.0 / p + 1.0 / (before * low) + 1.0 / (3.0 * (p - 1.0)) + logarithms / (2.0 * low * high)
}

/// What the ratio printed upside down in (4.12) adds to the bound of `U`.
fn near_bound_excess(row: u64) -> f64 {
    let p = row as f64;
    2.0 * p * (2.0 / (2.0 * p - 3.0)).ln_1p() / ((2.0 * p - 1.0) * (2.0 * p + 1.0))
}

/// The right side of (4.11), its integral in closed form; `p >= 1`.
fn far_bound(row: u64) -> f64 {
    let p = row as f64;
    let logarithms = (p + 0.5) * 3.0_f64.ln() - (2.0 * (1.0 + p)).ln();
    1.0 / (3.0 * (p + 1.0)) + logarithms / ((2.0 * p - 1.0) * (2.0 * p + 1.0))
}

/// What `4p+1` printed for `2p+1` in (4.12) adds to the bound of `V`.
fn far_bound_excess(row: u64) -> f64 {
    let p = row as f64;
    p * 3.0_f64.ln() / ((2.0 * p - 1.0) * (2.0 * p + 1.0))
}

//! Row sums of the two infinite systems, in closed form.
//!
//! # Closed forms
//!
//! With `O_p = 1 + 1/3 + ... + 1/(2p-1)`, partial fractions in the running index telescope and leave, per unit
//! `theta0`,
//!
//! - even system, row `p`, degree `2p`:
//!   - `S1 = 2 (O_p - ln 2)/(4p^2-1) - 1/(2p+1)^2`,
//!   - `S2 = 2/p + 2 (O_p - ln 2)/(4p^2-1) - 1/(2p-1)^2` for `p >= 1`, and `S2 = S1` for `p = 0`,
//!   - majorant (4.1): `2 ln 2/|4p^2-1| + S1 + S2`,
//!   - true sum: the majorant less `2/(p (16p^2-1))` for `p >= 1`; at `p = 0` both are `6 ln 2 - 2`.
//! - odd system, row `p`, degree `k = 2p-1`, with `D_p = [O_{p-1} - (p-1)/(2p-1)]/(p(p-1))` for `p >= 2`:
//!   - `S1 = D_p/2`, and `pi^2/8 - 1/2` for `p = 1`,
//!   - `S2 = D_p/2 + 4/k`, and `7/2 - pi^2/8` for `p = 1`,
//!   - true sum: `S1 + S2 - 4/(k (4k^2-1))`.
//!
//! The true sum is smaller because the diagonal entry `R_kk = 1 - 1/(4k^2-1)` is a difference of the two terms
//! whose absolute values (4.1) adds. No two large terms cancel, so the sums keep their digits at any row.
//!
//! # The row sums decrease
//!
//! *Theorem.* In each system the true row sums decrease strictly with `p`, from the first row on. So does the
//! majorant. Their suprema are therefore the values of the first rows, and the rows below any level are
//! all rows from some row on.
//!
//! *Proof, even system.* For `p >= 1` write the sum as `A_p + B_p`, `A_p = (2/p)(1 - 1/(16p^2-1))`,
//! `B_p = c_p/(4p^2-1) - 1/(2p-1)^2 - 1/(2p+1)^2`, `c_p = 4 O_p - 2 ln 2`.
//! As a function of real `p >= 1`, `-A' = (2/p^2)(1 - (48p^2-1)/(16p^2-1)^2) >= (2/p^2)(178/225)`, so
//! `A_p - A_{p+1} >= (356/225)/(p(p+1))`. With `u = 2p+1` and `c_{p+1} = c_p + 4/u`,
//! `B_p - B_{p+1} = 4/(u (u^2-4)) [c_p - (u-2)/u - 2u^2/(u^2-4)]`. For `p >= 2` the bracket is at least
//! `c_2 - 1 - 50/21 > 0.56`, as `c_2 > 3.946`. For `p = 1`, `B_1 - B_2 > -0.353` while `A_1 - A_2 > 0.79`.
//! Row 0 has `2.1589`, row 1 `1.6268`. The majorant has `2/p` in place of `A_p`, whose first step is 1, and
//! the same row 0.
//!
//! *Proof, odd system.* `(4/k)(1 - 1/(4k^2-1))` decreases over `k = 1, 3, 5, ...`, and for `p >= 2`
//! `D_p - D_{p+1} = 2/(p(p+1)) [O_{p-1}/(p-1) - (3p+1)/(4p^2-1)]`, where `O_{p-1} >= 1` and
//! `4p^2-1 - (3p+1)(p-1) = p^2 + 2p > 0`. Row 1 has `5/3` (majorant 3), row 2 `1.6286` (majorant 5/3).

use std::f64::consts::{LN_2, PI};

use super::RegularityError;
use super::harmonic::odd_harmonic;

/// The last row whose sums are offered, `2^50`: indices and degrees up to it are exact in `f64`.
pub const LAST_ROW: u64 = 1 << 50;

/// Which of the two infinite systems the equation splits into.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Parity {
    /// The system (3.10) of even degrees `2p`, `p = 0, 1, 2, ...`: the symmetric part of the solution.
    Even,
    /// The system (3.11) of odd degrees `2p-1`, `p = 1, 2, 3, ...`: the skew-symmetric part.
    Odd,
}

impl Parity {
    /// Index `p` of the system's first row: 0 of (3.10), 1 of (3.11).
    #[must_use]
    pub const fn first_index(self) -> u64 {
        match self {
            Self::Even => 0,
            Self::Odd => 1,
        }
    }

    /// `"even"` or `"odd"`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Even => "even",
            Self::Odd => "odd",
        }
    }
}

/// A row of (3.10) or (3.11). Its sums are **per unit `theta0`**: multiply by `theta0` for `S` of section 4.
///
/// Each sum costs a fixed number of operations at any row; relative error below `1e-15` (measured against 50 digits: `6e-16`).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Row {
    parity: Parity,
    index: u64,
}

impl Row {
    /// The row with index `p`, from [`Parity::first_index`] to [`LAST_ROW`].
    ///
    /// # Errors
    /// [`RegularityError::NoSuchRow`] outside that range.
    pub const fn new(parity: Parity, index: u64) -> Result<Self, RegularityError> {
        if index < parity.first_index() || index > LAST_ROW {
            return Err(RegularityError::NoSuchRow { parity, index });
        }
        Ok(Self { parity, index })
    }

    /// The first row of a system, where its sums are largest.
    #[must_use]
    pub const fn first(parity: Parity) -> Self {
        Self { parity, index: parity.first_index() }
    }

    /// The system the row belongs to.
    #[must_use]
    pub const fn parity(self) -> Parity {
        self.parity
    }

    /// The row's index `p`.
    #[must_use]
    pub const fn index(self) -> u64 {
        self.index
    }

    /// The row's Chebyshev degree: `2p` in the even system, `2p-1` in the odd one.
    #[must_use]
    pub const fn degree(self) -> u64 {
        2 * self.index - self.parity.first_index()
    }

    /// `sum_m a_m |R_km|` over the degrees `m` of the system, `k` the row's degree, with
    /// `R_km = int_{-1}^{1} T_k T_m`, `a_0 = ln 2`, `a_m = 2/m`.
    #[must_use]
    pub fn sum(self) -> f64 {
        let p = self.index as f64;
        match (self.parity, self.index) {
            (Parity::Even, 0) => 6.0 * LN_2 - 2.0,
            (Parity::Odd, 1) => 5.0 / 3.0,
            (Parity::Even, _) => {
                let diagonal = (1.0 - 1.0 / ((4.0 * p - 1.0) * (4.0 * p + 1.0))) / p;
                2.0 * diagonal + even_remainder(self.index)
            }
            (Parity::Odd, _) => {
                let k = 2.0 * p - 1.0;
                let diagonal = (1.0 - 1.0 / ((2.0 * k - 1.0) * (2.0 * k + 1.0))) / k;
                4.0 * diagonal + odd_remainder(self.index)
            }
        }
    }

    /// The paper's row sum with absolute values taken term by term: `2 ln 2/|4p^2-1| + S1 + S2` of (4.1), and
    /// `S1 + S2` of the odd system. Never below [`Row::sum`].
    #[must_use]
    pub fn majorant(self) -> f64 {
        let p = self.index as f64;
        match (self.parity, self.index) {
            (Parity::Even, 0) => self.sum(),
            (Parity::Even, _) => 2.0 / p + even_remainder(self.index),
            (Parity::Odd, _) => 4.0 / (2.0 * p - 1.0) + odd_remainder(self.index),
        }
    }

    /// The share of the constant function, `2 ln 2/|4p^2-1|` in (4.1); 0 in the odd system, which has none.
    #[must_use]
    pub fn constant_share(self) -> f64 {
        match self.parity {
            Parity::Even => 2.0 * LN_2 / product_of_neighbours(self.index).abs(),
            Parity::Odd => 0.0,
        }
    }

    /// `S1` of (4.1), `sum_{q>=1} (1/q)/(4(p+q)^2-1)`; in the odd system
    /// `sum_{q>=1} (2/(2q-1))/(4(p+q-1)^2-1)`.
    #[must_use]
    pub fn first_sum(self) -> f64 {
        match (self.parity, self.index) {
            (Parity::Even, p) => even_logarithm(p) - (2.0 * p as f64 + 1.0).powi(-2),
            (Parity::Odd, 1) => PI * PI / 8.0 - 0.5,
            (Parity::Odd, p) => 0.5 * odd_remainder(p),
        }
    }

    /// `S2` of (4.1), `sum_{q>=1} (1/q)/|4(p-q)^2-1|`; in the odd system
    /// `sum_{q>=1} (2/(2q-1))/|4(p-q)^2-1|`.
    #[must_use]
    pub fn second_sum(self) -> f64 {
        let p = self.index as f64;
        match (self.parity, self.index) {
            (Parity::Even, 0) => self.first_sum(),
            (Parity::Even, _) => 2.0 / p + even_logarithm(self.index) - (2.0 * p - 1.0).powi(-2),
            (Parity::Odd, 1) => 3.5 - PI * PI / 8.0,
            (Parity::Odd, _) => 4.0 / (2.0 * p - 1.0) + 0.5 * odd_remainder(self.index),
        }
    }
}

/// `4p^2 - 1 = (2p-1)(2p+1)`, -1 for `p = 0`.
fn product_of_neighbours(index: u64) -> f64 {
    let p = index as f64;
    (2.0 * p - 1.0) * (2.0 * p + 1.0)
}

/// `2 (O_p - ln 2)/(4p^2-1)`.
fn even_logarithm(index: u64) -> f64 {
    2.0 * (odd_harmonic(index) - LN_2) / product_of_neighbours(index)
}

/// The majorant of the even system less `2/p`: `B_p` of the proof above, for `p >= 1`.
fn even_remainder(index: u64) -> f64 {
    let p = index as f64;
    let squares = (2.0 * p - 1.0).powi(-2) + (2.0 * p + 1.0).powi(-2);
    (4.0 * odd_harmonic(index) - 2.0 * LN_2) / product_of_neighbours(index) - squares
}

/// The majorant of the odd system less `4/(2p-1)`: `D_p` of the proof above, and -1 for `p = 1`.
fn odd_remainder(index: u64) -> f64 {
    if index <= 1 {
        return -1.0;
    }
    let p = index as f64;
    (odd_harmonic(index - 1) - (p - 1.0) / (2.0 * p - 1.0)) / (p * (p - 1.0))
}

//! Gram matrices of systems of cosines.

use super::Gram;
use crate::{Error, memory};

/// `R_km = (c_{|k-m|} + c_{k+m+shift})/2`, `k, m < count`, from `c_0, c_1, ...` up to the largest index needed: products of cosines are half
/// sums of cosines. The shift is 0 for `cos k t` and 1 for `cos((2k + 1) t)`.
pub(super) fn half_sums(
    count: usize,
    shift: usize,
    integrals: impl FnOnce(usize) -> Vec<f64>,
) -> Result<Gram, Error> {
    memory::admit(count.saturating_sub(1), 48.0 * count as f64)?;
    let mut hankel = integrals((2 * count).saturating_sub(1) + shift);
    hankel.iter_mut().for_each(|c| *c *= 0.5);
    let toeplitz = hankel[..count].to_vec();
    hankel.drain(..shift.min(hankel.len()));
    Ok(Gram::ToeplitzHankel { toeplitz, hankel })
}

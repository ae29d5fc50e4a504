//! Gram matrices of systems of cosines.

use super::Gram;
use crate::{Error, memory};

/// Share of the memory at hand that a Gram matrix may take.
const SHARE: f64 = 0.9;

/// Refuses `values` numbers, for the Gram matrix of `count` functions, that would not fit into memory. They come in floating point: the square of
/// a hostile count overflows every integer.
pub(super) fn admit(count: usize, values: f64) -> Result<(), Error> {
    let (needed, available) = (8.0 * values, memory::available());
    if needed > SHARE * available as f64 {
        return Err(Error::TooLarge {
            degree: count.saturating_sub(1),
            needed: needed as u64,
            available,
        });
    }
    Ok(())
}

/// `R_km = (c_{|k-m|} + c_{k+m+shift})/2`, `k, m < count`, from `c_0, c_1, ...` up to the largest index needed: products of cosines are half
/// sums of cosines. The shift is 0 for `cos k t` and 1 for `cos((2k + 1) t)`.
pub(super) fn half_sums(
    count: usize,
    shift: usize,
    integrals: impl FnOnce(usize) -> Vec<f64>,
) -> Result<Gram, Error> {
    admit(count, 6.0 * count as f64)?;
    let mut hankel = integrals((2 * count).saturating_sub(1) + shift);
    hankel.iter_mut().for_each(|c| *c *= 0.5);
    let toeplitz = hankel[..count].to_vec();
    hankel.drain(..shift.min(hankel.len()));
    Ok(Gram::ToeplitzHankel { toeplitz, hankel })
}

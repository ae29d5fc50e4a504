//! What every form of the degenerate system shares: the split by parity, and the factors.

use crate::Error;
use crate::kernel::{Parity, SpectralRelation};

/// The indices `first, first + step, ...` of one independent part of the system.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Indices {
    pub(super) first: usize,
    pub(super) step: usize,
}

impl Indices {
    /// The parts of a system of `count` unknowns: even and odd, (3.10) and (3.11), or all in one.
    pub(super) fn parts(parity: Parity, count: usize) -> impl Iterator<Item = Self> {
        let step = steps(parity);
        (0..step.min(count)).map(move |first| Self { first, step })
    }

    /// The index of the `position`-th unknown of this part.
    pub(super) fn at(self, position: usize) -> usize {
        self.first + self.step * position
    }

    /// The entries of this part.
    pub(super) fn of(self, values: &[f64]) -> impl Iterator<Item = f64> {
        values.iter().skip(self.first).step_by(self.step).copied()
    }

    /// Writes the entries of this part.
    pub(super) fn put(self, part: impl IntoIterator<Item = f64>, values: &mut [f64]) {
        for (value, new) in values.iter_mut().skip(self.first).step_by(self.step).zip(part) {
            *value = new;
        }
    }
}

/// The number of independent parts.
pub(super) fn steps(parity: Parity) -> usize {
    match parity {
        Parity::Alternating => 2,
        Parity::None => 1,
    }
}

/// The parameters for which the symmetric positive form is sure to be positive.
pub(super) fn check_parameter(parameter: f64) -> Result<(), Error> {
    if parameter.is_finite() && parameter >= 0.0 {
        return Ok(());
    }
    Err(Error::InvalidParameter {
        name: "parameter",
        value: parameter,
        requirement: "finite and not negative",
    })
}

/// `D_m = lambda_m / h_m`, `m = 0 .. degree`.
pub(super) fn expansion_factors<K: SpectralRelation + ?Sized>(
    kernel: &K,
    degree: usize,
) -> Result<Vec<f64>, Error> {
    if degree >= kernel.available() {
        return Err(Error::TooFew { needed: degree + 1, available: kernel.available() });
    }
    (0..=degree)
        .map(|index| {
            let factor = kernel.expansion_factor(index);
            if factor.is_finite() {
                return Ok(factor);
            }
            Err(Error::NotFinite {
                what: "factor of the bilinear expansion",
                at: index as f64,
                value: factor,
            })
        })
        .collect()
}

/// The same where all must be positive.
pub(super) fn positive_factors<K: SpectralRelation + ?Sized>(
    kernel: &K,
    degree: usize,
) -> Result<Vec<f64>, Error> {
    let factors = expansion_factors(kernel, degree)?;
    match factors.iter().position(|factor| *factor <= 0.0) {
        Some(index) => Err(Error::NotPositive { index, eigenvalue: kernel.eigenvalue(index) }),
        None => Ok(factors),
    }
}

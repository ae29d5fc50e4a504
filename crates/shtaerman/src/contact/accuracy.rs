//! How sure an answer is.

use std::ops::Add;

use serde::Serialize;

use super::balance::State;
use super::stiffness::Stiffness;
use crate::{Load, Rotational};

/// Rounding of a quantity relative to what is added up in it (survey).
pub(super) const ROUNDING: f64 = 32.0 * f64::EPSILON;
/// What is stated, or allowed, over a difference that does not fall by a known rate (survey).
pub(super) const SAFETY: f64 = 4.0;
/// A residual, or a difference of two resolutions, that does not fall any more is rounding below this share of its scale (survey).
pub(super) const STAGNANT: f64 = 1e-9;

/// What a statement of error is worth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ErrorKind {
    /// Guaranteed, rounding aside, under the assumptions of the method.
    Bound,
    /// Likely: from the comparison of resolutions.
    Estimate,
}

impl ErrorKind {
    /// Name as in answers.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Bound => "bound",
            Self::Estimate => "estimate",
        }
    }
}

/// The error of an answer, without dimensions; zero for what the load prescribes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Accuracy {
    /// Bound or estimate.
    pub(crate) kind: ErrorKind,
    /// Of the pressure `p0`, largest over the closed base.
    pub(crate) pressure: f64,
    /// Of `delta0`.
    pub(crate) settlement: f64,
    /// Of `alpha0`.
    pub(crate) tilt: f64,
    /// Of `P0`.
    pub(crate) force: f64,
    /// Of `M0`.
    pub(crate) moment: f64,
}

/// Sizes against which the errors of an answer are held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sizes {
    /// Largest `|p0|`.
    pub(super) pressure: f64,
    /// Larger of `|delta0|` and `|alpha0|`.
    pub(super) displacement: f64,
    /// Larger of `|P0|` and `|M0|`; where nothing presses, and pressures of both signs balance on a base that is kept in contact, no less than `|p0|`.
    pub(super) force: f64,
}

impl State {
    /// Sizes of this state with so large a pressure.
    pub(super) fn sizes(&self, pressure: f64) -> Sizes {
        let balanced = if self.force == 0.0 { pressure } else { 0.0 };
        Sizes {
            pressure,
            displacement: self.settlement.abs().max(self.tilt.abs()),
            force: self.force.abs().max(self.moment.abs()).max(balanced),
        }
    }
}

impl Accuracy {
    /// An estimate of no less than this share of each size, where nothing is known of the profile between samples.
    pub(super) fn of_the_unknown(self, share: f64, sizes: &Sizes) -> Self {
        Self { kind: ErrorKind::Estimate, ..self.at_least(share, sizes) }
    }

    /// No error below this share of its size; what the load prescribes stays exact.
    pub(super) fn at_least(self, share: f64, sizes: &Sizes) -> Self {
        let Sizes { pressure, displacement, force } = *sizes;
        let least = [displacement, displacement, force, force].map(|size| share * size);
        let pressure = self.pressure.max(share * pressure);
        Self { pressure, ..self.open(least, f64::max) }
    }

    /// With what is made of the errors of settlement, tilt, force and moment and a number beside each; what is exact, prescribed or zero by symmetry, stays so.
    pub(super) fn open(self, beside: [f64; 4], made: impl Fn(f64, f64) -> f64) -> Self {
        let known = [self.settlement, self.tilt, self.force, self.moment];
        let [settlement, tilt, force, moment] =
            std::array::from_fn(|k| if known[k] == 0.0 { 0.0 } else { made(known[k], beside[k]) });
        Self { settlement, tilt, force, moment, ..self }
    }

    /// Without errors of what the load prescribes.
    pub(super) fn under(self, load: &Load) -> Self {
        let (by_force, rotational) = (load.vertical.force().is_some(), load.rotational);
        let unless = |is_given: bool, error: f64| if is_given { 0.0 } else { error };
        Self {
            settlement: unless(!by_force, self.settlement),
            tilt: unless(rotational.tilt().is_some(), self.tilt),
            force: unless(by_force, self.force),
            moment: unless(matches!(rotational, Rotational::Moment(_)), self.moment),
            ..self
        }
    }

    /// What a series that misses the profile by `error` adds: `A^-1` has norms near one, so each displacement moves by about as much, the pressure by twice that
    /// and forces by the stiffnesses `c11`, `c22` times that. An estimate.
    pub(super) fn with_profile_error(self, error: f64, stiffness: [f64; 2]) -> Self {
        let by = [error, 2.0 * error, stiffness[0] * error, 2.0 * stiffness[1] * error];
        let pressure = self.pressure + 2.0 * error;
        Self { kind: ErrorKind::Estimate, pressure, ..self.open(by, f64::add) }
    }

    /// With what penetration of this depth leaves: no displacement moves by more where it is taken away (the maximum principle), and forces by the stiffnesses times that.
    pub(super) fn with_left(self, depth: f64, stiffness: &Stiffness) -> Self {
        if depth == 0.0 {
            return self;
        }
        let [force, turn] = [stiffness.force_settlement, stiffness.moment_tilt].map(f64::abs);
        self.open([depth, 2.0 * depth, force * depth, 2.0 * turn * depth], f64::add)
    }

    pub(crate) fn is_finite(&self) -> bool {
        let parts = [self.pressure, self.settlement, self.tilt, self.force, self.moment];
        parts.into_iter().all(f64::is_finite)
    }

    /// The largest error relative to its size.
    pub(super) fn relative(&self, sizes: &Sizes) -> f64 {
        let parts = [
            (self.pressure, sizes.pressure),
            (self.settlement.max(self.tilt), sizes.displacement),
            (self.force.max(self.moment), sizes.force),
        ];
        parts.into_iter().fold(0.0, |worst: f64, (error, size)| {
            worst.max(if error == 0.0 { 0.0 } else { error / size })
        })
    }
}

//! Where the punch touches the body: one strip, a pair, a periodic row, a disk.

use serde::{Deserialize, Serialize};

use crate::Error;
use crate::error::require;

/// The geometry of the contact; lengths in the units of the problem.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Geometry {
    /// One punch, `|x| <= a`, plane strain.
    #[default]
    Plane,
    /// Two equal punches of one rigid body, `b <= |x| <= a`, plane strain.
    Pair {
        /// `b`, half the gap between them.
        inner_half_gap: f64,
    },
    /// Punches `|x - k L| <= a`, `k` any whole number, loaded alike; plane strain. `L = 2a` is a base without gaps.
    Periodic {
        /// `L`.
        period: f64,
    },
    /// A circular punch, `r <= a`.
    Circular,
}

impl Geometry {
    /// The geometry in half-widths.
    #[must_use]
    pub fn scaled(&self, half_width: f64) -> Self {
        match *self {
            Self::Pair { inner_half_gap } => {
                Self::Pair { inner_half_gap: inner_half_gap / half_width }
            }
            Self::Periodic { period } => Self::Periodic { period: period / half_width },
            other => other,
        }
    }

    /// The pieces of the base as `xi`, from left to right; of a circular one the diameter.
    #[must_use]
    pub fn pieces(&self, half_width: f64) -> Vec<[f64; 2]> {
        match self.scaled(half_width) {
            Self::Pair { inner_half_gap } => vec![[-1.0, -inner_half_gap], [inner_half_gap, 1.0]],
            Self::Plane | Self::Periodic { .. } | Self::Circular => vec![[-1.0, 1.0]],
        }
    }

    /// Name as in problem files.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Plane => "plane",
            Self::Pair { .. } => "pair",
            Self::Periodic { .. } => "periodic",
            Self::Circular => "circular",
        }
    }

    /// Length of the base in half-widths, in one period of a row; area in `a^2` of a circular one.
    #[must_use]
    pub fn measure(&self, half_width: f64) -> f64 {
        match self {
            Self::Circular => std::f64::consts::PI,
            _ => self.pieces(half_width).iter().map(|[left, right]| right - left).sum(),
        }
    }

    /// Whether the base fills the whole period of a row: it cannot tilt then.
    #[must_use]
    pub fn is_wave(&self, half_width: f64) -> bool {
        matches!(self, Self::Periodic { period } if *period <= 2.0 * half_width)
    }

    /// What the settlement is measured against on a homogeneous foundation.
    #[must_use]
    pub fn gauge(&self) -> &'static str {
        match self {
            Self::Plane => "ln(a/|x-s|), a = half_width",
            Self::Pair { .. } => "ln(a/|x-s|), a = outer_half_width",
            Self::Periodic { .. } => "ln(1/(2 sin(pi|x-s|/L))), L = period",
            Self::Circular => "zero at infinity",
        }
    }

    /// Refuses lengths that do not fit a punch of this half-width.
    ///
    /// # Errors
    /// [`Error::InvalidValue`].
    pub(crate) fn check(&self, half_width: f64) -> Result<(), Error> {
        match *self {
            Self::Pair { inner_half_gap: gap } => require(
                gap > 0.0 && gap < half_width,
                "inner_half_gap",
                gap,
                "greater than zero and less than outer_half_width",
            )
            .map(|_| ()),
            Self::Periodic { period } => require(
                period.is_finite() && period >= 2.0 * half_width,
                "period",
                period,
                "finite and at least twice half_width: punches do not overlap",
            )
            .map(|_| ()),
            Self::Plane | Self::Circular => Ok(()),
        }
    }
}

//! The kernels whose operators are positive.

use crate::norms;

/// What a kernel does where its points meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Singularity {
    /// `ln|x - s|`.
    Logarithm,
    /// `|x - s|^-mu`, `0 < mu < 1`.
    Power(f64),
}

impl Singularity {
    /// `mu`, 0 for the logarithm.
    pub(crate) fn exponent(self) -> f64 {
        match self {
            Self::Logarithm => 0.0,
            Self::Power(mu) => mu,
        }
    }

    /// `sigma(d)`.
    #[cfg(test)]
    pub(crate) fn value(self, d: f64) -> f64 {
        match self {
            Self::Logarithm => d.ln(),
            Self::Power(mu) => d.powf(-mu),
        }
    }
}

/// A symmetric kernel that is positive semidefinite on a base within `[-1, 1]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kernel {
    /// `ln(1/|x - s|)`: positive on any set within an interval of length 2.
    Logarithm,
    /// `ln(1/|x - s|) + c` with `c >= -ln 2`, below which it is not positive on `[-1, 1]`: the logarithm of an interval of half-length `a <= 2` that was scaled to 1, `c = -ln a`.
    ShiftedLogarithm {
        /// `c`.
        constant: f64,
    },
    /// `ln(1/(2 sin(pi|x - s|/L)))` with the period `L >= 2`: its modes are `L/(2 k)`, `k >= 1`, and 0 for the mean.
    Row {
        /// `L`.
        period: f64,
    },
    /// `|x - s|^-mu`, `0 < mu < 1`: its Fourier transform is positive.
    Power {
        /// `mu`.
        exponent: f64,
    },
}

impl Kernel {
    pub(crate) fn singularity(self) -> Singularity {
        match self {
            Self::Logarithm | Self::ShiftedLogarithm { .. } | Self::Row { .. } => {
                Singularity::Logarithm
            }
            Self::Power { exponent } => Singularity::Power(exponent),
        }
    }

    /// What is added to the singular part everywhere.
    pub(crate) fn constant(self) -> f64 {
        match self {
            Self::ShiftedLogarithm { constant } => constant,
            Self::Logarithm | Self::Row { .. } | Self::Power { .. } => 0.0,
        }
    }

    /// A bound of `max_x int |K(x, s)| ds` over `[-1, 1]`, and so of the norm of `K` in `L2` and between bounded functions.
    #[must_use]
    pub fn mass(self) -> f64 {
        norms::mass(self, 1.0)
    }

    /// A bound of `max_x ||K(x, .)||` in `L2` of `[-1, 1]`; infinite for powers from 1/2 on.
    #[must_use]
    pub fn row_norm(self) -> f64 {
        norms::row_norm(self)
    }
}

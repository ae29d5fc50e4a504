//! The kernels whose operators are positive.

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

/// How often the kernel of a layer is split by wave numbers.
pub(crate) const SPLITS: usize = 24;

/// What is known of `ln(1/d) + R(d)` on `[-1, 1]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layered {
    /// `c`, in the middle of the values of `R`.
    pub(crate) constant: f64,
    /// A bound of `|R - c|`.
    pub(crate) rest: f64,
    /// Whether it is positive for pressures that have a force, too.
    pub(crate) is_positive: bool,
    /// For wave numbers of which those below are split off: the value at 0 of the part below, and the norm of a row of the part above.
    pub(crate) splits: Option<[[f64; 2]; SPLITS]>,
}

/// A symmetric kernel that is positive semidefinite on a base within `[-1, 1]`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(
    clippy::large_enum_variant,
    reason = "a few are made for each audit, and boxes would take the copies away"
)]
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
    /// Plane ground that a transfer function describes, see [`Ground`](crate::Ground).
    Layered(Layered),
    /// `|x - s|^-mu`, `0 < mu < 1`: its Fourier transform is positive.
    Power {
        /// `mu`.
        exponent: f64,
    },
}

impl Kernel {
    pub(crate) fn singularity(self) -> Singularity {
        match self {
            Self::Logarithm
            | Self::ShiftedLogarithm { .. }
            | Self::Layered(_)
            | Self::Row { .. } => Singularity::Logarithm,
            Self::Power { exponent } => Singularity::Power(exponent),
        }
    }

    /// A bound of what it has beside the singular part and the constant.
    pub(crate) fn rest(self) -> f64 {
        match self {
            Self::Layered(layered) => layered.rest,
            Self::Logarithm
            | Self::ShiftedLogarithm { .. }
            | Self::Row { .. }
            | Self::Power { .. } => 0.0,
        }
    }

    /// What is added to the singular part everywhere.
    pub(crate) fn constant(self) -> f64 {
        match self {
            Self::ShiftedLogarithm { constant } => constant,
            Self::Layered(layered) => layered.constant,
            Self::Logarithm | Self::Row { .. } | Self::Power { .. } => 0.0,
        }
    }
}

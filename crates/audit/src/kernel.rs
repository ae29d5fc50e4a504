//! The kernels whose operators are positive, and the norms of them that bounds need.

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

    /// A bound of `max_x int |K(x, s)| ds` over the base, and so of the norm of `K` in `L2` and between bounded functions.
    ///
    /// The logarithm: `F(1-x) + F(1+x)` with `F(t) = int_0^t |ln u| du` is largest in the middle, 2. The power: `2/(1-mu)` in the middle. The row: `int_0^(L/2)` twice of
    /// `|ln(2 sin)|`, `L/pi int_0^pi |ln(2 sin(u/2))| du / 1 <= 0.6461 L`, with what lies farther than half a period counted twice.
    #[must_use]
    pub fn mass(self) -> f64 {
        match self {
            Self::Logarithm => 2.0,
            Self::ShiftedLogarithm { constant } => 2.0 + 2.0 * constant.abs(),
            Self::Row { period } => 0.66 * period,
            Self::Power { exponent } => 2.0 / (1.0 - exponent),
        }
    }

    /// A bound of `max_x ||K(x, .)||` in `L2` of the base; infinite for powers from 1/2 on.
    ///
    /// The logarithm: `int_0^1 ln^2 u du = 2` to either side, in all 4, largest in the middle. The power: `2/(1 - 2 mu)`. The row: `L sum 1/(2 k^2) = L pi^2/12`.
    #[must_use]
    pub fn row_norm(self) -> f64 {
        match self {
            Self::Logarithm => 2.0,
            Self::ShiftedLogarithm { constant } => 2.0 + std::f64::consts::SQRT_2 * constant.abs(),
            Self::Row { period } => (period * std::f64::consts::PI.powi(2) / 12.0).sqrt(),
            Self::Power { exponent } if exponent < 0.5 => (2.0 / (1.0 - 2.0 * exponent)).sqrt(),
            Self::Power { .. } => f64::INFINITY,
        }
    }

    /// A number `C` with `theta |K e|(x) <= C ||w||` wherever `<(1 + theta K) e, e> <= ||w|| ||e||`, beside `theta row_norm`: see [`Kernel::smoothing`].
    ///
    /// The kernel is split at its mode `N`: of the part below the energy of `e` is bounded, of the part above the norm. With `alpha^2 = theta sum of the modes below` and
    /// `beta = theta` times the norm of what is above, `C = (beta + sqrt(alpha^2 + beta^2))/2`.
    #[must_use]
    pub(crate) fn smoothing(self, theta: f64) -> f64 {
        let plain = theta * self.row_norm();
        let mut best = plain;
        let mut harmonic = 0.0;
        for n in 1..=4096u32 {
            harmonic += 1.0 / f64::from(n);
            if !n.is_power_of_two() {
                continue;
            }
            let (energy, above) = match self {
                // Modes (2/m) T_m, ln 2 the first; the unweighted norm of the rest is at most the weighted one.
                Self::Logarithm | Self::ShiftedLogarithm { .. } => (
                    self.constant() + std::f64::consts::LN_2 + 2.0 * harmonic,
                    (std::f64::consts::TAU / f64::from(n)).sqrt(),
                ),
                // sum cos(2 pi k d/L)/k
                Self::Row { period } => (harmonic, (0.5 * period / f64::from(n)).sqrt()),
                Self::Power { exponent } => return self.power_smoothing(exponent, theta),
            };
            let (alpha, beta) = (theta * energy, theta * above);
            best = best.min(0.5 * (beta + (alpha + beta * beta).sqrt()));
        }
        best
    }

    /// Of the power: [`Kernel::row_norm`] where it is finite; else the near part, of the mass 1/2 over theta, is left to the largest error, and twice the norm of the far part counts.
    fn power_smoothing(self, mu: f64, theta: f64) -> f64 {
        let plain = theta * self.row_norm();
        let near = self.near(theta);
        if near >= 1.0 {
            return plain.min(f64::MAX);
        }
        let square = if (mu - 0.5).abs() < 1e-9 {
            2.0 * (1.0 / near).ln() + 1e-6
        } else {
            2.0 * (near.powf(1.0 - 2.0 * mu) - 1.0) / (2.0 * mu - 1.0)
        };
        (2.0 * theta * square.abs().sqrt()).min(plain)
    }

    /// The distance within which `theta int |K|` is a half.
    pub(crate) fn near(self, theta: f64) -> f64 {
        let mu = self.singularity().exponent();
        ((1.0 - mu) / (4.0 * theta)).powf(1.0 / (1.0 - mu))
    }

    /// Whether the bound of the largest error counts the residual twice, see [`Kernel::smoothing`].
    pub(crate) fn doubles(self, theta: f64) -> bool {
        matches!(self, Self::Power { .. }) && self.smoothing(theta) < theta * self.row_norm()
    }
}

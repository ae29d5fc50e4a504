//! Which errors are broken promises of a method, and which bad input.

use super::{Error, InverseError};

impl Error {
    /// Whether a numerical promise failed, as opposed to bad input: exit code 3 instead of 2.
    #[must_use]
    pub fn is_numerical(&self) -> bool {
        matches!(
            self,
            Self::ToleranceNotMet { .. }
                | Self::NotComplementary { .. }
                | Self::TooManyZones { .. }
                | Self::NotAccurate { .. }
                | Self::NotBounded { .. }
                | Self::UnclearBend
                | Self::AuditFailed { .. }
                | Self::TimeLimit { .. }
                | Self::WorkLimit { .. }
                | Self::TooManyParts { .. }
                | Self::TooNarrow { .. }
                | Self::ZonesTooClose { .. }
                | Self::EquationTolerance { .. }
                | Self::EquationUnsolved { .. }
                | Self::InfiniteSolution { .. }
                | Self::OwnEquationUnsolved { .. }
                | Self::CheckUnsolved { .. }
                | Self::NoReference { .. }
                | Self::Beyond(_)
                | Self::Inverse(InverseError::Unsolved { .. } | InverseError::NotSolved { .. })
                | Self::Equation(
                    fredholm::Error::TooLarge { .. }
                        | fredholm::Error::BeyondMethod { .. }
                        | fredholm::Error::NotPositiveDefinite { .. }
                        | fredholm::Error::NotConverged { .. }
                        | fredholm::Error::EigenvaluesNotFound { .. }
                        | fredholm::Error::Singular { .. }
                        | fredholm::Error::ZeroEigenvalue { .. }
                        | fredholm::Error::InSpectrum { .. }
                )
        )
    }

    /// What an audit refused, where the method states a relative error of its own.
    pub(crate) fn of_audit(self, stated: f64) -> Self {
        match self {
            Self::NotAccurate { reached, most, method, n, .. } => {
                Self::NotBounded { reached, most, stated, method, n }
            }
            other => other,
        }
    }
}

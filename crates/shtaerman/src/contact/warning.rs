//! What a user should know about an answer.

use serde::Serialize;

/// Kind of a warning, stable across releases.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum WarningCode {
    /// The bilateral answer pulls somewhere: the pressure is negative.
    NegativePressure,
    /// The profile could not be resolved to rounding (a kink, a jump, fast oscillation).
    ProfileNotResolved,
    /// The degree is too low for this roughness: the answer has few digits.
    LowDegree,
}

/// A warning with its text.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Warning {
    /// Kind.
    pub code: WarningCode,
    /// One sentence for people, with figures.
    pub message: String,
}

//! Why an answer has no audit.

use shtaerman_audit::Refusal;

/// Why an answer has no audit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Unaudited {
    /// The theorem does not hold for it.
    NotCovered(&'static str),
    /// No bound was found.
    Refused(Refusal),
    /// No finite bound was found.
    NotFinite,
    /// On graded ground with an exponent from 1/2 on the pressure has corners so sharp that the residual bounds it in the mean only.
    InTheMeanOnly {
        /// The bound of the error in the mean square, relative to the largest pressure.
        mean_square: f64,
    },
}

impl std::fmt::Display for Unaudited {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NotCovered(reason) => formatter.write_str(reason),
            Self::NotFinite => formatter.write_str(
                "no finite bound of its error was found: the pressure changes too sharply for it, which more roughness or a lower grading exponent mends",
            ),
            Self::InTheMeanOnly { mean_square } => write!(
                formatter,
                "beside corners of the pressure on graded ground with an exponent from 1/2 on the residual bounds it in the mean square only, by {mean_square:.1e} of its largest value"
            ),
            Self::Refused(Refusal::NoPressure) => formatter.write_str("the pressure is not finite"),
            Self::Refused(Refusal::TooManyPanels) => {
                formatter.write_str("the pressure bends at more places than the audit follows")
            }
            Self::Refused(Refusal::TooManyWindows { at }) => {
                write!(
                    formatter,
                    "the residual near xi = {at} changes faster than the audit follows"
                )
            }
            Self::Refused(Refusal::Penetrates { at }) => {
                write!(
                    formatter,
                    "the base penetrates near xi = {at:.6}, where the answer has no contact"
                )
            }
            Self::Refused(Refusal::LoadNotMet) => {
                formatter.write_str("the pressure is far from the prescribed force or moment")
            }
        }
    }
}

impl Unaudited {
    /// A wave on a power law under a settlement: its force is bounded by nothing.
    pub(super) const NOT_ESTIMATED: Self =
        Self::NotCovered("the residual says nothing of its errors: the estimate is not finite");
}

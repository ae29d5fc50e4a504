//! Why an answer has no audit.

use shtaerman_audit::Refusal;

/// Why an answer has no audit.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Unaudited {
    /// The theorem does not hold for it.
    #[error("{0}")]
    NotCovered(&'static str),
    /// No bound was found.
    #[error(transparent)]
    Refused(Refusal),
    /// No finite bound was found.
    #[error(
        "no finite bound of its error was found: the pressure changes too sharply for it, which more roughness or a lower grading exponent mends"
    )]
    NotFinite,
    /// On graded ground with an exponent from 1/2 on the pressure has corners so sharp that the residual bounds it in the mean only.
    #[error(
        "beside corners of the pressure on graded ground with an exponent from 1/2 on the residual bounds it in the mean square only, by {mean_square:.1e} of its largest value"
    )]
    InTheMeanOnly {
        /// The bound of the error in the mean square, relative to the largest pressure.
        mean_square: f64,
    },
}

impl Unaudited {
    /// A wave on a power law under a settlement: its force is bounded by nothing.
    pub(super) const NOT_ESTIMATED: Self =
        Self::NotCovered("the residual says nothing of its errors: the estimate is not finite");
    /// What is unknown on ground graded to [`SHARP`](super::ground::SHARP).
    pub(super) const TOO_SHARP: Self = Self::NotCovered(
        "beside corners of the pressure on graded ground with an exponent from 1/2 on the residual tells it to no hundredth of its largest value",
    );
}

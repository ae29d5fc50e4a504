//! How finely smooth contact is resolved, and how far its search goes.

/// How finely pressures on zones are resolved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Detail {
    /// Digits to which modes are kept.
    pub(super) digits: f64,
    /// Panels of the slopes on a half turn before any is halved.
    pub(super) panels: usize,
}

/// Detail while zones are looked for, in the answer, and for its error: with other panels rounding comes out differently, too.
pub(super) const COARSE: Detail = Detail { digits: 9.0, panels: 8 };
pub(super) const FINE: Detail = Detail { digits: 17.0, panels: 8 };
pub(super) const COMPARED: Detail = Detail { digits: 12.0, panels: 7 };
/// Coefficients or differences this small relative to the largest value, that do not fall when a panel is halved, are noise. Half and twice change none of 32 answers (survey).
pub(super) const NOISE: f64 = 1e-11;
/// Cubes of the numbers of modes, added up over all solutions of a problem, after which the search for zones ends: about fifteen seconds; and what a panel costs in the
/// same unit. Half and twice change none of 32 answers (survey).
pub(super) const MOST_WORK: f64 = 3e11;
pub(super) const A_PANEL: f64 = 6e4;

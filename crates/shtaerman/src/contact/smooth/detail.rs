//! How finely smooth contact is resolved, and how far its search goes.

use crate::contact::search::Start;

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
/// Coefficients or differences this small relative to the largest value, that do not fall when a panel is halved, are noise.
pub(super) const NOISE: f64 = 1e-11;
/// Panels are halved at most this often.
pub(super) const DEEPEST: u32 = 44;
/// Rounding of a quantity relative to what is added up in it.
pub(super) const ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Cubes of the numbers of modes, added up over all solutions of a problem, after which the search for zones ends: about fifteen seconds; and what a panel costs in the
/// same unit.
pub(super) const MOST_WORK: f64 = 3e11;
pub(super) const A_PANEL: f64 = 6e4;
/// Numbers of cells, each four times the one before.
const TOPOLOGIES: u32 = 3;

/// Numbers of cells to look for zones with, each four times the one before.
pub(super) fn numbers_of_cells(first: usize, most: usize) -> Vec<Start> {
    let mut counts: Vec<usize> =
        (0..TOPOLOGIES).map(|power| (first * 4usize.pow(power)).min(most)).collect();
    counts.dedup();
    counts.into_iter().map(Start::Cells).collect()
}

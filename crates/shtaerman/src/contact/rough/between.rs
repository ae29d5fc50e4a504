//! Places between the nodes.

use crate::contact::iteration::GOLDEN;

/// Places on a panel at which resolutions are compared, and the pressure is looked at. At half or twice 1 of 32 differ beyond what is stated and stated errors grow up to 2.8 times (survey).
pub(super) const PLACES: usize = 128;

/// Both ends, the middle, and a golden-ratio sequence of angles between, which no grid of a method shares.
pub(super) fn between_nodes(count: usize) -> impl Iterator<Item = f64> {
    let between = (1..=count).map(|i| (std::f64::consts::PI * (i as f64 * GOLDEN).fract()).cos());
    [-1.0, 0.0, 1.0].into_iter().chain(between)
}

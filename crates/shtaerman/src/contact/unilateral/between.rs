//! Places between the nodes.

/// Both ends, the middle, and a golden-ratio sequence of angles between, which no grid of a method shares.
pub(super) fn between_nodes(count: usize) -> impl Iterator<Item = f64> {
    const STEP: f64 = 0.618_033_988_749_894_9;
    let between = (1..=count).map(|i| (std::f64::consts::PI * (i as f64 * STEP).fract()).cos());
    [-1.0, 0.0, 1.0].into_iter().chain(between)
}

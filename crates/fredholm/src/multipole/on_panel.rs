//! A place as a panel sees it.

/// Where a place lies on a panel, or beside it, in halves of its length.
///
/// Potentials of powers go with `d^(1 - mu)` of the distance `d` from an end, and only those of both panels that meet there together are smooth: `1 - z` would leave of a short distance no digits.
#[derive(Debug, Clone, Copy)]
pub(super) struct OnPanel {
    /// From -1 to 1 on the panel.
    pub(super) z: f64,
    /// From the left end to the place, and from there to the right end: negative beyond it.
    pub(super) from_left: f64,
    pub(super) to_right: f64,
}

impl OnPanel {
    /// From the distances to both ends.
    pub(super) fn new(from_left: f64, to_right: f64) -> Self {
        let z = if from_left < to_right { from_left - 1.0 } else { 1.0 - to_right };
        Self { z, from_left, to_right }
    }

    /// A place that is known no better than by this.
    pub(super) fn at(z: f64) -> Self {
        Self { z, from_left: 1.0 + z, to_right: 1.0 - z }
    }

    /// The distances to the farther end and to the nearer one.
    pub(super) fn to_ends(self) -> [f64; 2] {
        let [left, right] = [self.from_left, self.to_right];
        if self.z < 0.0 { [right, left] } else { [left, right] }
    }
}

//! Places that need not be numbers of the machine.

/// Places `from + offset`: on intervals of a few numbers of the machine, too, they can lie where nodes are wanted.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Places<'a> {
    pub(crate) from: f64,
    pub(crate) offsets: &'a [f64],
}

impl<'a> Places<'a> {
    /// Numbers of the machine.
    pub(crate) fn numbers(numbers: &'a [f64]) -> Self {
        Self { from: 0.0, offsets: numbers }
    }
}

/// The middle of an interval, which is rounded, and the half-length with which it is covered.
pub(crate) fn middle([left, right]: [f64; 2]) -> (f64, f64) {
    let c = 0.5 * (left + right);
    (c, (right - c).max(c - left))
}

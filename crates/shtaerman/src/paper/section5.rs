//! The numbers and bases of the paper's section 5.

/// Poisson's ratio of sec. 5.
pub const POISSON_RATIO: f64 = 0.25;
/// `P0` of sec. 5.
pub const FORCE0: f64 = 0.001;
/// `M0` that the printed tilts follow from; sec. 5 prints ten times less.
pub const MOMENT0: f64 = 0.0001;

/// `theta0 = 15/(8 pi) lambda0`, sec. 5.
#[must_use]
pub fn theta0(lambda0: f64) -> f64 {
    15.0 / (8.0 * std::f64::consts::PI) * lambda0
}

/// A polynomial base of degree two, over `lambda0`: `f(x)/a` in powers of `xi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Base {
    pub(super) constant: f64,
    pub(super) linear: f64,
    pub(super) square: f64,
}

impl Base {
    pub(super) fn at(self, xi: f64) -> f64 {
        self.constant + xi * (self.linear + xi * self.square)
    }
}

//! How exact parts of the audit have to be for it to reach its aim.

/// Unit of rounding.
pub(crate) const UNIT: f64 = 0.5 * f64::EPSILON;

/// In the mean square: three roundings of `theta q`, so that some ten times that, which is what the theorem makes of it, is below the aim.
const MEAN_SQUARE: f64 = 1.0;
/// At a place: a thirtieth of the aim. What a window misses counts with the norm of its interpolation, some 4.5 times that, and the pressure is off by the residual there, by the largest, and by the free displacements.
const AT_A_PLACE: f64 = 16.0;
/// Below this `theta` the aim does not fall.
const LEAST: f64 = 40.0;

/// The unit of residuals that matter, relative to the largest pressure.
pub(crate) fn unit(theta: f64) -> f64 {
    UNIT * theta.max(LEAST)
}

/// What an interval of this width may add to the residual, relative to the largest pressure.
///
/// The aim is `1e-12 max(1, theta/10)` at every place, 9000 roundings. The mean square of the whole is more dear, since the theorem multiplies it; short intervals hardly count in it.
pub(crate) fn allowance(theta: f64, width: f64) -> f64 {
    unit(theta) * (MEAN_SQUARE / width.sqrt()).min(AT_A_PLACE)
}

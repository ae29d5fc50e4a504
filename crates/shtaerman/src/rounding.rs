//! Rounding of double precision.

/// Of a value that a few operations make, relative to the largest of them.
pub(crate) const OF_A_VALUE: f64 = 4.0 * f64::EPSILON;

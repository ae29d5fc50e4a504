//! A function of an angle.

use super::accuracy::OF_A_VALUE;

/// A profile as function of the angle.
pub trait Angular {
    /// `f`.
    fn height(&self, angle: f64) -> f64;
    /// Rounding of heights, given the largest of them and of their slopes: of the sum that a height is, and of the place.
    fn rounding(&self, height: f64, slope: f64) -> f64 {
        OF_A_VALUE * (height + slope)
    }
    /// `df/dt`, where it is known better than by differences.
    fn slope(&self, angle: f64) -> Option<f64>;
    /// `f` and `df/dt` at many angles.
    fn tangents(&self, angles: &[f64]) -> Vec<(f64, Option<f64>)> {
        angles.iter().map(|angle| (self.height(*angle), self.slope(*angle))).collect()
    }
    /// Size of what is taken away from slopes, and leaves its rounding in them.
    fn taken_slope(&self) -> f64 {
        0.0
    }
    /// Rounding of angles about this one: beside an end, where places follow angles by their square, rounded places move them farther.
    fn blur(&self, _angle: f64) -> f64 {
        f64::EPSILON
    }
}

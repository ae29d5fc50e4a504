//! Numbers that several inversions share.

/// Rounding of a quantity relative to what is added up in it.
pub(super) const ROUNDING: f64 = 32.0 * f64::EPSILON;
/// Rounding of a value that a few operations make, relative to the largest of them.
pub(super) const OF_A_VALUE: f64 = 4.0 * f64::EPSILON;
/// Coefficients or differences this small relative to the largest value, that do not fall when a panel is halved, are noise.
pub(super) const NOISE: f64 = 1e-11;
/// Last coefficients relative to the largest value that count as resolved, at best.
pub(super) const RESOLVED: f64 = 4e-16;
/// A slope at a kink, or a jump where panels meet, is rounding below this share of the largest slope: panels are made to meet, as a jump would be a pole.
pub(super) const HARMLESS: f64 = 1e-9;
/// Panels are halved at most this often.
pub(super) const DEEPEST: u32 = 44;
/// Most steps of an iteration that ends by itself: as many halvings are twice the digits of a double.
pub(super) const STEPS: usize = 120;
/// `(sqrt(5) - 1)/2`: its multiples never fall in with a wave.
pub(super) const GOLDEN: f64 = 0.618_033_988_749_894_9;

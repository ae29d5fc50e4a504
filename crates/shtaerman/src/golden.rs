//! The golden section.

/// `(sqrt(5) - 1)/2`: it divides an interval so that one of two places inside serves again. Its multiples never fall in with a wave.
pub(crate) const GOLDEN: f64 = 0.618_033_988_749_894_9;

//! Complex numbers.

/// A complex number as the transforms take it.
pub type Complex = rustfft::num_complex::Complex<f64>;

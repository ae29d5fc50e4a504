//! Fast transforms: real sequences through complex Fourier transforms of half the length, planned once.

mod cosine;
mod length;
mod packed;
mod rotation;

pub(crate) use cosine::cosine_sums;
pub(crate) use length::fast_length;
pub(crate) use packed::PackedTransform;

/// A complex number as the transforms take it.
pub(crate) type Complex = rustfft::num_complex::Complex<f64>;

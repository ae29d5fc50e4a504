//! Fast transforms: real sequences through complex Fourier transforms of half the length, planned once.

mod complex;
mod cosine;
mod length;
mod packed;
mod rotation;

pub(crate) use complex::Complex;
pub(crate) use cosine::cosine_sums;
pub(crate) use length::fast_length;
pub(crate) use packed::PackedTransform;

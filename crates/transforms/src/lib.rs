//! Fast transforms of double precision: real sequences through complex Fourier transforms of half the length, planned once.
//!
//! A crate of its own because the library underneath is generic: here it is compiled for `f64` once, and not again in whatever uses it.

mod complex;
mod cosine;
mod length;
mod packed;
mod planner;
mod rotation;

pub use complex::Complex;
pub use cosine::cosine_sums;
pub use length::fast_length;
pub use packed::PackedTransform;
pub use planner::Planner;

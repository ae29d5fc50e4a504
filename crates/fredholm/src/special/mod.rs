//! Special functions for which no library of ours serves.

mod cosine_integral;

pub use cosine_integral::cosine_integral_pi;

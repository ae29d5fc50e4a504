//! The method of degenerate kernels.

pub mod regularity;

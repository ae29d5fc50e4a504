//! Collocation, independent of any spectral relation.

pub(crate) mod map;
mod sinc;
mod weights;

pub use sinc::{SincOperator, SincSolution};

//! Collocation, independent of any spectral relation.

mod map;
mod sinc;
mod weights;

pub use sinc::{SincOperator, SincSolution};

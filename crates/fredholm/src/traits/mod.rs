//! What a kernel is, and what is known of one: the traits that kernels implement and methods ask for.

mod definition;
mod relation;
mod singularity;

pub use definition::Kernel;
pub(crate) use definition::forward_kernel;
pub use relation::{EndExponents, Expansion, Gram, Moments, Parity, SpectralRelation};
pub use singularity::{Pair, Singularity, Split};

//! Orthogonal systems.

pub mod chebyshev;
mod function;
mod supremum;
pub(crate) mod transform;

pub use chebyshev::ChebyshevSeries;
pub use function::Function;

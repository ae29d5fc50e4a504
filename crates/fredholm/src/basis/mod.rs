//! Orthogonal systems.

pub mod chebyshev;
mod function;
pub(crate) mod transform;

pub use chebyshev::ChebyshevSeries;
pub use function::Function;

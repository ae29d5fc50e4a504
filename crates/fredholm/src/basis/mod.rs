//! Orthogonal systems.

pub mod chebyshev;
mod function;

pub use chebyshev::ChebyshevSeries;
pub use function::Function;

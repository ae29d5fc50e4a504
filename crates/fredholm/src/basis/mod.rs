//! Orthogonal systems.

pub mod chebyshev;
pub(crate) mod expansion;
mod function;
pub(crate) mod legendre;
pub(crate) mod spheroidal;
mod supremum;
pub(crate) mod transform;

pub use chebyshev::ChebyshevSeries;
pub use function::Function;

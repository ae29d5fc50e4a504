//! Orthogonal systems.

pub mod chebyshev;
pub(crate) mod expansion;
mod function;
pub(crate) mod gegenbauer;
pub(crate) mod laguerre;
pub(crate) mod laguerre_moments;
mod supremum;
pub(crate) mod transform;

pub use chebyshev::ChebyshevSeries;
pub use function::Function;

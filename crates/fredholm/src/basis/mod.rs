//! Orthogonal systems.

pub mod chebyshev;
pub(crate) mod expansion;
mod function;
pub(crate) mod gegenbauer;
pub(crate) mod harmonics;
pub(crate) mod interval_moments;
pub(crate) mod laguerre;
pub(crate) mod laguerre_moments;
pub(crate) mod legendre;
pub(crate) mod spheroidal;
mod supremum;
mod table;

pub use chebyshev::ChebyshevSeries;
pub use function::Function;
pub use table::ChebyshevTable;

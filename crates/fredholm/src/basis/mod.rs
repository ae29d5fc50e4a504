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
mod shown;
pub(crate) mod spheroidal;
mod supremum;
mod table;

pub use chebyshev::ChebyshevSeries;
pub use function::Function;
pub use shown::Shown;
pub use table::ChebyshevTable;

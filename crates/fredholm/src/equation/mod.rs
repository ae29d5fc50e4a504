//! Equations of the second and of the first kind on any kernel, solved by either method, each answer with a statement of its error.
//!
//! `phi + lambda K phi = f` (1.1) by [`collocate`] (accurate, an estimate of the error) or by [`degenerate`] (the paper's method; for
//! the logarithm [`degenerate_logarithm`] adds guaranteed bounds); `K phi = f`, the smooth limit, by [`first_kind`] straight from the spectral relation.
//!
//! ```
//! use fredholm::Interval;
//! use fredholm::equation::{collocate, degenerate, first_kind};
//! use fredholm::kernel::Logarithm;
//!
//! let kernel = Logarithm::unit();
//! let sinc = collocate(&kernel, 2.0, &f64::cos, &[], 1e-12)?;
//! let spectral = degenerate(&kernel, 2.0, &f64::cos, 400)?;
//! let difference = (sinc.evaluate(1.0) - spectral.evaluate(1.0)).abs();
//! assert!(difference <= sinc.error.solution + spectral.error.solution);
//!
//! // int ln(1/|x - s|) phi(s) ds = 1: phi = 1/(pi ln 2 sqrt(1 - x^2)), unbounded at the ends.
//! let smooth = first_kind(&kernel, &|_| 1.0, 40)?;
//! assert!((smooth.evaluate(0.6) - 1.25 / (std::f64::consts::PI * 2f64.ln())).abs() < 1e-14);
//! assert!(smooth.evaluate(1.0).is_infinite());
//! # Ok::<(), fredholm::Error>(())
//! ```

mod audit;
mod collocated;
mod first_kind;
mod half_line;
mod logarithm;
mod remainder;
mod residual;
mod solution;
mod truncated;

pub use audit::{Audit, audit};
pub use collocated::{collocate, collocate_in_parts};
pub use first_kind::{first_kind, first_kind_in_parts};
pub use half_line::{collocate_half_line, collocate_half_line_in_parts};
pub use logarithm::{degenerate_logarithm, degenerate_logarithm_in_parts};
pub(crate) use solution::checks;
pub use solution::{ErrorStatement, Method, Solution};
pub use truncated::{degenerate, degenerate_in_parts};

//! Dense linear algebra behind our own names; the library underneath does not show.

mod cholesky;
mod tridiagonal;
pub(crate) mod vector;

pub(crate) use cholesky::Cholesky;
pub(crate) use tridiagonal::Tridiagonal;

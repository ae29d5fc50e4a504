//! Dense linear algebra behind our own names; the library underneath does not show.

mod cholesky;

pub(crate) use cholesky::Cholesky;

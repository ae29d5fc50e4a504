//! Dense linear algebra behind our own names; the library underneath does not show.

mod cholesky;
mod columns;
mod dense;
mod elimination;
mod general;
mod lowest;
mod positive;
mod skyline;
mod small_cholesky;
mod substitution;
mod symmetric;
mod tridiagonal;
mod tridiagonal_spectrum;
pub(crate) mod vector;
mod vectorised;

pub(crate) use cholesky::Cholesky;
pub(crate) use dense::multiply_rows;
pub(crate) use elimination::Elimination;
pub use general::eliminate;
pub(crate) use lowest::{Lowest, lowest};
pub use positive::eliminate_positive;
pub(crate) use skyline::{Skyline, SkylineFactor};
pub(crate) use symmetric::{Eigensystem, Factored};
pub(crate) use tridiagonal::Tridiagonal;
pub(crate) use tridiagonal_spectrum::{SymmetricTridiagonal, VECTORS};
pub(crate) use vector::{dot, sum};
pub(crate) use vectorised::vectorised;

//! The degenerate system at truncations of a million and more, for kernels whose Gram matrix is the sum of a Toeplitz
//! and a Hankel matrix: products by fast transforms, conjugate gradients with a preconditioner that knows the leading block.

mod conjugate_gradients;
mod operator;
mod preconditioner;
mod product;
mod system;

pub use conjugate_gradients::Convergence;
pub use operator::{BYTES_A_DEGREE, StructuredOperator};
pub use system::StructuredSystem;

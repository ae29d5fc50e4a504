//! The paper's method: the kernel is replaced by the first terms of its bilinear expansion, (1.6), which turns the
//! integral equation into a small linear system, (1.9).

pub mod bounds;
pub mod regularity;
mod solution;
mod solver;
mod split;
mod structured;
mod system;

pub use solution::DegenerateSolution;
pub use solver::{ConstantShift, DegenerateSolver, ShiftedSolution};
pub use structured::{BYTES_A_DEGREE, Convergence, StructuredOperator, StructuredSystem};
pub use system::DegenerateSystem;

//! Equations of the second and of the first kind on any of the paper's seven kernels, without mechanics.
//!
//! `phi(x) + lambda int_L K(x, s) phi(s) dm(s) = f(x)`   (1.1), or its smooth limit `int_L K(x, s) phi(s) dm(s) = f(x)`
//!
//! with `dm = ds`, for the kernels of a disk (`weber-sonine`, `yukawa`) `dm = s ds`. A [`NamedKernel`] is one of the kernels with its parameters, an
//! [`Equation`] adds the kind and the right-hand side, and [`Equation::solve`] gives the solution with its integral and the statement of its error. [`Spectrum`] lists
//! the eigenvalues and norms of a kernel and verifies them. [`EquationFile`] reads all of it from TOML:
//!
//! ```
//! use shtaerman::equation::EquationFile;
//!
//! let file = EquationFile::parse(
//!     r#"
//!     [equation]
//!     kind = "second"
//!     lambda = 1.0
//!     rhs = "1 + x"
//!
//!     [kernel]
//!     name = "log"
//!     a = 1.0
//!     "#,
//!     "equation.toml",
//! )?;
//! let solution = file.equation().solve()?;
//! let answer = solution.answer(vec![-1.0, 0.0, 1.0])?;
//! assert!(answer.error.solution_sup.unwrap() < 1e-11);
//!
//! // int K phi, from the equation itself: lambda int K phi = f - phi.
//! let potential = 1.0 - answer.solution.phi[1].unwrap();
//! assert!(potential > 0.0);
//! # Ok::<(), shtaerman::Error>(())
//! ```

mod answer;
mod audit;
mod bounded;
mod catalogue;
mod cross_check;
mod definition;
mod draft;
mod family;
mod file;
mod infinite;
mod own;
mod parts;
mod places;
mod plan;
mod right_hand_side;
mod solved;
mod spectrum;

pub use answer::{EQUATION_SCHEMA, EquationAnswer, EquationErrors, Samples};
pub use audit::EquationAudit;
pub use cross_check::EquationCheck;
pub use definition::{Equation, Kind, LEAST_DEGREE, MOST_DEGREE, suggestion};
pub use family::{Family, KernelError, NamedKernel, Parameter};
pub use file::{EquationFile, is_equation};
pub use own::{OwnAnswer, OwnKernel, RightHandSide, SolvedOwn, solve_own};
pub use solved::SolvedEquation;
pub use spectrum::{CheckReport, SPECTRUM_SCHEMA, Spectrum, SpectrumCheck};

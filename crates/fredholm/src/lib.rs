//! Fredholm integral equations of the second kind with symmetric, weakly singular kernels,
//!
//! `phi(x) + lambda int_L K(x, s) phi(s) ds = f(x)`, `x` in `L`   (1.1)
//!
//! solved two independent ways: by **degenerate kernels** (the kernel is expanded in the eigenfunctions of its own
//! operator, [`degenerate`]) and by **sinc collocation** ([`collocation`]).
//!
//! The flat punch on a rough half-plane, `p + theta int_{-1}^{1} ln(1/|x-s|) p(s) ds = 1`, both ways:
//!
//! ```
//! use fredholm::kernel::{Logarithm, SpectralRelation};
//! use fredholm::{DegenerateSystem, SincOperator};
//!
//! let (kernel, theta) = (Logarithm::unit(), 2.0);
//!
//! let system = DegenerateSystem::new(&kernel, theta, 400)?;
//! let moments = kernel.moments(&|_| 1.0, 401)?;
//! let pressure = system.solve(&moments.values);
//! let force = pressure.projections()[0];
//!
//! let operator = SincOperator::new(&kernel, 50)?;
//! let right_hand_side = vec![1.0; operator.count()];
//! let independent = &operator.solve(theta, &[right_hand_side])?[0];
//!
//! assert!((force - independent.integral(|_| 1.0)).abs() < 1e-10);
//! assert!((pressure.evaluate(0.5, 1.0) - independent.evaluate(0.5, 1.0)).abs() < 1e-7);
//! assert!((pressure.evaluate(1.0, 1.0) - independent.evaluate(1.0, 1.0)).abs() < 1e-4);
//! # Ok::<(), fredholm::Error>(())
//! ```
//!
//! Equation numbers are those of S. M. Mkhitaryan, *On the solution to integral equations of one class of mixed and
//! contact problems by the degenerate kernel method*, Proceedings of NAS of Armenia, Mechanics.

pub mod basis;
pub mod collocation;
pub mod complementarity;
pub mod conformance;
pub mod degenerate;
pub mod equation;
mod error;
mod interval;
pub mod inversion;
pub mod kernel;
mod linear;
pub mod memory;
pub mod multipole;
pub mod quadrature;
pub mod special;
mod traits;

pub use collocation::{SincOperator, SincSolution, solve_adaptive};
pub use degenerate::bounds;
pub use degenerate::{
    Convergence, DegenerateSolution, DegenerateSolver, DegenerateSystem, StructuredOperator,
    StructuredSystem,
};
pub use error::Error;
pub use interval::Interval;
pub use linear::{eliminate, eliminate_positive};

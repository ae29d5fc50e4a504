//! How far an answer is from the truth, whatever way it was found.
//!
//! The contact pressure `p` on a base within `[-1, 1]` solves, with `A = 1 + theta K`, `theta >= 0`, and a symmetric, positive semidefinite kernel `K`,
//!
//! `A p = delta - alpha x - f` where `p > 0`, `A p >= delta - alpha x - f` where `p = 0`, `p >= 0` (unilateral), or the equation on the whole base (bilateral),
//!
//! with the force `P = int p dx` or the settlement `delta` given, and the moment `M = int x p dx` or the tilt `alpha`. Of any answer this crate bounds the distance from `p` by its
//! residual alone: it shares nothing with the ways of finding answers.
//!
//! The density is resampled by polynomials on panels; their potentials have closed forms; the profile is enclosed, not sampled, and the residual is bounded between the places where
//! it is computed. Rounding is inside the bound. The chapter *The audit* of the book has the proofs.

mod allowance;
mod bent;
mod between;
mod bound;
mod chebyshev;
#[cfg(test)]
mod closed;
mod covering;
mod density;
mod disk;
mod displacements;
mod distance;
mod double;
mod effort;
mod elementary;
mod ends;
mod far;
mod fitted;
mod grading;
mod ground;
mod heights;
mod highest;
mod kernel;
mod layer;
mod legendre;
mod modelled;
mod narrow;
mod near;
mod norms;
mod open;
mod panel;
mod places;
mod potentials;
mod problem;
mod processors;
mod profile;
mod remainders;
mod residual;
mod row;
mod sample;
mod sampled;
mod shape;
#[cfg(test)]
mod slow;
mod sum;
mod tangent;
#[cfg(test)]
mod tests;
mod vectorised;
mod windows;

pub use bent::audit_bent;
pub use bound::{audit, audit_on_halved_panels};
pub use disk::{DiskProblem, audit_disk};
pub use ground::Ground;
pub use kernel::{Kernel, Layered};
pub use problem::{Answer, Bound, Prescribed, Problem, Refusal};
pub use profile::Profile;

//! An independent solver of contact problems, slow and simple on purpose: a truth to hold other answers against.
//!
//! The pressure `p` under a rigid base solves `v(p) + theta int K(x, s) p(s) dm(s) = delta - alpha x - f(x)` in the zones of contact, `v` the law of the rough layer. The zones are cut
//! into panels that shrink towards their ends; on each `p` is a polynomial, known by its values at Gauss-Legendre nodes, where the equation is kept. Potentials are integrals of
//! `K(x, s)` times those polynomials, by Gauss-Legendre quadrature on subintervals that shrink towards `x`: nothing of a kernel is used but its values. Free ends are roots of the pressure.
//! Errors are stated from a second solution with more nodes on finer panels.
//!
//! It shares no code with the other crates of this workspace.

mod grid;
mod kernel;
mod panel;
mod problem;
mod reference;
mod rough;
mod rule;
mod smooth;
#[cfg(test)]
mod tests;
mod transfer;
mod zones;

pub use grid::Break;
pub use kernel::Kernel;
pub use panel::potential;
pub use problem::{Layer, Problem, Refusal, Rotational, Vertical};
pub use reference::{Errors, Reference};
pub use transfer::Transferred;

//! Guaranteed errors of approximate solutions of `p + theta K p = g`, `theta >= 0`, `K` the logarithmic kernel on `(-1, 1)`.
//!
//! `K` is positive, so `A = 1 + theta K >= 1` and everything follows from the residual `r = g - A q` of an approximation
//! `q`, which is known in full: its modes one by one up to four times the degree of `q`, the rest by an expansion with a bounded
//! remainder, its value at a point in closed form.
//!
//! | quantity | bound |
//! |---|---|
//! | `p - q` in `L2` | `‖r‖` |
//! | `p(x) - q(x)` | `abs(r(x)) + C(theta) ‖r‖` |
//! | `p(x) - q_1(x)`, the [iterated solution](IteratedSolution) | `C(theta) ‖r‖` |
//! | `p(1)`, `p(-1)`, corrected with an [influence function](EndInfluence) | `theta ‖r_k‖ ‖r‖ / 2` |
//! | `<u, A^{-1} v>`, corrected | `‖r_u‖ ‖r_v‖ / 2` |
//! | coefficients and projections of a [combination](Combination) `c_1 A^{-1} 1 + c_2 A^{-1} x - A^{-1} f` | from those |
//!
//! The assumptions: exact arithmetic, and a right-hand side that *is* its Chebyshev series; where it was not resolved every
//! statement is a [`Kind::Estimate`]. Derivations: chapter "Error bounds" of the book.

mod amplification;
mod approximation;
mod combination;
mod enclosure;
mod ends;
mod iterated;
mod operator;
mod responses;
mod tail;

pub use approximation::Approximation;
pub use combination::{Combination, Refinement};
pub use enclosure::{Enclosure, Kind};
pub use ends::{End, EndInfluence};
pub use iterated::IteratedSolution;
pub use operator::ResidualOperator;
pub use responses::{Given, Responses};

//! Linear complementarity for the second kind: densities that must not be negative on a set that is not known.
//!
//! On cells of the line, with the mean values `phi_i` on cells of widths `h_i` and `z_i = sqrt(h_i) phi_i`, the problem is
//!
//! `z >= 0`, `w = (1 + theta S) z - b - sum_k mu_k c_k >= 0`, `z . w = 0`, `r_k . z = v_k`
//!
//! with the symmetric positive Galerkin matrix `S` of the kernel ([`logarithm_cells`]), right-hand sides `b`, and up to a few conditions `r_k . z = v_k` whose
//! multipliers `mu_k` are unknown. [`Complementarity::solve`] finds the cells that carry (`z > 0`): the topology of the set. It is a first step: collocation on the intervals found
//! gives the digits.

mod cells;
mod solver;

pub use cells::{centred, galerkin, logarithm_cells, mean_logarithms, mean_powers};
pub(crate) use cells::{mean_logarithm, mean_power};
pub use solver::{Complementarity, ComplementaritySolution, Condition};

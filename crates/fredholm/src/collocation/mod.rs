//! Sinc collocation with the double-exponential map, independent of any spectral relation.
//!
//! `x = c + a tanh(pi/2 sinh t)` maps the line onto `(c - a, c + a)` and crowds the nodes `t_j = j h` towards the ends, so
//! that the `d ln d` or `d^(1-q)` behaviour of solutions there costs nothing. With `w_j = h x'(t_j)` and the density `m` of the measure the
//! equation `phi + lambda int K phi dm = f` becomes `phi_i + lambda sum_j M_ij phi_j = f_i`. For the split `K = A sigma(|x - s|) + B`
//!
//! `M_ij = w_j m_j [K_ij - A_ij Ci(pi |i-j|)]`, `M_ii = w_i m_i [A_ii (ln w_i - gamma - ln pi) + B_ii]`
//!
//! with `sigma = ln`, and with `sigma(d) = (d^-q - 1)/q` and the exact sinc weights `h^(1-q) c_j` of `|t - u|^-q`
//!
//! `M_ij = w_j m_j [K_ij + A_ij |x_i - x_j|^-q (|i-j|^q c_{|i-j|} - 1)/q]`, `M_ii = w_i m_i [A_ii (w_i^-q c_0 - 1)/q + B_ii]`.
//!
//! Scaled by the square roots of the masses `w_i m_i` the matrix is symmetric, and positive to rounding for a positive kernel. It
//! does not depend on `lambda`: [`SincOperator`] holds it, and solves by one Cholesky factorisation for each `lambda`
//! ([`SincFactor`], the most accurate) or by one eigendecomposition for all ([`SincSpectrum`], [`Sweep`]).
//!
//! Kinks and jumps of the right-hand side inside the interval are breakpoints: each panel between two of them has a map
//! of its own. [`solve_adaptive`] chooses the number of nodes.
//!
//! The error is always an *estimate*: the method has finite rank on continuous functions only, so the bounds of a
//! degenerate kernel do not carry over. (H. Takahasi and M. Mori, Publ. RIMS 9 (1974) 721, and M. Sugihara and T. Matsuo,
//! J. Comput. Appl. Math. 164-165 (2004) 673, for the map; the weights follow from the Fourier integral of the sinc
//! function.)

mod adaptive;
mod assembly;
mod check;
mod eigenpairs;
mod entries;
mod estimate;
mod factor;
mod grid;
mod half_line;
mod mesh;
mod modes;
mod operator;
mod points;
mod resolution;
mod solution;
mod spectrum;
mod sweep;
mod weighted;
mod weights;

pub use adaptive::{
    AdaptiveSolution, first_half_count, solve_adaptive, solve_adaptive_in_parts,
    solve_adaptive_with_breaks,
};
pub(crate) use eigenpairs::Eigenpairs;
pub use estimate::{Estimate, extrapolate, rounding};
pub use factor::SincFactor;
pub use grid::SincGrid;
pub use half_line::{
    HalfLineEstimate, HalfLineSolution, solve_half_line, solve_half_line_in_parts,
};
pub use mesh::Place;
pub use operator::SincOperator;
pub use points::PointSet;
pub use solution::SincSolution;
pub use spectrum::SincSpectrum;
pub use sweep::{Prescribed, Sweep, SweepValue};
pub use weighted::WeightedFactor;

//! The logarithm, on a line or a circle, powers, and rings about an axis on very many panels: collocation at Gauss nodes, products in time proportional to their number by a fast multipole method (V. Rokhlin, *Rapid solution of
//! integral equations of classical potential theory*, J. Comput. Phys. 60 (1985) 187; here with interpolation at Chebyshev points, W. Fong and E. Darve, J. Comput. Phys. 228
//! (2009) 8712), and the equation of the second kind by GMRES with the means over groups of panels solved exactly, and each group by itself.
//!
//! For densities that bend at thousands of places, where [sinc collocation](crate::collocation) of a dense matrix would not fit.

mod boxes;
mod far;
mod groups;
mod kernel;
mod krylov;
mod near;
mod on_panel;
mod operator;
mod panels;
mod rings;
mod rule;
mod sums;
mod threads;
mod tree;

pub use groups::Groups;
pub use kernel::PanelKernel;
pub use krylov::{PanelCondition, PanelEquation, PanelSolution, PanelTask};
pub use operator::{PanelField, PanelOperator};
pub use panels::Panels;
pub use rings::Rings;

//! Polynomials on many panels, with fast products: many zones, and bases that bend often.
//!
//! Each zone is cut into panels at the measured points, where the third derivative of the spline jumps, and towards its ends, where the pressure goes on as `d^2 ln d`; on each
//! the pressure is a polynomial through Gauss nodes. The equation on all zones is solved by GMRES with products by a fast multipole method
//! ([`fredholm::multipole`]).

mod mesh;
mod nodes;
mod search;

pub(super) use nodes::OnPanels;
pub(super) use search::ManyPanels;

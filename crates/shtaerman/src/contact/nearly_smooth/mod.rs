//! Contact with a roughness so small that the direct solution loses its digits: by the expansion about the smooth limit.
//!
//! With `e = 1/theta0`, every settlement, tilt, force and edge is `q0 + e (A ln(1/e) + B) + O(e^2 ln^2 e)`, in units in which the smooth problem stays the same.
//! `q0` is the smooth answer; `A` and `B` follow from the rough one at smaller `theta0`, where it has all its digits. The [pressure](pressure) is
//! expanded in the same way between the boundary layers, and in them at a fixed distance in units of their width.

mod answer;
mod companion;
mod errors;
mod fit;
mod linearised;
mod pressure;

use std::sync::Arc;

use super::solution::Solution;
use crate::roughness::Law;
use crate::{Error, Geometry, MethodChoice, Problem};
use answer::NearlySmooth;
use companion::Companions;
pub(super) use companion::companion;

/// Beyond this `theta0`, for a half-width of the shortest stretch between edges and kinks, the direct solution has lost 8 digits of the pressure.
pub(super) const SWITCH: f64 = 1e6;
/// An expansion with a larger relative error than this is compared with the direct solution.
const DOUBTFUL: f64 = 1e-6;

impl Problem {
    /// The expansion about the smooth limit, where it applies and promises more than the direct solution.
    pub(super) fn solve_nearly_smooth(&self) -> Option<Arc<dyn Solution>> {
        if !self.may_be_nearly_smooth() {
            return None;
        }
        let companions = Companions::new(self)?;
        let expanded = NearlySmooth::new(self, companions)?;
        let reached = expanded.relative_error();
        if reached > DOUBTFUL
            && let Ok(direct) = self.solve_directly()
            && direct.relative_error() < reached
        {
            return None;
        }
        Some(Arc::new(expanded))
    }

    fn may_be_nearly_smooth(&self) -> bool {
        let frame = self.frame();
        let has_ends = match frame.geometry().scaled(frame.half_width()) {
            Geometry::Plane | Geometry::Pair { .. } => true,
            Geometry::Periodic { period } => period > 2.0,
            Geometry::Circular => false,
        };
        let solver = self.solver();
        has_ends
            && frame.theta0() > SWITCH
            && frame.law() == Law::Linear
            && frame.is_homogeneous()
            && solver.method == MethodChoice::Auto
            && solver.degree.is_none()
    }

    fn solve_directly(&self) -> Result<super::Contact, Error> {
        super::plan::solve_rough(self)
    }
}

//! A stated problem with a smooth surface.

use std::sync::Arc;

use super::{Curve, SmoothContact, SmoothKernel, SmoothProblem, SmoothProfile};
use crate::contact::parts::{DEGREE, RESOLVED};
use crate::contact::steps::INSIDE;
use crate::{ContactKind, Error, Geometry, Problem, Rotational, Scaling, Vertical};

/// To this share the slope of a measured profile or a closure is resolved on graded ground: the third derivative of a spline jumps at every point, and slopes of a closure are those of
/// polynomials through its values. At half or twice 1 of 10 answers are lost and stated errors grow up to 2.7 times (survey).
pub(super) const MEASURED: f64 = 1e-10;
impl Problem {
    /// Solves the equation of the first kind of a smooth surface, plane, under a pair or periodic.
    ///
    /// # Errors
    /// Those of [`SmoothProblem::solve`], with values in the units of the problem.
    pub(crate) fn solve_smooth(&self) -> Result<SmoothContact, Error> {
        self.smooth().solve().map_err(|error| self.in_units(error))
    }

    /// The problem without dimensions.
    pub(super) fn smooth(&self) -> SmoothProblem {
        let frame = self.frame();
        let half_width = frame.half_width();
        let kernel = match frame.geometry().scaled(half_width) {
            Geometry::Periodic { period } => SmoothKernel::Periodic { period },
            _ => SmoothKernel::Plane,
        };
        let problem = Arc::new(self.clone());
        let height = {
            let problem = Arc::clone(&problem);
            Arc::new(move |xi| problem.dimensionless_profile(xi))
        };
        let scale = frame.scaling().map_or(1.0, Scaling::displacement);
        // Of a closure heights are known better than slopes, which graded ground needs.
        let is_closure = self.profile().is_closure();
        let has_slope = !is_closure || frame.grading().is_some();
        let slope: Option<Curve> = has_slope.then(|| {
            let slope = move |xi| problem.profile().slope(xi, half_width).unwrap_or(f64::NAN);
            Arc::new(move |xi| slope(xi) / scale) as Curve
        });
        let measured = self.profile().measured_points().is_some();
        let (breaks, mut joints) = (self.smooth_breaks(), Vec::new());
        let mut tolerance = 0.0;
        if measured {
            joints = self.profile().joints(half_width);
            joints.sort_by(f64::total_cmp);
        } else if frame.grading().is_some() {
            joints = self.profile().resolve(&frame.pieces(), half_width, DEGREE, RESOLVED).joints;
            joints.retain(|at| breaks.iter().all(|known| (known - at).abs() > INSIDE));
        }
        if (measured || is_closure) && frame.grading().is_some() {
            tolerance = MEASURED;
        }
        let mut load = self.dimensionless_load();
        let is_wave = matches!(kernel, SmoothKernel::Periodic { period } if period <= 2.0);
        if is_wave && matches!(load.rotational, Rotational::Moment(m) if m == 0.0) {
            // A wave cannot tilt: that no moment is asked for means that none is applied.
            load.rotational = Rotational::Tilt(0.0);
        }
        SmoothProblem {
            pieces: frame.pieces(),
            kernel,
            theta0: frame.theta0(),
            load,
            profile: SmoothProfile { height, slope, breaks, joints, tolerance },
            is_unilateral: self.solver().contact == ContactKind::Unilateral,
            deadline: self.deadline().clone(),
        }
    }

    /// Where the panels of slopes, the cells and the places that are looked at are cut: kinks, and the surroundings of features that are narrower than samples.
    /// On graded ground, where each would be a kink, the kinks alone.
    pub(super) fn smooth_breaks(&self) -> Vec<f64> {
        let (frame, profile) = (self.frame(), self.profile());
        let half_width = frame.half_width();
        if profile.measured_points().is_some() || frame.grading().is_some() {
            return profile.breakpoints(half_width);
        }
        profile.resolve(&frame.pieces(), half_width, DEGREE, RESOLVED).joints
    }

    /// An error with its value as the problem states it.
    pub(super) fn in_units(&self, error: Error) -> Error {
        let load = self.load();
        let half_width = self.frame().half_width();
        match (error, load.vertical, load.rotational) {
            (
                Error::InvalidValue { field: "force", requirement, .. },
                Vertical::Force(value),
                _,
            ) => Error::InvalidValue { field: "force", value, requirement },
            (
                Error::InvalidValue { field: "settlement", requirement, .. },
                Vertical::Settlement(value),
                _,
            ) => Error::InvalidValue { field: "settlement", value, requirement },
            (
                Error::TipsOver { field, name, .. },
                Vertical::Force(force),
                Rotational::Moment(value),
            ) => Error::TipsOver { field, value, limit: half_width * force, name },
            (Error::TipsOver { field, name, .. }, _, Rotational::Eccentricity(value)) => {
                Error::TipsOver { field, value, limit: half_width, name }
            }
            (error, _, _) => error,
        }
    }
}

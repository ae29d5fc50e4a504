//! A stated problem of a smooth circular punch.

use std::sync::Arc;

use super::{are_likely, are_possible, solve};
use crate::contact::revolution::require_even;
use crate::contact::smooth::disk::SmoothDisk;
use crate::contact::smooth::stated::MEASURED;
use crate::contact::solution::Solution;
use crate::{ContactKind, Error, Problem, Rotational, Scaling, Vertical};

impl Problem {
    /// Solves a circular punch on a smooth body.
    ///
    /// # Errors
    /// Those of [`SmoothDisk::solve`] and of [`solve`](super::solve) for rings, which takes over where the contact is no single disk, with values in the units of
    /// the problem; [`Error::InvalidValue`] for a base that is no body of revolution.
    pub(in crate::contact) fn solve_smooth_disk(&self) -> Result<Arc<dyn Solution>, Error> {
        require_even(self)?;
        let disk = self.smooth_disk();
        let rings = || solve(&disk).map(|contact| -> Arc<dyn Solution> { Arc::new(contact) });
        let mut tried = are_likely(&disk).then(rings);
        if let Some(Ok(_) | Err(Error::TooManyZones { .. })) = tried {
            return tried.unwrap_or_else(rings);
        }
        let solution: Result<Arc<dyn Solution>, Error> = match disk.solve() {
            Ok(contact) => Ok(Arc::new(contact)),
            Err(Error::Rings { .. }) if are_possible(&disk) => tried.take().unwrap_or_else(rings),
            Err(error) => Err(error),
        };
        solution.map_err(|error| self.with_units(error))
    }

    /// The problem without dimensions.
    fn smooth_disk(&self) -> SmoothDisk {
        let half_width = self.frame().half_width();
        let scale = self.frame().scaling().map_or(1.0, Scaling::displacement);
        let problem = Arc::new(self.clone());
        let height = {
            let problem = Arc::clone(&problem);
            Arc::new(move |r| problem.dimensionless_profile(r))
        };
        let slope =
            move |r| problem.profile().slope(r, half_width).map_or(f64::NAN, |slope| slope / scale);
        let measured = self.profile().measured_points().is_some() || self.profile().is_closure();
        SmoothDisk {
            exponent: self.frame().grading().map_or(0.0, |grading| grading.exponent()),
            theta0: self.frame().theta0(),
            load: self.dimensionless_load(),
            height,
            slope: Arc::new(slope),
            breaks: self.smooth_breaks(),
            joints: self.radii_of_points(),
            tolerance: if measured { MEASURED } else { 0.0 },
            is_unilateral: self.solver().contact == ContactKind::Unilateral,
            deadline: self.deadline().clone(),
            is_over: {
                let deadline = self.deadline().clone();
                Arc::new(move || deadline.is_past())
            },
        }
    }

    /// The radii at which a measured profile has points, from the axis.
    fn radii_of_points(&self) -> Vec<f64> {
        if self.profile().measured_points().is_none() {
            return Vec::new();
        }
        let mut radii = self.profile().joints(self.frame().half_width());
        radii.retain(|at| *at > 0.0 && *at < 1.0);
        radii.sort_by(f64::total_cmp);
        radii.dedup();
        radii
    }

    /// An error with its value as the problem states it.
    fn with_units(&self, error: Error) -> Error {
        let load = self.load();
        let half_width = self.frame().half_width();
        match (error, load.vertical) {
            (Error::InvalidValue { field: "force", requirement, .. }, Vertical::Force(value)) => {
                Error::InvalidValue { field: "force", value, requirement }
            }
            (Error::InvalidValue { field: "profile", requirement, value }, _) => {
                Error::InvalidValue { field: "profile", value: value * half_width, requirement }
            }
            (Error::Rings { at, found, .. }, _) => {
                let variable = self.frame().coordinate();
                Error::Rings { variable, at: at * half_width, found }
            }
            (Error::LiftsOff { field, value: scaled, limit }, _) => {
                let (Rotational::Moment(value)
                | Rotational::Eccentricity(value)
                | Rotational::Tilt(value)) = load.rotational;
                Error::LiftsOff { field, value, limit: limit / scaled.abs() * value.abs() }
            }
            (error, _) => error,
        }
    }
}

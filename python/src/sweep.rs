//! Very many `theta0` of a bilateral problem.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use shtaerman::{Error, Load, Rotational, Swept, Theta0Sweep, Vertical};

use crate::errors::{raised, text};
use crate::problem::Problem;
use crate::running::{Ended, run};

/// Cases that a thread does before it looks whether the user wants to end.
const BLOCK: usize = 1 << 14;

/// A number that a sweep tells of a case: of its `theta0`, what was swept, and the relative error.
type Told = fn(&Row<'_>) -> f64;

struct Row<'r> {
    theta0: f64,
    swept: &'r Swept,
    load: &'r Load,
    relative_error: f64,
}

impl Row<'_> {
    /// The error of a displacement, a pressure or a force (0, 1, 2); 0 where it is prescribed.
    fn error(&self, kind: usize, is_prescribed: bool) -> f64 {
        if is_prescribed { 0.0 } else { self.relative_error * self.swept.sizes()[kind] }
    }
}

/// What a sweep tells under this name.
fn told(name: &str) -> Option<Told> {
    Some(match name {
        "settlement" => |row| row.swept.settlement,
        "tilt" => |row| row.swept.tilt,
        "force" => |row| row.swept.force,
        "moment" => |row| row.swept.moment,
        "pressure_left" => |row| row.swept.pressure_left,
        "pressure_right" => |row| row.swept.pressure_right,
        // Over the two half-widths of the base.
        "mean_pressure" => |row| 0.5 * row.swept.force,
        "theta0" => |row| row.theta0,
        "stiffness_00" => |row| row.swept.stiffness[0][0],
        "stiffness_01" => |row| row.swept.stiffness[0][1],
        "stiffness_10" => |row| row.swept.stiffness[1][0],
        "stiffness_11" => |row| row.swept.stiffness[1][1],
        "error_pressure" => |row| row.error(1, false),
        "error_settlement" => {
            |row| row.error(0, matches!(row.load.vertical(), Vertical::Settlement(_)))
        }
        "error_tilt" => |row| row.error(0, matches!(row.load.rotational(), Rotational::Tilt(_))),
        "error_force" => |row| row.error(2, matches!(row.load.vertical(), Vertical::Force(_))),
        "error_moment" => {
            |row| row.error(2, matches!(row.load.rotational(), Rotational::Moment(_)))
        }
        "relative_error" => |row| row.relative_error,
        _ => return None,
    })
}

/// Whether a sweep tells a number of this name.
#[pyfunction]
pub(crate) fn is_swept(name: &str) -> bool {
    told(name).is_some()
}

fn is_valid(theta0: f64) -> bool {
    theta0.is_finite() && theta0 >= 0.0
}

/// Rows of the numbers asked for, one for each `theta0`; NaN where that is none. None where the flag was set.
fn rows(
    sweep: &Theta0Sweep,
    load: &Load,
    theta0: &[f64],
    asked: &[Told],
    threads: usize,
    stop: &Arc<AtomicBool>,
) -> Option<Vec<f64>> {
    let width = asked.len();
    // Zeros are pages that nobody has touched yet: the threads do, each its own.
    let mut rows = vec![0.0; theta0.len() * width];
    let share = theta0.len().div_ceil(threads.max(1)).next_multiple_of(BLOCK);
    let fill = |theta0: &[f64], rows: &mut [f64]| {
        let mut swept = vec![Swept::default(); BLOCK.min(theta0.len())];
        for (theta0, rows) in theta0.chunks(BLOCK).zip(rows.chunks_mut(BLOCK * width)) {
            if stop.load(Ordering::Relaxed) {
                return;
            }
            sweep.run(theta0, &mut swept);
            for ((theta0, swept), row) in theta0.iter().zip(&swept).zip(rows.chunks_mut(width)) {
                if is_valid(*theta0) {
                    let relative_error = sweep.relative_error();
                    let case = Row { theta0: *theta0, swept, load, relative_error };
                    row.iter_mut().zip(asked).for_each(|(place, told)| *place = told(&case));
                } else {
                    row.fill(f64::NAN);
                }
            }
        }
    };
    thread::scope(|scope| {
        for (theta0, rows) in theta0.chunks(share).zip(rows.chunks_mut(share * width)) {
            scope.spawn(|| fill(theta0, rows));
        }
    });
    (!stop.load(Ordering::Relaxed)).then_some(rows)
}

/// The numbers case by case, and the reasons of cases that are none.
type Found<'py> = (Bound<'py, PyArray2<f64>>, Vec<(usize, String)>);

/// What is asked for at many `theta0`, by one decomposition; none where single solves have to tell.
#[pyfunction]
pub(crate) fn sweep_theta0<'py>(
    py: Python<'py>,
    problem: &Problem,
    theta0: PyReadonlyArray1<'py, f64>,
    names: Vec<String>,
    threads: usize,
) -> PyResult<Option<Found<'py>>> {
    let asked = names.iter().map(|name| told(name)).collect::<Option<Vec<Told>>>();
    let asked = asked.ok_or_else(|| PyValueError::new_err("a sweep does not tell that"))?;
    let (width, theta0) = (asked.len(), theta0.as_array().to_vec());
    let valid = || theta0.iter().copied().filter(|theta0| is_valid(*theta0));
    let range = [valid().fold(f64::INFINITY, f64::min), valid().fold(0.0, f64::max)];
    if range[0] > range[1] || width == 0 {
        return Ok(None);
    }
    let reasons: Vec<(usize, String)> = (theta0.iter().enumerate())
        .filter(|(_, theta0)| !is_valid(**theta0))
        .filter_map(|(case, theta0)| Some((case, problem.problem().with_theta0(*theta0).err()?)))
        .map(|(case, error)| (case, text(&error)))
        .collect();
    let asked_of = problem.problem().clone();
    let work = move |stop: &Arc<AtomicBool>| -> Result<Option<Vec<f64>>, Error> {
        let Some(sweep) = asked_of.theta0_sweep(range)? else { return Ok(None) };
        Ok(rows(&sweep, asked_of.load(), &theta0, &asked, threads, stop))
    };
    let Ended::Done(found) = run(py, None, work)? else { return Ok(None) };
    let Some(rows) = found.map_err(|error| raised(&error))? else { return Ok(None) };
    let count = rows.len() / width;
    Ok(Some((PyArray1::from_vec(py, rows).reshape([count, width])?, reasons)))
}

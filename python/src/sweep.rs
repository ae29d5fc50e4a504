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
const BLOCK: usize = 1 << 12;

/// Cases that were swept.
struct Block<'b> {
    theta0: &'b [f64],
    swept: &'b [Swept],
    load: &'b Load,
    relative_error: f64,
}

impl Block<'_> {
    /// Writes a number of each case into a column of their rows. A loop of its own for every number: asked case by case which one it is, they take a tenth longer.
    fn write(&self, rows: &mut [f64], width: usize, number: impl Fn(&Row<'_>) -> f64) {
        let cases = self.theta0.iter().zip(self.swept);
        for ((theta0, swept), place) in cases.zip(rows.iter_mut().step_by(width)) {
            *place = if is_valid(*theta0) {
                number(&Row { theta0: *theta0, swept, block: self })
            } else {
                f64::NAN
            };
        }
    }
}

struct Row<'r> {
    theta0: f64,
    swept: &'r Swept,
    block: &'r Block<'r>,
}

impl Row<'_> {
    /// The error of a displacement, a pressure or a force (0, 1, 2); 0 where it is prescribed.
    fn error(&self, kind: usize, is_prescribed: bool) -> f64 {
        if is_prescribed { 0.0 } else { self.block.relative_error * self.swept.sizes()[kind] }
    }

    fn is_settled(&self) -> bool {
        matches!(self.block.load.vertical(), Vertical::Settlement(_))
    }

    fn is_tilted(&self) -> bool {
        matches!(self.block.load.rotational(), Rotational::Tilt(_))
    }

    fn has_moment(&self) -> bool {
        matches!(self.block.load.rotational(), Rotational::Moment(_))
    }
}

/// Writes what a sweep tells of cases into a column of so wide rows; the first of the slice is that of the first case.
type Told = fn(&Block<'_>, &mut [f64], usize);

/// What a sweep tells under this name.
fn told(name: &str) -> Option<Told> {
    Some(match name {
        "settlement" => |block, rows, width| block.write(rows, width, |row| row.swept.settlement),
        "tilt" => |block, rows, width| block.write(rows, width, |row| row.swept.tilt),
        "force" => |block, rows, width| block.write(rows, width, |row| row.swept.force),
        "moment" => |block, rows, width| block.write(rows, width, |row| row.swept.moment),
        "pressure_left" => {
            |block, rows, width| block.write(rows, width, |row| row.swept.pressure_left)
        }
        "pressure_right" => {
            |block, rows, width| block.write(rows, width, |row| row.swept.pressure_right)
        }
        // Over the two half-widths of the base.
        "mean_pressure" => {
            |block, rows, width| block.write(rows, width, |row| 0.5 * row.swept.force)
        }
        "theta0" => |block, rows, width| block.write(rows, width, |row| row.theta0),
        "stiffness_00" => {
            |block, rows, width| block.write(rows, width, |row| row.swept.stiffness[0][0])
        }
        "stiffness_01" => {
            |block, rows, width| block.write(rows, width, |row| row.swept.stiffness[0][1])
        }
        "stiffness_10" => {
            |block, rows, width| block.write(rows, width, |row| row.swept.stiffness[1][0])
        }
        "stiffness_11" => {
            |block, rows, width| block.write(rows, width, |row| row.swept.stiffness[1][1])
        }
        "error_pressure" => {
            |block, rows, width| block.write(rows, width, |row| row.error(1, false))
        }
        "error_settlement" => {
            |block, rows, width| block.write(rows, width, |row| row.error(0, row.is_settled()))
        }
        "error_tilt" => {
            |block, rows, width| block.write(rows, width, |row| row.error(0, row.is_tilted()))
        }
        "error_force" => {
            |block, rows, width| block.write(rows, width, |row| row.error(2, !row.is_settled()))
        }
        "error_moment" => {
            |block, rows, width| block.write(rows, width, |row| row.error(2, row.has_moment()))
        }
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

/// Some of the cases, with what is found out about them as they are copied.
struct Share {
    theta0: Vec<f64>,
    /// The least and the largest that are valid.
    range: [f64; 2],
    /// The places of those that are not, and they.
    invalid: Vec<(usize, f64)>,
}

impl Share {
    fn new(first: usize, theta0: &[f64]) -> Self {
        let mut share =
            Self { theta0: theta0.to_vec(), range: [f64::INFINITY, 0.0], invalid: vec![] };
        for (case, theta0) in theta0.iter().enumerate() {
            if is_valid(*theta0) {
                share.range = [share.range[0].min(*theta0), share.range[1].max(*theta0)];
            } else {
                share.invalid.push((first + case, *theta0));
            }
        }
        share
    }
}

/// A copy of the cases in shares for the threads, made by as many.
fn shares(theta0: &[f64], threads: usize) -> Vec<Share> {
    let length = theta0.len().div_ceil(threads.max(1)).next_multiple_of(BLOCK);
    thread::scope(|scope| {
        let copies: Vec<_> = (theta0.chunks(length).enumerate())
            .map(|(i, theta0)| scope.spawn(move || Share::new(i * length, theta0)))
            .collect();
        copies.into_iter().filter_map(|copy| copy.join().ok()).collect()
    })
}

/// Rows of the numbers asked for, one for each `theta0`; NaN where that is none. None where the flag was set.
fn rows(
    sweep: &Theta0Sweep,
    load: &Load,
    shares: &[Share],
    asked: &[Told],
    stop: &Arc<AtomicBool>,
) -> Option<Vec<f64>> {
    let width = asked.len();
    let count: usize = shares.iter().map(|share| share.theta0.len()).sum();
    // Zeros are pages that nobody has touched yet: the threads do, each its own.
    let mut rows = vec![0.0; count * width];
    let fill = |theta0: &[f64], rows: &mut [f64]| {
        let mut swept = vec![Swept::default(); BLOCK.min(theta0.len())];
        for (theta0, rows) in theta0.chunks(BLOCK).zip(rows.chunks_mut(BLOCK * width)) {
            if stop.load(Ordering::Relaxed) {
                return;
            }
            sweep.run(theta0, &mut swept);
            let relative_error = sweep.relative_error();
            let block = Block { theta0, swept: &swept, load, relative_error };
            for (column, told) in asked.iter().enumerate() {
                told(&block, &mut rows[column..], width);
            }
        }
    };
    thread::scope(|scope| {
        let mut left = rows.as_mut_slice();
        for Share { theta0, .. } in shares {
            let (own, others) = left.split_at_mut(theta0.len() * width);
            left = others;
            scope.spawn(|| fill(theta0, own));
        }
    });
    (!stop.load(Ordering::Relaxed)).then_some(rows)
}

/// The numbers case by case, the relative error of them all, and the reasons of cases that are none.
type Found<'py> = (Bound<'py, PyArray2<f64>>, f64, Vec<(usize, String)>);

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
    let (width, shares) = (asked.len(), shares(theta0.as_slice()?, threads));
    let range = shares.iter().fold([f64::INFINITY, 0.0f64], |[least, most], share| {
        [least.min(share.range[0]), most.max(share.range[1])]
    });
    if range[0] > range[1] || width == 0 {
        return Ok(None);
    }
    let reasons: Vec<(usize, String)> = (shares.iter().flat_map(|share| &share.invalid))
        .filter_map(|(case, theta0)| Some((*case, problem.problem().with_theta0(*theta0).err()?)))
        .map(|(case, error)| (case, text(&error)))
        .collect();
    let asked_of = problem.problem().clone();
    let work = move |stop: &Arc<AtomicBool>| -> Result<Option<(Vec<f64>, f64)>, Error> {
        let Some(sweep) = asked_of.theta0_sweep(range)? else { return Ok(None) };
        let rows = rows(&sweep, asked_of.load(), &shares, &asked, stop);
        Ok(rows.map(|rows| (rows, sweep.relative_error())))
    };
    let Ended::Done(found) = run(py, None, work)? else { return Ok(None) };
    let found = found.map_err(|error| raised(&error))?;
    let Some((rows, relative_error)) = found else { return Ok(None) };
    let count = rows.len() / width;
    Ok(Some((PyArray1::from_vec(py, rows).reshape([count, width])?, relative_error, reasons)))
}

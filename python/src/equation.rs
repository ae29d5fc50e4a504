//! Integral equations without mechanics, and what commands find whose answer is text.

use std::sync::Arc;

use numpy::PyReadonlyArray1;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use shtaerman::Error;
use shtaerman::equation::EquationFile;
use shtaerman_cli::Refusal;

use crate::errors::{ConvergenceError, raised};
use crate::problem::Problem;
use crate::running::done;

/// The answer to an equation as the JSON of the command line, with the solution at `at`, or at `points` places.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "what the command line has as options")]
pub(crate) fn solve_equation(
    py: Python<'_>,
    content: Vec<u8>,
    name: String,
    overrides: Vec<String>,
    points: usize,
    at: Option<PyReadonlyArray1<'_, f64>>,
    audit: bool,
    cross_check: bool,
) -> PyResult<String> {
    let at = at.map(|at| at.as_array().to_vec());
    let answered = move || {
        let file = EquationFile::from_bytes(&content, &name, &overrides)?;
        let answer = || {
            let places = at.as_ref().map(|at| {
                let place = |x: &f64| file.equation().place(*x);
                at.iter().map(place).collect::<Result<Vec<f64>, Error>>()
            });
            let places = places.transpose()?;
            let reach = places.iter().flatten().copied().fold(0.0, f64::max);
            let solved = file.equation().solve_to(reach)?;
            let solved = if audit { solved.audited()? } else { solved };
            let places = places.map_or_else(|| solved.places(points), Ok)?;
            let mut answer = solved.answer(places)?;
            if cross_check {
                answer.cross_check = Some(solved.cross_check()?);
            }
            Ok(serde_json::to_string(&answer))
        };
        answer().map_err(|error| file.locate(error))
    };
    let text = done(py, answered)?.map_err(|error| raised(&error))?;
    text.map_err(|error| PyRuntimeError::new_err(error.to_string()))
}

/// The JSON that a command which takes no problem file writes: `spectrum` or `roughness`.
#[pyfunction]
pub(crate) fn command_json(py: Python<'_>, arguments: Vec<String>) -> PyResult<String> {
    let found = done(py, move || shtaerman_cli::json_of(&arguments))?;
    found.map_err(refused)
}

/// What `shtaerman export` writes of a problem.
#[pyfunction]
pub(crate) fn export_text(
    py: Python<'_>,
    problem: &Problem,
    arguments: Vec<String>,
) -> PyResult<String> {
    let (asked, file) = (problem.problem().clone(), Arc::clone(problem.file()));
    let found = done(py, move || shtaerman_cli::export_of(&arguments, &asked, &file))?;
    found.map_err(refused)
}

fn refused(refusal: Refusal) -> PyErr {
    match refusal.exit_code {
        1 | 3 => ConvergenceError::new_err(refusal.message),
        _ => PyValueError::new_err(refusal.message),
    }
}

//! Errors of the library as exceptions.

use pyo3::exceptions::{PyArithmeticError, PyValueError};
use pyo3::prelude::*;
use pyo3::{PyErr, create_exception};
use shtaerman::{Error, Warning};

create_exception!(
    shtaerman,
    ConvergenceError,
    PyArithmeticError,
    "A numerical promise was not kept: a tolerance not met, a time limit over, zones of contact not found. The command line ends with exit code 3 there."
);

/// The exception of an error, with the text of the command line: `ConvergenceError` where that ends with exit code 3, `ValueError` for bad input.
pub(crate) fn raised(error: &Error) -> PyErr {
    let words = text(error);
    if error.is_numerical() {
        ConvergenceError::new_err(words)
    } else {
        PyValueError::new_err(words)
    }
}

/// The same with what is doubtful about the file as notes, which Python 3.11 and newer show below the error, in the words of the command line.
pub(crate) fn raised_beside(py: Python<'_>, error: &Error, doubts: &[Warning]) -> PyErr {
    let raised = raised(error);
    let notes: Vec<String> =
        doubts.iter().map(|doubt| format!("warning: {}", doubt.message)).collect();
    if notes.is_empty() {
        return raised;
    }
    match raised.value(py).setattr("__notes__", notes) {
        Ok(()) => raised,
        Err(other) => other,
    }
}

/// The text of the command line without the line break at its end.
pub(crate) fn text(error: &Error) -> String {
    shtaerman_cli::told(error).trim_end().to_owned()
}

//! Errors of the library as exceptions.

use pyo3::exceptions::{PyArithmeticError, PyValueError};
use pyo3::{PyErr, create_exception};
use shtaerman::Error;

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

/// The text of the command line without the line break at its end.
pub(crate) fn text(error: &Error) -> String {
    shtaerman_cli::told(error).trim_end().to_owned()
}

//! The compiled half of the Python package: problems, contacts and what is asked of them, as NumPy arrays.
//!
//! Nothing is computed here. A problem is read from text as the command line reads it, and goes through the same library to the same
//! answer. The other half, in Python, makes the text from keywords and dictionaries and gives results their names.

mod contact;
mod equation;
mod errors;
mod find;
mod many;
mod own;
mod problem;
mod running;
mod sampled;
mod study;
mod sweep;

/// What `shtaerman/__init__.py` builds on; no one else should import it.
#[pyo3::pymodule]
mod _shtaerman {
    #[pymodule_export]
    use crate::contact::Contact;
    #[pymodule_export]
    use crate::equation::{command_json, export_text, solve_equation};
    #[pymodule_export]
    use crate::errors::ConvergenceError;
    #[pymodule_export]
    use crate::find::{find_crown, find_profile, find_value};
    #[pymodule_export]
    use crate::many::{is_varied_directly, solve_single, solve_varied};
    #[pymodule_export]
    use crate::own::solve_own;
    #[pymodule_export]
    use crate::problem::{Problem, load, superseded};

    #[pymodule_export]
    use crate::study::{Results, Study};
    #[pymodule_export]
    use crate::sweep::{is_swept, sweep_theta0};

    /// Version of the package and of the library.
    #[pymodule_export]
    #[allow(non_upper_case_globals, reason = "the name that Python has for it")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}

//! Studies and folders of their results.

use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::{PyKeyboardInterrupt, PyOSError, PyValueError};
use pyo3::prelude::*;
use shtaerman_cli::{PartFormat, Refusal, StudyResults};
use shtaerman_study::{Column, Design, Index, Part, Row, Summary};

use crate::errors::{ConvergenceError, raised};
use crate::running::{Ended, done, run};

/// A problem with some of its values varied, as a study file states it.
#[pyclass(frozen, module = "shtaerman._shtaerman")]
pub(crate) struct Study(Arc<shtaerman_study::Study>);

/// The results of a study in a folder.
#[pyclass(frozen, module = "shtaerman._shtaerman")]
pub(crate) struct Results(Arc<StudyResults>);

fn refused(refusal: Refusal) -> PyErr {
    match refusal.exit_code {
        // What could not be written: no other check of a study ends with this code.
        1 => PyOSError::new_err(refusal.message),
        3 => ConvergenceError::new_err(refusal.message),
        _ => PyValueError::new_err(refusal.message),
    }
}

/// What comes of work that stops where it is interrupted.
fn stoppable<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&AtomicBool) -> Option<T> + Send + 'static,
) -> PyResult<T> {
    match run(py, None, move |stop| work(stop))? {
        Ended::Done(Some(found)) => Ok(found),
        Ended::Done(None) | Ended::Late => Err(PyKeyboardInterrupt::new_err(())),
    }
}

/// Cases one block after the other; none where the flag was set.
fn in_blocks(
    study: &shtaerman_study::Study,
    cases: Range<usize>,
    stop: &AtomicBool,
) -> Option<Vec<Row>> {
    let mut rows = Vec::new();
    for first in cases.clone().step_by(study.block()) {
        if stop.load(Ordering::Relaxed) {
            return None;
        }
        rows.extend(study.solve(first..cases.end.min(first + study.block())));
    }
    Some(rows)
}

/// The columns of rows: arrays of numbers, lists of texts.
fn arrays<'py>(
    py: Python<'py>,
    study: &shtaerman_study::Study,
    rows: &[Row],
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let array = |column| match column {
        Column::Whole(values) => PyArray1::from_vec(py, values).into_bound_py_any(py),
        Column::Number(values) => PyArray1::from_vec(py, values).into_bound_py_any(py),
        Column::Text(values) => values.into_bound_py_any(py),
    };
    study.arrays(rows).into_iter().map(array).collect()
}

/// The part of this number.
fn part(study: &shtaerman_study::Study, number: usize) -> PyResult<Part> {
    let fault = || PyValueError::new_err(format!("there is no part {number}"));
    study.parts().nth(number).ok_or_else(fault)
}

#[pymethods]
impl Study {
    #[new]
    fn new(content: &[u8], name: &str, folder: PathBuf, overrides: Vec<String>) -> PyResult<Self> {
        let read = shtaerman_study::Study::from_bytes(content, name, &folder, &overrides);
        Ok(Self(Arc::new(read.map_err(|error| raised(&error))?)))
    }

    #[getter]
    fn cases(&self) -> usize {
        self.0.cases()
    }

    /// How many parts the results have.
    #[getter]
    fn parts(&self) -> usize {
        self.0.parts().len()
    }

    #[getter]
    fn columns(&self) -> Vec<String> {
        self.0.columns()
    }

    #[getter]
    fn variables(&self) -> Vec<String> {
        self.0.variables().iter().map(|variable| variable.key.clone()).collect()
    }

    #[getter]
    fn outputs(&self) -> Vec<&str> {
        self.0.outputs().iter().map(|output| output.name.as_str()).collect()
    }

    #[getter]
    fn is_audited(&self) -> bool {
        self.0.is_audited()
    }

    /// How many values each variable of a grid has, in order; none for other designs.
    #[getter]
    fn shape(&self) -> Option<Vec<usize>> {
        if self.0.design() != Design::Grid {
            return None;
        }
        self.0.variables().iter().map(|variable| variable.variation.count()).collect()
    }

    /// Sobol's indices of each output for each variable, with their standard errors: first order, total. None for other designs.
    fn sobol_indices(
        &self,
        cases: PyReadonlyArray1<'_, i64>,
        answered: PyReadonlyArray1<'_, bool>,
        outputs: Vec<PyReadonlyArray1<'_, f64>>,
    ) -> Option<Vec<Vec<[f64; 4]>>> {
        let mut summary = Summary::new(&self.0);
        for (at, (case, is_answered)) in
            cases.as_array().iter().zip(answered.as_array().iter()).enumerate()
        {
            let values =
                outputs.iter().map(|values| values.as_array().get(at).copied().unwrap_or(f64::NAN));
            summary.add(&Row {
                case: usize::try_from(*case).ok()?,
                inputs: Vec::new(),
                outputs: values.collect(),
                errors: vec![None; outputs.len()],
                error_kind: String::new(),
                warnings: String::new(),
                reason: if *is_answered { String::new() } else { "none".to_owned() },
            });
        }
        let indices = summary.indices?;
        let of_output = |output| {
            let four =
                |index: Index| [index.first, index.first_error, index.total, index.total_error];
            indices.of(output).map(four).collect()
        };
        Some((0..outputs.len()).map(of_output).collect())
    }

    /// Whether these are the cases of a part.
    fn is_part(&self, number: usize, cases: PyReadonlyArray1<'_, i64>) -> PyResult<bool> {
        let part = part(&self.0, number)?;
        Ok(part.cases.map(|case| case as i64).eq(cases.as_array().iter().copied()))
    }

    /// How many cases are best solved together.
    #[getter]
    fn block(&self) -> usize {
        self.0.block()
    }

    /// Solves cases one after the other.
    fn solve<'py>(
        &self,
        py: Python<'py>,
        first: usize,
        end: usize,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let study = Arc::clone(&self.0);
        let cases = first.min(study.cases())..end.min(study.cases());
        let rows = stoppable(py, move |stop| in_blocks(&study, cases, stop))?;
        arrays(py, &self.0, &rows)
    }

    /// The sample of the cases that is audited: without and with audit.
    #[allow(clippy::type_complexity, reason = "two lists of columns")]
    fn audited_sample<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Vec<Bound<'py, PyAny>>, Vec<Bound<'py, PyAny>>)> {
        let study = Arc::clone(&self.0);
        let (plain, audited) = stoppable(py, move |stop| {
            let cases = study.audited_sample();
            let each = |solve: &dyn Fn(usize) -> Vec<Row>| {
                let mut rows = Vec::new();
                for case in &cases {
                    if stop.load(Ordering::Relaxed) {
                        return None;
                    }
                    rows.extend(solve(*case));
                }
                Some(rows)
            };
            let plain = each(&|case| study.solve(case..case + 1))?;
            Some((plain, each(&|case| vec![study.solve_audited(case)])?))
        })?;
        Ok((arrays(py, &self.0, &plain)?, arrays(py, &self.0, &audited)?))
    }

    /// The folder of its results: made unless they are only read.
    fn results(
        &self,
        name: &str,
        folder: PathBuf,
        format: &str,
        is_read_only: bool,
    ) -> PyResult<Results> {
        let format = match format {
            "csv" => PartFormat::Csv,
            "npz" => PartFormat::Npz,
            "parquet" => PartFormat::Parquet,
            other => {
                let message = format!("format: must be csv, npz or parquet, got {other:?}");
                return Err(PyValueError::new_err(message));
            }
        };
        let study = self.0.as_ref().clone();
        let opened = StudyResults::open(study, name, &folder, format, is_read_only);
        Ok(Results(Arc::new(opened.map_err(refused)?)))
    }
}

#[pymethods]
impl Results {
    /// Where a part is, or will be.
    fn path(&self, number: usize) -> PyResult<PathBuf> {
        Ok(self.0.path(&part(self.0.study(), number)?))
    }

    /// Removes what runs that were killed have left of files they wrote.
    fn sweep_out(&self) {
        self.0.sweep_out();
    }

    /// The columns of a part that is there and whole.
    fn arrays<'py>(
        &self,
        py: Python<'py>,
        number: usize,
    ) -> PyResult<Option<Vec<Bound<'py, PyAny>>>> {
        let part = part(self.0.study(), number)?;
        let results = Arc::clone(&self.0);
        let rows = done(py, move || results.rows(&part))?.map_err(refused)?;
        rows.map(|rows| arrays(py, self.0.study(), &rows)).transpose()
    }

    /// The columns of a part, computed.
    fn solve<'py>(
        &self,
        py: Python<'py>,
        number: usize,
        threads: usize,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let part = part(self.0.study(), number)?;
        let results = Arc::clone(&self.0);
        let rows = stoppable(py, move |stop| results.solve_unless(&part, threads, stop))?;
        arrays(py, self.0.study(), &rows)
    }

    /// Computes a part and writes its file unless it is there and whole; whether it was computed.
    fn complete(&self, py: Python<'_>, number: usize, threads: usize) -> PyResult<bool> {
        let part = part(self.0.study(), number)?;
        let results = Arc::clone(&self.0);
        let completed = stoppable(py, move |stop| {
            let known = results.rows(&part).map(|rows| rows.is_some());
            if !matches!(known, Ok(false)) {
                return Some(known.map(|_| false));
            }
            let rows = results.solve_unless(&part, threads, stop)?;
            Some(results.write(&part, &rows).map(|()| true))
        })?;
        completed.map_err(refused)
    }
}

//! Problems.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use shtaerman::Error;
use shtaerman::document::{Document, FileError, ValueKind, load_bytes};
use shtaerman::file::{ALTERNATIVES, ProblemFile};

use crate::contact::Contact;
use crate::errors::{raised, raised_beside};
use crate::running::{Ended, run};
use crate::sampled::Sampled;

/// A problem that was read from text.
#[pyclass(frozen, module = "shtaerman._shtaerman")]
pub(crate) struct Problem {
    file: Arc<ProblemFile>,
    /// That of the file, with the profile that was sampled.
    problem: shtaerman::Problem,
}

impl Problem {
    pub(crate) fn problem(&self) -> &shtaerman::Problem {
        &self.problem
    }

    pub(crate) fn file(&self) -> &Arc<ProblemFile> {
        &self.file
    }
}

/// The document of a text with values replaced, also tables by plain values: here that is no slip of who types an option.
fn replaced(content: &[u8], name: &str, overrides: &[String]) -> Result<Document, FileError> {
    let mut document = Document::from_bytes(content, name)?;
    for text in overrides {
        let (key, value) = text.split_once('=').unwrap_or((text, ""));
        if document.get(key).is_some_and(|old| matches!(old.kind(), ValueKind::Table(_))) {
            document.remove(key);
        }
        document.set(key, value)?;
    }
    Ok(document)
}

/// The bytes of a file, or the fault of who named it.
#[pyfunction]
pub(crate) fn load(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyBytes>> {
    let name = path.display().to_string();
    let fault = |message| Error::from(FileError::new(message).in_file(Some(&name)));
    let bytes = load_bytes(&path).map_err(|message| raised(&fault(message)))?;
    Ok(PyBytes::new(py, &bytes))
}

/// Overrides `KEY=VALUE` with later ones, which take the place of earlier ones of the same key and of what excludes it.
#[pyfunction]
pub(crate) fn superseded(overrides: Vec<String>, later: Vec<String>) -> Vec<String> {
    let excludes = |one: &str, two: &str| {
        one == two || ALTERNATIVES.iter().any(|group| group.contains(&one) && group.contains(&two))
    };
    let gone = |text: &String| later.iter().any(|other| excludes(key(text), key(other)));
    let mut kept: Vec<String> = overrides.into_iter().filter(|text| !gone(text)).collect();
    kept.extend(later.iter().cloned());
    kept
}

fn key(text: &str) -> &str {
    text.split_once('=').map_or(text, |(key, _)| key)
}

#[pymethods]
impl Problem {
    #[new]
    #[pyo3(signature = (content, name, folder, overrides, profile = None))]
    fn new(
        content: &[u8],
        name: &str,
        folder: PathBuf,
        overrides: Vec<String>,
        profile: Option<Sampled<'_>>,
    ) -> PyResult<Self> {
        let document = replaced(content, name, &overrides)
            .map_err(|error| raised(&ProblemFile::explained(error, content).into()))?;
        let read = ProblemFile::from_document(document, Path::new(&folder));
        let file = read.map_err(|error| raised(&error))?;
        let problem = match &profile {
            Some(sampled) => sampled.on(file.problem()).map_err(|e| raised(&file.locate(e)))?,
            None => file.problem().clone(),
        };
        Ok(Self { file: Arc::new(file), problem })
    }

    /// Whether it is stated in numbers without dimensions.
    #[getter]
    fn is_dimensionless(&self) -> bool {
        self.problem.is_dimensionless()
    }

    #[getter]
    fn theta0(&self) -> f64 {
        self.problem.theta0()
    }

    #[getter]
    fn half_width(&self) -> f64 {
        self.problem.punch().half_width()
    }

    #[getter]
    fn gauge(&self) -> &'static str {
        self.problem.gauge()
    }

    /// Whether force and moment are those of a disk, not per unit length.
    #[getter]
    fn is_circular(&self) -> bool {
        self.problem.is_circular()
    }

    /// `unilateral` or `bilateral`.
    #[getter]
    fn contact(&self) -> &'static str {
        self.problem.solver().contact().name()
    }

    /// The places where the profile has kinks or jumps, in half-widths.
    fn breakpoints(&self) -> Vec<f64> {
        self.problem.profile().breakpoints(self.problem.punch().half_width())
    }

    /// The points of a measured profile.
    #[allow(clippy::type_complexity, reason = "a pair of arrays")]
    fn points<'py>(
        &self,
        py: Python<'py>,
    ) -> Option<(Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>)> {
        let (x, f) = self.problem.profile().points()?;
        Some((PyArray1::from_slice(py, x), PyArray1::from_slice(py, f)))
    }

    /// The heights of the base at places on it, in the units of the problem.
    fn heights<'py>(
        &self,
        py: Python<'py>,
        x: numpy::PyReadonlyArray1<'py, f64>,
    ) -> Bound<'py, PyArray1<f64>> {
        let half_width = self.half_width();
        let profile = self.problem.profile();
        let heights = x.as_array().into_iter().map(|x| profile.height(x / half_width, half_width));
        PyArray1::from_vec(py, heights.collect())
    }

    /// Solves it, with the audit of the answer if that is wanted.
    fn solve(&self, py: Python<'_>, audit: bool) -> PyResult<Contact> {
        let limit = self.problem.solver().time_limit();
        let (problem, file) = (self.problem.clone(), Arc::clone(&self.file));
        let work = move |stop: &Arc<AtomicBool>| {
            let found = solved(&problem, audit, stop);
            found.map(|found| found.map_err(|error| file.locate(error)))
        };
        // Where the interpreter was interrupted, that is raised; where the search was, its time is over.
        match run(py, limit, work)? {
            Ended::Done(Some(found)) => found
                .map(|contact| Contact::to(&self.file, contact))
                .map_err(|error| raised_beside(py, &error, &self.file.input_checks())),
            Ended::Done(None) | Ended::Late => {
                let error = Error::TimeLimit { limit: limit.unwrap_or_default() };
                Err(raised_beside(py, &error, &self.file.input_checks()))
            }
        }
    }
}

/// The answer, audited if that is wanted; none where the flag was set before it was found.
pub(crate) fn solved(
    problem: &shtaerman::Problem,
    audit: bool,
    stop: &Arc<AtomicBool>,
) -> Option<Result<shtaerman::Contact, Error>> {
    let found = problem.solve_unless(stop)?;
    Some(if audit { found.and_then(shtaerman::Contact::audited) } else { found })
}

//! Many cases of one problem, on several threads.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, mpsc};
use std::thread;

use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use shtaerman::file::ProblemFile;
use shtaerman::{Contact, Error};

use crate::errors::text;
use crate::problem::{Problem, solved};
use crate::running::{Ended, run};

/// Numbers that are told of a case, in this order; the four of the stiffness are one array of Python's.
const NUMBERS: [&str; 23] = [
    "settlement",
    "tilt",
    "force",
    "moment",
    "pressure_left",
    "pressure_middle",
    "pressure_right",
    "mean_pressure",
    "peak_pressure",
    "peak_pressure_at",
    "contact_width",
    "theta0",
    "stiffness_00",
    "stiffness_01",
    "stiffness_10",
    "stiffness_11",
    "error_pressure",
    "error_peak_pressure",
    "error_settlement",
    "error_tilt",
    "error_force",
    "error_moment",
    "relative_error",
];
/// Cases that a thread takes at a time: few, as one may take a thousand times as long as another.
const TAKEN: usize = 4;

/// What is told of a case.
struct Case {
    numbers: [f64; NUMBERS.len()],
    /// `bound` or `estimate`; empty where nothing is stated.
    kind: &'static str,
    /// Codes of the warnings.
    warnings: String,
    /// Why there is no answer; empty where there is one.
    reason: String,
}

impl Case {
    fn failed(reason: String) -> Self {
        let numbers = [f64::NAN; NUMBERS.len()];
        Self { numbers, kind: "", warnings: String::new(), reason }
    }

    fn solved(contact: &Contact) -> Self {
        let error = contact.error();
        let stated = |value: Option<f64>| value.unwrap_or(f64::NAN);
        let [[a, b], [c, d]] = contact.stiffness().matrix();
        let numbers = [
            contact.settlement(),
            contact.tilt(),
            contact.force(),
            contact.moment(),
            contact.pressure_left(),
            contact.pressure_middle(),
            contact.pressure_right(),
            contact.mean_pressure(),
            contact.peak_pressure(),
            contact.peak_pressure_at(),
            contact.contact_width(),
            contact.theta0(),
            a,
            b,
            c,
            d,
            stated(error.map(|error| error.pressure)),
            stated(error.and_then(|error| error.peak_pressure)),
            stated(error.map(|error| error.settlement)),
            stated(error.map(|error| error.tilt)),
            stated(error.map(|error| error.force)),
            stated(error.map(|error| error.moment)),
            contact.relative_error(),
        ];
        let codes = contact.warnings().iter().map(|warning| warning.code.to_string());
        let warnings = codes.collect::<Vec<_>>().join(" ");
        let kind = error.map_or("", |error| error.kind.name());
        Self { numbers, kind, warnings, reason: String::new() }
    }
}

/// A quantity that is varied without reading the problem anew.
#[derive(Clone, Copy)]
struct Varied(fn(&shtaerman::Problem, f64) -> Result<shtaerman::Problem, Error>);

impl Varied {
    fn named(name: &str) -> Option<Self> {
        type P = shtaerman::Problem;
        Some(Self(match name {
            "theta0" => P::with_theta0,
            "roughness" => |problem, value| problem.with_roughness(value),
            "young_modulus" => P::with_young_modulus,
            "force" => P::with_force,
            "settlement" => P::with_settlement,
            "moment" => P::with_moment,
            "eccentricity" => P::with_eccentricity,
            "tilt" => P::with_tilt,
            "tolerance" => P::with_tolerance,
            _ => return None,
        }))
    }
}

/// Cases to be solved.
enum Cases {
    /// One problem with columns of values.
    Varied { problem: Box<shtaerman::Problem>, columns: Vec<(Varied, Vec<f64>)>, count: usize },
    /// Problems of their own.
    Single(Vec<Result<(shtaerman::Problem, Arc<ProblemFile>), String>>),
}

impl Cases {
    fn len(&self) -> usize {
        match self {
            Self::Varied { count, .. } => *count,
            Self::Single(problems) => problems.len(),
        }
    }

    /// What came of a case; none where the flag was set before.
    fn case(
        &self,
        index: usize,
        file: &ProblemFile,
        audit: bool,
        stop: &Arc<AtomicBool>,
    ) -> Option<Case> {
        let (problem, file) = match self {
            Self::Varied { problem, columns, .. } => {
                let varied =
                    columns.iter().try_fold(problem.as_ref().clone(), |problem, (vary, values)| {
                        (vary.0)(&problem, values[index])
                    });
                match varied {
                    Ok(problem) => (problem, file),
                    Err(error) => return Some(Case::failed(text(&error))),
                }
            }
            Self::Single(problems) => match &problems[index] {
                Ok((problem, file)) => (problem.clone(), file.as_ref()),
                Err(reason) => return Some(Case::failed(reason.clone())),
            },
        };
        Some(match solved(&problem, audit, stop)? {
            Ok(contact) => Case::solved(&contact),
            Err(error) => Case::failed(text(&self.located(error, file))),
        })
    }

    /// A varied value stands in no line of the file.
    fn located(&self, error: Error, file: &ProblemFile) -> Error {
        match self {
            Self::Varied { .. } => error,
            Self::Single(_) => file.locate(error),
        }
    }
}

/// Solves all cases on so many threads; each is solved by itself, so that their number changes nothing. None where the flag was set.
fn all(
    cases: &Cases,
    file: &ProblemFile,
    audit: bool,
    threads: usize,
    stop: &Arc<AtomicBool>,
) -> Option<Vec<Case>> {
    let count = cases.len();
    let (next, (sender, receiver)) = (AtomicUsize::new(0), mpsc::channel());
    let worker = |sender: mpsc::Sender<(usize, Case)>| {
        loop {
            let first = next.fetch_add(TAKEN, Ordering::Relaxed);
            for index in first..count.min(first + TAKEN) {
                let Some(case) = cases.case(index, file, audit, stop) else { return };
                if sender.send((index, case)).is_err() {
                    return;
                }
            }
            if first >= count {
                return;
            }
        }
    };
    let mut found: Vec<Option<Case>> = Vec::new();
    found.resize_with(count, || None);
    thread::scope(|scope| {
        for _ in 0..threads.clamp(1, count.max(1)) {
            let sender = sender.clone();
            scope.spawn(|| worker(sender));
        }
        drop(sender);
        for (index, case) in receiver {
            found[index] = Some(case);
        }
    });
    found.into_iter().collect()
}

/// Names of the numbers, the numbers case by case, and kinds, warnings and reasons.
type Told<'py> = (
    [&'static str; NUMBERS.len()],
    Bound<'py, numpy::PyArray2<f64>>,
    Vec<&'static str>,
    Vec<String>,
    Vec<String>,
);

fn told<'py>(
    py: Python<'py>,
    cases: Cases,
    file: Arc<ProblemFile>,
    audit: bool,
    threads: usize,
) -> PyResult<Told<'py>> {
    let work = move |stop: &Arc<AtomicBool>| all(&cases, &file, audit, threads, stop);
    let Ended::Done(Some(found)) = run(py, None, work)? else {
        return Err(PyValueError::new_err("interrupted"));
    };
    let flat = PyArray1::from_iter(py, found.iter().flat_map(|case| case.numbers));
    let numbers = flat.reshape([found.len(), NUMBERS.len()])?;
    let kinds = found.iter().map(|case| case.kind).collect();
    let (warnings, reasons) = found.into_iter().map(|case| (case.warnings, case.reason)).unzip();
    Ok((NUMBERS, numbers, kinds, warnings, reasons))
}

/// Names of quantities that are varied without reading the problem anew.
#[pyfunction]
pub(crate) fn is_varied_directly(name: &str) -> bool {
    Varied::named(name).is_some()
}

/// Solves a problem for columns of values, all of one length.
#[pyfunction]
pub(crate) fn solve_varied<'py>(
    py: Python<'py>,
    problem: &Problem,
    columns: Vec<(String, PyReadonlyArray1<'py, f64>)>,
    audit: bool,
    threads: usize,
) -> PyResult<Told<'py>> {
    let count = columns.first().map_or(1, |(_, values)| values.as_array().len());
    let columns = columns.into_iter().map(|(name, values)| {
        let varied = Varied::named(&name).filter(|_| values.as_array().len() == count);
        let fault = || PyValueError::new_err(format!("{name}: is no column of {count} values"));
        Ok((varied.ok_or_else(fault)?, values.as_array().to_vec()))
    });
    let columns = columns.collect::<PyResult<Vec<_>>>()?;
    let cases = Cases::Varied { problem: Box::new(problem.problem().clone()), columns, count };
    told(py, cases, Arc::clone(problem.file()), audit, threads)
}

/// Solves problems, or tells the reasons that stand in their place.
#[pyfunction]
pub(crate) fn solve_single<'py>(
    py: Python<'py>,
    problem: &Problem,
    problems: Vec<(Option<PyRef<'py, Problem>>, String)>,
    audit: bool,
    threads: usize,
) -> PyResult<Told<'py>> {
    let single = problems.into_iter().map(|(problem, reason)| {
        problem.map(|p| (p.problem().clone(), Arc::clone(p.file()))).ok_or(reason)
    });
    told(py, Cases::Single(single.collect()), Arc::clone(problem.file()), audit, threads)
}

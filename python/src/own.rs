//! Equations on kernels of one's own, given by callables of Python.

use std::sync::{Mutex, MutexGuard, PoisonError};

use fredholm::Interval;
use fredholm::conformance::{Report, check_kernel};
use fredholm::kernel::{Kernel, Singularity, Split};
use numpy::PyReadonlyArray1;
use pyo3::call::PyCallArgs;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyFloat};
use shtaerman::Error;
use shtaerman::equation::{Equation, RightHandSide, solve_own as solve};
use shtaerman::expression::Expression;

use crate::errors::raised;

/// The first exception of callables; everything asked after it is NaN, so that the solver ends.
#[derive(Default)]
struct Fault(Mutex<Option<PyErr>>);

impl Fault {
    fn first(&self) -> MutexGuard<'_, Option<PyErr>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The exception of a callable where there was one: an error of the solver only follows from it.
    fn or(&self, error: &Error) -> PyErr {
        self.first().take().unwrap_or_else(|| raised(error))
    }

    /// What was found, unless a callable failed on the way.
    fn check<T>(&self, found: Result<T, Error>) -> PyResult<T> {
        let found = found.map_err(|error| self.or(&error))?;
        self.first().take().map_or(Ok(found), Err)
    }

    /// What a callable gives, read by `read`; `wanted` and `place` are for messages.
    fn call<T>(
        &self,
        function: &Py<PyAny>,
        arguments: impl for<'py> PyCallArgs<'py>,
        read: impl Fn(&Bound<'_, PyAny>) -> Option<T>,
        (wanted, place): (&str, &dyn Fn() -> String),
    ) -> Option<T> {
        if self.first().is_some() {
            return None;
        }
        let found = Python::attach(|py| {
            let found = function.bind(py).call1(arguments)?;
            read(&found).ok_or_else(|| {
                let given = found.repr().map_or(String::new(), |given| given.to_string());
                PyValueError::new_err(format!("{wanted}, got {given} at {}", place()))
            })
        });
        found.map_err(|error| self.first().replace(error)).ok()
    }
}

/// A finite real number of Python or NumPy, also an array without dimensions.
fn number(value: &Bound<'_, PyAny>) -> Option<f64> {
    if !value.is_exact_instance_of::<PyFloat>() {
        // NumPy makes numbers of arrays with one value and of complex numbers, with a warning at most.
        let kind =
            value.getattr("dtype").and_then(|kind| kind.getattr("kind")?.extract::<String>());
        let is_real = kind.map_or(true, |kind| matches!(kind.as_str(), "i" | "u" | "f"));
        if !is_real || value.is_instance_of::<PyBool>() || value.len().is_ok() {
            return None;
        }
    }
    value.extract::<f64>().ok().filter(|value| value.is_finite())
}

/// Two such numbers.
fn pair(found: &Bound<'_, PyAny>) -> Option<[f64; 2]> {
    let is_pair = found.len().is_ok_and(|count| count == 2);
    is_pair.then_some(())?;
    Some([number(&found.get_item(0).ok()?)?, number(&found.get_item(1).ok()?)?])
}

/// What a kernel does at `x = s`, as it is stated in Python.
#[derive(Clone, Copy)]
enum Stated {
    /// `B`.
    Smooth,
    /// `A ln |x - s| + B`.
    Logarithm,
    /// `A |x - s|^-mu + B`.
    Power(f64),
}

struct Own<'f> {
    function: &'f Py<PyAny>,
    fault: &'f Fault,
    interval: Interval,
    stated: Stated,
    is_even: bool,
}

impl Kernel for Own<'_> {
    fn interval(&self) -> Interval {
        self.interval
    }

    fn singularity(&self) -> Singularity {
        match self.stated {
            Stated::Smooth => Singularity::None,
            Stated::Logarithm => Singularity::Logarithm,
            Stated::Power(exponent) => Singularity::Power { exponent },
        }
    }

    fn split(&self, x: f64, s: f64, distance: f64) -> Split {
        let (function, fault) = (self.function, self.fault);
        let place = || format!("x = {x}, s = {s}");
        let parts = || {
            let wanted = "kernel: must give a pair (A, B) of finite numbers";
            fault.call(function, (x, s, distance), pair, (wanted, &place)).unwrap_or([f64::NAN; 2])
        };
        match self.stated {
            Stated::Smooth => {
                let wanted = "kernel: must give one finite number";
                let value = fault.call(function, (x, s), number, (wanted, &place));
                Split { factor: 0.0, rest: value.unwrap_or(f64::NAN) }
            }
            Stated::Logarithm => {
                let [factor, rest] = parts();
                Split { factor, rest }
            }
            // A d^-mu + B = (mu A) (d^-mu - 1)/mu + (A + B).
            Stated::Power(exponent) => {
                let [factor, rest] = parts();
                Split { factor: exponent * factor, rest: factor + rest }
            }
        }
    }

    fn is_even(&self) -> bool {
        self.is_even
    }
}

/// What a check of [`check_kernel`] that fails means for who wrote the kernel.
fn meaning(check: &str) -> &'static str {
    match check {
        "symmetry" => "K(x, s) and K(s, x) differ",
        "evenness" => "even = True, but reflection about the middle of the interval changes it",
        "split at the diagonal" => {
            "beside x = s its values are not what A and B at x = s say: the split is wrong, or the kernel has a jump, a singularity that is not stated, or too narrow a peak there"
        }
        _ => "it is not finite everywhere",
    }
}

fn require_kernel(report: &Report) -> PyResult<()> {
    let Some(check) = report.checks.iter().find(|check| !check.passes()) else { return Ok(()) };
    let (said, error, limit) = (meaning(check.name), check.error, check.limit);
    let message = format!(
        "kernel: must be symmetric and smooth but for its singularity: {said} (a relative {error:.1e}, where {limit:.0e} is allowed)"
    );
    Err(PyValueError::new_err(message))
}

fn formula(text: &str) -> PyResult<Expression> {
    Expression::parse(text, &[Equation::VARIABLE]).map_err(|error| {
        let help = error.help().map_or(String::new(), |help| format!("; {help}"));
        PyValueError::new_err(format!("rhs: `{text}`: {error}{help}"))
    })
}

/// The answer to `phi + parameter int K phi ds = f` for a kernel that a callable gives, as JSON. A singularity is the exponent of a power, 0 for the logarithm; a right-hand side is
/// text or a callable.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "what an equation is made of")]
pub(crate) fn solve_own<'py>(
    kernel: Py<PyAny>,
    singularity: Option<f64>,
    interval: [f64; 2],
    is_even: bool,
    parameter: f64,
    right_hand_side: Bound<'py, PyAny>,
    tolerance: Option<f64>,
    points: usize,
    at: Option<PyReadonlyArray1<'py, f64>>,
) -> PyResult<String> {
    let fault = Fault::default();
    let own = Own {
        function: &kernel,
        fault: &fault,
        interval: Interval::new(interval[0], interval[1]).map_err(|error| raised(&error.into()))?,
        stated: match singularity {
            None => Stated::Smooth,
            Some(0.0) => Stated::Logarithm,
            Some(exponent) => Stated::Power(exponent),
        },
        is_even,
    };
    require_kernel(&fault.check(check_kernel(&own).map_err(Error::from))?)?;
    let text = right_hand_side.extract::<String>();
    let right_hand_side = right_hand_side.unbind();
    let rhs = match text {
        Ok(text) => RightHandSide::formula(formula(&text)?),
        Err(_) => RightHandSide::function(|x: f64| {
            let described = ("rhs: must give one finite number", &(|| format!("x = {x}")) as _);
            fault.call(&right_hand_side, (x,), number, described).unwrap_or(f64::NAN)
        }),
    };
    let solved = fault.check(solve(&own, parameter, &rhs, tolerance))?;
    let places = match at {
        Some(at) => at.as_array().to_vec(),
        None => solved.places(points).map_err(|error| raised(&error))?,
    };
    let answer = fault.check(solved.answer(&places))?;
    serde_json::to_string(&answer).map_err(|error| PyRuntimeError::new_err(error.to_string()))
}

//! Solved contacts.

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use shtaerman::file::ProblemFile;
use shtaerman::{Answer, Error, PressureCurve, Stress, StressField, Warning};
use shtaerman_cli::plot::{Format, Size, render};

use crate::errors::raised;
use crate::running::done;

/// A solved contact, in the units of its problem.
#[pyclass(frozen, module = "shtaerman._shtaerman")]
pub(crate) struct Contact {
    contact: shtaerman::Contact,
    /// What an engineer would doubt.
    doubts: Vec<Warning>,
}

impl From<shtaerman::Contact> for Contact {
    fn from(contact: shtaerman::Contact) -> Self {
        let doubts = contact.sense_checks();
        Self { contact, doubts }
    }
}

impl Contact {
    /// The answer to the problem of a file.
    pub(crate) fn to(file: &ProblemFile, contact: shtaerman::Contact) -> Self {
        let doubts = file.sense_checks(&contact);
        Self { contact, doubts }
    }

    /// With what is doubtful about how it was asked for.
    pub(crate) fn with_doubts(mut self, doubts: &[Warning]) -> Self {
        self.doubts.extend_from_slice(doubts);
        self
    }

    fn all_warnings(&self) -> Vec<Warning> {
        [self.contact.warnings(), &self.doubts].concat()
    }
}

type Array<'py> = Bound<'py, PyArray1<f64>>;

#[pymethods]
impl Contact {
    #[getter]
    fn settlement(&self) -> f64 {
        self.contact.settlement()
    }

    #[getter]
    fn tilt(&self) -> f64 {
        self.contact.tilt()
    }

    #[getter]
    fn force(&self) -> f64 {
        self.contact.force()
    }

    #[getter]
    fn moment(&self) -> f64 {
        self.contact.moment()
    }

    #[getter]
    fn pressure_left(&self) -> f64 {
        self.contact.pressure_left()
    }

    #[getter]
    fn pressure_middle(&self) -> f64 {
        self.contact.pressure_middle()
    }

    #[getter]
    fn pressure_right(&self) -> f64 {
        self.contact.pressure_right()
    }

    #[getter]
    fn mean_pressure(&self) -> f64 {
        self.contact.mean_pressure()
    }

    #[getter]
    fn peak_pressure(&self) -> f64 {
        self.contact.peak_pressure()
    }

    #[getter]
    fn peak_pressure_at(&self) -> f64 {
        self.contact.peak_pressure_at()
    }

    #[getter]
    fn contact_width(&self) -> f64 {
        self.contact.contact_width()
    }

    #[getter]
    fn theta0(&self) -> f64 {
        self.contact.theta0()
    }

    #[getter]
    fn stiffness(&self) -> [[f64; 2]; 2] {
        self.contact.stiffness().matrix()
    }

    #[getter]
    fn zones(&self) -> Vec<[f64; 2]> {
        self.contact.zones()
    }

    #[getter]
    fn tension(&self) -> Vec<[f64; 2]> {
        self.contact.tension()
    }

    #[getter]
    fn relative_error(&self) -> f64 {
        self.contact.relative_error()
    }

    /// The errors as JSON: `kind`, and those in the units of the problem; none where the method tells none.
    #[getter]
    fn error(&self) -> Option<(&'static str, String)> {
        let error = self.contact.error()?;
        Some((error.kind.name(), json(&error)))
    }

    /// The kind and the reason of the audit that was made, and its figures as JSON; none where nobody asked for it.
    #[getter]
    fn audited_by(&self) -> Option<(&'static str, String, Option<String>)> {
        Some(match self.contact.audited_by()? {
            Ok(audit) => (audit.kind.name(), audit.reason.to_owned(), Some(json(audit))),
            Err(reason) => ("none", reason.to_string(), None),
        })
    }

    /// The method, its size and why it was taken.
    #[getter]
    fn method(&self) -> (&'static str, usize, &str) {
        let method = self.contact.method();
        (method.name.name(), method.n, self.contact.reason())
    }

    /// Codes and texts of the warnings as JSON.
    #[getter]
    fn warnings(&self) -> String {
        json(&self.all_warnings())
    }

    /// The sensitivities as JSON, by differences of complete solves where the linearised equation gives none and that is wanted.
    fn sensitivities(&self, py: Python<'_>, by_differences: bool) -> PyResult<Option<String>> {
        if let Some(found) = self.contact.tangent_sensitivities() {
            return Ok(Some(json(&found)));
        }
        if !by_differences {
            return Ok(None);
        }
        let contact = self.contact.clone();
        let found = done(py, move || contact.sensitivities())?;
        found.map(|found| Some(json(&found))).map_err(|error| raised(&error))
    }

    /// The same contact with the errors of its audit.
    fn audited(&self, py: Python<'_>) -> PyResult<Self> {
        let (contact, doubts) = (self.contact.clone(), self.doubts.clone());
        let found = done(py, move || contact.audited())?;
        found.map(|contact| Self { contact, doubts }).map_err(|error| raised(&error))
    }

    /// The same contact in numbers without dimensions.
    fn dimensionless(&self) -> Self {
        Self { contact: self.contact.dimensionless(), doubts: self.doubts.clone() }
    }

    /// The JSON of the command line, byte for byte but for the line break at its end: with the pressure at `at`, or at `points` places.
    fn to_json(&self, points: usize, at: Option<PyReadonlyArray1<'_, f64>>) -> PyResult<String> {
        let curve = match at {
            Some(at) => PressureCurve::at(&self.contact, at.as_array().to_vec()),
            None => PressureCurve::along(&self.contact, points),
        };
        let curve = curve.map_err(|error| raised(&error))?;
        let mut answer = Answer::new(&self.contact, curve);
        answer.warnings = self.all_warnings();
        if self.contact.is_nearly_smooth() {
            answer = answer.with_implied_edge_pressure(self.contact.implied_edge_pressures());
        }
        if let Some(found) = self.contact.tangent_sensitivities() {
            answer = answer.with_sensitivities(found);
        }
        serde_json::to_string_pretty(&answer).map_err(|e| PyRuntimeError::new_err(e.to_string()))
    }

    /// The pressure at places of the closed base.
    fn pressure<'py>(
        &self,
        py: Python<'py>,
        x: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Array<'py>> {
        let (contact, x) = (&self.contact, x.as_array().to_vec());
        // One by one: what a place gives does not depend on the others.
        let found: Result<Vec<f64>, Error> =
            py.detach(|| x.iter().map(|x| contact.pressure(*x)).collect());
        found.map(|p| PyArray1::from_vec(py, p)).map_err(|error| raised(&error))
    }

    /// The elastic displacement of the surface.
    fn displacement<'py>(&self, py: Python<'py>, x: PyReadonlyArray1<'py, f64>) -> Array<'py> {
        let (contact, x) = (&self.contact, x.as_array().to_vec());
        let found: Vec<f64> =
            py.detach(|| x.iter().map(|x| contact.elastic_displacement(*x)).collect());
        PyArray1::from_vec(py, found)
    }

    /// The gap between base and body.
    fn gap<'py>(&self, py: Python<'py>, x: PyReadonlyArray1<'py, f64>) -> PyResult<Array<'py>> {
        let (contact, x) = (&self.contact, x.as_array().to_vec());
        let found: Result<Vec<f64>, Error> =
            py.detach(|| x.iter().map(|x| contact.gap(*x)).collect());
        found.map(|gap| PyArray1::from_vec(py, gap)).map_err(|error| raised(&error))
    }

    /// `sigma_x, sigma_y, sigma_z, tau_xy`, von Mises' and the largest shear stress at places and depths, and the error of the field.
    fn stress<'py>(
        &self,
        py: Python<'py>,
        x: PyReadonlyArray1<'py, f64>,
        depth: PyReadonlyArray1<'py, f64>,
        poisson_ratio: Option<f64>,
    ) -> PyResult<([Array<'py>; 6], f64)> {
        let contact = &self.contact;
        let places: Vec<[f64; 2]> =
            x.as_array().iter().zip(depth.as_array().iter()).map(|(x, d)| [*x, *d]).collect();
        let found = py.detach(|| {
            let field = StressField::new(contact, poisson_ratio)?;
            let at = places.iter().map(|[x, depth]| field.stress(*x, *depth));
            Ok::<_, Error>((at.collect::<Result<Vec<_>, _>>()?, field.error()))
        });
        let (found, error) = found.map_err(|error| raised(&error))?;
        let parts: [fn(&Stress) -> f64; 6] = [
            |stress| stress.sigma_x,
            |stress| stress.sigma_y,
            |stress| stress.sigma_z,
            |stress| stress.tau_xy,
            Stress::von_mises,
            Stress::max_shear,
        ];
        let parts = parts.map(|part| found.iter().map(part).collect());
        Ok((parts.map(|part| PyArray1::from_vec(py, part)), error))
    }

    /// The picture of the command line, as SVG.
    fn svg(&self) -> PyResult<String> {
        let plot = shtaerman_cli::contact_plot(&self.contact).map_err(|error| raised(&error))?;
        let bytes = render(&plot, Format::Svg, Size::default());
        let bytes = bytes.map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        String::from_utf8(bytes).map_err(|error| PyRuntimeError::new_err(error.to_string()))
    }
}

/// What the library's own types serialise to; a fault there would be one of ours.
fn json(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).unwrap_or_default()
}

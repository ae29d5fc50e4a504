//! The inverse way round.

use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use shtaerman::Error;
use shtaerman::inverse::{self, Crowned, Goal, Normalisation};
use shtaerman::quantity::{self, Dimension};
use shtaerman::{Rotational, Roughness, Scaling, Vertical, Warning};

use crate::contact::Contact;
use crate::errors::raised;
use crate::problem::Problem;
use crate::running::done;

/// A number in the units of the problem, or text with a unit.
#[derive(FromPyObject)]
pub(crate) enum Quantity {
    #[pyo3(transparent)]
    Number(f64),
    #[pyo3(transparent)]
    Text(String),
}

impl Quantity {
    /// The value of `name`, in SI units.
    pub(crate) fn value(&self, name: &str, dimension: Dimension) -> PyResult<f64> {
        let text = match self {
            Self::Number(value) => return Ok(*value),
            Self::Text(text) => text,
        };
        let parsed = quantity::parse(text).and_then(|quantity| quantity.of(dimension, text));
        parsed.map_err(|error| PyValueError::new_err(format!("{name} `{text}`: {error}")))
    }
}

/// The dimension that a quantity has in a problem.
fn of_problem(problem: &shtaerman::Problem, dimension: Dimension) -> Dimension {
    if problem.is_dimensionless() { Dimension::NONE } else { dimension }
}

/// What is doubtful about a number that is wanted, in the words of the command line.
fn doubt(problem: &shtaerman::Problem, name: &str, wanted: &Quantity) -> Vec<Warning> {
    let is_bare = !problem.is_dimensionless() && name == "peak_pressure";
    let doubt = match wanted {
        Quantity::Number(value) if is_bare => Warning::low_peak_pressure(name, *value),
        _ => None,
    };
    doubt.into_iter().collect()
}

/// Changes of the problem that lead to what was found: keywords of Python's `replace`.
type Changes = Vec<(&'static str, f64)>;

/// Force and what goes with it, as the load of a contact has them.
fn load(contact: &shtaerman::Contact) -> Changes {
    let load = contact.problem().load();
    let vertical = match load.vertical() {
        Vertical::Force(value) => ("force", value),
        Vertical::Settlement(value) => ("settlement", value),
    };
    let rotational = match load.rotational() {
        Rotational::Moment(value) => ("moment", value),
        Rotational::Eccentricity(value) => ("eccentricity", value),
        Rotational::Tilt(value) => ("tilt", value),
    };
    vec![vertical, rotational]
}

/// Coefficient and exponent of the rough layer.
fn layer(contact: &shtaerman::Contact) -> Changes {
    match contact.problem().scaling().map(Scaling::roughness) {
        Some(Roughness::Linear { compliance }) => vec![("roughness", compliance)],
        Some(Roughness::Power { coefficient, exponent }) => {
            vec![("coefficient", coefficient), ("exponent", exponent)]
        }
        _ => vec![("roughness", 0.0)],
    }
}

/// Value, wanted, reached, relative error, solves, changes, contact.
type Found = (f64, f64, f64, f64, usize, Changes, Contact);

/// The force or the roughness for a peak pressure, a contact width or a settlement.
#[pyfunction]
pub(crate) fn find_value(
    py: Python<'_>,
    problem: &Problem,
    unknown: &str,
    goal: &str,
    wanted: Quantity,
    audit: bool,
) -> PyResult<Found> {
    let named: fn(f64) -> Goal = match goal {
        "peak_pressure" => Goal::PeakPressure,
        "contact_width" => Goal::ContactWidth,
        _ => Goal::Settlement,
    };
    let dimension = of_problem(problem.problem(), named(0.0).dimension());
    let doubt = doubt(problem.problem(), goal, &wanted);
    let goal = named(wanted.value(goal, dimension)?);
    let is_force = unknown == "force";
    let (asked, file) = (problem.problem().clone(), problem.file().clone());
    let work = move || {
        let search = if is_force { inverse::force } else { inverse::roughness };
        let mut found = search(&asked, goal)?;
        if audit {
            found.contact = found.contact.audited()?;
        }
        Ok::<_, Error>(found)
    };
    let found = done(py, move || work().map_err(|error| file.locate(error)))?;
    let found = found.map_err(|error| raised(&error))?;
    let changes = if is_force { load(&found.contact) } else { layer(&found.contact) };
    let (wanted, error) = (goal.wanted(), found.relative_error());
    let contact = Contact::from(found.contact).with_doubts(&doubt);
    Ok((found.value, wanted, found.reached, error, found.evaluations, changes, contact))
}

/// Radius, profile and contact of a crown.
type CrownRow = (Option<f64>, String, Contact);

/// The crown of the lowest peak pressure, the sharpest and the flattest within the limit, and the number of solves.
#[pyfunction]
pub(crate) fn find_crown(
    py: Python<'_>,
    problem: &Problem,
    limit: Option<Quantity>,
    audit: bool,
) -> PyResult<(CrownRow, Option<CrownRow>, Option<CrownRow>, usize)> {
    let dimension = of_problem(problem.problem(), Dimension::PRESSURE);
    let doubts: Vec<Warning> =
        limit.iter().flat_map(|limit| doubt(problem.problem(), "peak_pressure", limit)).collect();
    let limit = limit.map(|limit| limit.value("peak_pressure", dimension)).transpose()?;
    let (asked, file) = (problem.problem().clone(), problem.file().clone());
    let work = move || {
        let crown = inverse::crown(&asked, limit)?;
        let row = |crowned: Crowned| {
            let contact = crowned.contact.clone();
            let contact = if audit { contact.audited()? } else { contact };
            let contact = Contact::from(contact).with_doubts(&doubts);
            Ok::<_, Error>((crowned.radius, crowned.formula(), contact))
        };
        let (least, largest) = (crown.least.map(row).transpose()?, crown.largest.map(row));
        Ok::<_, Error>((row(crown.best)?, least, largest.transpose()?, crown.evaluations))
    };
    let found = done(py, move || work().map_err(|error| file.locate(error)))?;
    found.map_err(|error| raised(&error))
}

/// Places, heights, pressures; settlement, tilt, force, moment, factor, error.
type Shaped<'py> = ([Bound<'py, PyArray1<f64>>; 3], [f64; 6]);

/// The profile that gives a prescribed pressure.
#[pyfunction]
pub(crate) fn find_profile<'py>(
    py: Python<'py>,
    problem: &Problem,
    pressure: String,
    is_lowest: bool,
    points: usize,
) -> PyResult<Shaped<'py>> {
    let zero = if is_lowest { Normalisation::Lowest } else { Normalisation::Centre };
    let (asked, file) = (problem.problem().clone(), problem.file().clone());
    let found = done(py, move || {
        let shaped = inverse::prescribed_pressure(&asked, &pressure, zero, points);
        shaped.map_err(|error| file.locate(error))
    })?;
    let found = found.map_err(|error| raised(&error))?;
    let arrays = [found.places, found.heights, found.pressures];
    let numbers =
        [found.settlement, found.tilt, found.force, found.moment, found.factor, found.error];
    Ok((arrays.map(|part| PyArray1::from_vec(py, part)), numbers))
}

//! What the outputs of a study are for one answer.

use std::cell::OnceCell;

use shtaerman::equation::SolvedEquation;
use shtaerman::{Contact, Criterion, Error, Peak, StressField, Warning};

use crate::Output;
use crate::output::Told;

/// The values of the outputs with their errors.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Answered {
    pub(crate) outputs: Vec<f64>,
    pub(crate) errors: Vec<Option<f64>>,
    /// `bound` or `estimate`; empty where no error is stated.
    pub(crate) error_kind: String,
    /// Codes with spaces between.
    pub(crate) warnings: String,
}

/// A value with its error.
type Stated = (f64, Option<f64>);

impl Answered {
    fn new(stated: Vec<Stated>, error_kind: &str) -> Self {
        let (outputs, errors) = stated.into_iter().unzip();
        Self { outputs, errors, error_kind: error_kind.to_owned(), warnings: String::new() }
    }

    /// Of a contact, and of what was looked for where it was found.
    pub(crate) fn contact(
        outputs: &[Output],
        contact: &Contact,
        found: Option<f64>,
    ) -> Result<Self, Error> {
        let stresses = Stresses { contact, field: OnceCell::new(), peaks: Default::default() };
        let stated = |output: &Output| -> Result<Stated, Error> {
            let errors = contact.error();
            let (value, error) = match output.told {
                Told::Contact(quantity) => (quantity.value(contact), quantity.error(contact)),
                Told::Pressure(x) => (contact.pressure(x)?, errors.map(|error| error.pressure)),
                Told::Displacement(x) => (contact.elastic_displacement(x), None),
                Told::Stress(criterion) => stresses.largest(criterion)?,
                Told::Depth(criterion) => (stresses.peak(criterion)?.depth, None),
                Told::Found => (found.unwrap_or(f64::NAN), None),
                Told::Integral | Told::Solution(_) => (f64::NAN, None),
            };
            // The pressure at a corner without roughness is infinite, and not within any error of that.
            Ok((value, error.filter(|_| value.is_finite())))
        };
        let kind = contact.error().map_or("", |error| error.kind.name());
        // Those of stresses are estimates whatever is known of the pressure.
        let is_estimate = !kind.is_empty() && outputs.iter().any(Output::is_stress);
        let kind = if is_estimate { "estimate" } else { kind };
        Ok(Self::new(outputs.iter().map(stated).collect::<Result<_, _>>()?, kind))
    }

    pub(crate) fn with_warnings(self, warnings: &[Warning]) -> Self {
        Self { warnings: codes(warnings), ..self }
    }

    /// Of the solution of an equation.
    pub(crate) fn equation(outputs: &[Output], solved: &SolvedEquation<'_>) -> Result<Self, Error> {
        let stated = |output: &Output| -> Result<Stated, Error> {
            Ok(match output.told {
                Told::Integral => {
                    let integral = solved.integral();
                    let error = solved.error().integral;
                    (integral.unwrap_or(f64::NAN), integral.and(finite(error)))
                }
                // A solution of the first kind is infinite where its weight is.
                Told::Solution(x) => {
                    (solved.evaluate(x)?.unwrap_or(f64::INFINITY), solved.error_at(x)?)
                }
                _ => (f64::NAN, None),
            })
        };
        let stated = outputs.iter().map(stated).collect::<Result<_, _>>()?;
        Ok(Self::new(stated, solved.error_kind().name()))
    }
}

/// The codes of warnings, each once.
fn codes(warnings: &[Warning]) -> String {
    let mut codes: Vec<String> = Vec::new();
    for warning in warnings {
        let code = warning.code.to_string();
        if !codes.contains(&code) {
            codes.push(code);
        }
    }
    codes.join(" ")
}

fn finite(value: f64) -> Option<f64> {
    Some(value).filter(|value| value.is_finite())
}

/// The stresses below a contact, computed where an output asks for them.
struct Stresses<'c> {
    contact: &'c Contact,
    field: OnceCell<StressField>,
    /// Of von Mises, and of the largest shear stress.
    peaks: [OnceCell<Peak>; 2],
}

impl Stresses<'_> {
    fn field(&self) -> Result<&StressField, Error> {
        if let Some(field) = self.field.get() {
            return Ok(field);
        }
        let field = StressField::new(self.contact, None)?;
        Ok(self.field.get_or_init(|| field))
    }

    fn peak(&self, criterion: Criterion) -> Result<&Peak, Error> {
        let field = self.field()?;
        let place = usize::from(criterion == Criterion::Tresca);
        Ok(self.peaks[place].get_or_init(|| field.peak(criterion)))
    }

    /// Of Tresca's stress the half, which is the shear stress.
    fn largest(&self, criterion: Criterion) -> Result<Stated, Error> {
        let value = self.peak(criterion)?.value;
        let share = if criterion == Criterion::Tresca { 0.5 } else { 1.0 };
        Ok((share * value, finite(self.field()?.error())))
    }
}

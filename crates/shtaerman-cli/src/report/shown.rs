//! Values in the units of a problem, for people and for columns.

use shtaerman::Problem;
use shtaerman::quantity::{AxisUnit, Measure, OutputUnits};

use super::significant;

/// Significant digits of a value without dimension.
const DIGITS: usize = 10;

/// How values of a problem are shown.
#[derive(Debug, Clone)]
pub(crate) struct Shown {
    pub(crate) units: OutputUnits,
    pub(crate) is_physical: bool,
    is_circular: bool,
}

impl Shown {
    /// Of a problem whose results are wanted in these units.
    pub(crate) fn of(problem: &Problem, units: &OutputUnits) -> Self {
        Self {
            units: units.clone(),
            is_physical: !problem.is_dimensionless(),
            is_circular: problem.is_circular(),
        }
    }

    /// A value with its unit.
    pub(crate) fn value(&self, value: f64, measure: Measure) -> String {
        if self.is_physical { self.units.shown(value, measure) } else { significant(value, DIGITS) }
    }

    /// The same with at most so many digits.
    pub(crate) fn with_digits(&self, value: f64, measure: Measure, digits: usize) -> String {
        if self.is_physical {
            self.units.shown_with_digits(value, measure, digits)
        } else {
            significant(value, digits)
        }
    }

    /// An error.
    pub(crate) fn few_digits(&self, value: f64, measure: Measure) -> String {
        self.with_digits(value, measure, 2)
    }

    /// A value that is zero as far as its error tells.
    pub(crate) fn certain(&self, value: f64, error: Option<f64>, measure: Measure) -> String {
        let is_lost = error.is_some_and(|error| value.abs() <= error);
        self.value(if is_lost { 0.0 } else { value }, measure)
    }

    /// A force, per unit length but for a circular punch.
    pub(crate) fn force(&self) -> Measure {
        if self.is_circular { Measure::Force } else { Measure::ForcePerLength }
    }

    /// A moment likewise.
    pub(crate) fn moment(&self) -> Measure {
        if self.is_circular { Measure::Moment } else { Measure::MomentPerLength }
    }

    /// The name of a column with its unit, where units were chosen; what values are multiplied by.
    pub(crate) fn column(&self, name: &str, measure: Measure) -> (String, f64) {
        if !(self.is_physical && self.units.are_chosen()) {
            return (name.to_owned(), 1.0);
        }
        let AxisUnit { factor, label } = self.units.column(measure);
        (format!("{name} [{label}]"), factor)
    }
}

//! The units of the outputs and of the varied values of a study.

use shtaerman::file::AnyFile;
use shtaerman::quantity::{AxisUnit, Measure, OutputUnits};
use shtaerman_study::{Input, Study};

use super::Shown;

/// A column of a table or an axis: its name with the unit, and what values are multiplied by.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scaled {
    pub(crate) name: String,
    pub(crate) factor: f64,
}

impl Scaled {
    fn plain(name: &str) -> Self {
        Self { name: name.to_owned(), factor: 1.0 }
    }

    fn of(name: &str, unit: &AxisUnit) -> Self {
        Self { name: format!("{name} [{}]", unit.label), factor: unit.factor }
    }
}

/// How the values of a study are shown; those of an equation have no units.
#[derive(Debug, Default)]
pub(crate) struct StudyUnits(Option<Shown>);

impl StudyUnits {
    /// In these units, as the first case of the study has them; in SI units where none were chosen.
    ///
    /// # Errors
    /// Those of the first case.
    pub(crate) fn new(study: &Study, overrides: &[String]) -> Result<Self, shtaerman::Error> {
        let AnyFile::Problem(file) = study.first(overrides)? else { return Ok(Self(None)) };
        let shown = Shown::of(file.problem(), file.units());
        Ok(Self(shown.is_physical.then_some(shown)))
    }

    /// The unit of an output or a varied key, where units were chosen and it has one.
    pub(crate) fn chosen(&self, name: &str) -> Option<AxisUnit> {
        let shown = self.0.as_ref().filter(|shown| shown.units.are_chosen())?;
        measure(shown, name).map(|measure| shown.units.column(measure))
    }

    /// The column of a file, `name`, which holds values or errors of `quantity`: with its unit where units were chosen, else in SI units without a word.
    pub(crate) fn file_column(&self, name: &str, quantity: &str) -> Scaled {
        let unit = self.chosen(quantity);
        unit.map_or_else(|| Scaled::plain(name), |unit| Scaled::of(name, &unit))
    }

    /// The column of a table: an output or a varied key in the chosen unit, or that of SI without a prefix.
    pub(crate) fn column(&self, name: &str) -> Scaled {
        self.scaled(name, OutputUnits::column)
    }

    /// An axis that reaches from zero to `largest` (SI) at least: in the chosen unit, or that of SI with a prefix.
    pub(crate) fn axis(&self, name: &str, largest: f64) -> Scaled {
        self.scaled(name, |units, measure| units.axis(largest, measure))
    }

    /// A varied value as messages show it: with its unit where it has one, else as it is given.
    pub(crate) fn value(&self, key: &str, value: &Input) -> String {
        let shown = self.0.as_ref().zip(value.number());
        let with_unit = shown.and_then(|(shown, number)| {
            measure(shown, key).map(|measure| shown.units.shown(number, measure))
        });
        with_unit.unwrap_or_else(|| value.to_string())
    }

    fn scaled(&self, name: &str, unit: impl Fn(&OutputUnits, Measure) -> AxisUnit) -> Scaled {
        let Some(shown) = &self.0 else { return Scaled::plain(name) };
        match measure(shown, name) {
            Some(measure) => Scaled::of(name, &unit(&shown.units, measure)),
            None if NUMBERS.contains(&last(name)) => Scaled::plain(name),
            None => Scaled::of(name, &AxisUnit { factor: 1.0, label: "SI".to_owned() }),
        }
    }
}

/// What has no unit.
const NUMBERS: [&str; 6] =
    ["theta0", "number_of_zones", "poisson_ratio", "tolerance", "exponent", "grading_exponent"];

fn last(name: &str) -> &str {
    name.rsplit('.').next().unwrap_or(name)
}

/// What an output or a key measures, where it has one unit.
fn measure(shown: &Shown, name: &str) -> Option<Measure> {
    // A function at a place, such as `pressure(2 mm)`.
    let name = name.split_once('(').map_or(name, |(function, _)| function.trim_end());
    Some(match last(name) {
        "settlement" | "displacement" => Measure::Displacement,
        "tilt" => Measure::Angle,
        "force" => shown.force(),
        "moment" => shown.moment(),
        "pressure_left"
        | "pressure_middle"
        | "pressure_right"
        | "mean_pressure"
        | "mean_contact_pressure"
        | "peak_pressure"
        | "pressure"
        | "max_von_mises"
        | "max_shear"
        | "young_modulus"
        | "grading_modulus"
        | "yield_stress" => Measure::Pressure,
        "peak_pressure_at"
        | "max_von_mises_depth"
        | "max_shear_depth"
        | "contact_width"
        | "half_width"
        | "outer_half_width"
        | "inner_half_gap"
        | "period"
        | "radius"
        | "eccentricity"
        | "thickness" => Measure::Length,
        "roughness" => Measure::Compliance,
        _ => return None,
    })
}

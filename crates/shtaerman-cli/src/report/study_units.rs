//! The units of the outputs and of the varied values of a study.

use shtaerman::file::AnyFile;
use shtaerman::quantity::{AxisUnit, Measure, OutputUnits};
use shtaerman_study::Study;

use super::Shown;

/// A column of a table or an axis: its name with the unit, and what values are multiplied by.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scaled {
    pub(crate) name: String,
    pub(crate) factor: f64,
}

/// How the values of a study are shown.
#[derive(Debug, Default)]
pub(crate) struct StudyUnits(Option<Shown>);

impl StudyUnits {
    /// In these units, as the first case of the study has them; in SI units where none were chosen.
    ///
    /// # Errors
    /// Those of the first case.
    pub(crate) fn new(study: &Study, overrides: &[String]) -> Result<Self, shtaerman::Error> {
        // Equations have no units.
        let AnyFile::Problem(file) = study.first(overrides)? else { return Ok(Self(None)) };
        let units: &OutputUnits = file.units();
        Ok(Self(units.are_chosen().then(|| Shown::of(file.problem(), units))))
    }

    /// The unit of an output or a varied key, where units were chosen and it has one.
    pub(crate) fn chosen(&self, name: &str) -> Option<AxisUnit> {
        let shown = self.0.as_ref().filter(|shown| shown.is_physical)?;
        measure(shown, name).map(|measure| shown.units.column(measure))
    }

    /// An output or a varied key.
    pub(crate) fn column(&self, study: &Study, name: &str) -> Scaled {
        let plain = |unit: &str| Scaled { name: format!("{name}{unit}"), factor: 1.0 };
        let Some(shown) = &self.0 else {
            return plain(if study.is_dimensionless() { "" } else { ", SI" });
        };
        match measure(shown, name) {
            Some(measure) => {
                let (name, factor) = shown.column(name, measure);
                Scaled { name, factor }
            }
            None => plain(if NUMBERS.contains(&last(name)) { "" } else { ", SI" }),
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

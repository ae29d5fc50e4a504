//! The result of `find profile`.

use std::fmt::Write;

use serde::Serialize;
use shtaerman::Problem;
use shtaerman::inverse::Shaped;
use shtaerman::quantity::{Measure, OutputUnits};

use super::find::{SCHEMA, key, system, value_of};
use super::{Shown, Table, Told};
use crate::output::Content;

/// The trace of a profile, in the units of the problem.
#[derive(Debug, Serialize)]
struct Trace {
    x: Vec<f64>,
    f: Vec<f64>,
    p: Vec<f64>,
}

/// The result of `find profile`.
#[derive(Debug, Serialize)]
pub(crate) struct ShapedReport {
    schema: &'static str,
    unknown: &'static str,
    units: &'static str,
    pressure: String,
    factor: f64,
    settlement: f64,
    tilt: f64,
    force: f64,
    moment: f64,
    error: f64,
    profile: Trace,
    #[serde(skip)]
    shown: Shown,
}

impl ShapedReport {
    pub(crate) fn new(
        problem: &Problem,
        units: &OutputUnits,
        pressure: &str,
        shaped: Shaped,
    ) -> Self {
        let shown = Shown::of(problem, units);
        let Shaped { places, heights, pressures, settlement, tilt, force, moment, factor, error } =
            shaped;
        Self {
            schema: SCHEMA,
            unknown: "profile",
            units: system(&shown),
            pressure: pressure.to_owned(),
            factor,
            settlement,
            tilt,
            force,
            moment,
            error,
            profile: Trace { x: places, f: heights, p: pressures },
            shown,
        }
    }

    /// The profile and the pressure over the base: name and points of each.
    pub(crate) fn curves(&self) -> [(String, Vec<(f64, f64)>); 2] {
        let Trace { x, f, p } = &self.profile;
        let over = |values: &[f64]| x.iter().copied().zip(values.iter().copied()).collect();
        [("profile".to_owned(), over(f)), ("pressure".to_owned(), over(p))]
    }

    /// What the places of the curves are.
    pub(crate) fn position_label(&self) -> &'static str {
        if self.shown.is_physical { "x [m]" } else { "ξ = x/a" }
    }

    pub(crate) fn table(&self, name: &str) -> Told {
        let shown = &self.shown;
        let length = |value| value_of(shown, value, Measure::Displacement);
        let Trace { x, f, p } = &self.profile;
        let mut text = Told::new(format!(
            "{name}: the profile under which the pressure is {}\n\n",
            self.pressure
        ));
        let mut table = Table::new(&["", "", ""]);
        let mut row = |name: &str, value: String, note: &str| {
            table.row(vec![name.to_owned(), value, note.to_owned()]);
        };
        row("settlement", length(self.settlement), "gauge: ln(a/|x-s|), with this profile");
        row("tilt", value_of(shown, self.tilt, Measure::Angle), "");
        row("force", value_of(shown, self.force, shown.force()), "to which the pressure is scaled");
        row("moment", value_of(shown, self.moment, shown.moment()), "");
        let largest = p.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        row("pressure, largest", value_of(shown, largest, Measure::Pressure), "");
        let lowest = f.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = f.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        row("profile, lowest", length(lowest), "");
        row("profile, highest", length(highest), "");
        row("profile, edges", length(f[0]), &format!("and {}", length(f[f.len() - 1])));
        let note = shown.few_digits(self.error, Measure::Displacement);
        text.table(table);
        let _ = writeln!(text, "\nerror (estimate) of the heights, at most: {note}");
        let keys = key(shown, "punch", "profile");
        let units = if shown.is_physical && shown.units.are_chosen() {
            let [x, f] = [Measure::Length, Measure::Displacement]
                .map(|measure| shown.units.column(measure).label);
            format!(", x_unit = \"{x}\", f_unit = \"{f}\"")
        } else {
            String::new()
        };
        let _ =
            writeln!(text, "trace of {} points: --format csv --output profile.csv, then", x.len());
        let _ = writeln!(text, "set: {keys} = {{ csv = \"profile.csv\"{units} }}");
        text
    }

    pub(crate) fn csv(&self) -> Content<'_> {
        let [x, f] = if self.shown.is_physical { ["x", "f"] } else { ["xi", "f0"] };
        let (x, length) = self.shown.column(x, Measure::Length);
        let (f, height) = self.shown.column(f, Measure::Displacement);
        let rows = self.profile.x.iter().zip(&self.profile.f);
        let rows = rows.map(move |(x, f)| vec![(x * length).to_string(), (f * height).to_string()]);
        Content::csv(&[x, f], rows)
    }
}

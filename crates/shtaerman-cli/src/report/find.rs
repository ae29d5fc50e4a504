//! The results of `find` for people, as JSON and as CSV.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde::Serialize;
use serde_json::Value;
use shtaerman::inverse::{Crown, Crowned, Found, Goal};
use shtaerman::quantity::{Dimension, Measure, OutputUnits};
use shtaerman::{Contact, Problem, Rotational, Roughness, Scaling, Warning};

use super::{Shown, Table, Told, significant};
use crate::output::Content;

/// Version of the layout; `schema/find.schema.json` describes it.
pub(super) const SCHEMA: &str = "shtaerman-find/2";
/// Significant digits of the value found, in tables.
const DIGITS: usize = 10;

/// A value with the digits of a value that was found.
pub(super) fn value_of(shown: &Shown, value: f64, measure: Measure) -> String {
    shown.with_digits(value, measure, DIGITS)
}

/// The word of JSON for the units of a problem.
pub(super) fn system(shown: &Shown) -> &'static str {
    if shown.is_physical { "SI" } else { "dimensionless" }
}

/// The table of a problem or of `[dimensionless]` in which a key stands.
pub(super) fn key(shown: &Shown, table: &str, name: &str) -> String {
    format!("{}.{name}", if shown.is_physical { table } else { "dimensionless" })
}

/// A number as TOML and `--set` read it back to the last bit; infinities are none of ours.
fn written(value: f64) -> Value {
    serde_json::Number::from_f64(value).map_or(Value::Null, Value::Number)
}

/// What the contact is like at the value found, in the units of the problem.
#[derive(Debug, Serialize)]
struct Summary {
    settlement: f64,
    tilt: f64,
    force: f64,
    moment: f64,
    peak_pressure: f64,
    peak_pressure_at: f64,
    contact_width: f64,
    zones: Vec<[f64; 2]>,
    error: Option<SummaryError>,
}

/// How sure the contact is, in the units of the problem: by its audit, where it has one.
#[derive(Debug, Serialize)]
struct SummaryError {
    kind: &'static str,
    pressure: f64,
    settlement: f64,
    tilt: f64,
    force: f64,
    moment: f64,
}

impl SummaryError {
    fn new(contact: &Contact) -> Option<Self> {
        let error = contact.error()?;
        Some(Self {
            kind: error.kind.name(),
            pressure: error.pressure,
            settlement: error.settlement,
            tilt: error.tilt,
            force: error.force,
            moment: error.moment,
        })
    }
}

impl Summary {
    fn new(contact: &Contact) -> Self {
        Self {
            settlement: contact.settlement(),
            tilt: contact.tilt(),
            force: contact.force(),
            moment: contact.moment(),
            peak_pressure: contact.peak_pressure(),
            peak_pressure_at: contact.peak_pressure_at(),
            contact_width: contact.contact_width(),
            zones: contact.zones(),
            error: SummaryError::new(contact),
        }
    }

    fn rows(&self, shown: &Shown, gauge: &str, table: &mut Table) {
        let length = |value| value_of(shown, value, Measure::Length);
        let mut row = |name: &str, value: String, note: String| {
            table.row(vec![name.to_owned(), value, note]);
        };
        let settlement = value_of(shown, self.settlement, Measure::Displacement);
        row("settlement", settlement, format!("gauge: {gauge}"));
        row("tilt", value_of(shown, self.tilt, Measure::Angle), String::new());
        row("force", value_of(shown, self.force, shown.force()), String::new());
        row("moment", value_of(shown, self.moment, shown.moment()), String::new());
        let place = format!("at {}", length(self.peak_pressure_at));
        row("pressure, largest", value_of(shown, self.peak_pressure, Measure::Pressure), place);
        let zones = match self.zones.len() {
            1 => format!("{} to {}", length(self.zones[0][0]), length(self.zones[0][1])),
            count => format!("{count} zones"),
        };
        row("contact width", length(self.contact_width), zones);
        if let Some(error) = &self.error {
            let name = format!("error ({})", error.kind);
            let value = shown.few_digits(error.pressure, Measure::Pressure);
            row(&name, value, "of the pressure, at most".to_owned());
        }
    }
}

/// Keys and values as lines of TOML.
fn set_lines(set: &BTreeMap<String, Value>) -> String {
    let mut text = String::new();
    for (key, value) in set {
        let value = match value {
            Value::Object(table) => {
                let pairs: Vec<String> =
                    table.iter().map(|(key, value)| format!("{key} = {value}")).collect();
                format!("{{ {} }}", pairs.join(", "))
            }
            other => other.to_string(),
        };
        let _ = writeln!(text, "set: {key} = {value}");
    }
    text
}

/// What was wanted and what was reached.
#[derive(Debug, Serialize)]
struct Reached {
    quantity: &'static str,
    wanted: f64,
    reached: f64,
    relative_error: f64,
}

/// The result of `find force` and `find roughness`.
#[derive(Debug, Serialize)]
pub(crate) struct FoundReport {
    schema: &'static str,
    unknown: &'static str,
    units: &'static str,
    goal: Reached,
    value: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    kept: Option<&'static str>,
    set: BTreeMap<String, Value>,
    contact: Summary,
    evaluations: usize,
    warnings: Vec<Warning>,
    #[serde(skip)]
    shown: Shown,
    /// What the value found and the goal measure.
    #[serde(skip)]
    measures: [Measure; 2],
}

impl FoundReport {
    /// Of the force; `problem` is that of the file.
    pub(crate) fn force(problem: &Problem, found: &Found, units: &OutputUnits) -> Self {
        let shown = Shown::of(problem, units);
        let mut set = BTreeMap::from([(key(&shown, "load", "force"), written(found.value))]);
        let kept = match problem.load().rotational() {
            Rotational::Tilt(_) => "tilt",
            Rotational::Moment(moment) if moment != 0.0 => {
                set.insert(key(&shown, "load", "moment"), written(found.contact.moment()));
                "eccentricity"
            }
            Rotational::Moment(_) | Rotational::Eccentricity(_) => "eccentricity",
        };
        let measure = shown.force();
        Self::new("force", shown, measure, found, Some(kept), set)
    }

    /// Of the roughness.
    pub(crate) fn roughness(problem: &Problem, found: &Found, units: &OutputUnits) -> Self {
        let shown = Shown::of(problem, units);
        let value = match found.contact.problem().scaling().map(Scaling::roughness) {
            Some(Roughness::Power { coefficient, exponent }) => {
                serde_json::json!({ "coefficient": coefficient, "exponent": exponent })
            }
            _ => written(found.value),
        };
        let set = BTreeMap::from([("foundation.roughness".to_owned(), value)]);
        Self::new("roughness", shown, Measure::Compliance, found, None, set)
    }

    fn new(
        unknown: &'static str,
        shown: Shown,
        measure: Measure,
        found: &Found,
        kept: Option<&'static str>,
        set: BTreeMap<String, Value>,
    ) -> Self {
        Self {
            schema: SCHEMA,
            unknown,
            units: system(&shown),
            goal: Reached {
                quantity: found.goal.key(),
                wanted: found.goal.wanted(),
                reached: found.reached,
                relative_error: found.relative_error(),
            },
            value: found.value,
            kept,
            set,
            contact: Summary::new(&found.contact),
            evaluations: found.evaluations,
            warnings: Vec::new(),
            shown,
            measures: [measure, measure_of(found.goal)],
        }
    }

    /// What a user should know about the contact found.
    pub(crate) fn warn(&mut self, warnings: Vec<Warning>) {
        self.warnings = warnings;
    }

    pub(crate) fn table(&self, name: &str, found: &Found) -> Told {
        let problem = found.contact.problem();
        let shown = &self.shown;
        let wanted = |value| value_of(shown, value, self.measures[1]);
        let kept = match self.kept {
            Some("eccentricity") => ", keeping the eccentricity M/P",
            Some(_) => ", keeping the tilt",
            None => "",
        };
        let mut text = Told::new(format!(
            "{name}: the {} for a {} of {}{kept}\n\n",
            self.unknown,
            found.goal.name(),
            wanted(self.goal.wanted)
        ));
        let mut table = Table::new(&["", "", ""]);
        if self.unknown == "roughness" {
            let (value, note) = match problem.scaling().map(Scaling::roughness) {
                Some(Roughness::Power { exponent, .. }) => (
                    significant(self.value, DIGITS),
                    format!("coefficient B of B p^{exponent}, m/Pa^{exponent}"),
                ),
                _ => (value_of(shown, self.value, Measure::Compliance), "chi".to_owned()),
            };
            table.row(vec!["roughness".to_owned(), value, note]);
        }
        self.contact.rows(shown, problem.gauge(), &mut table);
        text.table(table);
        let _ = writeln!(
            text,
            "\nreached: {} by {} solves, off by {} of it",
            wanted(self.goal.reached),
            self.evaluations,
            significant(self.goal.relative_error, 2)
        );
        text.push_str(&set_lines(&self.set));
        text.push_str(&warning_lines(&self.warnings));
        text
    }

    pub(crate) fn csv(&self) -> Content<'_> {
        let [of_value, of_goal] = self.measures;
        let (value, unit) = match (self.unknown, &self.set.values().next()) {
            // The coefficient of a power law has a unit of its own.
            ("roughness", Some(Value::Object(_))) => ("value".to_owned(), 1.0),
            _ => self.shown.column("value", of_value),
        };
        let (wanted, goal) = self.shown.column("wanted", of_goal);
        let (reached, _) = self.shown.column("reached", of_goal);
        let relative = "relative_error".to_owned();
        let header =
            ["unknown".to_owned(), value, "quantity".to_owned(), wanted, reached, relative];
        let row = vec![
            self.unknown.to_owned(),
            (self.value * unit).to_string(),
            self.goal.quantity.to_owned(),
            (self.goal.wanted * goal).to_string(),
            (self.goal.reached * goal).to_string(),
            self.goal.relative_error.to_string(),
        ];
        Content::csv(&header, [row])
    }
}

fn measure_of(goal: Goal) -> Measure {
    match goal {
        Goal::Settlement(_) => Measure::Displacement,
        _ if goal.dimension() == Dimension::PRESSURE => Measure::Pressure,
        _ => Measure::Length,
    }
}

fn warning_lines(warnings: &[Warning]) -> String {
    warnings.iter().map(|warning| format!("warning: {}\n", warning.message)).collect()
}

/// One crown; the radius of the flat base is `null`.
#[derive(Debug, Serialize)]
struct CrownRow {
    radius: Option<f64>,
    profile: String,
    contact: Summary,
}

impl CrownRow {
    fn new(crown: &Crowned) -> Self {
        Self {
            radius: crown.radius,
            profile: crown.formula(),
            contact: Summary::new(&crown.contact),
        }
    }
}

/// The result of `find crown`.
#[derive(Debug, Serialize)]
pub(crate) struct CrownReport {
    schema: &'static str,
    unknown: &'static str,
    units: &'static str,
    limit: Option<f64>,
    best: CrownRow,
    least: Option<CrownRow>,
    largest: Option<CrownRow>,
    set: BTreeMap<String, Value>,
    evaluations: usize,
    warnings: Vec<Warning>,
    #[serde(skip)]
    shown: Shown,
}

impl CrownReport {
    pub(crate) fn new(crown: &Crown, units: &OutputUnits, warnings: Vec<Warning>) -> Self {
        let shown = Shown::of(crown.best.contact.problem(), units);
        let profile = Value::String(crown.best.formula());
        Self {
            schema: SCHEMA,
            unknown: "crown",
            units: system(&shown),
            limit: crown.limit,
            best: CrownRow::new(&crown.best),
            least: crown.least.as_ref().map(CrownRow::new),
            largest: crown.largest.as_ref().map(CrownRow::new),
            set: BTreeMap::from([(key(&shown, "punch", "profile"), profile)]),
            evaluations: crown.evaluations,
            warnings,
            shown,
        }
    }

    pub(crate) fn table(&self, name: &str) -> Told {
        let shown = &self.shown;
        let pressure = |value| value_of(shown, value, Measure::Pressure);
        let heading = match self.limit {
            Some(limit) => format!(
                "{name}: the crown radii, base x^2/(2R), that keep the peak pressure at {} or below\n\n",
                pressure(limit)
            ),
            None => {
                format!("{name}: the crown radius, base x^2/(2R), of the lowest peak pressure\n\n")
            }
        };
        let mut text = Told::new(heading);
        let mut table = Table::new(&["", "radius", "peak pressure", "at", "contact width"]);
        let rows = [("least", &self.least), ("lowest peak", &None), ("largest", &self.largest)];
        for (name, row) in rows {
            let row = if name == "lowest peak" { Some(&self.best) } else { row.as_ref() };
            let Some(CrownRow { radius, contact, .. }) = row else { continue };
            let radius =
                radius.map_or("flat base".to_owned(), |r| value_of(shown, r, Measure::Length));
            table.row(vec![
                name.to_owned(),
                radius,
                pressure(contact.peak_pressure),
                value_of(shown, contact.peak_pressure_at, Measure::Length),
                value_of(shown, contact.contact_width, Measure::Length),
            ]);
        }
        text.table(table);
        let _ =
            writeln!(text, "\n{} solves; set is the crown of the lowest peak", self.evaluations);
        text.push_str(&set_lines(&self.set));
        text.push_str(&warning_lines(&self.warnings));
        text
    }

    pub(crate) fn csv(&self) -> Content<'_> {
        let (radius, length) = self.shown.column("radius", Measure::Length);
        let (peak, stress) = self.shown.column("peak_pressure", Measure::Pressure);
        let optional = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
        let rows = [
            ("least", self.least.as_ref()),
            ("best", Some(&self.best)),
            ("largest", self.largest.as_ref()),
        ];
        let rows = rows.into_iter().filter_map(move |(name, row)| {
            let row = row?;
            let peak = (row.contact.peak_pressure * stress).to_string();
            Some(vec![name.to_owned(), optional(row.radius.map(|radius| radius * length)), peak])
        });
        Content::csv(&["crown".to_owned(), radius, peak], rows)
    }
}

//! The results of `find` for people, as JSON and as CSV.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde::Serialize;
use serde_json::Value;
use shtaerman::inverse::{Crown, Crowned, Found, Goal, Shaped};
use shtaerman::quantity::{Dimension, DisplayUnit, engineering, engineering_with_digits};
use shtaerman::{Contact, Problem, Rotational, Roughness, Scaling};

use super::{Table, significant};
use crate::output::Content;

/// Version of the layout; `schema/find.schema.json` describes it.
const SCHEMA: &str = "shtaerman-find/2";
/// Significant digits of the value found, in tables.
const DIGITS: usize = 10;

/// Values in the units of a problem, for people.
#[derive(Debug, Clone, Copy)]
struct Shown {
    is_physical: bool,
    is_circular: bool,
}

impl Shown {
    fn of(problem: &Problem) -> Self {
        Self { is_physical: !problem.is_dimensionless(), is_circular: problem.is_circular() }
    }

    fn units(self) -> &'static str {
        if self.is_physical { "SI" } else { "dimensionless" }
    }

    fn value(self, value: f64, unit: impl Into<DisplayUnit>) -> String {
        if !self.is_physical {
            return significant(value, DIGITS);
        }
        engineering_with_digits(value, unit, DIGITS)
    }

    fn few_digits(self, value: f64, unit: impl Into<DisplayUnit>) -> String {
        if self.is_physical {
            engineering_with_digits(value, unit, 2)
        } else {
            significant(value, 2)
        }
    }

    fn force(self) -> DisplayUnit {
        // A force has the dimension of a moment per length, whose symbol it must not take.
        if self.is_circular {
            DisplayUnit::prefixed("N")
        } else {
            Dimension::FORCE_PER_LENGTH.into()
        }
    }

    fn moment(self) -> DisplayUnit {
        if self.is_circular { Dimension::MOMENT.into() } else { DisplayUnit::prefixed("N") }
    }
}

/// The table of a problem or of `[dimensionless]` in which a key stands.
fn key(shown: Shown, table: &str, name: &str) -> String {
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

    fn rows(&self, shown: Shown, gauge: &str, table: &mut Table) {
        let length = |value| shown.value(value, Dimension::LENGTH);
        let mut row = |name: &str, value: String, note: String| {
            table.row(vec![name.to_owned(), value, note]);
        };
        row("settlement", length(self.settlement), format!("gauge: {gauge}"));
        row("tilt", shown.value(self.tilt, DisplayUnit::angle()), String::new());
        row("force", shown.value(self.force, shown.force()), String::new());
        row("moment", shown.value(self.moment, shown.moment()), String::new());
        let place = format!("at {}", length(self.peak_pressure_at));
        row("pressure, largest", shown.value(self.peak_pressure, Dimension::PRESSURE), place);
        let zones = match self.zones.len() {
            1 => format!("{} to {}", length(self.zones[0][0]), length(self.zones[0][1])),
            count => format!("{count} zones"),
        };
        row("contact width", length(self.contact_width), zones);
        if let Some(error) = &self.error {
            let name = format!("error ({})", error.kind);
            let value = shown.few_digits(error.pressure, Dimension::PRESSURE);
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
}

impl FoundReport {
    /// Of the force; `problem` is that of the file.
    pub(crate) fn force(problem: &Problem, found: &Found) -> Self {
        let shown = Shown::of(problem);
        let mut set = BTreeMap::from([(key(shown, "load", "force"), written(found.value))]);
        let kept = match problem.load().rotational() {
            Rotational::Tilt(_) => "tilt",
            Rotational::Moment(moment) if moment != 0.0 => {
                set.insert(key(shown, "load", "moment"), written(found.contact.moment()));
                "eccentricity"
            }
            Rotational::Moment(_) | Rotational::Eccentricity(_) => "eccentricity",
        };
        Self::new("force", shown, found, Some(kept), set)
    }

    /// Of the roughness.
    pub(crate) fn roughness(problem: &Problem, found: &Found) -> Self {
        let shown = Shown::of(problem);
        let value = match found.contact.problem().scaling().map(Scaling::roughness) {
            Some(Roughness::Power { coefficient, exponent }) => {
                serde_json::json!({ "coefficient": coefficient, "exponent": exponent })
            }
            _ => written(found.value),
        };
        let set = BTreeMap::from([("foundation.roughness".to_owned(), value)]);
        Self::new("roughness", shown, found, None, set)
    }

    fn new(
        unknown: &'static str,
        shown: Shown,
        found: &Found,
        kept: Option<&'static str>,
        set: BTreeMap<String, Value>,
    ) -> Self {
        Self {
            schema: SCHEMA,
            unknown,
            units: shown.units(),
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
        }
    }

    pub(crate) fn table(&self, name: &str, found: &Found) -> String {
        let problem = found.contact.problem();
        let shown = Shown::of(problem);
        let wanted = |value| shown.value(value, goal_unit(found.goal));
        let kept = match self.kept {
            Some("eccentricity") => ", keeping the eccentricity M/P",
            Some(_) => ", keeping the tilt",
            None => "",
        };
        let mut text = format!(
            "{name}: the {} for a {} of {}{kept}\n\n",
            self.unknown,
            found.goal.name(),
            wanted(self.goal.wanted)
        );
        let mut table = Table::new(&["", "", ""]);
        if self.unknown == "roughness" {
            let (value, note) = match problem.scaling().map(Scaling::roughness) {
                Some(Roughness::Power { exponent, .. }) => (
                    significant(self.value, DIGITS),
                    format!("coefficient B of B p^{exponent}, m/Pa^{exponent}"),
                ),
                _ => (shown.value(self.value, Dimension::COMPLIANCE), "chi".to_owned()),
            };
            table.row(vec!["roughness".to_owned(), value, note]);
        }
        self.contact.rows(shown, problem.gauge(), &mut table);
        text.push_str(&table.to_string());
        let _ = writeln!(
            text,
            "\nreached: {} by {} solves, off by {} of it",
            wanted(self.goal.reached),
            self.evaluations,
            significant(self.goal.relative_error, 2)
        );
        text.push_str(&set_lines(&self.set));
        text
    }

    pub(crate) fn csv(&self) -> Content<'_> {
        let header = ["unknown", "value", "quantity", "wanted", "reached", "relative_error"];
        let row = vec![
            self.unknown.to_owned(),
            self.value.to_string(),
            self.goal.quantity.to_owned(),
            self.goal.wanted.to_string(),
            self.goal.reached.to_string(),
            self.goal.relative_error.to_string(),
        ];
        Content::csv(&header, [row])
    }
}

fn goal_unit(goal: Goal) -> DisplayUnit {
    goal.dimension().into()
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
}

impl CrownReport {
    pub(crate) fn new(crown: &Crown) -> Self {
        let shown = Shown::of(crown.best.contact.problem());
        let profile = Value::String(crown.best.formula());
        Self {
            schema: SCHEMA,
            unknown: "crown",
            units: shown.units(),
            limit: crown.limit,
            best: CrownRow::new(&crown.best),
            least: crown.least.as_ref().map(CrownRow::new),
            largest: crown.largest.as_ref().map(CrownRow::new),
            set: BTreeMap::from([(key(shown, "punch", "profile"), profile)]),
            evaluations: crown.evaluations,
        }
    }

    pub(crate) fn table(&self, name: &str, crown: &Crown) -> String {
        let shown = Shown::of(crown.best.contact.problem());
        let pressure = |value| shown.value(value, Dimension::PRESSURE);
        let mut text = match self.limit {
            Some(limit) => format!(
                "{name}: the crown radii, base x^2/(2R), that keep the peak pressure at {} or below\n\n",
                pressure(limit)
            ),
            None => {
                format!("{name}: the crown radius, base x^2/(2R), of the lowest peak pressure\n\n")
            }
        };
        let mut table = Table::new(&["", "radius", "peak pressure", "at", "contact width"]);
        let rows = [("least", &self.least), ("lowest peak", &None), ("largest", &self.largest)];
        for (name, row) in rows {
            let row = if name == "lowest peak" { Some(&self.best) } else { row.as_ref() };
            let Some(CrownRow { radius, contact, .. }) = row else { continue };
            let radius =
                radius.map_or("flat base".to_owned(), |r| shown.value(r, Dimension::LENGTH));
            table.row(vec![
                name.to_owned(),
                radius,
                pressure(contact.peak_pressure),
                shown.value(contact.peak_pressure_at, Dimension::LENGTH),
                shown.value(contact.contact_width, Dimension::LENGTH),
            ]);
        }
        text.push_str(&table.to_string());
        let _ =
            writeln!(text, "\n{} solves; set is the crown of the lowest peak", self.evaluations);
        text.push_str(&set_lines(&self.set));
        text
    }

    pub(crate) fn csv(&self) -> Content<'_> {
        let optional = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
        let rows = [
            ("least", self.least.as_ref()),
            ("best", Some(&self.best)),
            ("largest", self.largest.as_ref()),
        ];
        let rows = rows.into_iter().filter_map(move |(name, row)| {
            let row = row?;
            let peak = row.contact.peak_pressure.to_string();
            Some(vec![name.to_owned(), optional(row.radius), peak])
        });
        Content::csv(&["crown", "radius", "peak_pressure"], rows)
    }
}

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
    pub(crate) fn new(problem: &Problem, pressure: &str, shaped: Shaped) -> Self {
        let shown = Shown::of(problem);
        let Shaped { places, heights, pressures, settlement, tilt, force, moment, factor, error } =
            shaped;
        Self {
            schema: SCHEMA,
            unknown: "profile",
            units: shown.units(),
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

    pub(crate) fn table(&self, name: &str) -> String {
        let shown = self.shown;
        let length = |value| shown.value(value, Dimension::LENGTH);
        let Trace { x, f, p } = &self.profile;
        let mut text =
            format!("{name}: the profile under which the pressure is {}\n\n", self.pressure);
        let mut table = Table::new(&["", "", ""]);
        let mut row = |name: &str, value: String, note: &str| {
            table.row(vec![name.to_owned(), value, note.to_owned()]);
        };
        row("settlement", length(self.settlement), "gauge: ln(a/|x-s|), with this profile");
        row("tilt", shown.value(self.tilt, DisplayUnit::angle()), "");
        row("force", shown.value(self.force, shown.force()), "to which the pressure is scaled");
        row("moment", shown.value(self.moment, shown.moment()), "");
        let largest = p.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        row("pressure, largest", shown.value(largest, Dimension::PRESSURE), "");
        let lowest = f.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = f.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        row("profile, lowest", length(lowest), "");
        row("profile, highest", length(highest), "");
        row("profile, edges", length(f[0]), &format!("and {}", length(f[f.len() - 1])));
        let note = if shown.is_physical {
            engineering(self.error, Dimension::LENGTH)
        } else {
            significant(self.error, 2)
        };
        text.push_str(&table.to_string());
        let _ = writeln!(text, "\nerror (estimate) of the heights, at most: {note}");
        let keys = key(shown, "punch", "profile");
        let _ = writeln!(
            text,
            "trace of {} points: --format csv --output profile.csv, then {keys} = {{ csv = \"profile.csv\" }}",
            x.len()
        );
        text
    }

    pub(crate) fn csv(&self) -> Content<'_> {
        let header = if self.shown.is_physical { ["x", "f"] } else { ["xi", "f0"] };
        let rows = self.profile.x.iter().zip(&self.profile.f);
        Content::csv(&header, rows.map(|(x, f)| vec![x.to_string(), f.to_string()]))
    }
}

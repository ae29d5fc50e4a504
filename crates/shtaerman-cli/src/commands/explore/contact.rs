//! A solved contact for the page: the answer as the command line gives it, and what the pictures need.

use serde_json::{Map, Value, json};
use shtaerman::document::{Document, Table, ValueKind};
use shtaerman::file::ProblemFile;
use shtaerman::quantity::{self, Dimension, DisplayUnit};
use shtaerman::{Answer, Contact, Law, PressureCurve, Warning};

use super::asked::{self, Asked};
use crate::commands::problem_file::{self, Solved};
use crate::commands::{sheet, solve};
use crate::output::Content;
use crate::report::{self, Shown};
use crate::{Failure, snippets};

/// Points of the pressure curve, as many as `solve` gives.
pub(super) const POINTS: usize = 201;
/// Points of the surface beside the punch, on each side, and how far it is drawn, in half-widths.
const BESIDE: u32 = 40;
const MARGIN: f64 = 0.6;

/// A file and its contact.
pub(super) struct Solution {
    pub(super) file: ProblemFile,
    pub(super) contact: Contact,
    doubts: Vec<Warning>,
}

impl Solution {
    /// Solves as `solve` does.
    pub(super) fn new(asked: &Asked, is_audited: bool) -> Result<Self, Failure> {
        let file = asked.problem()?;
        let contact = match problem_file::solved(&file, is_audited)? {
            Solved::Answer(contact) => contact,
            Solved::Unfinished(contact, _) => contact,
        };
        let doubts = file.sense_checks(&contact);
        Ok(Self { file, contact, doubts })
    }

    /// The answer as `solve --format json` writes it.
    pub(super) fn answer(&self) -> Result<Answer, Failure> {
        let curve = PressureCurve::along(&self.contact, POINTS)?;
        solve::answer(&self.contact, curve, &self.doubts)
    }
}

/// Everything that the page shows of a contact.
pub(super) fn told(asked: &Asked, is_audited: bool) -> Result<Value, Failure> {
    let solution = Solution::new(asked, is_audited)?;
    let (contact, answer) = (&solution.contact, solution.answer()?);
    let document = asked.document()?;
    Ok(json!({
        "answer": serde_json::to_value(&answer).map_err(asked::unwritable)?,
        "cards": cards(contact),
        "table": report::answer_rows(contact, &answer),
        "words": report::sentences(contact),
        "notes": report::answer_notes(contact, &answer),
        "picture": picture(contact)?,
        "inputs": inputs(&document),
        "unfinished": contact.is_unfinished(),
        "python": snippets::python(&document),
        "command": format!("shtaerman solve {}", snippets::quoted(&asked.name)),
    }))
}

/// The figures that are looked at first, each with its stated error.
fn cards(contact: &Contact) -> Value {
    let shown = Shown::of(contact);
    let errors = contact.error();
    let error = |value: Option<f64>, unit: DisplayUnit| {
        value.filter(|value| value.is_finite()).map(|value| shown.error(value, unit))
    };
    let length = || DisplayUnit::from(Dimension::LENGTH);
    let kind = errors.map(|errors| errors.kind.name());
    let card = |key: &str, name: &str, value: String, si: f64, error: Option<String>| json!({ "key": key, "name": name, "value": value, "si": finite(si), "error": error, "kind": kind });
    let peak = errors.and_then(|e| e.peak_pressure.or(Some(e.pressure)));
    json!([
        card(
            "settlement",
            "Settlement",
            shown.length(contact.settlement()),
            contact.settlement(),
            error(errors.map(|e| e.settlement), length())
        ),
        card(
            "tilt",
            "Tilt",
            shown.angle(contact.tilt()),
            contact.tilt(),
            error(errors.map(|e| e.tilt), DisplayUnit::angle())
        ),
        card(
            "peak_pressure",
            "Largest pressure",
            shown.pressure(contact.peak_pressure()),
            contact.peak_pressure(),
            error(peak, Dimension::PRESSURE.into())
        ),
        card(
            "contact_width",
            "Contact width",
            shown.length(contact.contact_width()),
            contact.contact_width(),
            error(errors.and_then(|e| e.zones), length())
        ),
        card(
            "force",
            "Force",
            shown.force(contact.force()),
            contact.force(),
            error(errors.map(|e| e.force), shown.force_unit())
        ),
        card(
            "moment",
            "Moment",
            shown.moment(contact.moment()),
            contact.moment(),
            error(errors.map(|e| e.moment), shown.moment_unit())
        ),
    ])
}

/// JSON has no infinity.
fn finite(value: f64) -> Value {
    if value.is_finite() { json!(value) } else { Value::Null }
}

/// What the pictures are drawn from, in the units of the problem.
fn picture(contact: &Contact) -> Result<Value, Failure> {
    let problem = contact.problem();
    let punch = problem.punch();
    let half_width = punch.half_width();
    let curve = PressureCurve::along(contact, POINTS)?;
    let beside = (1..=BESIDE)
        .map(|i| half_width * (1.0 + MARGIN * (f64::from(i) / f64::from(BESIDE)).powi(2)));
    let mut places: Vec<f64> =
        beside.clone().map(|x| -x).chain(curve.x.iter().copied()).chain(beside).collect();
    places.sort_by(f64::total_cmp);
    let heights: Vec<Value> =
        places.iter().map(|&x| finite(contact.elastic_displacement(x))).collect();
    let base: Vec<Value> = curve.x.iter().map(|&x| finite(contact.base_depth(x))).collect();
    let pressures: Vec<Value> = curve.pressure.iter().map(|&p| finite(p)).collect();
    Ok(json!({
        "x": curve.x,
        "pressure": pressures,
        "base": base,
        "surface": { "x": places, "displacement": heights },
        "zones": contact.zones(),
        "tension": contact.tension(),
        "pieces": punch.pieces().iter().map(|piece| piece.map(|xi| xi * half_width)).collect::<Vec<_>>(),
        "half_width": half_width,
        "geometry": punch.geometry().name(),
        "is_physical": !problem.is_dimensionless(),
        "is_smooth": problem.foundation().law() == Law::Smooth,
        "coordinate": problem.coordinate(),
        "error": contact.error().map(|error| error.pressure),
        "has_stresses": problem.check_stresses().is_ok(),
    }))
}

/// Every number and quantity of a file by its dotted key, with its SI value.
pub(super) fn inputs(document: &Document) -> Value {
    let mut found = Map::new();
    collect("", document.root(), &mut found);
    Value::Object(found)
}

fn collect(path: &str, table: &Table, found: &mut Map<String, Value>) {
    for key in table.keys() {
        let Some(value) = table.get(key) else { continue };
        let path = if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
        let si = match value.kind() {
            ValueKind::Table(inner) => {
                collect(&path, inner, found);
                continue;
            }
            ValueKind::Integer(number) => Some(*number as f64),
            ValueKind::Float(number) => Some(*number),
            ValueKind::String(text) => quantity::parse(text).ok().map(|read| read.value),
            _ => None,
        };
        if let Some(si) = si {
            found.insert(path, json!(si));
        }
    }
}

/// The tree of a file, as it is written.
pub(super) fn tree(table: &Table) -> Value {
    let mut written: Vec<(&str, &shtaerman::document::Value)> =
        table.keys().filter_map(|key| Some((key, table.get(key)?))).collect();
    written.sort_by_key(|(_, value)| value.origin().span().start);
    Value::Object(written.into_iter().map(|(key, value)| (key.to_owned(), plain(value))).collect())
}

fn plain(value: &shtaerman::document::Value) -> Value {
    match value.kind() {
        ValueKind::String(text) | ValueKind::Datetime(text) => json!(text),
        ValueKind::Integer(number) => json!(number),
        ValueKind::Float(number) => json!(number),
        ValueKind::Boolean(truth) => json!(truth),
        ValueKind::Array(items) => Value::Array(items.iter().map(plain).collect()),
        ValueKind::Table(inner) => tree(inner),
        _ => Value::Null,
    }
}

/// The pressure curve as `solve --format csv` writes it.
pub(super) fn csv(asked: &Asked) -> Result<Value, Failure> {
    let answer = Solution::new(asked, false)?.answer()?;
    Ok(json!({ "text": report::answer_csv(&answer).text()? }))
}

/// The picture as `solve --plot` draws it.
pub(super) fn svg(asked: &Asked) -> Result<Value, Failure> {
    let solution = Solution::new(asked, true)?;
    let plot = report::contact_plot(&solution.contact)?;
    let bytes = crate::plot::render(&plot, crate::plot::Format::Svg, crate::plot::Size::default())?;
    Ok(json!({ "text": Content::from(bytes).text()? }))
}

/// The report as `solve --report` writes it.
pub(super) fn report(asked: &Asked) -> Result<Value, Failure> {
    let solution = Solution::new(asked, true)?;
    let (file, contact, answer) = (&solution.file, &solution.contact, solution.answer()?);
    let told = report::answer_table(&asked.name, contact, &answer, false);
    let name = snippets::quoted(&asked.name);
    let command = format!("shtaerman solve {name} --report report.html");
    let title = format!("Contact: {}", asked.name);
    let mut sheet = sheet::of_contact(&title, &command, &told, file, contact)?;
    for (name, content) in asked.contents() {
        sheet.file(&name, &content);
    }
    Ok(json!({ "text": sheet.html() }))
}

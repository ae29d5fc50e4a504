//! A solved contact for the page: the answer as the command line gives it, and what the pictures need.

use serde_json::{Map, Value, json};
use shtaerman::document::{Document, Table, ValueKind};
use shtaerman::file::ProblemFile;
use shtaerman::quantity::{self, Measure, OutputUnits};
use shtaerman::{Answer, Contact, Error, Errors, Law, PressureCurve, Warning};

use super::asked::{self, Asked};
use crate::commands::problem_file::{self, Solved};
use crate::commands::{sheet, solve};
use crate::output::Content;
use crate::plot::{Format, Look, Plot, render_as};
use crate::report::{self, ContactPicture, Shown, contact_picture};
use crate::{Failure, snippets};

/// Points of the pressure curve, as many as `solve` gives.
pub(super) const POINTS: usize = 201;
/// Points of the surface beside the punch, on each side, and how far it is drawn, in half-widths.
const BESIDE: u32 = 40;
const MARGIN: f64 = 0.6;
/// The relative error that serves while something moves: less than a pixel, and than the digits that figures show.
const WHILE_MOVING: f64 = 1e-6;

/// A file and its contact.
pub(super) struct Solution {
    pub(super) file: ProblemFile,
    pub(super) contact: Contact,
    doubts: Vec<Warning>,
}

/// A contact that is kept, with what it is the answer to.
pub(super) type Kept = Option<(Asked, Solution)>;

impl Solution {
    /// Solves as `solve` does.
    pub(super) fn new(asked: &Asked, is_audited: bool) -> Result<Self, Failure> {
        Self::of(asked.problem()?, is_audited)
    }

    /// The same of a file that was read.
    pub(super) fn of(file: ProblemFile, is_audited: bool) -> Result<Self, Failure> {
        let solved = problem_file::solved(&file, is_audited)?;
        Ok(Self::with(file, solved))
    }

    /// To what is enough while something moves, where the file states no tolerance and that can be met.
    fn moving(file: ProblemFile) -> Result<Self, Failure> {
        let solver = file.problem().solver();
        if solver.tolerance().is_some() {
            return Self::of(file, false);
        }
        let problem = file.problem().with_solver(solver.with_tolerance(WHILE_MOVING)?);
        let is_short =
            |error: &Error| error.is_numerical() && !matches!(error, Error::TimeLimit { .. });
        match problem_file::solved_as(&file, &problem, false) {
            Err(Failure::Problem(error)) if is_short(&error) => Self::of(file, false),
            solved => Ok(Self::with(file, solved?)),
        }
    }

    fn with(file: ProblemFile, solved: Solved) -> Self {
        let (Solved::Answer(contact) | Solved::Unfinished(contact, _)) = solved;
        let doubts = file.sense_checks(&contact);
        Self { file, contact, doubts }
    }

    /// The answer as `solve --format json` writes it, or as its table shows it.
    pub(super) fn answer(&self, is_for_people: bool) -> Result<Answer, Failure> {
        let curve = PressureCurve::along(&self.contact, POINTS)?;
        // The best so far is not asked how it changes.
        let is_plain = is_for_people || self.contact.is_unfinished();
        let known = self.contact.warnings_in(self.file.units());
        let warnings = [known.as_slice(), &self.doubts].concat();
        solve::answer(&self.contact, curve, warnings, is_plain)
    }
}

/// Everything that the page shows of a contact, or why there is none, with what is doubtful about the file.
pub(super) fn told(kept: &mut Kept, asked: &Asked, is_audited: bool) -> Result<Value, Failure> {
    let file = asked.problem()?;
    let doubts = file.input_checks();
    *kept = None;
    shown(kept, asked, file, is_audited).or_else(|failure| {
        let mut fault = asked::fault(&failure);
        fault["warnings"] = serde_json::to_value(doubts).map_err(asked::unwritable)?;
        Ok(fault)
    })
}

fn shown(
    kept: &mut Kept,
    asked: &Asked,
    file: ProblemFile,
    is_audited: bool,
) -> Result<Value, Failure> {
    let solution = if is_audited { Solution::of(file, true) } else { Solution::moving(file) }?;
    let (contact, answer) = (&solution.contact, solution.answer(false)?);
    let units = solution.file.units();
    let document = asked.document()?;
    // While something moves, the points of the answer serve; the answer that stays is drawn as finely as it bends.
    let curve = answer.pressure.clone();
    let half_width = contact.problem().punch().half_width();
    let curve = if is_audited {
        report::refined(contact, curve, [-half_width, half_width]).map_err(Failure::from)?
    } else {
        curve
    };
    let told = json!({
        "answer": serde_json::to_value(&answer).map_err(asked::unwritable)?,
        "cards": cards(contact, units),
        "table": report::answer_rows(contact, &answer, units),
        "words": report::sentences(contact, units),
        "notes": report::answer_notes(contact, &answer, units),
        "picture": picture(contact, &curve, units)?,
        "inputs": inputs(&document),
        "unfinished": contact.is_unfinished(),
        "python": snippets::python(&document),
        "command": format!("shtaerman solve {}", snippets::quoted(&asked.name)),
    });
    // An audit takes longer than a solve, and maps are of what the method states itself.
    if !is_audited && !contact.is_unfinished() {
        *kept = Some((asked.clone(), solution));
    }
    Ok(told)
}

/// Whether what was told is an answer under which stresses are known.
pub(super) fn has_stresses(told: &Value) -> bool {
    told["picture"]["has_stresses"] == Value::Bool(true)
}

/// The figures that are looked at first, each with its stated error, as the table shows them.
fn cards(contact: &Contact, units: &OutputUnits) -> Value {
    let shown = Shown::of(contact.problem(), units);
    let errors = contact.error();
    let kind = errors.map(|errors| errors.kind.name());
    let of = |error: fn(&Errors) -> Option<f64>| errors.as_ref().and_then(error);
    let figures = [
        (
            "settlement",
            "Settlement",
            contact.settlement(),
            Measure::Displacement,
            of(|e| Some(e.settlement)),
        ),
        ("tilt", "Tilt", contact.tilt(), Measure::Angle, of(|e| Some(e.tilt))),
        ("force", "Force", contact.force(), shown.force(), of(|e| Some(e.force))),
        ("moment", "Moment", contact.moment(), shown.moment(), of(|e| Some(e.moment))),
        (
            "peak_pressure",
            "Largest pressure",
            contact.peak_pressure(),
            Measure::Pressure,
            of(|e| e.peak_pressure.or(Some(e.pressure))),
        ),
        (
            "contact_width",
            "Contact width",
            contact.contact_width(),
            Measure::Length,
            of(|e| e.zones),
        ),
    ];
    let card = |(key, name, value, measure, error): (&str, &str, f64, Measure, Option<f64>)| {
        let error = error.filter(|error| error.is_finite());
        // The table shows what it states no error of as it is.
        let value_shown = match key {
            "peak_pressure" | "contact_width" => shown.value(value, measure),
            _ => shown.certain(value, error, measure),
        };
        json!({
            "key": key,
            "name": name,
            "value": if value.is_finite() { value_shown } else { "infinite".to_owned() },
            "si": finite(value),
            "error": error.map(|error| shown.few_digits(error, measure)),
            "kind": kind,
        })
    };
    Value::Array(figures.into_iter().map(card).collect())
}

/// JSON has no infinity.
fn finite(value: f64) -> Value {
    if value.is_finite() { json!(value) } else { Value::Null }
}

/// What the pictures are drawn from, in the units of the problem.
fn picture(
    contact: &Contact,
    curve: &PressureCurve,
    units: &OutputUnits,
) -> Result<Value, Failure> {
    let problem = contact.problem();
    let punch = problem.punch();
    let half_width = punch.half_width();
    let beside = (1..=BESIDE)
        .map(|i| half_width * (1.0 + MARGIN * (f64::from(i) / f64::from(BESIDE)).powi(2)));
    let mut places: Vec<f64> =
        beside.clone().map(|x| -x).chain(curve.x.iter().copied()).chain(beside).collect();
    places.sort_by(f64::total_cmp);
    let heights: Vec<Value> =
        places.iter().map(|&x| finite(contact.elastic_displacement(x))).collect();
    let base: Vec<Value> = curve.x.iter().map(|&x| finite(contact.base_depth(x))).collect();
    let largest = |values: &[f64]| {
        values
            .iter()
            .filter(|value| value.is_finite())
            .fold(0.0f64, |most, value| most.max(value.abs()))
    };
    let highest = largest(&curve.pressure);
    let deepest = curve.x.iter().map(|&x| contact.base_depth(x).abs()).fold(0.0, f64::max);
    let unit = |largest: f64, measure: Measure| {
        let unit = units.axis(largest, measure);
        json!({ "factor": unit.factor, "label": unit.label })
    };
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
        "units": units.are_chosen().then(|| json!({
            "length": unit(half_width, Measure::Length),
            "depth": unit(deepest, Measure::Displacement),
            "pressure": unit(highest, Measure::Pressure),
        })),
        "has_stresses": problem.check_stresses().is_ok(),
    }))
}

/// The units of the axes of a map, where the file states some.
pub(super) fn chosen_units(units: &OutputUnits, x: &[f64], highest: f64) -> Value {
    if !units.are_chosen() {
        return Value::Null;
    }
    let unit = |largest: f64, measure: Measure| {
        let unit = units.axis(largest, measure);
        json!({ "factor": unit.factor, "label": unit.label })
    };
    let widest = x.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    json!({ "length": unit(widest, Measure::Length), "pressure": unit(highest, Measure::Pressure) })
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
    let solution = Solution::new(asked, false)?;
    let shown = Shown::of(solution.file.problem(), solution.file.units());
    Ok(json!({ "text": report::answer_csv(&solution.answer(false)?, &shown).text()? }))
}

/// The picture as `solve --plot` draws it.
pub(super) fn svg(asked: &Asked) -> Result<Value, Failure> {
    let solution = Solution::new(asked, true)?;
    let wanted = ContactPicture {
        name: asked.stem().to_owned(),
        units: solution.file.units().clone(),
        ..ContactPicture::default()
    };
    let plot = contact_picture(&solution.contact, &wanted)?;
    Ok(json!({ "text": drawn(&plot)? }))
}

/// A picture as a command draws it where nothing is said about its looks.
pub(super) fn drawn(plot: &dyn Plot) -> Result<String, Failure> {
    let bytes = render_as(plot, Format::Svg, Look::default())?;
    Content::from(bytes).text()
}

/// The report as `solve --report` writes it.
pub(super) fn report(asked: &Asked) -> Result<Value, Failure> {
    let solution = Solution::new(asked, true)?;
    let (file, contact, answer) = (&asked.stated()?, &solution.contact, solution.answer(true)?);
    let told = report::answer_table(&asked.name, contact, &answer, file.units(), false);
    let command = format!(
        "shtaerman solve {} --report {}",
        snippets::quoted(&asked.name),
        snippets::quoted(&format!("{}.html", asked.stem()))
    );
    let title = format!("Contact: {}", asked.name);
    let found = (contact, solution.doubts.as_slice());
    let mut sheet = sheet::of_contact([&title, asked.stem()], &command, &told, file, found)?;
    for (name, content) in asked.contents() {
        sheet.file(&name, &content);
    }
    Ok(json!({ "text": sheet.html() }))
}

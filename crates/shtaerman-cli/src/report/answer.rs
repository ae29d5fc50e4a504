//! The answer of `solve` for people, and as CSV.

use std::fmt::Write;

use shtaerman::quantity::{Measure, OutputUnits};
use shtaerman::{
    Answer, Contact, CrossCheck, ErrorReport, Errors, Geometry, PhysicalOnly, PressureCurve,
    Quantities, Rotational, Vertical,
};

use super::{Shown, Table, Told, significant};
use crate::output::Content;

/// Significant digits of a table.
const DIGITS: usize = 8;

/// The answer as a table in units for people; `with_places` adds the pressure at the places asked for.
#[must_use]
pub(crate) fn answer_table(
    name: &str,
    contact: &Contact,
    answer: &Answer,
    units: &OutputUnits,
    with_places: bool,
) -> Told {
    let shown = &Shown::of(contact.problem(), units);
    let surface = match &answer.dimensionless {
        Some(_) => format!("theta0 = {}", significant(contact.theta0(), DIGITS)),
        None => "smooth surface".to_owned(),
    };
    let mut text = Told::new(format!(
        "{name}: {} contact, {surface}, {} method with n = {}\n\n",
        answer.contact, answer.method.name, answer.method.n
    ));
    text.table(quantities(contact, answer, shown));
    text.push('\n');
    text.push_str(&answer_notes(contact, answer, units));
    text.append(super::extras(contact, answer, shown));
    if with_places {
        text.push('\n');
        text.table(places(&answer.pressure, shown));
    }
    if !answer.warnings.is_empty() {
        text.push('\n');
    }
    for warning in &answer.warnings {
        let _ = writeln!(text, "warning: {}", warning.message);
    }
    text
}

/// The quantities of an answer for people: name, value, note.
fn quantities(contact: &Contact, answer: &Answer, shown: &Shown) -> Table {
    let errors = answer.error.as_ref();
    match (&answer.physical, &answer.dimensionless) {
        (Some(quantities @ Quantities { physical: Some(physical), .. }), _) => {
            let errors = errors.and_then(|error| error.physical.as_ref());
            physical_table(contact, quantities, physical, errors, shown)
        }
        (_, Some(dimensionless)) => {
            let errors = errors.map(|error| &error.dimensionless);
            dimensionless_table(contact, dimensionless, errors, shown)
        }
        (_, None) => Table::new(&[""; 3]),
    }
}

/// The rows of the table: name, value, note.
#[must_use]
pub(crate) fn answer_rows(
    contact: &Contact,
    answer: &Answer,
    units: &OutputUnits,
) -> Vec<Vec<String>> {
    quantities(contact, answer, &Shown::of(contact.problem(), units)).cells()
}

/// How it was found and how sure it is, a line each.
#[must_use]
pub(crate) fn answer_notes(contact: &Contact, answer: &Answer, units: &OutputUnits) -> String {
    let mut text = format!("method: {}\n", answer.method.reason);
    if let Some(error) = &answer.error {
        text.push_str(&error_line(contact, error, &Shown::of(contact.problem(), units)));
    }
    if let Some(audit) = &answer.audit {
        let _ = writeln!(text, "audit ({}): {}", audit.kind, audit.reason);
    }
    if let Some(left) = &answer.complementarity {
        let _ = writeln!(
            text,
            "complementarity: tension {}, penetration {} of their scales",
            significant(left.tension, 2),
            significant(left.penetration, 2)
        );
    }
    if let Some(check) = &answer.cross_check {
        text.push_str(&cross_check_line(check));
    }
    text
}

/// The error of the answer on one line.
fn error_line(contact: &Contact, error: &ErrorReport, shown: &Shown) -> String {
    let kind = error.kind.name();
    let errors = error.physical.as_ref().unwrap_or(&error.dimensionless);
    let pressure = shown.few_digits(errors.pressure, Measure::Pressure);
    let mut parts = vec![format!("pressure {pressure}")];
    let load = contact.problem().load();
    let by_force = matches!(load.vertical(), Vertical::Force(_));
    let by_tilt = matches!(load.rotational(), Rotational::Tilt(_));
    let by_moment = matches!(load.rotational(), Rotational::Moment(_));
    let unknowns: [(&str, Option<f64>, Measure); 6] = [
        ("largest pressure", errors.peak_pressure, Measure::Pressure),
        ("settlement", by_force.then_some(errors.settlement), Measure::Displacement),
        ("tilt", (!by_tilt).then_some(errors.tilt), Measure::Angle),
        ("force", (!by_force).then_some(errors.force), shown.force()),
        ("moment", (!by_moment).then_some(errors.moment), shown.moment()),
        ("edges", errors.zones, Measure::Length),
    ];
    for (name, value, measure) in unknowns {
        parts.extend(value.map(|value| format!("{name} {}", shown.few_digits(value, measure))));
    }
    format!("error ({kind}), at most: {}\n", parts.join(", "))
}

/// The differences from the reference and its own errors.
fn cross_check_line(check: &CrossCheck) -> String {
    let own = &check.reference_error;
    let parts = [
        ("pressure", check.pressure, own.pressure),
        ("settlement", check.settlement, own.settlement),
        ("tilt", check.tilt, own.tilt),
        ("force", check.force, own.force),
        ("moment", check.moment, own.moment),
    ]
    .map(|(name, found, own)| {
        format!("{name} {} (+-{})", significant(found, 2), significant(own, 2))
    });
    let mut text = format!(
        "cross-check by {} with n = {}: {}; differences (and errors of the reference) without dimensions: {}\n",
        check.method.replace('_', " "),
        check.n,
        if check.agrees { "agrees" } else { "DIFFERS by more than both state" },
        parts.join(", ")
    );
    if let Some(limits) = &check.limits {
        let _ = writeln!(text, "cross-check: the reference knows {limits}");
    }
    text
}

/// Errors of what a table shows, where the answer states one.
struct Stated<'e>(Option<&'e Errors>);

impl Stated<'_> {
    fn of(&self, error: fn(&Errors) -> f64) -> Option<f64> {
        self.0.map(error)
    }

    fn stiffness(&self, row: usize, column: usize) -> Option<f64> {
        Some(self.0?.stiffness?[row][column])
    }
}

fn physical_table(
    contact: &Contact,
    found: &Quantities,
    physical: &PhysicalOnly,
    errors: Option<&Errors>,
    shown: &Shown,
) -> Table {
    let problem = contact.problem();
    let stated = Stated(errors);
    let length = |value| shown.value(value, Measure::Length);
    let pressure = |value| shown.value(value, Measure::Pressure);
    let certain = |value, error| shown.certain(value, error, Measure::Pressure);
    let [[k11, k12], [_, k22]] = found.stiffness;
    let mut table = Table::new(&["", "", ""]);
    let mut row = |name: &str, value: String, note: &str| {
        table.row(vec![name.to_owned(), value, note.to_owned()]);
    };
    let notes = LoadNotes::of(contact, shown);
    let gauge = format!("gauge: {}", physical.gauge);
    let settlement = stated.of(|error| error.settlement);
    row("settlement", shown.certain(found.settlement, settlement, Measure::Displacement), &gauge);
    let tilt = shown.certain(found.tilt, stated.of(|error| error.tilt), Measure::Angle);
    row("tilt", tilt, "negative under a positive moment");
    let force = shown.certain(found.force, stated.of(|error| error.force), shown.force());
    row("force", force, notes.force);
    let moment = shown.certain(found.moment, stated.of(|error| error.moment), shown.moment());
    row("moment", moment, notes.moment);
    let error = stated.of(|error| error.pressure);
    for (name, value) in [
        ("pressure, left edge", found.pressure_left),
        ("pressure, centre", found.pressure_middle),
        ("pressure, right edge", found.pressure_right),
    ] {
        row(name, certain(value, error), "");
    }
    row("pressure, mean", pressure(found.mean_pressure), "over the base");
    row("", pressure(found.mean_contact_pressure), "over the contact");
    let place = format!("at x = {}", length(found.peak_pressure_at));
    row("pressure, largest", pressure(found.peak_pressure), &place);
    for (name, value, note) in zones(&found.zones, contact, shown) {
        row(&name, value, &note);
    }
    let pairs = |values: &[[f64; 2]], shown: &dyn Fn(f64) -> String| -> String {
        let of_zone = |[left, right]: &[f64; 2]| format!("{}, {}", shown(*left), shown(*right));
        values.iter().take(MOST_ZONES).map(of_zone).collect::<Vec<_>>().join("; ")
    };
    if let Some(intensities) = &physical.corner_intensity {
        let unit = problem.foundation().corner_unit();
        let shown = |value| shtaerman::quantity::engineering(value, unit.clone());
        row("corner intensity", pairs(intensities, &shown), "left, right; 0 at free edges");
    }
    if let Some(implied) = &physical.implied_edge_pressure {
        let note = "left, right; K/sqrt(E* chi) of the smooth contact";
        row("edge pressure implied", pairs(implied, &pressure), note);
    }
    let [of_settlement, of_tilt, mixed] = notes.stiffness;
    let stiffness = |value, error, measure| shown.certain(value, error, measure);
    let k11 = stiffness(k11, stated.stiffness(0, 0), of_settlement);
    row("stiffness dP/d(settlement)", k11, notes.force);
    // A wave cannot tilt.
    if k22.is_finite() {
        let k22 = stiffness(k22, stated.stiffness(1, 1), of_tilt);
        row("stiffness dM/d(-tilt)", k22, notes.turning);
    }
    if !k12.is_nan() {
        row("stiffness dM/d(settlement)", stiffness(k12, stated.stiffness(0, 1), mixed), "");
    }
    let elastic_punch = problem.punch().body().is_some();
    let modulus =
        if elastic_punch { "composite of both bodies" } else { "E/(1-nu^2), rigid punch" };
    row("contact modulus E*", pressure(physical.contact_modulus), modulus);
    table
}

/// What is said beside force, moment and stiffness: per unit length, but for a circular punch.
struct LoadNotes {
    force: &'static str,
    moment: &'static str,
    turning: &'static str,
    /// What the stiffnesses by settlement, by tilt and between measure.
    stiffness: [Measure; 3],
}

impl LoadNotes {
    fn of(contact: &Contact, shown: &Shown) -> Self {
        let problem = contact.problem();
        if problem.is_circular() {
            let stiffness = [Measure::ForcePerLength, Measure::Moment, Measure::Force];
            return Self { force: "", moment: "", turning: "per rad", stiffness };
        }
        let row = matches!(problem.punch().geometry(), Geometry::Periodic { .. });
        // The unit that was chosen for a moment says it itself.
        let is_said = shown.units.has(Measure::MomentPerLength);
        Self {
            force: if row { "per unit length and period" } else { "per unit length" },
            moment: if is_said { "" } else { "N m per m" },
            turning: if is_said { "per rad" } else { "N m per m and rad" },
            stiffness: [Measure::Pressure, Measure::MomentPerLength, Measure::ForcePerLength],
        }
    }
}

/// Most zones that the table names one by one.
const MOST_ZONES: usize = 12;

/// The zones of contact, as rows of a table.
fn zones(zones: &[[f64; 2]], contact: &Contact, shown: &Shown) -> Vec<(String, String, String)> {
    let half_width = if shown.is_physical { contact.problem().punch().half_width() } else { 1.0 };
    let length = |value| shown.value(value, Measure::Length);
    let beside = |[left, right]: [f64; 2]| match (left > -half_width, right < half_width) {
        (false, false) => "the full base",
        (true, false) => "lifted on the left",
        (false, true) => "lifted on the right",
        (true, true) => "lifted on both sides",
    };
    let is_disk = |[left, right]: [f64; 2]| left == -right;
    if contact.problem().is_circular() && zones.iter().any(|zone| is_disk(*zone) || zones.len() > 1)
    {
        return rings(zones, half_width, &length);
    }
    if let [zone] = zones {
        let note = format!("{}, width {}", beside(*zone), length(zone[1] - zone[0]));
        let value = format!("{} to {}", length(zone[0]), length(zone[1]));
        return vec![("contact".to_owned(), value, note)];
    }
    let width: f64 = zones.iter().map(|[left, right]| right - left).sum();
    let total = format!("{} zones, width {}", zones.len(), length(width));
    let mut rows = vec![("contact".to_owned(), total, String::new())];
    for (number, [left, right]) in zones.iter().take(MOST_ZONES).enumerate() {
        let value = format!("{} to {}", length(*left), length(*right));
        rows.push((format!("zone {}", number + 1), value, String::new()));
    }
    rows.extend(more(zones.len()));
    rows
}

/// Zones of a diameter as the disk and the rings that they are.
fn rings(
    zones: &[[f64; 2]],
    radius: f64,
    length: &dyn Fn(f64) -> String,
) -> Vec<(String, String, String)> {
    let right: Vec<[f64; 2]> =
        zones.iter().filter(|zone| zone[1] > 0.0).map(|zone| [zone[0].max(0.0), zone[1]]).collect();
    let mut rows = Vec::new();
    for (number, [inner, outer]) in right.iter().take(MOST_ZONES).enumerate() {
        let name = match (number, right.len()) {
            (0, 1) => "contact".to_owned(),
            _ => format!("contact {}", number + 1),
        };
        let (value, note) = if *inner > 0.0 {
            let value = format!("radius {} to {}", length(*inner), length(*outer));
            (value, "a ring")
        } else {
            (format!("radius {}", length(*outer)), "a disk")
        };
        let note = if *inner == 0.0 && *outer >= radius { "the full base" } else { note };
        rows.push((name, value, note.to_owned()));
    }
    rows.extend(more(right.len()));
    rows
}

fn more(count: usize) -> Option<(String, String, String)> {
    (count > MOST_ZONES).then(|| {
        let more = format!("{} more", count - MOST_ZONES);
        (String::new(), more, "all of them with --format json".to_owned())
    })
}

fn dimensionless_table(
    contact: &Contact,
    d: &Quantities,
    errors: Option<&Errors>,
    shown: &Shown,
) -> Table {
    let stated = Stated(errors);
    let [[k11, k12], [_, k22]] = d.stiffness;
    let mut table = Table::new(&["", "", ""]);
    let mut row = |name: &str, value: String, note: &str| {
        table.row(vec![name.to_owned(), value, note.to_owned()]);
    };
    let certain = |value, error| shown.certain(value, error, Measure::Pressure);
    let gauge = format!("delta/(chi E), gauge: {}", contact.problem().gauge());
    let circular = contact.problem().is_circular();
    let settlement = certain(d.settlement, stated.of(|error| error.settlement));
    row("settlement delta0", settlement, &gauge);
    let tilt = certain(d.tilt, stated.of(|error| error.tilt));
    row("tilt alpha0", tilt, "a alpha/(chi E); negative under a positive moment");
    let force = certain(d.force, stated.of(|error| error.force));
    row("force P0", force, if circular { "P/(a^2 E)" } else { "P/(a E)" });
    let moment = certain(d.moment, stated.of(|error| error.moment));
    row("moment M0", moment, if circular { "M/(a^3 E)" } else { "M/(a^2 E)" });
    let error = stated.of(|error| error.pressure);
    row("pressure, left edge", certain(d.pressure_left, error), "p/E");
    row("pressure, centre", certain(d.pressure_middle, error), "");
    row("pressure, right edge", certain(d.pressure_right, error), "");
    row("pressure, mean", certain(d.mean_pressure, None), "over the base");
    row("", certain(d.mean_contact_pressure, None), "over the contact");
    let place = format!("at xi = {}", significant(d.peak_pressure_at, DIGITS));
    row("pressure, largest", certain(d.peak_pressure, None), &place);
    for (name, value, note) in zones(&d.zones, contact, shown) {
        row(&name, value, &note);
    }
    row("stiffness dP0/d(delta0)", certain(k11, stated.stiffness(0, 0)), "");
    if k22.is_finite() {
        row("stiffness dM0/d(-alpha0)", certain(k22, stated.stiffness(1, 1)), "");
    }
    if !k12.is_nan() {
        row("stiffness dM0/d(delta0)", certain(k12, stated.stiffness(0, 1)), "");
    }
    table
}

fn places(curve: &PressureCurve, shown: &Shown) -> Table {
    let mut table = Table::new(if shown.is_physical { &["x", "pressure"] } else { &["xi", "p0"] });
    for (x, p) in curve.x.iter().zip(&curve.pressure) {
        table.row(if shown.is_physical {
            vec![shown.value(*x, Measure::Length), shown.value(*p, Measure::Pressure)]
        } else {
            vec![significant(*x, 12), significant(*p, 12)]
        });
    }
    table
}

/// The pressure curve as CSV: `x,pressure`, in SI units, in those chosen, or without dimensions as the problem is; the surface in its place where that was asked for.
pub(crate) fn answer_csv<'a>(answer: &'a Answer, shown: &Shown) -> Content<'a> {
    if let Some(surface) = &answer.surface {
        return super::surface_csv(surface, shown);
    }
    let (x, length) = shown.column("x", Measure::Length);
    let (p, stress) = shown.column("pressure", Measure::Pressure);
    let pairs = answer.pressure.x.iter().zip(&answer.pressure.pressure);
    let rows = pairs.map(move |(x, p)| vec![(x * length).to_string(), (p * stress).to_string()]);
    Content::csv(&[x, p], rows)
}

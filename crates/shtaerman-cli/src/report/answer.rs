//! The answer of `solve` for people, and as CSV.

use std::fmt::Write;

use shtaerman::quantity::{Dimension, DisplayUnit, engineering, engineering_with_digits};
use shtaerman::{
    Answer, Contact, CrossCheck, ErrorReport, Geometry, PhysicalOnly, PressureCurve, Quantities,
    Rotational, Vertical,
};

use super::{Table, significant};
use crate::output::Content;

/// Significant digits of a table.
const DIGITS: usize = 8;

/// The answer as a table in engineering units; `with_places` adds the pressure at the places asked for.
#[must_use]
pub(crate) fn answer_table(
    name: &str,
    contact: &Contact,
    answer: &Answer,
    with_places: bool,
) -> String {
    let surface = match &answer.dimensionless {
        Some(_) => format!("theta0 = {}", significant(contact.theta0(), DIGITS)),
        None => "smooth surface".to_owned(),
    };
    let mut text = format!(
        "{name}: {} contact, {surface}, {} method with n = {}\n\n",
        answer.contact, answer.method.name, answer.method.n
    );
    text.push_str(&quantities(contact, answer).to_string());
    text.push('\n');
    text.push_str(&answer_notes(contact, answer));
    text.push_str(&super::extras(answer));
    if with_places {
        text.push('\n');
        let physical = answer.physical.is_some();
        text.push_str(&places(&answer.pressure, physical).to_string());
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
fn quantities(contact: &Contact, answer: &Answer) -> Table {
    match (&answer.physical, &answer.dimensionless) {
        (Some(quantities @ Quantities { physical: Some(physical), .. }), _) => {
            physical_table(contact, quantities, physical)
        }
        (_, Some(dimensionless)) => dimensionless_table(contact, dimensionless),
        (_, None) => Table::new(&[""; 3]),
    }
}

/// The rows of the table: name, value, note.
#[must_use]
pub(crate) fn answer_rows(contact: &Contact, answer: &Answer) -> Vec<Vec<String>> {
    quantities(contact, answer).cells()
}

/// How it was found and how sure it is, a line each.
#[must_use]
pub(crate) fn answer_notes(contact: &Contact, answer: &Answer) -> String {
    let mut text = format!("method: {}\n", answer.method.reason);
    if let Some(error) = &answer.error {
        text.push_str(&error_line(contact, error));
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
fn error_line(contact: &Contact, error: &ErrorReport) -> String {
    let units = LoadUnits::of(contact);
    let kind = error.kind.name();
    let errors = error.physical.as_ref().unwrap_or(&error.dimensionless);
    let physical = error.physical.is_some();
    let shown = |value: f64, unit: DisplayUnit| {
        if physical { engineering_with_digits(value, unit, 2) } else { significant(value, 2) }
    };
    let mut parts =
        vec![format!("pressure {}", shown(errors.pressure, Dimension::PRESSURE.into()))];
    let load = contact.problem().load();
    let by_force = matches!(load.vertical(), Vertical::Force(_));
    let by_tilt = matches!(load.rotational(), Rotational::Tilt(_));
    let by_moment = matches!(load.rotational(), Rotational::Moment(_));
    let unknowns: [(&str, Option<f64>, DisplayUnit); 6] = [
        ("largest pressure", errors.peak_pressure, Dimension::PRESSURE.into()),
        ("settlement", by_force.then_some(errors.settlement), Dimension::LENGTH.into()),
        ("tilt", (!by_tilt).then_some(errors.tilt), DisplayUnit::angle()),
        ("force", (!by_force).then_some(errors.force), units.force),
        ("moment", (!by_moment).then_some(errors.moment), units.moment),
        ("edges", errors.zones, Dimension::LENGTH.into()),
    ];
    for (name, value, unit) in unknowns {
        parts.extend(value.map(|value| format!("{name} {}", shown(value, unit))));
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

fn physical_table(contact: &Contact, found: &Quantities, physical: &PhysicalOnly) -> Table {
    let length = |value| engineering(value, Dimension::LENGTH);
    let pressure = |value| engineering(value, Dimension::PRESSURE);
    let elastic_punch = contact.problem().punch().body().is_some();
    let modulus =
        if elastic_punch { "composite of both bodies" } else { "E/(1-nu^2), rigid punch" };
    let [[k11, k12], [_, k22]] = found.stiffness;
    let mut table = Table::new(&["", "", ""]);
    let mut row = |name: &str, value: String, note: &str| {
        table.row(vec![name.to_owned(), value, note.to_owned()]);
    };
    let units = LoadUnits::of(contact);
    row("settlement", length(found.settlement), &format!("gauge: {}", physical.gauge));
    row(
        "tilt",
        engineering(found.tilt, DisplayUnit::angle()),
        "a positive moment gives a negative tilt",
    );
    row("force", engineering(found.force, units.force.clone()), units.force_note);
    row("moment", engineering(found.moment, units.moment.clone()), units.moment_note);
    row("pressure, left edge", pressure(found.pressure_left), "");
    row("pressure, centre", pressure(found.pressure_middle), "");
    row("pressure, right edge", pressure(found.pressure_right), "");
    row("pressure, mean", pressure(found.mean_pressure), "over the base");
    row(
        "pressure, largest",
        pressure(found.peak_pressure),
        &format!("at x = {}", length(found.peak_pressure_at)),
    );
    for (name, value, note) in zones(&found.zones, contact, &length) {
        row(&name, value, &note);
    }
    let pairs = |values: &[[f64; 2]], unit: DisplayUnit| -> String {
        let shown = |value: f64| engineering(value, unit.clone());
        let of_zone = |[left, right]: &[f64; 2]| format!("{}, {}", shown(*left), shown(*right));
        values.iter().take(MOST_ZONES).map(of_zone).collect::<Vec<_>>().join("; ")
    };
    if let Some(intensities) = &physical.corner_intensity {
        let unit = contact.problem().foundation().corner_unit();
        row("corner intensity", pairs(intensities, unit), "left, right; 0 at free edges");
    }
    if let Some(implied) = &physical.implied_edge_pressure {
        let note = "left, right; K/sqrt(E* chi) of the smooth contact";
        row("edge pressure implied", pairs(implied, Dimension::PRESSURE.into()), note);
    }
    row("stiffness dP/d(settlement)", engineering(k11, units.stiffness), units.force_note);
    row("stiffness dM/d(-tilt)", engineering(k22, units.moment), units.turning_note);
    row("stiffness dM/d(settlement)", engineering(k12, units.force), "");
    row("contact modulus E*", pressure(physical.contact_modulus), modulus);
    table
}

/// Units of force and moment: per unit length, but for a circular punch.
struct LoadUnits {
    force: DisplayUnit,
    moment: DisplayUnit,
    stiffness: DisplayUnit,
    force_note: &'static str,
    moment_note: &'static str,
    turning_note: &'static str,
}

impl LoadUnits {
    fn of(contact: &Contact) -> Self {
        let problem = contact.problem();
        if problem.is_circular() {
            return Self {
                force: DisplayUnit::prefixed("N"),
                moment: Dimension::MOMENT.into(),
                stiffness: Dimension::FORCE_PER_LENGTH.into(),
                force_note: "",
                moment_note: "",
                turning_note: "per rad",
            };
        }
        let row = matches!(problem.punch().geometry(), Geometry::Periodic { .. });
        Self {
            force: Dimension::FORCE_PER_LENGTH.into(),
            moment: DisplayUnit::prefixed("N"),
            stiffness: Dimension::PRESSURE.into(),
            force_note: if row { "per unit length and period" } else { "per unit length" },
            moment_note: "N m per m",
            turning_note: "N m per m and rad",
        }
    }
}

/// Most zones that the table names one by one.
const MOST_ZONES: usize = 12;

/// The zones of contact, as rows of a table.
fn zones(
    zones: &[[f64; 2]],
    contact: &Contact,
    shown: &dyn Fn(f64) -> String,
) -> Vec<(String, String, String)> {
    let half_width = contact.problem().punch().half_width();
    let beside = |[left, right]: [f64; 2]| match (left > -half_width, right < half_width) {
        (false, false) => "the full base",
        (true, false) => "lifted on the left",
        (false, true) => "lifted on the right",
        (true, true) => "lifted on both sides",
    };
    if let [zone] = zones {
        let note = format!("{}, width {}", beside(*zone), shown(contact.contact_width()));
        let value = format!("{} to {}", shown(zone[0]), shown(zone[1]));
        return vec![("contact".to_owned(), value, note)];
    }
    let total = format!("{} zones, width {}", zones.len(), shown(contact.contact_width()));
    let mut rows = vec![("contact".to_owned(), total, String::new())];
    for (number, [left, right]) in zones.iter().take(MOST_ZONES).enumerate() {
        let value = format!("{} to {}", shown(*left), shown(*right));
        rows.push((format!("zone {}", number + 1), value, String::new()));
    }
    if zones.len() > MOST_ZONES {
        let more = format!("{} more", zones.len() - MOST_ZONES);
        rows.push((String::new(), more, "all of them with --format json".to_owned()));
    }
    rows
}

fn dimensionless_table(contact: &Contact, d: &Quantities) -> Table {
    let [[k11, k12], [_, k22]] = d.stiffness;
    let mut table = Table::new(&["", "", ""]);
    let mut row = |name: &str, value: String, note: &str| {
        table.row(vec![name.to_owned(), value, note.to_owned()]);
    };
    let shown = |value: f64| significant(value, 10);
    let gauge = contact.problem().gauge();
    row("settlement delta0", shown(d.settlement), &format!("delta/(chi E), gauge: {gauge}"));
    row("tilt alpha0", shown(d.tilt), "a alpha/(chi E); a positive moment gives a negative tilt");
    let circular = contact.problem().is_circular();
    row("force P0", shown(d.force), if circular { "P/(a^2 E)" } else { "P/(a E)" });
    row("moment M0", shown(d.moment), if circular { "M/(a^3 E)" } else { "M/(a^2 E)" });
    row("pressure, left edge", shown(d.pressure_left), "p/E");
    row("pressure, centre", shown(d.pressure_middle), "");
    row("pressure, right edge", shown(d.pressure_right), "");
    row("pressure, mean", shown(d.mean_pressure), "over the base");
    let place = format!("at xi = {}", significant(d.peak_pressure_at, DIGITS));
    row("pressure, largest", shown(d.peak_pressure), &place);
    for (name, value, note) in zones(&d.zones, contact, &shown) {
        row(&name, value, &note);
    }
    row("stiffness dP0/d(delta0)", shown(k11), "");
    row("stiffness dM0/d(-alpha0)", shown(k22), "");
    row("stiffness dM0/d(delta0)", shown(k12), "");
    table
}

fn places(curve: &PressureCurve, is_physical: bool) -> Table {
    let mut table = Table::new(if is_physical { &["x", "pressure"] } else { &["xi", "p0"] });
    for (x, p) in curve.x.iter().zip(&curve.pressure) {
        table.row(if is_physical {
            vec![engineering(*x, Dimension::LENGTH), engineering(*p, Dimension::PRESSURE)]
        } else {
            vec![significant(*x, 12), significant(*p, 12)]
        });
    }
    table
}

/// The pressure curve as CSV: `x,pressure`, in SI units or without dimensions as the problem is; the surface in its place where that was asked for.
pub(crate) fn answer_csv(answer: &Answer) -> Content<'_> {
    if let Some(surface) = &answer.surface {
        return super::surface_csv(surface);
    }
    let pairs = answer.pressure.x.iter().zip(&answer.pressure.pressure);
    Content::csv(&["x", "pressure"], pairs.map(|(x, p)| vec![x.to_string(), p.to_string()]))
}

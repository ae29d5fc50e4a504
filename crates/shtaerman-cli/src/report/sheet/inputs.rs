//! The inputs of a report: as they were given, and in SI units.

use std::fmt::Write;

use shtaerman::document::{Document, Table, Value, ValueKind};
use shtaerman::quantity::{self, Dimension, plain};

use super::math::escaped;

/// Longest text of a value that is shown whole.
const LONGEST: usize = 90;
/// Most values of a list that are shown.
const MOST_ITEMS: usize = 8;
/// From here on a number is shown with a power of ten.
const LONG: f64 = 1e7;

/// An input: its key, what was given, what that is in SI units, and where it stands.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Entry {
    pub(crate) key: String,
    pub(crate) given: String,
    pub(crate) si: String,
    pub(crate) place: String,
}

impl Entry {
    /// An option of the command line.
    pub(crate) fn option(name: &str, given: &str) -> Self {
        let si = quantity::parse(given)
            .map_or_else(|_| String::new(), |read| shown(read.value, read.dimension));
        Self { key: name.to_owned(), given: given.to_owned(), si, place: "command line".to_owned() }
    }
}

/// All inputs of a document in the order of the file, and what it leaves to the usual.
pub(super) fn of_document(document: &Document) -> Vec<Entry> {
    let mut found = Vec::new();
    collect("", document.root(), is_round(document), &mut found);
    if document.get("punch").is_some() || document.get("dimensionless").is_some() {
        for (key, usual, unless) in
            [("solver.contact", "unilateral", "solver.contact"), ("punch", "rigid", "body")]
        {
            if document.get(unless).is_none()
                && !(key == "punch" && document.get("dimensionless").is_some())
            {
                found.push(Entry {
                    key: key.to_owned(),
                    given: String::new(),
                    si: usual.to_owned(),
                    place: "as usual".to_owned(),
                });
            }
        }
    }
    found
}

fn is_round(document: &Document) -> bool {
    let circular = |key| matches!(document.get(key).map(Value::kind), Some(ValueKind::String(text)) if text == "circular");
    circular("punch.geometry") || circular("dimensionless.geometry")
}

fn collect(path: &str, table: &Table, is_round: bool, found: &mut Vec<Entry>) {
    let mut written: Vec<(&str, &Value)> =
        table.keys().filter_map(|key| Some((key, table.get(key)?))).collect();
    written.sort_by_key(|(_, value)| (value.origin().is_override(), value.origin().span().start));
    for (key, value) in written {
        let key = if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
        if let ValueKind::Table(inner) = value.kind() {
            collect(&key, inner, is_round, found);
            continue;
        }
        let origin = value.origin();
        let place = if origin.is_override() {
            "--set".to_owned()
        } else {
            format!("line {}", origin.line())
        };
        let dimension =
            if path == "dimensionless" { Dimension::NONE } else { dimension(&key, is_round) };
        found.push(Entry { given: given(value), si: si(value, &key, dimension), key, place });
    }
}

fn given(value: &Value) -> String {
    let text = match value.kind() {
        ValueKind::String(text) | ValueKind::Datetime(text) => text.clone(),
        ValueKind::Integer(number) => number.to_string(),
        ValueKind::Float(number) => format!("{number:?}"),
        ValueKind::Boolean(truth) => truth.to_string(),
        ValueKind::Array(items) => {
            let shown: Vec<String> = items.iter().take(MOST_ITEMS).map(given).collect();
            let more = if items.len() > MOST_ITEMS { ", …" } else { "" };
            format!("{}{more}", shown.join(", "))
        }
        _ => String::new(),
    };
    if text.chars().count() <= LONGEST {
        return text;
    }
    text.chars().take(LONGEST).collect::<String>() + "…"
}

fn si(value: &Value, key: &str, dimension: Dimension) -> String {
    match value.kind() {
        ValueKind::Integer(number) => shown(*number as f64, dimension),
        ValueKind::Float(number) => shown(*number, dimension),
        ValueKind::String(text) if key.ends_with(".profile") => match text.trim().parse::<f64>() {
            Ok(height) => shown(height, Dimension::LENGTH),
            Err(_) if key.starts_with("dimensionless") => "f₀(ξ)".to_owned(),
            Err(_) => "f(x) in m, x in m".to_owned(),
        },
        ValueKind::String(text) => match quantity::parse(text) {
            Ok(read) if read.unit_written() => shown(read.value, read.dimension),
            Ok(read) => shown(read.value, dimension),
            Err(_) => String::new(),
        },
        ValueKind::Array(items) => {
            let all = items.iter().take(MOST_ITEMS).map(|item| si(item, key, dimension));
            all.filter(|text| !text.is_empty()).collect::<Vec<_>>().join(", ")
        }
        _ => String::new(),
    }
}

fn shown(value: f64, dimension: Dimension) -> String {
    let unit = dimension.unit();
    let separator = if unit.is_empty() { "" } else { " " };
    // Nobody counts eleven zeros.
    let number = if value.abs() >= LONG { format!("{value:e}") } else { plain(value) };
    format!("{number}{separator}{unit}")
}

/// The dimension of a bare number, by its key.
fn dimension(key: &str, is_round: bool) -> Dimension {
    let last = key.rsplit('.').next().unwrap_or(key);
    match last {
        "force" if is_round => Dimension::FORCE,
        "force" => Dimension::FORCE_PER_LENGTH,
        "moment" if is_round => Dimension::MOMENT,
        "moment" => Dimension::MOMENT_PER_LENGTH,
        "settlement" | "eccentricity" | "half_width" | "outer_half_width" | "inner_half_gap"
        | "period" | "radius" | "thickness" => Dimension::LENGTH,
        "young_modulus" | "grading_modulus" | "yield_stress" => Dimension::PRESSURE,
        "roughness" => Dimension::COMPLIANCE,
        "subgrade_modulus" => Dimension::SUBGRADE_MODULUS,
        "time_limit" => Dimension::TIME,
        _ => Dimension::NONE,
    }
}

/// The inputs as a table.
pub(super) fn table(entries: &[Entry]) -> String {
    let mut text = String::from(
        "<table class=\"inputs\"><thead><tr><th scope=\"col\">input</th><th scope=\"col\">as given</th><th scope=\"col\">SI</th><th scope=\"col\">where</th></tr></thead><tbody>",
    );
    for Entry { key, given, si, place } in entries {
        let _ = write!(
            text,
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td class=\"note\">{}</td></tr>",
            escaped(key),
            escaped(given),
            escaped(si),
            escaped(place)
        );
    }
    text.push_str("</tbody></table>");
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inputs_are_told_as_given_and_in_si() {
        let text = "[foundation]\nyoung_modulus = \"29e6 psi\"\nroughness = 0\n[punch]\nhalf_width = 0.005\nprofile = \"x^2\"\n[load]\nforce = \"3 kip/in\"\nmoment = 0\n";
        let document = shtaerman::document::overridden(
            text.as_bytes(),
            "x.toml",
            &["load.force=2 N/mm".to_owned()],
            "",
        )
        .unwrap();
        let found = of_document(&document);
        let told = |key: &str| {
            let entry = found.iter().find(|entry| entry.key == key).unwrap();
            (entry.given.as_str(), entry.si.as_str(), entry.place.as_str())
        };
        // 29e6 psi are 29e6 times 6894.757293168362 Pa.
        assert_eq!(
            told("foundation.young_modulus"),
            ("29e6 psi", "1.9994796150188248e11 Pa", "line 2")
        );
        assert_eq!(told("foundation.roughness"), ("0", "0 m/Pa", "line 3"));
        assert_eq!(told("punch.half_width"), ("0.005", "0.005 m", "line 5"));
        assert_eq!(told("load.force"), ("2 N/mm", "2000 N/m", "--set"));
        assert_eq!(told("load.moment"), ("0", "0 N m/m", "line 9"));
        assert_eq!(told("solver.contact"), ("", "unilateral", "as usual"));
        assert_eq!(found.iter().filter(|entry| entry.key == "load.force").count(), 1);
    }
}

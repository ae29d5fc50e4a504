//! `profile = { csv = ".." }`: a measured trace.

use std::path::Path;

use crate::Warning;
use crate::bodies::Bodies;
use crate::document::{Field, FileError, TableReader, Value, ValueKind};
use crate::profile::{Column, Dialect, HeaderUnit, Place, Profile, Trace, TraceOptions};
use crate::quantity::{self, Dimension};

/// Most lines that are skipped.
const MOST_SKIPPED: usize = 1_000_000;
/// The options in the order in which a line shows them.
const KEYS: [&str; 13] = [
    "csv", "encoding", "skip", "x_column", "f_column", "x_unit", "f_unit", "reverse", "flip",
    "x_shift", "centre", "level", "filter",
];

/// The spline through the trace, and what is doubtful about its units.
pub(super) fn read(
    field: &Field<'_>,
    bodies: &Bodies,
    folder: &Path,
) -> Result<(Profile, Vec<Warning>), FileError> {
    let half_width = bodies.half_width();
    let is_period = bodies.geometry().is_wave(half_width);
    let physical = bodies.scaling().is_some();
    let options = stated(field, physical)?;
    let table = field.table()?;
    let csv = table.required("csv")?;
    let (name, bytes) = csv.load(folder)?;
    let over = [-half_width, half_width];
    let options = TraceOptions { is_periodic: is_period, ..options };
    let said =
        Trace::header_units(&bytes, &name, &options.dialect).map_err(|error| csv.error(error))?;
    let trace = Trace::read(&bytes, &name, &options).map_err(|error| {
        let fault = csv.error(error);
        match stating_units(field, &table, &said, physical) {
            Some(line) => fault.with_help(line),
            None => fault,
        }
    })?;
    let trace = trace.arranged(&options);
    let mut doubts = if physical { doubts(&table, &said) } else { Vec::new() };
    if physical && !table.has("x_unit") && matches!(said[0], HeaderUnit::Silent) {
        doubts.extend(Warning::few_rows(trace.rows_over(over), "x_unit = \"mm\" or the like"));
    }
    let is_elsewhere = trace.is_elsewhere(over);
    let covering = trace.covering(over, &name).map_err(|error| {
        let fault = csv.error(error);
        if !is_elsewhere || table.has("centre") || table.has("x_shift") {
            return fault;
        }
        fault.with_help(format!(
            "this puts its middle under the middle of the punch:\n{}",
            line(field, &table, &[("centre", "true".to_owned())])
        ))
    })?;
    let treated = covering
        .levelled(over, &options)
        .filtered(&options, &name)
        .map_err(|error| csv.error(error))?;
    let profile = Profile::from_trace(treated, &name).map_err(|error| csv.error(error))?;
    Ok((profile, doubts))
}

/// The names of the columns and the keys of their units.
const UNITS: [(&str, &str); 2] = [("positions", "x_unit"), ("heights", "f_unit")];

/// Units that the header may have, where none is stated: metres are read.
fn doubts(table: &TableReader<'_>, said: &[HeaderUnit; 2]) -> Vec<Warning> {
    let doubt = |((name, key), said): ((&str, &str), &HeaderUnit)| match said {
        HeaderUnit::Unknown { written } if !table.has(key) => {
            Some(Warning::unknown_unit(name, written, &format!("{key} = \"mm\" or the like")))
        }
        _ => None,
    };
    let found = UNITS.into_iter().zip(said).filter_map(doubt);
    // Lines that are skipped may have been a header with the other unit.
    let is_half_stated = table.has("x_unit") && !table.has("f_unit");
    let bare = (is_half_stated && said[1] == HeaderUnit::Silent)
        .then(|| Warning::heights_in_metres("f_unit = \"um\" or the like"));
    found.chain(bare).collect()
}

/// The line with the units that the header has, where it states none or others.
fn stating_units(
    field: &Field<'_>,
    table: &TableReader<'_>,
    said: &[HeaderUnit; 2],
    physical: bool,
) -> Option<String> {
    let stated = |((_, key), said): ((&str, &'static str), &HeaderUnit)| match said {
        HeaderUnit::Known { symbol, size, dimension, .. }
            if *dimension == Dimension::LENGTH
                && unit(table, key, physical).is_ok_and(|stated| stated != *size) =>
        {
            Some((key, serde_json::Value::from(symbol.as_str()).to_string()))
        }
        _ => None,
    };
    let missing: Vec<_> = UNITS.into_iter().zip(said).filter_map(stated).collect();
    let line = || format!("the units of the header:\n{}", line(field, table, &missing));
    (physical && !missing.is_empty()).then(line)
}

/// The options of a trace; lengths are numbers in a dimensionless problem.
fn stated(field: &Field<'_>, physical: bool) -> Result<TraceOptions, FileError> {
    let table = field.table()?;
    let length = |field: &Field<'_>| {
        field.quantity(if physical { Dimension::LENGTH } else { Dimension::NONE })
    };
    let place = match table.at_most_one(&["x_shift", "centre"])? {
        Some(field) if field.name().ends_with("x_shift") => Place::Shifted(length(&field)?),
        Some(_) if table.boolean("centre")? == Some(true) => Place::Centred,
        _ => Place::AsWritten,
    };
    let is_levelled = match table.optional("level") {
        Some(field) => field.one_of(&["none", "mean-line"])? == "mean-line",
        None => false,
    };
    Ok(TraceOptions {
        units: Some([unit(&table, "x_unit", physical)?, unit(&table, "f_unit", physical)?])
            .filter(|_| physical),
        dialect: dialect(&table)?,
        is_reversed: table.boolean("reverse")?.unwrap_or(false),
        is_flipped: table.boolean("flip")?.unwrap_or(false),
        place,
        is_levelled,
        cutoff: cutoff(&table, &length)?,
        is_periodic: false,
    })
}

fn dialect(table: &TableReader<'_>) -> Result<Dialect, FileError> {
    let skip = table.optional("skip").map(|field| field.count(0..=MOST_SKIPPED)).transpose()?;
    let [x, f] = ["x_column", "f_column"].map(|key| table.optional(key));
    let columns = match (x, f) {
        (None, None) => None,
        (x, f) => {
            let of = |field: Option<Field<'_>>, usual: usize| match field {
                Some(field) => column(&field),
                None => Ok(Column::Number(usual)),
            };
            Some([of(x, 1)?, of(f, 2)?])
        }
    };
    let encoding = table.string("encoding")?.map(str::to_owned);
    let chosen_by = "x_column and f_column";
    let skipped_by = "skip = ";
    Ok(Dialect { skip: skip.unwrap_or(0), columns, encoding, chosen_by, skipped_by })
}

/// The number of a column, or its name in the header.
fn column(field: &Field<'_>) -> Result<Column, FileError> {
    match field.value().kind() {
        ValueKind::String(name) => Ok(Column::Named(name.clone())),
        ValueKind::Integer(_) => Ok(Column::Number(field.count(1..=usize::MAX >> 12)?)),
        _ => Err(field.error(format!(
            "is the number of a column, from 1, or its name in the header, got {}",
            field.value().description()
        ))),
    }
}

fn cutoff(
    table: &TableReader<'_>,
    length: &dyn Fn(&Field<'_>) -> Result<f64, FileError>,
) -> Result<Option<f64>, FileError> {
    let Some(filter) = table.table("filter")? else { return Ok(None) };
    filter.required("kind")?.one_of(&["gauss"])?;
    let field = filter.required("cutoff")?;
    let cutoff = length(&field)?;
    if cutoff.is_finite() && cutoff > 0.0 {
        return Ok(Some(cutoff));
    }
    Err(field.error(format!("is {cutoff}: must be finite and greater than zero")))
}

/// SI value of the unit of a column.
fn unit(table: &TableReader<'_>, key: &str, physical: bool) -> Result<f64, FileError> {
    let Some(field) = table.optional(key) else { return Ok(1.0) };
    if !physical {
        return Err(
            field.error("has no place in a dimensionless problem: the columns are xi and f0")
        );
    }
    let text = field.string()?;
    let value = quantity::parse(&format!("1 {text}"))
        .and_then(|quantity| quantity.of(Dimension::LENGTH, text))
        .map_err(|error| field.error(format!("is a unit of length (like \"mm\"): {error}")))?;
    if value > 0.0 {
        Ok(value)
    } else {
        Err(field.error(format!("is a unit of length (like \"mm\"), got `{text}`")))
    }
}

/// The line as it is written, with some keys more or anew.
fn line(field: &Field<'_>, table: &TableReader<'_>, more: &[(&str, String)]) -> String {
    let is_anew = |known: &&str| !more.iter().any(|(key, _)| key == known);
    let written = KEYS.into_iter().filter(is_anew).filter_map(|known| {
        let field = table.optional(known)?;
        Some(format!("{known} = {}", toml(field.value())))
    });
    let more = more.iter().map(|(key, value)| format!("{key} = {value}"));
    let pairs: Vec<String> = written.chain(more).collect();
    let name = field.name().rsplit('.').next().unwrap_or("profile");
    format!("{name} = {{ {} }}", pairs.join(", "))
}

/// A value as TOML has it.
fn toml(value: &Value) -> String {
    match value.kind() {
        ValueKind::String(text) => serde_json::Value::from(text.as_str()).to_string(),
        ValueKind::Integer(number) => number.to_string(),
        ValueKind::Float(number) => format!("{number:?}"),
        ValueKind::Boolean(is_so) => is_so.to_string(),
        ValueKind::Table(table) => {
            let pairs =
                table.keys().filter_map(|key| Some(format!("{key} = {}", toml(table.get(key)?))));
            format!("{{ {} }}", pairs.collect::<Vec<_>>().join(", "))
        }
        _ => "..".to_owned(),
    }
}

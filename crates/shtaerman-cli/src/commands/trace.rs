//! `shtaerman trace`.

use std::path::Path;

use shtaerman::Warning;
use shtaerman::document::{FileError, load_bytes, read_bytes};
use shtaerman::profile::{Column, Dialect, HeaderUnit, Place, Trace, TraceOptions};
use shtaerman::quantity::{self, Dimension, Measure, OutputUnits};

use super::picture::Picture;
use super::{places, problem_file};
use crate::Failure;
use crate::arguments::{ReportFormat, TraceArguments};
use crate::failure;
use crate::output::{Content, Input, Outputs, check_writable};
use crate::report::{TraceReport, trace_csv};

/// A longer trace is doubted where no unit was stated: it would lie under a half-width of more than 1 m (m).
const LONGEST: f64 = 2.0;

pub(super) fn run(arguments: &TraceArguments) -> Result<(), Failure> {
    let picture = Picture::new(arguments.plot.as_deref(), &arguments.picture)?;
    let input = Input { what: "the trace", path: &arguments.file };
    let outputs = [arguments.output.output.as_deref(), arguments.plot.as_deref()];
    check_writable(&outputs, &[input])?;
    let units = units(arguments)?;
    let half_width =
        (arguments.half_width.as_deref()).map(|text| positive("--half-width", text)).transpose()?;
    let (name, bytes) = read(&arguments.file)?;
    let Asked { options, units: said, doubts } = asked(arguments, &bytes, &name)?;
    doubts.iter().for_each(|doubt| failure::warn(&doubt.message));
    let before = Trace::read(&bytes, &name, &options)?;
    let arranged = before.clone().arranged(&options);
    let over = half_width.map_or_else(|| arranged.range(), |a| [-a, a]);
    if half_width.is_some() && said[0].is_none() {
        let doubt = Warning::few_rows(arranged.rows_over(over), "--x-unit mm or the like");
        doubt.iter().for_each(|doubt| failure::warn(&doubt.message));
    }
    if said[0].is_none() && over[1] - over[0] > LONGEST {
        failure::warn(&format!(
            "the positions have no unit and are read in metres, {} in all: are millimetres meant? --x-unit mm",
            units.shown(over[1] - over[0], Measure::Length)
        ));
    }
    let begins_at_zero = half_width.is_none() && is_from_zero(&arranged);
    let covering = arranged.clone().covering(over, &name).map_err(|error| {
        if arranged.is_elsewhere(over) && options.place == Place::AsWritten {
            return error.with_help("--centre puts its middle under the middle of the punch");
        }
        error
    })?;
    let levelled = covering.levelled(over, &options);
    let after = levelled.clone().filtered(&options, &name)?;
    let report = TraceReport {
        name: &name,
        stem: problem_file::stem(&arguments.file),
        before: &before,
        levelled: &levelled,
        after: &after,
        over,
        line: line(arguments, &said),
        units: &units,
    };
    let text = match arguments.output.format {
        ReportFormat::Table => Content::page(&report.table()),
        ReportFormat::Json => Content::json(report.data()),
        ReportFormat::Csv => trace_csv(&after, &units),
    };
    let mut outputs = Outputs::default();
    outputs.result(arguments.output.output.as_deref(), text);
    if let Some(picture) = picture {
        picture.draw(&report.plot(), &mut outputs)?;
    }
    outputs.write()?;
    if begins_at_zero {
        failure::warn(
            "the positions begin at 0, and a punch reaches to both sides of 0: --centre, or `centre = true` in the file, puts the middle of the trace there",
        );
    }
    Ok(())
}

/// Positions of one sign, as an instrument counts them from its start.
fn is_from_zero(trace: &Trace) -> bool {
    let [first, last] = trace.range();
    first >= -1e-3 * (last - first)
}

fn read(path: &Path) -> Result<(String, Vec<u8>), Failure> {
    let name = problem_file::name(path);
    let located = |message| Failure::from(FileError::new(message).in_file(Some(&name)));
    let bytes = if path == Path::new("-") {
        read_bytes(std::io::stdin().lock()).map_err(located)?
    } else {
        load_bytes(path).map_err(located)?
    };
    Ok((name, bytes))
}

fn units(arguments: &TraceArguments) -> Result<OutputUnits, Failure> {
    let Some(text) = arguments.units.units.as_deref() else { return Ok(OutputUnits::default()) };
    if let Some(units) = OutputUnits::named(text.trim()) {
        return Ok(units);
    }
    let refused = |why: String| Failure::Usage(format!("--units `{text}`: {why}"));
    if let Some(twice) = problem_file::stated_twice(text) {
        return Err(refused(format!("states {twice} twice")));
    }
    let mut units = OutputUnits::default();
    for part in text.split(',') {
        let (key, unit) = part.split_once('=').ok_or_else(|| {
            refused("must be si, mm, inch, or such as \"length=in, displacement=mil\"".to_owned())
        })?;
        let measures: &[Measure] = match key.trim() {
            "length" => &[Measure::Length, Measure::Displacement],
            "displacement" => &[Measure::Displacement],
            other => {
                return Err(refused(format!("a trace has no {other}: length and displacement")));
            }
        };
        for measure in measures {
            units = units.with(*measure, unit).map_err(|error| refused(error.to_string()))?;
        }
    }
    Ok(units)
}

/// What is asked of a trace.
struct Asked {
    options: TraceOptions,
    /// The units of both columns, as a file states them.
    units: [Option<String>; 2],
    /// What is doubtful about them.
    doubts: Vec<Warning>,
}

/// What the arguments and the header ask.
fn asked(arguments: &TraceArguments, bytes: &[u8], name: &str) -> Result<Asked, Failure> {
    let columns = match (&arguments.x_column, &arguments.f_column) {
        (None, None) => None,
        (x, f) => Some([column(x.as_deref(), 1), column(f.as_deref(), 2)]),
    };
    let dialect = Dialect {
        skip: arguments.skip,
        columns,
        encoding: arguments.encoding.clone(),
        chosen_by: "--x-column and --f-column",
        skipped_by: "--skip ",
    };
    let header = Trace::header_units(bytes, name, &dialect)?;
    let asked = [
        ("positions", "x_unit", "--x-unit", &arguments.x_unit),
        ("heights", "f_unit", "--f-unit", &arguments.f_unit),
    ];
    let mut sizes = [1.0; 2];
    let mut said = [None, None];
    let mut doubts = Vec::new();
    let are_heights_bare = arguments.f_unit.is_none() && header[1] == HeaderUnit::Silent;
    for (index, ((what, key, option, asked), header)) in asked.into_iter().zip(header).enumerate() {
        match (asked, header) {
            (Some(text), _) => {
                sizes[index] = unit(option, text)?;
                said[index] = Some(text.clone());
            }
            (None, HeaderUnit::Known { symbol, size, dimension, .. })
                if dimension == Dimension::LENGTH =>
            {
                sizes[index] = size;
                said[index] = Some(symbol);
            }
            (None, HeaderUnit::Unknown { written }) => {
                let stated = format!("{option} mm or the like, in a file {key} = \"mm\"");
                doubts.push(Warning::unknown_unit(what, &written, &stated));
            }
            // What measures something else is refused where the rows are read.
            _ => {}
        }
    }
    // The line that is handed out states the unit of the positions, whoever said it.
    if are_heights_bare && said[0].is_some() {
        let stated = "--f-unit um or the like, in a file f_unit = \"um\"";
        doubts.push(Warning::heights_in_metres(stated));
    }
    let length = |option: &str, text: &str| places::quantity(option, text, Dimension::LENGTH);
    let place = match (&arguments.x_shift, arguments.centre) {
        (Some(text), _) => Place::Shifted(length("--x-shift", text)?),
        (None, true) => Place::Centred,
        (None, false) => Place::AsWritten,
    };
    let cutoff = arguments.cutoff.as_deref().map(|text| positive("--cutoff", text)).transpose()?;
    let options = TraceOptions {
        units: Some(sizes),
        dialect,
        is_reversed: arguments.reverse,
        is_flipped: arguments.flip,
        place,
        is_levelled: arguments.level.is_some(),
        cutoff,
        is_periodic: false,
    };
    Ok(Asked { options, units: said, doubts })
}

fn column(text: Option<&str>, usual: usize) -> Column {
    match text.map(|text| (text, text.trim().parse())) {
        None => Column::Number(usual),
        Some((_, Ok(number))) => Column::Number(number),
        Some((name, Err(_))) => Column::Named(name.to_owned()),
    }
}

fn unit(option: &str, text: &str) -> Result<f64, Failure> {
    let written = format!("1 {text}");
    let size = quantity::parse(&written)
        .and_then(|quantity| quantity.of(Dimension::LENGTH, &written))
        .map_err(|error| Failure::Usage(format!("{option} `{text}`: {error}")))?;
    if size > 0.0 {
        return Ok(size);
    }
    Err(Failure::Usage(format!("{option} `{text}`: must be a unit of length, such as mm")))
}

fn positive(option: &str, text: &str) -> Result<f64, Failure> {
    let value = places::quantity(option, text, Dimension::LENGTH)?;
    if value > 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(Failure::Usage(format!("{option} `{text}`: must be greater than zero")))
}

/// The same as a line of a problem file.
fn line(arguments: &TraceArguments, units: &[Option<String>; 2]) -> String {
    let quoted = |text: &str| serde_json::Value::from(text).to_string();
    let of_column = |text: &String| match text.trim().parse::<usize>() {
        Ok(number) => number.to_string(),
        Err(_) => quoted(text),
    };
    let mut pairs = vec![format!("csv = {}", quoted(&arguments.file.display().to_string()))];
    let mut add = |key: &str, value: Option<String>| {
        pairs.extend(value.map(|value| format!("{key} = {value}")));
    };
    let truth = |is_so: bool| is_so.then(|| "true".to_owned());
    add("encoding", arguments.encoding.as_deref().map(quoted));
    add("skip", (arguments.skip > 0).then(|| arguments.skip.to_string()));
    add("x_column", arguments.x_column.as_ref().map(of_column));
    add("f_column", arguments.f_column.as_ref().map(of_column));
    add("x_unit", units[0].as_deref().map(quoted));
    add("f_unit", units[1].as_deref().map(quoted));
    add("reverse", truth(arguments.reverse));
    add("flip", truth(arguments.flip));
    add("x_shift", arguments.x_shift.as_deref().map(quoted));
    add("centre", truth(arguments.centre));
    add("level", arguments.level.map(|_| quoted("mean-line")));
    let cutoff = arguments.cutoff.as_deref();
    add(
        "filter",
        cutoff.map(|cutoff| format!("{{ kind = \"gauss\", cutoff = {} }}", quoted(cutoff))),
    );
    format!("profile = {{ {} }}", pairs.join(", "))
}

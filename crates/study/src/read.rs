//! The table `[study]`.

use std::path::Path;
use std::sync::OnceLock;

use shtaerman::document::{Document, Field, FileError, Origin, TableReader, ValueKind};
use shtaerman::equation::is_equation;
use shtaerman::file::AnyFile;
use shtaerman::{Error, Problem, quantity};

use crate::design::{LONGEST_SOBOL, Shares};
use crate::find::Find;
use crate::output::Kind;
use crate::{Design, Distribution, Input, Output, Study, Variable, Variation};

/// Most values of a range, and most random cases: whole numbers up to it are floating-point numbers.
const MOST: usize = usize::MAX >> 11;
/// Most cases of a Latin hypercube, whose order is kept.
const MOST_KEPT: usize = 100_000_000;
/// Fewest groups for Sobol's indices: a standard error from `n` of them is itself uncertain by `1/sqrt(2 (n - 1))`, here by 18 %, and from one there is none.
const FEWEST_GROUPS: usize = 16;
/// Most variables.
const MOST_VARIABLES: usize = 64;
/// Cases of a part of the results of a study in which they make fewer parts than are usual, and the most.
const PART_SIZE: usize = 256;
const USUAL_PARTS: usize = 100;
const LARGEST_PART: usize = 100_000;
/// Cases that are audited in a study without audit, and the most.
const AUDITED_SAMPLE: usize = 20;
const LARGEST_SAMPLE: usize = 10_000;
/// The names of the designs.
const DESIGNS: [&str; 5] = ["grid", "latin-hypercube", "sobol", "sobol-indices", "random"];

/// Reads a study from a document with its overrides.
pub(crate) fn study(
    mut document: Document,
    folder: &Path,
    overrides: &[String],
) -> Result<Study, Error> {
    let text = std::iter::once(document.source_text())
        .chain(overrides.iter().map(String::as_str))
        .collect::<Vec<_>>()
        .join("\n--set ");
    let whole = document.clone();
    document.remove("study");
    let root = whole.reader();
    let table = root
        .required("study")
        .map_err(|error| {
            error.with_help(
                "[study] says what varies: vary.\"load.force\" = { from = \"0.1 MN/m\", to = \"2 MN/m\", count = 20 }",
            )
        })?
        .table()?;
    let is_equation = is_equation(&document);
    let is_dimensionless = is_equation || document.get("dimensionless").is_some();
    let find = if is_equation { None } else { Find::read(&table, is_dimensionless)? };
    let kind = if is_equation {
        Kind::Equation
    } else {
        Kind::Contact { is_dimensionless, is_search: find.is_some() }
    };
    let design_field = table.optional("design");
    let name = design_field.as_ref().map(|field| field.one_of(&DESIGNS)).transpose()?;
    let is_grid = matches!(name, None | Some("grid"));
    let variables = variables(&table, is_grid, &document, folder)?;
    check_find(&table, find, &variables)?;
    let design = design(&table, name.unwrap_or("grid"))?;
    let cases = match design {
        Design::Grid => combinations(&variables).ok_or_else(|| {
            table.error("has more combinations than can be numbered: use fewer values, or design = \"sobol\"")
        })?,
        Design::LatinHypercube { count, .. }
        | Design::Sobol { count, .. }
        | Design::Random { count, .. } => count,
        Design::SobolIndices { count, .. } => count * (variables.len() + 2),
    };
    let shares = Shares::new(design, variables.len());
    let study = Study {
        problem: document,
        folder: folder.to_owned(),
        design,
        find,
        outputs: outputs(&table, kind)?,
        is_audited: table.boolean("audit")?.unwrap_or(false),
        audited_sample: count(&table, "audited_sample", 0..=LARGEST_SAMPLE)?
            .unwrap_or(AUDITED_SAMPLE),
        part_size: count(&table, "part_size", 1..=LARGEST_PART)?
            .unwrap_or((cases / USUAL_PARTS).clamp(PART_SIZE, LARGEST_PART)),
        cases,
        shares,
        variables,
        text,
        way: OnceLock::new(),
    };
    // Only this table: the rest is that of a problem.
    table.finish()?;
    check(&study, &table)?;
    Ok(study)
}

/// Reads the problem with the first case that can be: a wrong key or unit is told before anything is computed, where the key is varied. So is an output that no case has.
fn check(study: &Study, table: &TableReader<'_>) -> Result<(), Error> {
    let error = match study.first(&[]) {
        Ok(file) => return check_outputs(study, &file, table),
        Err(error) => error,
    };
    if let Error::File(fault) = &error
        && let Some(field) = fault.field()
        && let Some(variable) = study.variables.iter().find(|v| is_of(fault, field, &v.key))
    {
        let varied = table.required("vary")?.table()?.required(&variable.key)?;
        let told = if field == variable.key {
            varied.error(fault.message())
        } else {
            varied.error(format!("{field} {}", fault.message()))
        };
        return Err(match fault.help() {
            Some(help) => told.with_help(help),
            None => told,
        }
        .into());
    }
    Err(error)
}

/// Whether a fault of a field is one of a varied key: of itself, or of a table that only the key has made.
fn is_of(fault: &FileError, field: &str, key: &str) -> bool {
    let is_made = fault.origin().is_some_and(Origin::is_override);
    let is_within = key.strip_prefix(field).is_some_and(|rest| rest.starts_with('.'));
    field == key || (is_made && is_within)
}

/// Refuses outputs that this case cannot have, unless others might.
fn check_outputs(study: &Study, file: &AnyFile, table: &TableReader<'_>) -> Result<(), Error> {
    let varies = |tables: &[&str]| {
        study.variables.iter().any(|v| tables.iter().any(|t| v.key.starts_with(t)))
    };
    for (index, output) in study.outputs.iter().enumerate() {
        let found = match (output.place(), file) {
            (Some(x), AnyFile::Problem(file)) if !varies(&["punch."]) => on_base(file.problem(), x),
            (Some(x), AnyFile::Equation(file)) if !varies(&["kernel."]) => {
                file.equation().place(x).map(drop)
            }
            (None, AnyFile::Problem(file)) if output.is_stress() => {
                file.problem().check_stresses().and_then(|()| {
                    let ratio = file.problem().foundation().poisson_ratio();
                    ratio.map(drop).ok_or(Error::NoPoissonRatio)
                })
            }
            _ => Ok(()),
        };
        if let (Err(error), Some(field)) = (found, table.optional("outputs")) {
            let fault = match field.items()?.get(index) {
                Some(item) => item.error(format!("cannot be told: {error}")),
                None => field.error(error),
            };
            return Err(fault.into());
        }
    }
    Ok(())
}

fn on_base(problem: &Problem, x: f64) -> Result<(), Error> {
    let right = problem.punch().half_width();
    if x.abs() <= right {
        return Ok(());
    }
    Err(Error::BeyondPunch { variable: problem.coordinate(), at: x, left: -right, right })
}

fn count(
    table: &TableReader<'_>,
    key: &str,
    range: std::ops::RangeInclusive<usize>,
) -> Result<Option<usize>, FileError> {
    table.optional(key).map(|field| field.count(range)).transpose()
}

/// The count of a design, which some limit.
fn drawn_count(
    field: &Field<'_>,
    range: std::ops::RangeInclusive<usize>,
) -> Result<usize, FileError> {
    let most = *range.end();
    field.count(range).map_err(|error| {
        if most < MOST && field.integer().is_ok_and(|count| count > most as i64) {
            error.with_help("design = \"random\" takes more")
        } else {
            error
        }
    })
}

fn combinations(variables: &[Variable]) -> Option<usize> {
    variables
        .iter()
        .filter_map(|variable| variable.variation.count())
        .try_fold(1usize, usize::checked_mul)
}

fn design(table: &TableReader<'_>, name: &str) -> Result<Design, FileError> {
    if name == "grid" {
        for key in ["count", "seed"] {
            if let Some(field) = table.optional(key) {
                return Err(field
                    .error("goes with design = \"latin-hypercube\", \"sobol\", \"sobol-indices\" or \"random\"")
                    .with_help("a grid takes the count of each variable: { from = .., to = .., count = 20 }"));
            }
        }
        return Ok(Design::Grid);
    }
    let longest = match name {
        "sobol" | "sobol-indices" => LONGEST_SOBOL,
        "latin-hypercube" => MOST_KEPT,
        _ => MOST,
    };
    let fewest = if name == "sobol-indices" { FEWEST_GROUPS } else { 1 };
    let count = drawn_count(&table.required("count")?, fewest..=longest)?;
    let seed = self::count(table, "seed", 0..=u32::MAX as usize)?.unwrap_or(0);
    Ok(match name {
        "latin-hypercube" => Design::LatinHypercube { count, seed: seed as u64 },
        "sobol" => Design::Sobol { count, seed: seed as u32 },
        "sobol-indices" => Design::SobolIndices { count, seed: seed as u32 },
        _ => Design::Random { count, seed: seed as u64 },
    })
}

/// Refuses to vary what is looked for.
fn check_find(
    table: &TableReader<'_>,
    find: Option<Find>,
    variables: &[Variable],
) -> Result<(), FileError> {
    let keys = find.map_or(&[][..], Find::keys);
    match variables.iter().find(|variable| keys.contains(&variable.key.as_str())) {
        Some(variable) => {
            let vary = table.required("vary")?.table()?;
            Err(vary
                .required(&variable.key)?
                .error("cannot vary: it is what [study] find looks for"))
        }
        None => Ok(()),
    }
}

fn outputs(table: &TableReader<'_>, kind: Kind) -> Result<Vec<Output>, FileError> {
    let Some(field) = table.optional("outputs") else { return Ok(Output::usual(kind)) };
    let items = field.items()?;
    if items.is_empty() {
        return Err(field.error("is empty: name at least one output"));
    }
    let mut outputs: Vec<Output> = Vec::new();
    for item in items {
        let output = Output::read(&item, kind)?;
        if outputs.iter().any(|known| known.name == output.name) {
            return Err(item.error(format!("names {} twice", output.name)));
        }
        outputs.push(output);
    }
    Ok(outputs)
}

fn variables(
    table: &TableReader<'_>,
    is_grid: bool,
    problem: &Document,
    folder: &Path,
) -> Result<Vec<Variable>, FileError> {
    let field = table.required("vary")?;
    let vary = field.table()?;
    let ValueKind::Table(written) = field.value().kind() else { return Ok(Vec::new()) };
    let keys: Vec<&str> = written.keys().collect();
    if keys.is_empty() || keys.len() > MOST_VARIABLES {
        return Err(field
            .error(format!("has {} keys, from 1 to {MOST_VARIABLES} can be varied", keys.len()))
            .with_help("write vary.\"load.force\" = { from = .., to = .., count = .. }"));
    }
    let ends: Vec<(&str, [String; 2])> = keys
        .iter()
        .filter_map(|key| Some((*key, first_and_last(&vary.required(key).ok()?)?)))
        .collect();
    keys.into_iter()
        .map(|key| {
            let field = vary.required(key)?;
            if !key.contains('.') {
                return Err(field
                    .error("is no key of the problem file")
                    .with_help("quote the dotted key: vary.\"load.force\" = .."));
            }
            if key.starts_with("study.") {
                return Err(field.error("is no key of the problem, which alone can vary"));
            }
            let trial = Trial { key, problem, folder, ends: &ends };
            Ok(Variable { key: key.to_owned(), variation: variation(&field, is_grid, &trial)? })
        })
        .collect()
}

/// Values put into the problem, to hear whether their units are right.
struct Trial<'t> {
    key: &'t str,
    problem: &'t Document,
    folder: &'t Path,
    /// The first and the last value of each key that varies.
    ends: &'t [(&'t str, [String; 2])],
}

impl Trial<'_> {
    /// Refuses a text as [`check`](Self::check) does, but for one whose number is refused in the same words: then it is not its unit, and its cases are without an answer as those of numbers are.
    fn check_quantity(&self, field: &Field<'_>, text: &str, value: f64) -> Result<(), FileError> {
        let Err(told) = self.check(field, text) else { return Ok(()) };
        match self.check(field, &format!("{value:e}")) {
            Err(same) if same.message() == told.message() => Ok(()),
            _ => Err(told),
        }
    }

    /// Refuses what the reader of the problem would refuse of this key, both in the file as it is and with the others that vary at their first or last values, of which one may depend on another as a moment on its force; faults of other keys are told later.
    fn check(&self, field: &Field<'_>, text: &str) -> Result<(), FileError> {
        let read = |mut document: Document| {
            document.set(self.key, text).map_err(|error| field.error(error.to_string()))?;
            match AnyFile::from_document(document, self.folder) {
                Err(Error::File(fault)) if fault.field() == Some(self.key) => Ok(Err(fault)),
                _ => Ok(Ok(())),
            }
        };
        let Err(fault) = read(self.problem.clone())? else { return Ok(()) };
        for side in 0..2 {
            let mut document = self.problem.clone();
            let others = self.ends.iter().filter(|(key, _)| *key != self.key);
            if others.map(|(key, ends)| document.set(key, &ends[side])).all(|set| set.is_ok())
                && read(document)?.is_ok()
            {
                return Ok(());
            }
        }
        Err(self.told(field, &fault))
    }

    fn told(&self, field: &Field<'_>, fault: &FileError) -> FileError {
        let told = field.error(format!("is refused: {}: {}", self.key, fault.message()));
        match fault.help() {
            Some(help) => told.with_help(help),
            None => told,
        }
    }
}

/// The first and the last of the values of a key, as the problem file would have them; none where they are no values.
fn first_and_last(field: &Field<'_>) -> Option<[String; 2]> {
    let text = |field: &Field<'_>| match field.value().kind() {
        ValueKind::String(text) => Some(text.clone()),
        ValueKind::Integer(value) => Some(value.to_string()),
        ValueKind::Float(value) => Some(format!("{value:e}")),
        _ => None,
    };
    if !field.is_table() {
        let items = field.items().ok()?;
        return Some([text(items.first()?)?, text(items.last()?)?]);
    }
    let table = field.table().ok()?;
    let at = |key: &str| text(&table.optional(key)?);
    let first = at("from").or_else(|| at("mean"))?;
    Some([first.clone(), at("to").unwrap_or(first)])
}

fn variation(field: &Field<'_>, is_grid: bool, trial: &Trial<'_>) -> Result<Variation, FileError> {
    if !field.is_table() {
        return values(field, trial);
    }
    let table = field.table()?;
    let given = |key: &str| number(&table.required(key)?, trial);
    if let Some(chosen) = table.optional("distribution") {
        let name = chosen.one_of(&["uniform", "log-uniform", "normal", "lognormal"])?;
        let distribution = match name {
            "uniform" | "log-uniform" => ends(&table, name == "log-uniform", trial)?,
            _ => {
                let mean = given("mean")?;
                let deviation = table.required("standard_deviation")?;
                let standard_deviation = number(&deviation, trial)?;
                if standard_deviation <= 0.0 {
                    return Err(deviation.error("must be greater than 0"));
                }
                if name == "normal" {
                    Distribution::Normal { mean, standard_deviation }
                } else if mean > 0.0 {
                    Distribution::Lognormal { mean, standard_deviation }
                } else {
                    return Err(table
                        .required("mean")?
                        .error("must be greater than 0: the logarithm of the value is normal"));
                }
            }
        };
        return drawn(field, distribution, is_grid);
    }
    let is_logarithmic = match table.optional("scale") {
        Some(scale) => scale.one_of(&["linear", "log"])? == "log",
        None => false,
    };
    let distribution = ends(&table, is_logarithmic, trial)?;
    match table.optional("count").map(|field| field.count(1..=MOST)).transpose()? {
        Some(count) => Ok(Variation::Spaced(distribution, count)),
        None => drawn(field, distribution, is_grid),
    }
}

fn drawn(
    field: &Field<'_>,
    distribution: Distribution,
    is_grid: bool,
) -> Result<Variation, FileError> {
    if is_grid {
        return Err(field
            .error("has no count, which a grid needs")
            .with_help("add count = 20, or draw: design = \"sobol\" (or latin-hypercube, random) and count = 256 in [study]"));
    }
    Ok(Variation::Drawn(distribution))
}

/// `from` and `to`.
fn ends(
    table: &TableReader<'_>,
    is_logarithmic: bool,
    trial: &Trial<'_>,
) -> Result<Distribution, FileError> {
    let (first, last) = (table.required("from")?, table.required("to")?);
    let (from, to) = (number(&first, trial)?, number(&last, trial)?);
    if !(to - from).is_finite() {
        return Err(last.error("is too far from `from`"));
    }
    if is_logarithmic {
        if from <= 0.0 || to <= 0.0 {
            let wrong = if from <= 0.0 { first } else { last };
            return Err(wrong.error("must be greater than 0 on a logarithmic scale"));
        }
        return Ok(Distribution::LogUniform { from, to });
    }
    Ok(Distribution::Uniform { from, to })
}

/// A list of values as the problem file would have them.
fn values(field: &Field<'_>, trial: &Trial<'_>) -> Result<Variation, FileError> {
    let items = field.items()?;
    if items.is_empty() {
        return Err(field.error("is empty: list at least one value"));
    }
    let value =
        |item: &Field<'_>| match item.value().kind() {
            ValueKind::String(text) => match quantity::parse(text) {
                // With a unit it is a quantity, and its column is in SI units as those of ranges are.
                Ok(read) if read.unit_written() => {
                    trial.check_quantity(item, text, read.value)?;
                    Ok(Input::Number(read.value))
                }
                _ => {
                    trial.check(item, text)?;
                    Ok(Input::Text(text.clone()))
                }
            },
            ValueKind::Integer(value) => Ok(Input::Whole(*value)),
            ValueKind::Float(value) => Ok(Input::Number(*value)),
            ValueKind::Boolean(value) => Ok(Input::Text(value.to_string())),
            _ => Err(item
                .error(format!("is {}, a list has numbers and texts", item.value().description()))),
        };
    Ok(Variation::Values(items.iter().map(value).collect::<Result<_, _>>()?))
}

/// A number, or a quantity with the unit of the key, in SI units.
fn number(field: &Field<'_>, trial: &Trial<'_>) -> Result<f64, FileError> {
    if !field.is_string() {
        return field.number();
    }
    let text = field.string()?;
    let read = quantity::parse(text)
        .map_err(|error| field.error_within(error.to_string(), error.span()))?;
    trial.check_quantity(field, text, read.value)?;
    Ok(read.value)
}

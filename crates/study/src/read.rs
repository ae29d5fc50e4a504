//! The table `[study]`.

use std::path::Path;
use std::sync::OnceLock;

use shtaerman::document::{Document, Field, FileError, TableReader, ValueKind};
use shtaerman::file::ProblemFile;
use shtaerman::quantity;

use crate::design::{LONGEST_SOBOL, Shares};
use crate::{Design, Distribution, Input, Output, Study, Variable, Variation};

/// Most values of one variable, and most cases of a design that is drawn.
const MOST: usize = 100_000_000;
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
) -> Result<Study, shtaerman::Error> {
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
    let design_field = table.optional("design");
    let name = design_field.as_ref().map(|field| field.one_of(&DESIGNS)).transpose()?;
    let is_grid = matches!(name, None | Some("grid"));
    let variables = variables(&table, is_grid, &document, folder)?;
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
        outputs: outputs(&table)?,
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

/// Reads the problem with the first case: a wrong key or unit is told before anything is computed, where the key is varied.
fn check(study: &Study, table: &TableReader<'_>) -> Result<(), shtaerman::Error> {
    let Err(error) = study.file(&study.inputs(0)) else { return Ok(()) };
    if let shtaerman::Error::File(fault) = &error
        && let Some(variable) = study.variables.iter().find(|v| fault.field() == Some(&v.key))
    {
        let told = table.required("vary")?.table()?.required(&variable.key)?.error(fault.message());
        return Err(match fault.help() {
            Some(help) => told.with_help(help),
            None => told,
        }
        .into());
    }
    Err(error)
}

fn count(
    table: &TableReader<'_>,
    key: &str,
    range: std::ops::RangeInclusive<usize>,
) -> Result<Option<usize>, FileError> {
    table.optional(key).map(|field| field.count(range)).transpose()
}

/// A count of values that are kept, and limited for that.
fn kept(field: &Field<'_>, range: std::ops::RangeInclusive<usize>) -> Result<usize, FileError> {
    let most = *range.end() as i64;
    field.count(range).map_err(|error| {
        if field.integer().is_ok_and(|count| count > most) {
            error.with_help("a grid over several keys with fewer values each has as many cases: how long they take is estimated and asked about")
        } else {
            error
        }
    })
}

fn combinations(variables: &[Variable]) -> Option<usize> {
    variables.iter().try_fold(1usize, |product, variable| match &variable.variation {
        Variation::Values(values) => product.checked_mul(values.len()),
        Variation::Drawn(_) => Some(product),
    })
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
    let longest = if name.starts_with("sobol") { LONGEST_SOBOL } else { MOST };
    let fewest = if name == "sobol-indices" { FEWEST_GROUPS } else { 1 };
    let count = kept(&table.required("count")?, fewest..=longest)?;
    let seed = self::count(table, "seed", 0..=u32::MAX as usize)?.unwrap_or(0);
    Ok(match name {
        "latin-hypercube" => Design::LatinHypercube { count, seed: seed as u64 },
        "sobol" => Design::Sobol { count, seed: seed as u32 },
        "sobol-indices" => Design::SobolIndices { count, seed: seed as u32 },
        _ => Design::Random { count, seed: seed as u64 },
    })
}

fn outputs(table: &TableReader<'_>) -> Result<Vec<Output>, FileError> {
    let Some(field) = table.optional("outputs") else { return Ok(Output::usual()) };
    let items = field.items()?;
    if items.is_empty() {
        return Err(field.error("is empty: name at least one output"));
    }
    let mut outputs: Vec<Output> = Vec::new();
    for item in items {
        let name = item.one_of(&Output::names())?;
        if outputs.iter().any(|output| output.name == name) {
            return Err(item.error(format!("names {name} twice")));
        }
        outputs.extend(Output::named(name));
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
            let trial = Trial { key, problem, folder };
            Ok(Variable { key: key.to_owned(), variation: variation(&field, is_grid, &trial)? })
        })
        .collect()
}

/// Values put into the problem, to hear whether their units are right.
struct Trial<'t> {
    key: &'t str,
    problem: &'t Document,
    folder: &'t Path,
}

impl Trial<'_> {
    /// Refuses what the reader of the problem would refuse of this key; faults of other keys are told later.
    fn check(&self, field: &Field<'_>, text: &str) -> Result<(), FileError> {
        let mut document = self.problem.clone();
        document.set(self.key, text).map_err(|error| field.error(error.to_string()))?;
        match ProblemFile::from_document(document, self.folder) {
            Err(shtaerman::Error::File(fault)) if fault.field() == Some(self.key) => {
                let told = field.error(format!("is refused: {}: {}", self.key, fault.message()));
                Err(match fault.help() {
                    Some(help) => told.with_help(help),
                    None => told,
                })
            }
            _ => Ok(()),
        }
    }
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
    match table.optional("count").map(|field| kept(&field, 1..=MOST)).transpose()? {
        Some(count) => Ok(Variation::Values(spaced(distribution, count))),
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

/// `count` values from end to end; the ends are exact.
fn spaced(distribution: Distribution, count: usize) -> Vec<Input> {
    let (Distribution::Uniform { from, to } | Distribution::LogUniform { from, to }) = distribution
    else {
        return Vec::new();
    };
    let last = count.saturating_sub(1).max(1);
    (0..count)
        .map(|index| match index {
            0 => from,
            index if index == last => to,
            index => distribution.quantile(index as f64 / last as f64),
        })
        .map(Input::Number)
        .collect()
}

/// A list of values as the problem file would have them.
fn values(field: &Field<'_>, trial: &Trial<'_>) -> Result<Variation, FileError> {
    let items = field.items()?;
    if items.is_empty() {
        return Err(field.error("is empty: list at least one value"));
    }
    let value =
        |item: &Field<'_>| match item.value().kind() {
            ValueKind::String(text) => {
                trial.check(item, text)?;
                // With a unit it is a quantity, and its column is in SI units as those of ranges are.
                match quantity::parse(text) {
                    Ok(read) if read.unit_written() => Ok(Input::Number(read.value)),
                    _ => Ok(Input::Text(text.clone())),
                }
            }
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
    trial.check(field, text)?;
    Ok(read.value)
}

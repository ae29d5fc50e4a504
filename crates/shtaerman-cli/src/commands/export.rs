//! `shtaerman export`.

use shtaerman::file::ProblemFile;
use shtaerman::finite_elements::{
    LoadCurve, Overclosure, Penalty, Units, check_problem, force_curve, moment_curve,
};
use shtaerman::quantity::Dimension;
use shtaerman::{Contact, Datum, Error, Problem};

use super::{places, problem_file};
use crate::arguments::{ExportArguments, Exported, ModelUnits, Program, UnitArguments};
use crate::output::Outputs;
use crate::report::{ForceExport, Model, SurfaceExport, significant};
use crate::{Failure, clock};

/// The most points that `CalculiX` keeps of a table (`plconloc` in `materialdata_sp.f`).
const CALCULIX_POINTS: usize = 200;
/// The farthest that tables reach, over the largest pressure of a contact: no iteration of a finite-element program comes there.
const MOST_REACH: f64 = 1e6;
/// The least distance of two overclosures, in the units of the model: `CalculiX` moves nearer ones apart (`surfacebehaviors.f`).
const CALCULIX_DISTANCE: f64 = 1e-10;

pub(super) fn run(arguments: &ExportArguments) -> Result<(), Failure> {
    let factors = Factors::parse(arguments)?;
    let file = problem_file::read(
        &arguments.problem,
        &UnitArguments::default(),
        &[arguments.output.as_deref()],
    )?;
    problem_file::check_input(&file, &arguments.sense, false)?;
    if arguments.sense.strict {
        let contact = problem_file::solve(&file, false)?;
        problem_file::doubts(&file, &contact, &arguments.sense)?;
    }
    let text = text(arguments, factors, &Asked { problem: file.problem(), file: &file })?;
    clock::stop();
    let mut outputs = Outputs::default();
    outputs.result(arguments.output.as_deref(), text);
    outputs.write()
}

/// What the command writes of a problem that was read, for programs that have one.
pub(crate) fn exported(
    arguments: &ExportArguments,
    problem: &Problem,
    file: &ProblemFile,
) -> Result<String, Failure> {
    text(arguments, Factors::parse(arguments)?, &Asked { problem, file })
}

/// A problem, and the file that knows where its faults stand.
#[derive(Clone, Copy)]
struct Asked<'a> {
    problem: &'a Problem,
    file: &'a ProblemFile,
}

fn text(
    arguments: &ExportArguments,
    factors: Factors,
    asked: &Asked<'_>,
) -> Result<String, Failure> {
    let datum = datum(arguments)?;
    let units = units(arguments.units);
    let mut model = Model::new(
        arguments.program,
        units,
        length(arguments, asked.problem)?,
        &problem_file::name(&arguments.problem.file),
    );
    let located = |error: Error| named(asked.file, error);
    for content in contents(arguments) {
        match content {
            Exported::Surface => {
                let (contact, table) = surface(asked, &factors)?;
                check_table(arguments, units, &table)?;
                let penalty = match Penalty::new(&contact, factors.share, datum) {
                    Ok(penalty) => Ok(penalty),
                    // The table is none the worse for it.
                    Err(error @ Error::InvalidValue { field: "settlement", .. }) => {
                        Err(error.to_string())
                    }
                    Err(error) => return Err(located(error)),
                };
                let Factors { share, reach, .. } = factors;
                model.surface(&SurfaceExport { contact, table, penalty, share, reach });
            }
            Exported::Force => {
                let curve = force_curve(asked.problem, factors.load, factors.share, datum);
                let curve = curve.map_err(located)?;
                check_curve(arguments, &curve)?;
                model.force(&ForceExport { problem: asked.problem, curve, datum });
            }
            Exported::Moment => {
                let curve = moment_curve(asked.problem, factors.moment, factors.share);
                let curve = curve.map_err(|error| tilted(asked.file, &factors, error))?;
                check_curve(arguments, &curve)?;
                model.moment(&curve);
            }
        }
    }
    Ok(model.text())
}

/// What was asked for, once each and in one order.
fn contents(arguments: &ExportArguments) -> impl Iterator<Item = Exported> {
    let all = [Exported::Surface, Exported::Force, Exported::Moment];
    all.into_iter().filter(|content| arguments.content.contains(content))
}

/// The contact of the file, and the table that reaches beyond its pressures.
fn surface(asked: &Asked<'_>, factors: &Factors) -> Result<(Contact, Overclosure), Failure> {
    let located = |error| named(asked.file, error);
    let problem = asked.problem;
    check_problem(problem).map_err(located)?;
    let roughness = problem.foundation().roughness();
    // What is no law is told before anything is solved.
    Overclosure::new(roughness, [1.0, 1.0], factors.share).map_err(located)?;
    let contact = problem.solve().map_err(|error| asked.file.locate(error))?;
    let pressures = [contact.mean_pressure(), factors.reach * contact.peak_pressure()];
    let table = Overclosure::new(roughness, pressures, factors.share).map_err(located)?;
    Ok((contact, table))
}

/// An error with the line of the file, or the option, that it is about.
fn named(file: &ProblemFile, error: Error) -> Failure {
    let option = match &error {
        Error::InvalidValue { field: "share", .. } => "--share",
        Error::InvalidValue { field: "factor", .. } => "--load-factor",
        Error::InvalidValue { field: "moment share", .. } => "--moment-share",
        Error::InvalidValue { field: "datum distance", .. } => "--datum-distance",
        Error::InvalidValue { field: "datum depth", .. } => "--datum-depth",
        _ => return file.locate(error).into(),
    };
    match error {
        Error::InvalidValue { value, requirement, .. } => {
            Failure::Usage(format!("{option} {value}: must be {requirement}"))
        }
        other => other.into(),
    }
}

/// An error of the moment curve: its moments are none of the file's.
fn tilted(file: &ProblemFile, factors: &Factors, error: Error) -> Failure {
    let Error::LiftsOff { value, limit, .. } = error else { return named(file, error) };
    if limit == 0.0 {
        let message = "--content moment: the circular base does not touch as a whole, and its contact under a moment is no disk, which is not solved";
        return Failure::Usage(message.to_owned());
    }
    Failure::Usage(format!(
        "--moment-share {}: the circular punch lifts off on one side, which is not solved; full contact holds up to a share of {}",
        factors.moment,
        significant(factors.moment * limit / value.abs(), 3)
    ))
}

/// Refuses a table that the program would read as another one.
fn check_table(
    arguments: &ExportArguments,
    units: Units,
    table: &Overclosure,
) -> Result<(), Failure> {
    if arguments.program != Program::CalculiX {
        return Ok(());
    }
    check_count(arguments, table.points().len())?;
    let apart = |pair: &[[f64; 2]]| (pair[1][1] - pair[0][1]) / units.length();
    let least = table.points().windows(2).map(apart).fold(f64::INFINITY, f64::min);
    if least >= CALCULIX_DISTANCE {
        return Ok(());
    }
    let [_, length, _] = units.names();
    let remedy = match units {
        Units::Si => "--units mm, or a larger --share",
        Units::Millimetres => "a larger --share",
    };
    Err(Failure::Usage(format!(
        "overclosures of the table are {least:.1e} {length} apart, and CalculiX moves those apart that are closer than {CALCULIX_DISTANCE:e} in the units of its model: give {remedy}"
    )))
}

fn check_curve(arguments: &ExportArguments, curve: &LoadCurve) -> Result<(), Failure> {
    match arguments.program {
        Program::Abaqus => Ok(()),
        Program::CalculiX => check_count(arguments, curve.points.len()),
    }
}

fn check_count(arguments: &ExportArguments, count: usize) -> Result<(), Failure> {
    if count <= CALCULIX_POINTS {
        return Ok(());
    }
    Err(Failure::Usage(format!(
        "--share {} makes {count} points, and CalculiX keeps {CALCULIX_POINTS} of a table: give a larger one",
        arguments.share
    )))
}

/// The numbers among the options.
#[derive(Clone, Copy)]
struct Factors {
    share: f64,
    reach: f64,
    load: f64,
    moment: f64,
}

impl Factors {
    fn parse(arguments: &ExportArguments) -> Result<Self, Failure> {
        let number = |option, text: &str| places::quantity(option, text, Dimension::NONE);
        let reach = number("--reach", &arguments.reach)?;
        if !(1.0..=MOST_REACH).contains(&reach) {
            return Err(Failure::Usage(format!(
                "--reach `{}`: must be at least 1, or the contact itself goes beyond the table, and at most {MOST_REACH:e}",
                arguments.reach
            )));
        }
        Ok(Self {
            share: number("--share", &arguments.share)?,
            reach,
            load: number("--load-factor", &arguments.load_factor)?,
            moment: number("--moment-share", &arguments.moment_share)?,
        })
    }
}

fn units(units: ModelUnits) -> Units {
    match units {
        ModelUnits::Si => Units::Si,
        ModelUnits::Mm => Units::Millimetres,
    }
}

/// The length of a plane punch out of the plane (m); none of a circular one.
fn length(arguments: &ExportArguments, problem: &Problem) -> Result<Option<f64>, Failure> {
    let is_circular = problem.is_circular();
    let Some(text) = &arguments.length else {
        let unit = units(arguments.units).length();
        return Ok((!is_circular).then_some(unit));
    };
    let length = places::quantity("--length", text, Dimension::LENGTH)?;
    if is_circular {
        let message = "--length: a circular punch has none; its force is that of the whole punch";
        return Err(Failure::Usage(message.to_owned()));
    }
    if length > 0.0 && length.is_finite() {
        return Ok(Some(length));
    }
    Err(Failure::Usage(format!("--length `{text}`: must be finite and greater than zero")))
}

fn datum(arguments: &ExportArguments) -> Result<Option<Datum>, Failure> {
    let value = |option, text: &Option<String>| {
        let text = text.as_deref();
        text.map(|text| places::quantity(option, text, Dimension::LENGTH)).transpose()
    };
    let distance = value("--datum-distance", &arguments.datum_distance)?;
    let depth = value("--datum-depth", &arguments.datum_depth)?;
    Ok(distance.map(Datum::Distance).or(depth.map(Datum::Depth)))
}

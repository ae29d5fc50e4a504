//! `shtaerman stress`.

mod map;
mod section;

use std::fmt::Write;

use shtaerman::file::ProblemFile;
use shtaerman::quantity::{Dimension, Measure};
use shtaerman::{Contact, Criterion, Error, Peak, StressField, Warning, WarningCode};

use super::picture::Picture;
use super::problem_file;
use super::sheet::{self, ReportFile};
use crate::arguments::{StressArguments, StressFormat};
use crate::failure;
use crate::output::{Content, Outputs};
use crate::plot::{MapPlot, Plot};
use crate::report::{self, Sheet, Shown, StressReport, Stresses, Told, YieldReport};
use crate::{Failure, clock};
pub(super) use map::{MIDDLE, limits, name, plot, zones};
pub(super) use section::{Section, Units};

pub(super) fn run(arguments: &StressArguments) -> Result<(), Failure> {
    let picture = Picture::new(arguments.plot.as_deref(), &arguments.picture)?;
    if arguments.format == StressFormat::Npz && arguments.output.is_none() {
        let message = "--format npz is no text: give --output FILE.npz";
        return Err(Failure::Usage(message.to_owned()));
    }
    let sheet_file = ReportFile::of(&arguments.report)?;
    let sheet_path = sheet_file.as_ref().map(|report| report.path);
    let outputs = [arguments.output.as_deref(), arguments.plot.as_deref(), sheet_path];
    let file = problem_file::read(&arguments.problem, &arguments.units, &outputs)?;
    let is_shown = arguments.format == StressFormat::Table && arguments.output.is_none();
    problem_file::check_input(&file, &arguments.sense, is_shown)?;
    let problem = file.problem();
    problem.check_stresses().map_err(|error| file.locate(error))?;
    let units = Units::of(problem);
    let ratio = poisson_ratio(arguments, &file)?;
    let section = Section::parse(arguments, units)?;
    let places =
        arguments.at.as_deref().map(|text| section::parse_places(text, units)).transpose()?;
    let limit = yield_stress(arguments, &file)?;

    let contact = problem_file::solve(&file, !arguments.no_audit)?;
    clock::answered("its stresses");
    let field = StressField::new(&contact, Some(ratio)).map_err(|error| file.locate(error))?;
    let load = [contact.force(), contact.moment()];
    let peaks = [field.peak(Criterion::VonMises), field.peak(Criterion::Tresca)];
    let mut report = StressReport::new(&field, load, Shown::of(problem, file.units()), &peaks);
    report.add_warnings(&contact.warnings_in(file.units()));
    let limit_stress = limit.map(|(stress, _)| stress);
    let doubts = doubts(arguments, &file, &contact, &peaks[0], limit_stress);
    let doubts = problem_file::refuse(&arguments.sense, doubts)?;
    report.add_warnings(&doubts);
    if let Some((stress, is_asked)) = limit {
        // That there is none is an error where they were asked for, else a warning.
        match loads_at_yield(&file, stress, ratio)? {
            Err(message) if is_asked => {
                let name = problem_file::name(&arguments.problem.file);
                return Err(Failure::Usage(format!("{name}: {message}")));
            }
            found => report.set_yield(stress, found),
        }
    }
    let places = places.map(|places| stresses_at(&field, places)).transpose()?;
    let wants_grid = arguments.grid.is_some() || arguments.format != StressFormat::Json;
    let needs_grid = places.is_none() && arguments.format != StressFormat::Table && wants_grid;
    let is_drawn = arguments.plot.is_some() || sheet_file.is_some();
    let grid = if needs_grid || is_drawn { Some(section.stresses(&field)?) } else { None };
    let mut outputs = Outputs::default();
    let shown = Shown::of(problem, file.units());
    let name = problem_file::stem(&arguments.problem.file);
    let map = grid
        .as_ref()
        .filter(|_| is_drawn)
        .map(|grid| plot(&name, arguments.component, (&contact, &field), grid, &peaks, &shown));
    let sheet = match &map {
        Some(map) if sheet_file.is_some() => {
            let name = problem_file::name(&arguments.problem.file);
            let told = report::stress_table(&name, &report, places.as_ref());
            Some(sheet(arguments, &file, (&contact, &doubts), &told, map)?)
        }
        _ => None,
    };
    let text = written(arguments, report, &shown, places.as_ref(), grid.as_ref())?;
    outputs.result(arguments.output.as_deref(), text);
    if let (Some(path), Some(sheet)) = (&sheet_file, &sheet) {
        let is_told = arguments.format == StressFormat::Table && arguments.output.is_none();
        path.add(&mut outputs, sheet, is_told)?;
    }
    if let (Some(picture), Some(map)) = (picture, &map) {
        picture.draw(map, &mut outputs)?;
    }
    outputs.write()
}

/// The result.
fn written<'a>(
    arguments: &StressArguments,
    mut report: StressReport<'a>,
    shown: &Shown,
    places: Option<&'a Stresses>,
    grid: Option<&'a Stresses>,
) -> Result<Content<'a>, Failure> {
    let chosen = || {
        places.or(grid).ok_or_else(|| Failure::Usage("there are no stresses to write".to_owned()))
    };
    Ok(match arguments.format {
        StressFormat::Table => {
            let name = problem_file::name(&arguments.problem.file);
            let mut text = report::stress_table(&name, &report, places);
            if let Some(path) = &arguments.plot {
                let _ = writeln!(text, "plot: {}", failure::shown(path));
            }
            Content::page(&text.to_string())
        }
        StressFormat::Json => {
            let asked = places.or(grid.filter(|_| arguments.grid.is_some()));
            if let Some(stresses) = asked {
                report.set_stresses(stresses);
            }
            Content::json(report)
        }
        StressFormat::Csv => report::stress_csv(chosen()?, shown),
        StressFormat::Npz => report::stress_npz(chosen()?),
    })
}

/// The report of the stresses under a contact.
fn sheet(
    arguments: &StressArguments,
    file: &ProblemFile,
    (contact, doubts): (&Contact, &[Warning]),
    told: &Told,
    map: &MapPlot,
) -> Result<Sheet, Failure> {
    let title = format!("Stresses: {}", problem_file::name(&arguments.problem.file));
    let stem = problem_file::stem(&arguments.problem.file);
    let heads = [title.as_str(), &stem];
    let mut sheet = sheet::of_contact(heads, &sheet::command(), told, file, (contact, doubts))?;
    let ratio = arguments.poisson_ratio.map(|ratio| ratio.to_string());
    sheet.options(sheet::options(&[
        ("--yield-stress", arguments.yield_stress.as_deref()),
        ("--poisson-ratio", ratio.as_deref()),
        ("--at", arguments.at.as_deref()),
        ("--grid", arguments.grid.as_deref()),
        ("--x-range", arguments.x_range.as_deref()),
        ("--depth", arguments.depth.as_deref()),
    ]));
    sheet.picture("Stresses below the surface.", map, map.usual_size())?;
    sheet.contact(contact, file.units())?;
    Ok(sheet)
}

fn poisson_ratio(arguments: &StressArguments, file: &ProblemFile) -> Result<f64, Failure> {
    let refused = |text: String| Err(Failure::Usage(text));
    match (arguments.poisson_ratio, file.problem().foundation().poisson_ratio()) {
        (Some(_), Some(_)) => refused(
            "--poisson-ratio is for a dimensionless file: use --set foundation.poisson_ratio=..."
                .to_owned(),
        ),
        (None, None) => refused(
            "a dimensionless file has no Poisson's ratio, which the stress out of the plane needs: give --poisson-ratio"
                .to_owned(),
        ),
        (Some(ratio), None) if !(ratio > -1.0 && ratio <= 0.5) => {
            refused(format!("--poisson-ratio {ratio}: must be greater than -1 and at most 0.5"))
        }
        (Some(ratio), None) | (None, Some(ratio)) => Ok(ratio),
    }
}

/// The yield stress, and whether it was asked for on the command line.
fn yield_stress(
    arguments: &StressArguments,
    file: &ProblemFile,
) -> Result<Option<(f64, bool)>, Failure> {
    let Some(text) = &arguments.yield_stress else {
        return Ok(file.yield_stress()?.map(|stress| (stress, false)));
    };
    let is_physical = !file.problem().is_dimensionless();
    let dimension = if is_physical { Dimension::PRESSURE } else { Dimension::NONE };
    let stress = section::quantity("--yield-stress", text, dimension)?;
    if stress > 0.0 && stress.is_finite() {
        return Ok(Some((stress, true)));
    }
    Err(Failure::Usage(format!("--yield-stress {text}: must be finite and greater than zero")))
}

/// What an engineer would doubt. That the body yields is told by its largest von Mises stress, not by the pressure on it, unless a corner makes that infinite under any load.
fn doubts(
    arguments: &StressArguments,
    file: &ProblemFile,
    contact: &Contact,
    largest: &Peak,
    yield_stress: Option<f64>,
) -> Vec<Warning> {
    let mut doubts = file.sense_checks(contact);
    if largest.value.is_finite() {
        doubts.retain(|doubt| doubt.code != WarningCode::AboveYield);
        let shown = Shown::of(file.problem(), file.units());
        let limit = yield_stress.filter(|limit| largest.value > *limit);
        doubts.extend(limit.map(|limit| Warning {
            code: WarningCode::AboveYield,
            message: format!(
                "the largest von Mises stress, {}, is above the yield stress, {}: the body yields, and stresses and pressures beyond that are not those of an elastic one",
                shown.value(largest.value, Measure::Pressure),
                shown.value(limit, Measure::Pressure)
            ),
        }));
    }
    if !file.problem().is_dimensionless() {
        let bare = arguments.yield_stress.as_ref().and_then(|text| text.trim().parse().ok());
        doubts.extend(bare.and_then(|stress| Warning::low_yield_stress("--yield-stress", stress)));
    }
    doubts
}

/// The loads at first yield, or why there are none.
pub(super) fn loads_at_yield(
    file: &ProblemFile,
    stress: f64,
    ratio: f64,
) -> Result<Result<Vec<YieldReport>, String>, Failure> {
    let shown = Shown::of(file.problem(), file.units());
    let mut loads = Vec::new();
    for criterion in [Criterion::VonMises, Criterion::Tresca] {
        match file.problem().first_yield(criterion, stress, Some(ratio)) {
            Ok(load) => loads.push(load.into()),
            Err(Error::NoYield { yield_stress, nearest }) => {
                return Ok(Err(report::no_yield(yield_stress, nearest, &shown)));
            }
            Err(error) => return Err(file.locate(error).into()),
        }
    }
    Ok(Ok(loads))
}

fn stresses_at(field: &StressField, places: Vec<[f64; 2]>) -> Result<Stresses, Failure> {
    let stresses =
        places.iter().map(|[x, y]| field.stress(*x, *y)).collect::<Result<Vec<_>, _>>()?;
    let (x, y) = places.into_iter().map(|[x, y]| (x, y)).unzip();
    Ok(Stresses { x, y, is_grid: false, stresses })
}

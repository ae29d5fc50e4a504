//! `shtaerman find`.

use shtaerman::file::ProblemFile;
use shtaerman::inverse::{self, Found, Goal, Normalisation};
use shtaerman::quantity::{self, Dimension};
use shtaerman::{Contact, Error, Warning};

use super::sheet::{self, ReportFile};
use super::{places, problem_file};
use crate::Failure;
use crate::arguments::{
    FindArguments, FindCrownArguments, FindForceArguments, FindProfileArguments,
    FindRoughnessArguments, OutputArguments, ProblemArguments, ReportFormat, SenseArguments,
    UnitArguments, Unknown, Zero,
};
use crate::failure;
use crate::output::{Content, Outputs};
use crate::plot::{Arrangement, Curve, CurvePanel, CurveScaling, CurvesPlot, Size};
use crate::report::{CrownReport, Entry, FoundReport, ShapedReport, Sheet, Told};

/// The option of a pressure that is wanted.
const PEAK_PRESSURE: &str = "--peak-pressure";

pub(super) fn run(arguments: &FindArguments) -> Result<(), Failure> {
    match &arguments.unknown {
        Unknown::Force(arguments) => force(arguments),
        Unknown::Roughness(arguments) => roughness(arguments),
        Unknown::Crown(arguments) => crown(arguments),
        Unknown::Profile(arguments) => profile(arguments),
    }
}

fn force(arguments: &FindForceArguments) -> Result<(), Failure> {
    let report_file = ReportFile::of(&arguments.report)?;
    let file = read(&arguments.problem, &arguments.units, &arguments.output, report_file.as_ref())?;
    let doubt = doubt(&file, arguments.peak_pressure.as_deref());
    let input = [file.input_checks(), doubt.clone()].concat();
    problem_file::check_doubts(input, &arguments.sense, arguments.output.is_table())?;
    let FindForceArguments { peak_pressure, contact_width, .. } = arguments;
    let goal = goal(&file, [peak_pressure, contact_width, &None])?;
    let given = given([peak_pressure, contact_width, &None]);
    let found = located(&file, inverse::force(file.problem(), goal))?;
    let found = audited(&file, found, arguments.no_audit)?;
    let name = problem_file::name(&arguments.problem.file);
    let mut report = FoundReport::force(file.problem(), &found, file.units());
    let warnings = warnings(&file, &found.contact, doubt, &arguments.sense)?;
    say(&arguments.output, &warnings);
    report.warn(warnings);
    let sheet = || {
        let title = format!("Force for a goal: {name}");
        of_contact(&title, &report.table(&name, &found), &file, &found.contact, given)
    };
    write(
        &arguments.output,
        report_file.as_ref(),
        sheet,
        || report.table(&name, &found),
        || Content::json(&report),
        || report.csv(),
    )
}

fn roughness(arguments: &FindRoughnessArguments) -> Result<(), Failure> {
    let report_file = ReportFile::of(&arguments.report)?;
    let file = read(&arguments.problem, &arguments.units, &arguments.output, report_file.as_ref())?;
    let doubt = doubt(&file, arguments.peak_pressure.as_deref());
    let input = [file.input_checks(), doubt.clone()].concat();
    problem_file::check_doubts(input, &arguments.sense, arguments.output.is_table())?;
    let FindRoughnessArguments { peak_pressure, contact_width, settlement, .. } = arguments;
    let goal = goal(&file, [peak_pressure, contact_width, settlement])?;
    let given = given([peak_pressure, contact_width, settlement]);
    let found = located(&file, inverse::roughness(file.problem(), goal))?;
    let found = audited(&file, found, arguments.no_audit)?;
    let name = problem_file::name(&arguments.problem.file);
    let mut report = FoundReport::roughness(file.problem(), &found, file.units());
    let warnings = warnings(&file, &found.contact, doubt, &arguments.sense)?;
    say(&arguments.output, &warnings);
    report.warn(warnings);
    let sheet = || {
        let title = format!("Roughness for a goal: {name}");
        of_contact(&title, &report.table(&name, &found), &file, &found.contact, given)
    };
    write(
        &arguments.output,
        report_file.as_ref(),
        sheet,
        || report.table(&name, &found),
        || Content::json(&report),
        || report.csv(),
    )
}

fn crown(arguments: &FindCrownArguments) -> Result<(), Failure> {
    let report_file = ReportFile::of(&arguments.report)?;
    let file = read(&arguments.problem, &arguments.units, &arguments.output, report_file.as_ref())?;
    let doubt = doubt(&file, arguments.peak_pressure.as_deref());
    let input = [file.input_checks(), doubt.clone()].concat();
    problem_file::check_doubts(input, &arguments.sense, arguments.output.is_table())?;
    let limit = arguments
        .peak_pressure
        .as_deref()
        .map(|text| positive(&file, PEAK_PRESSURE, text, Dimension::PRESSURE))
        .transpose()?;
    let mut crown = located(&file, inverse::crown(file.problem(), limit))?;
    if !arguments.no_audit {
        for crowned in
            std::iter::once(&mut crown.best).chain(&mut crown.least).chain(&mut crown.largest)
        {
            crowned.contact = located(&file, crowned.contact.clone().audited())?;
        }
    }
    let name = problem_file::name(&arguments.problem.file);
    let warnings = warnings(&file, &crown.best.contact, doubt, &arguments.sense)?;
    say(&arguments.output, &warnings);
    let report = CrownReport::new(&crown, file.units(), warnings);
    let sheet = || {
        let title = format!("Crown: {name}");
        let given = given([&arguments.peak_pressure, &None, &None]);
        of_contact(&title, &report.table(&name), &file, &crown.best.contact, given)
    };
    write(
        &arguments.output,
        report_file.as_ref(),
        sheet,
        || report.table(&name),
        || Content::json(&report),
        || report.csv(),
    )
}

fn profile(arguments: &FindProfileArguments) -> Result<(), Failure> {
    places::check_points(arguments.points)?;
    let report_file = ReportFile::of(&arguments.report)?;
    let file = read(&arguments.problem, &arguments.units, &arguments.output, report_file.as_ref())?;
    problem_file::check_input(&file, &SenseArguments::default(), false)?;
    let normalisation = match arguments.zero {
        Zero::Centre => Normalisation::Centre,
        Zero::Lowest => Normalisation::Lowest,
    };
    let pressure = &arguments.pressure;
    let shaped = inverse::prescribed_pressure(
        file.problem(),
        pressure,
        normalisation,
        arguments.points.max(3),
    );
    let shaped = located(&file, shaped)?;
    let name = problem_file::name(&arguments.problem.file);
    let report = ShapedReport::new(file.problem(), file.units(), pressure, shaped);
    let sheet = || {
        let title = format!("Profile for a pressure: {name}");
        let mut sheet = sheet::of_file(&title, &sheet::command(), &report.table(&name), &file);
        sheet.options(sheet::options(&[("--pressure", Some(pressure))]));
        let size = Some(Size { width: 860, height: 480 });
        sheet.picture("The profile found, and the pressure under it.", &shape(&report), size)?;
        Ok(sheet)
    };
    write(
        &arguments.output,
        report_file.as_ref(),
        sheet,
        || report.table(&name),
        || Content::json(&report),
        || report.csv(),
    )
}

fn read(
    problem: &ProblemArguments,
    units: &UnitArguments,
    output: &OutputArguments,
    report: Option<&ReportFile<'_>>,
) -> Result<ProblemFile, Failure> {
    let outputs = [output.output.as_deref(), report.map(|report| report.path)];
    problem_file::read(problem, units, &outputs)
}

/// The report of a contact that was found.
fn of_contact(
    title: &str,
    told: &Told,
    file: &ProblemFile,
    contact: &Contact,
    given: Vec<Entry>,
) -> Result<Sheet, Failure> {
    let doubts = file.sense_checks(contact);
    let found = (contact, doubts.as_slice());
    let mut sheet = sheet::of_contact([title, ""], &sheet::command(), told, file, found)?;
    sheet.options(given);
    sheet.contact(contact, file.units())?;
    Ok(sheet)
}

/// What was wanted, as inputs of a report.
fn given([peak_pressure, contact_width, settlement]: [&Option<String>; 3]) -> Vec<Entry> {
    sheet::options(&[
        (PEAK_PRESSURE, peak_pressure.as_deref()),
        ("--contact-width", contact_width.as_deref()),
        ("--settlement", settlement.as_deref()),
    ])
}

/// A profile and its pressure, each over the base.
fn shape(report: &ShapedReport) -> CurvesPlot {
    let panel = |(name, points): (String, Vec<(f64, f64)>)| CurvePanel {
        heading: name.clone(),
        curves: vec![Curve { name, points }],
    };
    CurvesPlot {
        title: String::new(),
        notes: Vec::new(),
        panels: report.curves().map(panel).into(),
        scaling: CurveScaling::Normalised,
        arrangement: Arrangement::SideBySide,
        horizontal_label: report.position_label().to_owned(),
        vertical_label: "of the largest".to_owned(),
    }
}

fn located<T>(file: &ProblemFile, result: Result<T, Error>) -> Result<T, Failure> {
    result.map_err(|error| file.locate(error).into())
}

/// What a user should know about the contact found, and what an engineer would doubt.
fn warnings(
    file: &ProblemFile,
    contact: &Contact,
    of_goal: Vec<Warning>,
    sense: &SenseArguments,
) -> Result<Vec<Warning>, Failure> {
    let doubts = problem_file::doubts(file, contact, sense)?;
    Ok([contact.warnings_in(file.units()), doubts, of_goal].concat())
}

/// A pressure that is wanted and has no unit, below any that would be sought in pascals: as low as a yield stress that is doubted.
fn doubt(file: &ProblemFile, text: Option<&str>) -> Vec<Warning> {
    let is_physical = !file.problem().is_dimensionless();
    let read = text.filter(|_| is_physical).and_then(|text| quantity::parse(text).ok());
    let bare = read.filter(|read| !read.unit_written()).map(|read| read.value);
    bare.and_then(|value| Warning::low_peak_pressure(PEAK_PRESSURE, value)).into_iter().collect()
}

/// Says the warnings that the result itself does not show.
fn say(output: &OutputArguments, warnings: &[Warning]) {
    if output.format != ReportFormat::Table || output.output.is_some() {
        warnings.iter().for_each(|warning| failure::warn(&warning.message));
    }
}

/// What was found with the audit of its contact.
fn audited(file: &ProblemFile, found: Found, is_left_out: bool) -> Result<Found, Failure> {
    if is_left_out {
        return Ok(found);
    }
    let contact = located(file, found.contact.audited())?;
    Ok(Found { contact, ..found })
}

/// The one of peak pressure, contact width and settlement that is wanted.
fn goal(
    file: &ProblemFile,
    [peak_pressure, contact_width, settlement]: [&Option<String>; 3],
) -> Result<Goal, Failure> {
    if let Some(text) = peak_pressure {
        let value = positive(file, PEAK_PRESSURE, text, Dimension::PRESSURE)?;
        return Ok(Goal::PeakPressure(value));
    }
    if let Some(text) = contact_width {
        let value = positive(file, "--contact-width", text, Dimension::LENGTH)?;
        return Ok(Goal::ContactWidth(value));
    }
    match settlement {
        Some(text) => Ok(Goal::Settlement(number(file, "--settlement", text, Dimension::LENGTH)?)),
        None => Err(Failure::Usage("nothing is wanted".to_owned())),
    }
}

fn positive(
    file: &ProblemFile,
    option: &str,
    text: &str,
    dimension: Dimension,
) -> Result<f64, Failure> {
    let value = number(file, option, text, dimension)?;
    if value > 0.0 {
        return Ok(value);
    }
    Err(Failure::Usage(format!("{option} `{text}`: must be greater than zero")))
}

/// A quantity in the units of the problem.
fn number(
    file: &ProblemFile,
    option: &str,
    text: &str,
    dimension: Dimension,
) -> Result<f64, Failure> {
    let physical = !file.problem().is_dimensionless();
    places::quantity(option, text, if physical { dimension } else { Dimension::NONE })
}

/// Writes the result in the format asked for.
fn write<'a>(
    output: &OutputArguments,
    report: Option<&ReportFile<'_>>,
    sheet: impl FnOnce() -> Result<Sheet, Failure>,
    table: impl FnOnce() -> Told,
    json: impl FnOnce() -> Content<'a>,
    csv: impl FnOnce() -> Content<'a>,
) -> Result<(), Failure> {
    let text = match output.format {
        ReportFormat::Table => Content::page(&table().to_string()),
        ReportFormat::Json => json(),
        ReportFormat::Csv => csv(),
    };
    let mut outputs = Outputs::default();
    outputs.result(output.output.as_deref(), text);
    if let Some(report) = report {
        report.add(&mut outputs, &sheet()?, output.is_table())?;
    }
    outputs.write()
}

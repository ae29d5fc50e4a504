//! `shtaerman solve`.

use std::fmt::Write;
use std::path::Path;

use shtaerman::file::ProblemFile;
use shtaerman::quantity::{Dimension, Measure, OutputUnits};
use shtaerman::{Answer, Contact, Datum, Geometry, PressureCurve, Problem, SurfaceCurve, Warning};

use super::picture::Picture;
use super::problem_file::Solved;
use super::sheet::{self, ReportFile};
use super::{places, problem_file, vary};
use crate::arguments::{ReportFormat, SolveArguments};
use crate::failure::{self, shown};
use crate::output::{Content, Outputs};
use crate::report::{ContactPicture, Sheet, Shown, contact_picture};
use crate::{Failure, clock, report};

/// The most periods that a picture shows.
const MOST_PERIODS: f64 = 100.0;
/// A place this far beyond an edge, in half-widths, is the edge: units round (200 mil and 5.08 mm).
const EDGE_SLACK: f64 = 1e-12;

pub(super) fn run(arguments: &SolveArguments) -> Result<(), Failure> {
    if !arguments.vary.is_empty() {
        return vary::run(arguments);
    }
    let picture = Picture::new(arguments.plot.as_deref(), &arguments.picture)?;
    let report = ReportFile::of(&arguments.report)?;
    let report_path = report.as_ref().map(|report| report.path);
    let outputs = [arguments.output.output.as_deref(), arguments.plot.as_deref(), report_path];
    places::check_points(arguments.points)?;
    let file = problem_file::read(&arguments.problem, &arguments.units, &outputs)?;
    problem_file::check_input(&file, &arguments.sense, arguments.output.is_table())?;
    let places = arguments.at.as_deref().map(|text| parse_places(text, &file)).transpose()?;
    let window = arguments.x_range.as_deref().map(|text| window(text, &file)).transpose()?;
    let extras = Extras::new(arguments, file.problem())?;
    let (contact, over) = match problem_file::solved(&file, !arguments.no_audit)? {
        Solved::Answer(contact) => (contact, None),
        Solved::Unfinished(contact, limit) => (contact, Some(limit)),
    };
    let doubts = problem_file::doubts(&file, &contact, &arguments.sense)?;
    clock::answered("its curve");
    let curve = match places {
        Some(places) => PressureCurve::at(&contact, places)?,
        None => PressureCurve::along(&contact, arguments.points)?,
    };
    let mut answer = Answer::new(&contact, curve);
    answer.warnings = [contact.warnings_in(file.units()), doubts].concat();
    if let Some(limit) = over {
        let mut outputs = Outputs::default();
        outputs.result(None, text(arguments, &contact, &answer, file.units(), None));
        outputs.write()?;
        warn(arguments, &answer);
        return Err(Failure::Unfinished(limit));
    }
    clock::answered("what was asked for beside it, such as sensitivities,");
    let mut answer = extended(answer, &contact, &extras)?;
    // An answer that cannot be checked is an answer all the same.
    let mut unchecked = None;
    if arguments.cross_check {
        clock::answered("its cross-check");
        match file.problem().cross_check(&contact) {
            Ok(check) => answer.cross_check = Some(check),
            Err(error) => unchecked = Some(Failure::from(file.locate(error))),
        }
    }
    let mut outputs = Outputs::default();
    let text = text(arguments, &contact, &answer, file.units(), arguments.plot.as_deref());
    outputs.result(arguments.output.output.as_deref(), text);
    if let Some(picture) = picture {
        clock::answered("its plot");
        let wanted = ContactPicture {
            name: problem_file::stem(&arguments.problem.file),
            title: arguments.picture.title.clone(),
            x_range: window,
            units: file.units().clone(),
        };
        picture.draw(&contact_picture(&contact, &wanted)?, &mut outputs)?;
    }
    if let Some(report) = &report {
        clock::answered("its report");
        let sheet = sheet(arguments, &file, &contact, &answer)?;
        report.add(&mut outputs, &sheet, arguments.output.is_table())?;
    }
    outputs.write()?;
    warn(arguments, &answer);
    match &answer.cross_check {
        Some(check) if !check.agrees => Err(Failure::Check(format!(
            "the reference, {}, differs by more than it and the answer state: pressure {:.1e}, settlement {:.1e}, tilt {:.1e}, force {:.1e}, moment {:.1e}, without dimensions",
            check.method.replace('_', " "),
            check.pressure,
            check.settlement,
            check.tilt,
            check.force,
            check.moment
        ))),
        _ => unchecked.map_or(Ok(()), Err),
    }
}

/// The ends of `--x-range`, with some of the base between them.
fn window(text: &str, file: &ProblemFile) -> Result<[f64; 2], Failure> {
    let problem = file.problem();
    let dimension = if problem.is_dimensionless() { Dimension::NONE } else { Dimension::LENGTH };
    let window = places::range("--x-range", text, dimension)?;
    let refused = |words: String| Failure::Usage(format!("--x-range {text}: {words}"));
    let shown = Shown::of(problem, file.units());
    let length = |x: f64| shown.value(x, Measure::Length);
    let punch = problem.punch();
    let period = match punch.geometry() {
        Geometry::Periodic { period } => Some(period),
        _ => None,
    };
    if let Some(period) = period.filter(|period| (window[1] - window[0]) / period > MOST_PERIODS) {
        return Err(refused(format!(
            "shows more than {MOST_PERIODS} periods of {}",
            length(period)
        )));
    }
    let pieces = || punch.pieces().into_iter().map(|piece| piece.map(|xi| xi * punch.half_width()));
    let is_met = pieces().any(|piece| is_met(window, piece, period));
    if is_met {
        return Ok(window);
    }
    let ends: Vec<String> = pieces()
        .map(|[left, right]| format!("from {} to {}", length(left), length(right)))
        .collect();
    let again =
        period.map_or(String::new(), |period| format!(", and again every {}", length(period)));
    Err(refused(format!("lies beside the punch, which reaches {}{again}", ends.join(" and "))))
}

/// Whether a window has a part of a piece of the base, or of one of its repetitions.
fn is_met(window: [f64; 2], piece: [f64; 2], period: Option<f64>) -> bool {
    let overlaps = |shift: f64| window[0] < piece[1] + shift && piece[0] + shift < window[1];
    match period {
        // The first repetition that ends beyond the left end of the window.
        Some(period) => overlaps(period * (((window[0] - piece[1]) / period).floor() + 1.0)),
        None => overlaps(0.0),
    }
}

/// The answer in the format that was asked for, with the name of its plot.
fn text<'a>(
    arguments: &SolveArguments,
    contact: &Contact,
    answer: &'a Answer,
    units: &OutputUnits,
    plot: Option<&Path>,
) -> Content<'a> {
    match arguments.output.format {
        ReportFormat::Table => {
            let name = problem_file::name(&arguments.problem.file);
            let mut text =
                report::answer_table(&name, contact, answer, units, arguments.at.is_some());
            if let Some(path) = plot {
                let _ = writeln!(text, "plot: {}", shown(path));
            }
            Content::page(&text.to_string())
        }
        ReportFormat::Json => Content::json(answer),
        ReportFormat::Csv => report::answer_csv(answer, &Shown::of(contact.problem(), units)),
    }
}

/// The report of an answer.
fn sheet(
    arguments: &SolveArguments,
    file: &ProblemFile,
    contact: &Contact,
    answer: &Answer,
) -> Result<Sheet, Failure> {
    let name = problem_file::name(&arguments.problem.file);
    let with_places = arguments.at.is_some();
    let told = report::answer_table(&name, contact, answer, file.units(), with_places);
    let title = format!("Contact: {name}");
    let stem = problem_file::stem(&arguments.problem.file);
    let heads = [title.as_str(), &stem];
    let doubts = file.sense_checks(contact);
    let mut sheet = sheet::of_contact(heads, &sheet::command(), &told, file, (contact, &doubts))?;
    sheet.options(sheet::options(&[
        ("--at", arguments.at.as_deref()),
        ("--datum-distance", arguments.datum_distance.as_deref()),
        ("--datum-depth", arguments.datum_depth.as_deref()),
    ]));
    Ok(sheet)
}

/// Says the warnings that the result itself does not show.
fn warn(arguments: &SolveArguments, answer: &Answer) {
    if arguments.output.format != ReportFormat::Table || arguments.output.output.is_some() {
        for warning in &answer.warnings {
            failure::warn(&warning.message);
        }
    }
}

/// What was asked for beside the answer.
struct Extras {
    data: Vec<Datum>,
    surface: Option<usize>,
    sensitivities: Sensitivities,
}

/// Whether the answer has its sensitivities.
enum Sensitivities {
    /// Also where they take differences of eighteen more solves.
    Asked,
    /// In JSON, wherever the linearised equation gives them.
    IfLinearised,
    Left,
}

impl Extras {
    fn new(arguments: &SolveArguments, problem: &Problem) -> Result<Self, Failure> {
        let physical = !problem.is_dimensionless();
        let dimension = if physical { Dimension::LENGTH } else { Dimension::NONE };
        let mut data = Vec::new();
        if let Some(text) = &arguments.datum_distance {
            let distance = places::quantity("--datum-distance", text, dimension)?;
            data.push(Datum::Distance(distance));
        }
        if let Some(text) = &arguments.datum_depth {
            data.push(Datum::Depth(places::quantity("--datum-depth", text, dimension)?));
        }
        if let Some(count) = arguments.surface {
            places::check_count("--surface", count)?;
            if arguments.output.format == ReportFormat::Table {
                return Err(Failure::Usage("--surface goes with --format json or csv".to_owned()));
            }
        }
        let sensitivities = match (arguments.sensitivities, arguments.output.format) {
            (true, _) => Sensitivities::Asked,
            (false, ReportFormat::Json) => Sensitivities::IfLinearised,
            (false, ReportFormat::Table | ReportFormat::Csv) => Sensitivities::Left,
        };
        Ok(Self { data, surface: arguments.surface, sensitivities })
    }
}

/// The answer with these warnings, where nothing is asked for beside it: as `--format json` writes it, or as the table shows it.
pub(super) fn answer(
    contact: &Contact,
    curve: PressureCurve,
    warnings: Vec<Warning>,
    is_for_people: bool,
) -> Result<Answer, Failure> {
    let sensitivities =
        if is_for_people { Sensitivities::Left } else { Sensitivities::IfLinearised };
    let extras = Extras { data: Vec::new(), surface: None, sensitivities };
    let mut answer = Answer::new(contact, curve);
    answer.warnings = warnings;
    extended(answer, contact, &extras)
}

fn extended(answer: Answer, contact: &Contact, extras: &Extras) -> Result<Answer, Failure> {
    let relative = extras.data.iter().map(|datum| contact.relative_settlement(*datum));
    let mut answer = answer.with_relative_settlement(relative.collect::<Result<_, _>>()?);
    if contact.is_nearly_smooth() {
        answer = answer.with_implied_edge_pressure(contact.implied_edge_pressures());
    }
    if let Some(count) = extras.surface {
        answer.surface = Some(SurfaceCurve::new(contact, count)?);
    }
    let found = match extras.sensitivities {
        Sensitivities::Asked => Some(contact.sensitivities()?),
        Sensitivities::IfLinearised => contact.tangent_sensitivities(),
        Sensitivities::Left => None,
    };
    if let Some(found) = found {
        answer = answer.with_sensitivities(found);
    }
    Ok(answer)
}

/// The places of `--at`: lengths, or bare numbers for a dimensionless problem.
fn parse_places(text: &str, file: &ProblemFile) -> Result<Vec<f64>, Failure> {
    let problem = file.problem();
    let dimension = if problem.is_dimensionless() { Dimension::NONE } else { Dimension::LENGTH };
    let half_width = problem.punch().half_width();
    let shown = Shown::of(problem, file.units());
    places::parse(text, dimension, &|place| {
        if place.abs() <= half_width {
            return Ok(place);
        }
        if place.abs() <= half_width * (1.0 + EDGE_SLACK) {
            return Ok(half_width.copysign(place));
        }
        Err(format!(
            "is beyond the punch, which reaches from {} to {}",
            shown.value(-half_width, Measure::Length),
            shown.value(half_width, Measure::Length)
        ))
    })
}

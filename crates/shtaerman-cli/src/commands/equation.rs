//! `shtaerman equation`.

use std::fmt::Write;
use std::time::Duration;

use shtaerman::equation::{EquationAnswer, EquationFile, Kind, SolvedEquation};
use shtaerman::quantity::Dimension;

use super::picture::Picture;
use super::sheet::{self, ReportFile};
use super::{places, problem_file};
use crate::arguments::{EquationArguments, ReportFormat};
use crate::failure::{self, shown};
use crate::output::{Content, Input, Outputs, check_writable, interrupt};
use crate::plot::{Size, SolutionPlot};
use crate::report::{self, Sheet};
use crate::{Failure, clock};

/// Points of the curve, where no number is asked for.
pub(super) const POINTS: usize = 201;
/// Points of the plotted curve.
const PLOT_POINTS: usize = 401;

pub(super) fn run(arguments: &EquationArguments) -> Result<(), Failure> {
    let picture = Picture::new(arguments.plot.as_deref(), &arguments.picture)?;
    let input = Input { what: "the problem file", path: &arguments.file };
    let report_file = ReportFile::of(&arguments.report)?;
    let report_path = report_file.as_ref().map(|report| report.path);
    let outputs = [arguments.output.output.as_deref(), arguments.plot.as_deref(), report_path];
    check_writable(&outputs, &[input])?;
    places::check_points(arguments.points)?;
    let file = problem_file::read_equation(&arguments.file, &arguments.overrides)?;
    let limit = arguments.time_limit.as_deref().map(problem_file::time_limit).transpose()?;
    // Longer than any computer runs is no limit.
    let limit = limit.and_then(|limit| Duration::try_from_secs_f64(limit).ok());
    clock::start(limit, Failure::Unsolved, interrupt);
    if arguments.cross_check && file.equation().kind() == Kind::First {
        return Err(Failure::Usage(format!("--cross-check: {}", shtaerman::Error::NoOtherMethod)));
    }
    let window = (arguments.x_range.as_deref()).map(|text| window(text, &file)).transpose()?;
    let name = problem_file::stem(&arguments.file);
    let asked = arguments.at.as_deref().map(|text| parse_places(text, &file)).transpose()?;
    let drawn = window.filter(|_| picture.is_some()).map(|[_, to]| to);
    let reach = asked.iter().flatten().copied().chain(drawn).fold(0.0, f64::max);
    let solved = file.equation().solve_to(reach).map_err(|error| file.locate(error))?;
    clock::answered("its audit");
    let solved = if arguments.no_audit {
        solved
    } else {
        solved.audited().map_err(|error| file.locate(error))?
    };
    let points = match asked {
        Some(points) => points,
        None => solved.places(arguments.points)?,
    };
    let mut answer = solved.answer(points).map_err(|error| file.locate(error))?;
    clock::answered("what was asked for beside it, such as a plot,");
    if arguments.cross_check {
        answer.cross_check = Some(solved.cross_check().map_err(|error| file.locate(error))?);
    }
    let mut outputs = Outputs::default();
    outputs.result(arguments.output.output.as_deref(), content(arguments, &solved, &answer)?);
    if let Some(picture) = picture {
        let plot = plot(&name, &solved, &answer, window).map_err(|error| file.locate(error))?;
        picture.draw(&plot, &mut outputs)?;
    }
    if let Some(path) = &report_file {
        let sheet = sheet(arguments, &file, &solved, &answer)?;
        path.add(&mut outputs, &sheet, arguments.output.is_table())?;
    }
    outputs.write()?;
    if arguments.output.format != ReportFormat::Table || arguments.output.output.is_some() {
        for warning in solved.warnings() {
            failure::warn(&warning.message);
        }
    }
    verdict(&answer)
}

/// The ends of `--x-range`, with some of the interval between them.
fn window(text: &str, file: &EquationFile) -> Result<[f64; 2], Failure> {
    let window = places::range("--x-range", text, Dimension::NONE)?;
    let interval = file.equation().kernel().kernel().interval();
    if window[0] < interval.right() && interval.left() < window[1] {
        return Ok(window);
    }
    let [left, right] = [interval.left(), interval.right()];
    let reaches = match right.is_finite() {
        true => format!("reaches from {left} to {right}"),
        false => format!("begins at {left}"),
    };
    Err(Failure::Usage(format!("--x-range {text}: lies beside the interval, which {reaches}")))
}

fn content<'a>(
    arguments: &EquationArguments,
    solved: &SolvedEquation<'_>,
    answer: &'a EquationAnswer<'_>,
) -> Result<Content<'a>, Failure> {
    Ok(match arguments.output.format {
        ReportFormat::Table => {
            let name = problem_file::name(&arguments.file);
            let mut text = report::equation_table(&name, solved, answer, arguments.at.is_some())?;
            if let Some(path) = &arguments.plot {
                let _ = writeln!(text, "plot: {}", shown(path));
            }
            Content::page(&text.to_string())
        }
        ReportFormat::Json => Content::json(answer),
        ReportFormat::Csv => report::equation_csv(answer),
    })
}

/// The report of a solution.
fn sheet(
    arguments: &EquationArguments,
    file: &EquationFile,
    solved: &SolvedEquation<'_>,
    answer: &EquationAnswer<'_>,
) -> Result<Sheet, Failure> {
    let name = problem_file::name(&arguments.file);
    let told = report::equation_table(&name, solved, answer, arguments.at.is_some())?;
    let mut sheet = Sheet::new(&format!("Integral equation: {name}"), &sheet::command(), &told);
    sheet.document(file.document());
    sheet.options(sheet::options(&[("--at", arguments.at.as_deref())]));
    sheet.equation(file.equation());
    let stem = problem_file::stem(&arguments.file);
    let plot = plot(&stem, solved, answer, None).map_err(|error| file.locate(error))?;
    sheet.picture("The solution.", &plot, Some(Size { width: 860, height: 420 }))?;
    Ok(sheet)
}

/// The failure of a cross-check that found more than both errors allow.
fn verdict(answer: &EquationAnswer<'_>) -> Result<(), Failure> {
    match &answer.cross_check {
        Some(check) if !check.agrees => Err(Failure::Check(format!(
            "the methods differ by more than the errors they state: solution {:.1e}, allowed {:.1e}; integral {:.1e}, allowed {:.1e}",
            check.solution_sup,
            check.solution_allowed,
            check.integral.unwrap_or(0.0),
            check.integral_allowed.unwrap_or(0.0)
        ))),
        _ => Ok(()),
    }
}

fn parse_places(text: &str, file: &EquationFile) -> Result<Vec<f64>, Failure> {
    places::parse(text, Dimension::NONE, &|x| {
        file.equation().place(x).map_err(|error| {
            let words = error.to_string();
            words.split_once(" is ").map_or(words.clone(), |(_, rest)| format!("is {rest}"))
        })
    })
}

fn plot(
    name: &str,
    solved: &SolvedEquation<'_>,
    answer: &EquationAnswer<'_>,
    window: Option<[f64; 2]>,
) -> Result<SolutionPlot, shtaerman::Error> {
    let equation = solved.equation();
    let mut places = solved.places(PLOT_POINTS)?;
    if let (Some([from, to]), [left, .., right]) = (window, places.as_slice()) {
        let (from, to) = (from.max(*left), to.min(right.max(solved.reach())));
        let step = (to - from) / PLOT_POINTS as f64;
        places.extend((1..PLOT_POINTS).map(|index| from + step * index as f64));
        places.retain(|x| equation.place(*x).is_ok());
        places.sort_by(f64::total_cmp);
        places.dedup();
    }
    let evaluate = |places: &[f64]| -> Result<[Vec<f64>; 1], shtaerman::Error> {
        let value = |&x: &f64| Ok(solved.evaluate(x)?.unwrap_or(f64::INFINITY));
        Ok([places.iter().map(value).collect::<Result<_, shtaerman::Error>>()?])
    };
    let known = evaluate(&places)?;
    let shown = window.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
    let [values] = report::between(&mut places, known, shown, evaluate)?;
    let values = signed(values);
    let error = answer.error.solution_sup.filter(|_| equation.kind() != Kind::First);
    let kind = match equation.kind() {
        Kind::Second { lambda } => {
            format!("φ + λ ∫ K φ = f, λ = {}", report::significant(lambda, 6))
        }
        Kind::First => "∫ K φ = f".to_owned(),
    };
    Ok(SolutionPlot {
        title: match report::heading(name) {
            Some(name) => format!("{name}: {kind}, f = {}", equation.right_hand_side()),
            None => format!("{kind}, f = {}", equation.right_hand_side()),
        },
        notes: vec![
            symbols(&format!(
                "{}: K = {}",
                equation.kernel().title(),
                equation.kernel().family().formula
            )),
            format!("{}, n = {}; {}", method(solved.method()), solved.size(), sureness(answer)),
        ],
        points: places.into_iter().zip(values).collect(),
        error: error.map(|error| (error, format!("error ({})", answer.error.kind.name()))),
        window,
        horizontal_label: "x".to_owned(),
        vertical_label: "φ".to_owned(),
    })
}

/// Infinite values with the sign of those beside them.
fn signed(mut values: Vec<f64>) -> Vec<f64> {
    for index in 0..values.len() {
        if values[index].is_infinite() {
            let beside = [index.wrapping_sub(1), index + 1];
            let finite = beside.iter().filter_map(|at| values.get(*at)).find(|v| v.is_finite());
            values[index] = finite.map_or(f64::INFINITY, |value| f64::INFINITY.copysign(*value));
        }
    }
    values
}

/// The method in words.
fn method(name: &str) -> &str {
    match name {
        "spectral" => "degenerate kernel",
        "sinc" => "sinc collocation",
        other => other,
    }
}

/// Formulas as they are printed.
fn symbols(text: &str) -> String {
    let printed =
        [("^2", "²"), ("^3", "³"), ("lambda", "λ"), ("phi", "φ"), ("theta", "θ"), (" - ", " − ")];
    printed.iter().fold(text.to_owned(), |text, (plain, symbol)| text.replace(plain, symbol))
}

/// How sure the answer is.
fn sureness(answer: &EquationAnswer<'_>) -> String {
    let kind = answer.error.kind.name();
    match answer.error.solution_sup {
        Some(error) => {
            let of = symbols(answer.error.of);
            format!("error of {of} at most {} ({kind})", report::significant(error, 2))
        }
        None => "error unknown".to_owned(),
    }
}

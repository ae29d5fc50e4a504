//! `shtaerman sweep`.

use std::io::{IsTerminal, Write, stderr};
use std::path::Path;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use shtaerman::document::{load_bytes, overridden};
use shtaerman::file::ProblemFile;
use shtaerman_study::{Part, Row, Study, Summary};

use super::picture::{Picture, Titled};
use super::problem_file;
use super::sheet::{self, ReportFile};
use super::study_sense;
use crate::Failure;
use crate::arguments::SweepArguments;
use crate::failure;
use crate::output::{Content, Input, Outputs, check_writable};
use crate::plot::Size;
use crate::report::{self, Sheet, StudyUnits, Told};
use crate::results::{Results, processors};

/// Studies of more cases ask first.
const MANY: usize = 1_000_000;
/// Most threads.
const MOST_THREADS: usize = 1024;
/// How often the line of progress is written anew.
const TICK: Duration = Duration::from_millis(250);

pub(super) fn run(arguments: &SweepArguments) -> Result<(), Failure> {
    arguments.format.check()?;
    let picture = Picture::new(arguments.plot.as_deref(), &arguments.picture)?;
    let threads = threads(arguments.threads)?;
    let shard = arguments.shard.as_deref().map_or(Ok(Shard::WHOLE), Shard::read)?;
    let study = Study::open(&arguments.file, &overrides(arguments)?).map_err(unlimited)?;
    let input = Input { what: "the study file", path: &arguments.file };
    let report_file = ReportFile::of(&arguments.report)?;
    let report_path = report_file.as_ref().map(|report| report.path);
    check_writable(&[arguments.plot.as_deref(), report_path], &[input])?;
    let shown: Vec<String> = problem_file::units_override(&arguments.units)?.into_iter().collect();
    let units = StudyUnits::new(&study, &shown).map_err(|error| {
        problem_file::of_units(&arguments.units, error).unwrap_or_else(Failure::from)
    })?;
    study_sense::check_input(&study, &shown, arguments.sense)?;
    check_size(&study, arguments.yes || arguments.summary)?;
    let name = arguments.file.file_name().unwrap_or(arguments.file.as_os_str());
    let name = failure::shown(Path::new(name));
    let results =
        Results::open(study, &name, &arguments.output, arguments.format, arguments.summary)?;
    let study = results.study();

    let mut run = Run::new(&results, threads);
    // Not kept in a list: a study may have billions of them.
    let chosen = || study.parts().skip(shard.index).step_by(shard.count);
    let total = shard.cases(study);
    for part in chosen() {
        run.take(&part, arguments.summary, total)?;
    }
    run.clear();
    if !arguments.summary {
        run.audit_sample(shard);
        results.sweep_out();
    }
    // A summary computes nothing, unless it is asked to be strict.
    if (!arguments.summary || arguments.sense.strict) && !study.is_dimensionless() {
        let found = study_sense::doubts(study, &run.summary, &shown, arguments.sense)?;
        run.sense = Some(found);
    }
    let mut outputs = Outputs::default();
    let table = report::sweep_table(study, &units, results.manifest(), &run.report(chosen().len()));
    outputs.result(None, Content::page(&table.to_string()));
    if let Some(report_file) = &report_file {
        let sheet = sheet(arguments, &name, &run, &units, &table)?;
        report_file.add(&mut outputs, &sheet, true)?;
    }
    if let Some(picture) = picture {
        let stem = problem_file::stem(&arguments.file);
        let (figure, size) =
            report::response(&stem, study, &units, &run.curves, Some(&run.summary))
                .map_err(Failure::Usage)?;
        picture.draw(&Titled { figure, size }, &mut outputs)?;
    }
    outputs.write()
}

/// The overrides, with that of the time limit.
fn overrides(arguments: &SweepArguments) -> Result<Vec<String>, Failure> {
    let limit = problem_file::limit_override(arguments.time_limit.as_deref())?;
    Ok(arguments.overrides.iter().cloned().chain(limit).collect())
}

/// The fault of a study; of a limit of time where there is none in the words of its option.
fn unlimited(error: shtaerman::Error) -> Failure {
    match &error {
        shtaerman::Error::File(fault)
            if fault.field() == Some(problem_file::LIMIT) && fault.file_name().is_none() =>
        {
            Failure::Usage(format!("--time-limit: {}", fault.message()))
        }
        _ => error.into(),
    }
}

/// The report of a study: that of the problem that it varies, with its response.
fn sheet(
    arguments: &SweepArguments,
    name: &str,
    run: &Run<'_>,
    units: &StudyUnits,
    told: &Told,
) -> Result<Sheet, Failure> {
    let bytes = load_bytes(&arguments.file).map_err(Failure::Usage)?;
    let document = overridden(&bytes, name, &overrides(arguments)?, "study.count=100")?;
    let mut sheet = Sheet::new(&format!("Study: {name}"), &sheet::command(), told);
    sheet.document(&document);
    let folder = arguments.file.parent().unwrap_or(Path::new(""));
    // What varies may be missing in the problem itself, which then has no model of its own.
    if let Ok(file) = ProblemFile::from_document(run.study.problem().clone(), folder) {
        sheet.problem(file.problem());
        sheet.varied();
    }
    if arguments.summary {
        sheet.unchecked("the run itself, without --summary, looks at the cases with the least and the largest of each output.");
    }
    // Where nothing can be drawn, the table stands alone.
    let stem = problem_file::stem(&arguments.file);
    let drawn = report::response(&stem, run.study, units, &run.curves, Some(&run.summary));
    if let Ok((figure, _)) = drawn {
        sheet.picture("The response.", &figure, Some(Size { width: 860, height: 560 }))?;
    }
    Ok(sheet)
}

fn threads(asked: Option<usize>) -> Result<usize, Failure> {
    match asked {
        Some(count) if (1..=MOST_THREADS).contains(&count) => Ok(count),
        Some(count) => {
            Err(Failure::Usage(format!("--threads {count}: must be from 1 to {MOST_THREADS}")))
        }
        None => Ok(processors()),
    }
}

/// One of several shares of the parts.
#[derive(Debug, Clone, Copy)]
struct Shard {
    index: usize,
    count: usize,
}

impl Shard {
    const WHOLE: Self = Self { index: 0, count: 1 };

    fn read(text: &str) -> Result<Self, Failure> {
        let numbers = text.split_once('/').and_then(|(index, count)| {
            Some((index.trim().parse::<usize>().ok()?, count.trim().parse::<usize>().ok()?))
        });
        match numbers {
            Some((index, count)) if (1..=count).contains(&index) => {
                Ok(Self { index: index - 1, count })
            }
            _ => Err(Failure::Usage(format!(
                "--shard `{text}`: must be I/N with I from 1 to N, such as 2/4"
            ))),
        }
    }

    /// Whether the part of a case is one of them.
    fn has(self, study: &Study, case: usize) -> bool {
        case / study.part_size() % self.count == self.index
    }

    /// How many cases it has.
    fn cases(self, study: &Study) -> usize {
        let parts = study.parts().len();
        let own = parts.saturating_sub(self.index).div_ceil(self.count);
        let size = study.part_size();
        // The last part may be a shorter one.
        let has_last = parts > 0 && (parts - 1) % self.count == self.index;
        own * size - if has_last { parts * size - study.cases() } else { 0 }
    }
}

/// Refuses what would run for days, unless that is wanted; the first case says how long one takes.
fn check_size(study: &Study, is_wanted: bool) -> Result<(), Failure> {
    if study.cases() <= MANY || is_wanted {
        return Ok(());
    }
    let start = Instant::now();
    let rows = study.solve(0..study.block());
    let each = start.elapsed().as_secs_f64() / rows.len() as f64;
    let bytes = study.fields(&rows[0]).iter().map(|field| field.len() + 1).sum::<usize>() as f64;
    let cases = study.cases() as f64;
    Err(Failure::Usage(format!(
        "the study has {} cases: at {:.1e} s and {bytes} bytes each some {:.1e} hours on one core and {:.1e} GB; --yes runs it, fewer values or design = \"sobol\" make it smaller",
        study.cases(),
        each,
        cases * each / 3600.0,
        cases * bytes / 1e9
    )))
}

/// A study on its way.
struct Run<'s> {
    results: &'s Results,
    study: &'s Study,
    threads: usize,
    summary: Summary,
    /// Parts that were there, were computed and are missing.
    parts: [usize; 3],
    /// For plots: the number of the case and its outputs.
    curves: Vec<Row>,
    audited: Vec<(Row, Row)>,
    /// How many cases with extremes were looked at, and the doubts about them.
    sense: Option<(usize, Vec<String>)>,
    progress: Progress,
}

impl<'s> Run<'s> {
    fn new(results: &'s Results, threads: usize) -> Self {
        let study = results.study();
        Self {
            results,
            study,
            threads,
            summary: Summary::new(study),
            parts: [0; 3],
            curves: Vec::new(),
            audited: Vec::new(),
            sense: None,
            progress: Progress::new(),
        }
    }

    /// Takes a part from its file, or computes and writes it.
    fn take(&mut self, part: &Part, is_read_only: bool, total: usize) -> Result<(), Failure> {
        let known = self.known(part)?;
        self.parts[usize::from(known.is_none()) + usize::from(known.is_none() && is_read_only)] +=
            1;
        let rows = match known {
            Some(rows) => rows,
            None if is_read_only => return Ok(()),
            None => {
                let rows =
                    self.results.solve(part, self.threads, &|done| self.progress.tell(done, total));
                self.progress.clear();
                self.results.write(part, &rows)?;
                rows
            }
        };
        self.progress.finished += rows.len();
        rows.iter().for_each(|row| self.summary.add(row));
        report::keep(&mut self.curves, rows);
        Ok(())
    }

    /// The rows of a part that is there and whole; one that is not is told and computed again.
    fn known(&self, part: &Part) -> Result<Option<Vec<Row>>, Failure> {
        match self.results.known(part)? {
            Some(Err(fault)) => {
                let path = self.results.path(part);
                let name = failure::shown(Path::new(path.file_name().unwrap_or(path.as_os_str())));
                failure::warn(&format!("{name}: {}: it is computed again", fault.0));
                Ok(None)
            }
            known => Ok(known.and_then(Result::ok)),
        }
    }

    /// Audits some of the cases of a shard, chosen by the seed of the study.
    fn audit_sample(&mut self, shard: Shard) {
        if self.study.is_audited() {
            return;
        }
        let chosen = self.study.audited_sample();
        self.audited = chosen
            .into_iter()
            .filter(|case| shard.has(self.study, *case))
            .flat_map(|case| self.study.solve(case..case + 1))
            .map(|row| (self.study.solve_audited(row.case), row))
            .map(|(audited, row)| (row, audited))
            .filter(|(row, _)| row.is_answered())
            .collect();
    }

    fn report(&self, parts: usize) -> report::SweepReport<'_> {
        let [kept, computed, missing] = self.parts;
        report::SweepReport {
            summary: &self.summary,
            parts,
            kept,
            computed,
            missing,
            audited: &self.audited,
            sense: self.sense.as_ref(),
        }
    }

    fn clear(&self) {
        self.progress.clear();
    }
}

/// A line on the terminal: how far it is, how fast, how long it will take.
struct Progress {
    since: Instant,
    is_seen: bool,
    finished: usize,
    last: Mutex<Option<Instant>>,
}

impl Progress {
    fn new() -> Self {
        Self {
            since: Instant::now(),
            is_seen: stderr().is_terminal() && !failure::is_quiet(),
            finished: 0,
            last: Mutex::new(None),
        }
    }

    fn tell(&self, more: usize, total: usize) {
        if !self.is_seen {
            return;
        }
        let mut last = self.last.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let elapsed = self.since.elapsed();
        if elapsed < TICK || last.is_some_and(|last| last.elapsed() < TICK) {
            return;
        }
        *last = Some(Instant::now());
        let done = self.finished + more;
        let rate = done as f64 / elapsed.as_secs_f64();
        let left = (total - done) as f64 / rate;
        let line = format!("\r\x1b[K{done} of {total} cases, {rate:.3} a second, {left:.0} s left");
        let _ = stderr().write_all(line.as_bytes());
    }

    fn clear(&self) {
        if self.is_seen {
            let _ = stderr().write_all(b"\r\x1b[K");
        }
    }
}

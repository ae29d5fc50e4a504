//! `shtaerman sweep`.

use std::io::{IsTerminal, Write, stderr};
use std::num::NonZero;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use shtaerman_study::{Manifest, Part, Row, Study, Summary};

use crate::Failure;
use crate::arguments::SweepArguments;
use crate::failure::{say, shown};
use crate::output::{Content, Input, Outputs, check_writable};
use crate::plot::{Format, Size, render};
use crate::report;

/// Studies of more cases ask first.
const MANY: usize = 1_000_000;
/// Most threads.
const MOST_THREADS: usize = 1024;
/// What the folder of results says of itself.
const MANIFEST: &str = "study.json";
/// Largest manifest and part that are read, in bytes.
const LARGEST_FILE: u64 = 1 << 30;
/// How often the line of progress is written anew.
const TICK: Duration = Duration::from_millis(250);

pub(super) fn run(arguments: &SweepArguments) -> Result<(), Failure> {
    let format = arguments.plot.as_deref().map(Format::of_file).transpose()?;
    let threads = threads(arguments.threads)?;
    let shard = arguments.shard.as_deref().map_or(Ok(Shard::WHOLE), Shard::read)?;
    let study = Study::open(&arguments.file, &arguments.overrides)?;
    let input = Input { what: "the study file", path: &arguments.file };
    check_writable(&[arguments.plot.as_deref()], &[input])?;
    check_size(&study, arguments.yes || arguments.summary)?;
    let name = arguments.file.file_name().unwrap_or(arguments.file.as_os_str());
    let manifest = study.manifest(&shown(Path::new(name)))?;
    prepare(&arguments.output, &manifest, arguments.summary)?;

    let mut run = Run::new(&study, &arguments.output, threads);
    let chosen: Vec<Part> = study.parts().filter(|part| shard.has(part)).collect();
    let total: usize = chosen.iter().map(|part| part.cases.len()).sum();
    for part in &chosen {
        run.take(part, arguments.summary, total)?;
    }
    run.clear();
    if !arguments.summary {
        run.audit_sample(&chosen);
    }
    let mut outputs = Outputs::default();
    outputs.result(None, report::sweep_table(&study, &manifest, &run.report(chosen.len())));
    if let (Some(path), Some(format)) = (&arguments.plot, format) {
        let plot = report::response(&study, &run.curves).map_err(Failure::Usage)?;
        outputs.file(path, render(&plot, format, Size::default())?);
    }
    outputs.write()
}

fn threads(asked: Option<usize>) -> Result<usize, Failure> {
    match asked {
        Some(count) if (1..=MOST_THREADS).contains(&count) => Ok(count),
        Some(count) => {
            Err(Failure::Usage(format!("--threads {count}: must be from 1 to {MOST_THREADS}")))
        }
        None => Ok(thread::available_parallelism().map_or(1, NonZero::get)),
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

    fn has(&self, part: &Part) -> bool {
        part.number % self.count == self.index
    }
}

/// Refuses what would run for days, unless that is wanted; the first case says how long one takes.
fn check_size(study: &Study, is_wanted: bool) -> Result<(), Failure> {
    if study.cases() <= MANY || is_wanted {
        return Ok(());
    }
    let start = Instant::now();
    let row = study.solve(0);
    let each = start.elapsed().as_secs_f64();
    let bytes = study.fields(&row).iter().map(|field| field.len() + 1).sum::<usize>() as f64;
    let cases = study.cases() as f64;
    Err(Failure::Usage(format!(
        "the study has {} cases: at {:.1e} s and {bytes} bytes each some {:.1e} hours on one core and {:.1e} GB; --yes runs it, fewer values or design = \"sobol\" make it smaller",
        study.cases(),
        each,
        cases * each / 3600.0,
        cases * bytes / 1e9
    )))
}

/// Makes the folder, or finds it to belong to this study.
fn prepare(folder: &Path, manifest: &Manifest, is_read_only: bool) -> Result<(), Failure> {
    let path = folder.join(MANIFEST);
    if !folder.exists() {
        if is_read_only {
            return Err(Failure::Usage(format!("there is no folder {}", shown(folder))));
        }
        std::fs::create_dir(folder).map_err(|error| Failure::unwritable(folder, &error))?;
    }
    if !folder.is_dir() {
        return Err(Failure::Usage(format!(
            "{} is a file: --output names a folder",
            shown(folder)
        )));
    }
    let Some(bytes) = read(&path)? else {
        let is_empty = folder
            .read_dir()
            .map_err(|error| Failure::unwritable(folder, &error))?
            .next()
            .is_none();
        if !is_empty || is_read_only {
            return Err(Failure::Usage(format!(
                "{} has no {MANIFEST}: it is no folder of results, take an empty one",
                shown(folder)
            )));
        }
        let mut outputs = Outputs::default();
        outputs.file(&path, Content::json(manifest));
        return outputs.write();
    };
    let known: Option<Manifest> = serde_json::from_slice(&bytes).ok();
    match known {
        Some(known) if known.belongs_with(manifest) => Ok(()),
        Some(known) => Err(Failure::Usage(different(folder, &known, manifest))),
        None => Err(Failure::Usage(format!(
            "{} is no manifest of a study: take another folder",
            shown(&path)
        ))),
    }
}

/// Says in what a folder differs from the study.
fn different(folder: &Path, known: &Manifest, manifest: &Manifest) -> String {
    let what = if known.version == manifest.version {
        format!("another study, {} with {} cases as it was then", known.study, known.cases)
    } else {
        format!("version {} of the program", known.version)
    };
    format!("{} has results of {what}: take another folder, or remove it", shown(folder))
}

/// The bytes of a file; none where it is not there.
fn read(path: &Path) -> Result<Option<Vec<u8>>, Failure> {
    match path.metadata() {
        Ok(metadata) if metadata.is_file() && metadata.len() <= LARGEST_FILE => {
            std::fs::read(path).map(Some).map_err(|error| Failure::unwritable(path, &error))
        }
        Ok(_) => Err(Failure::Usage(format!("{} is no file of results", shown(path)))),
        Err(_) => Ok(None),
    }
}

/// A study on its way.
struct Run<'s> {
    study: &'s Study,
    folder: &'s Path,
    threads: usize,
    summary: Summary,
    /// Parts that were there, were computed and are missing.
    parts: [usize; 3],
    /// For plots: the number of the case and its outputs.
    curves: Vec<Row>,
    audited: Vec<(Row, Row)>,
    progress: Progress,
}

impl<'s> Run<'s> {
    fn new(study: &'s Study, folder: &'s Path, threads: usize) -> Self {
        Self {
            study,
            folder,
            threads,
            summary: Summary::new(study),
            parts: [0; 3],
            curves: Vec::new(),
            audited: Vec::new(),
            progress: Progress::new(),
        }
    }

    /// Takes a part from its file, or computes and writes it.
    fn take(&mut self, part: &Part, is_read_only: bool, total: usize) -> Result<(), Failure> {
        let path = self.folder.join(part.file_name());
        let known = self.known(part, &path)?;
        self.parts[usize::from(known.is_none()) + usize::from(known.is_none() && is_read_only)] +=
            1;
        let rows = match known {
            Some(rows) => rows,
            None if is_read_only => return Ok(()),
            None => {
                let rows = self.solved(part, total);
                self.progress.clear();
                let heads = self.study.columns();
                let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
                let mut outputs = Outputs::default();
                outputs.file(
                    &path,
                    Content::csv(&heads, rows.iter().map(|row| self.study.fields(row))),
                );
                outputs.write()?;
                rows
            }
        };
        self.progress.finished += rows.len();
        rows.iter().for_each(|row| self.summary.add(row));
        report::keep(&mut self.curves, rows);
        Ok(())
    }

    /// The rows of a part that is there and whole; one that is not is told and computed again.
    fn known(&self, part: &Part, path: &Path) -> Result<Option<Vec<Row>>, Failure> {
        let Some(bytes) = read(path)? else { return Ok(None) };
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .from_reader(bytes.as_slice());
        let lines: Result<Vec<Vec<String>>, _> = reader
            .records()
            .map(|record| record.map(|fields| fields.iter().map(str::to_owned).collect()))
            .collect();
        let fault = match (lines, bytes.ends_with(b"\n")) {
            (Ok(lines), true) => match self.study.rows(part, &lines) {
                Ok(rows) => return Ok(Some(rows)),
                Err(fault) => fault.0,
            },
            _ => format!("{}: is cut short", part.file_name()),
        };
        say("warning", &format!("{fault}: it is computed again"));
        Ok(None)
    }

    /// The cases of a part on all threads; each row depends on its case alone.
    fn solved(&self, part: &Part, total: usize) -> Vec<Row> {
        let cases = part.cases.clone();
        let next = AtomicUsize::new(cases.start);
        let rows = Mutex::new(Vec::with_capacity(cases.len()));
        let work = || {
            loop {
                let case = next.fetch_add(1, Ordering::Relaxed);
                if case >= cases.end {
                    return;
                }
                let row = self.study.solve(case);
                let mut rows = rows.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
                rows.push(row);
                self.progress.tell(rows.len(), total);
            }
        };
        thread::scope(|scope| {
            for _ in 1..self.threads.min(cases.len()) {
                scope.spawn(work);
            }
            work();
        });
        let mut rows = rows.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
        rows.sort_by_key(|row| row.case);
        rows
    }

    /// Audits some of the cases of these parts, chosen by the seed of the study.
    fn audit_sample(&mut self, parts: &[Part]) {
        if self.study.is_audited() {
            return;
        }
        let chosen = self.study.audited_sample();
        let here = |case: usize| parts.iter().any(|part| part.cases.contains(&case));
        self.audited = chosen
            .into_iter()
            .filter(|case| here(*case))
            .map(|case| (self.study.solve(case), self.study.solve_audited(case)))
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
            is_seen: stderr().is_terminal(),
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

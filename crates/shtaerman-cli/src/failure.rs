//! Why a command ends without its result, and the exit code that says so.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError,
    MietteSpanContents, SourceCode, SourceSpan, SpanContents,
};
use shtaerman::document::FileError;
use shtaerman::legible;

use crate::plot::PlotError;
use crate::terminal::{has_colours, painted_message};

/// Why a command ends without its result.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    /// The arguments make no sense.
    #[error("{0}")]
    Usage(String),
    /// The problem has no answer.
    #[error(transparent)]
    Problem(#[from] shtaerman::Error),
    /// A plot cannot be drawn.
    #[error(transparent)]
    Plot(#[from] PlotError),
    /// There can be no file at the place named.
    #[error("{path} cannot be written: {reason}")]
    Unwritable {
        /// The file.
        path: String,
        /// What the system says.
        reason: String,
    },
    /// The place is right, and writing failed: a full disk, a limit of the size of files.
    #[error("{path} cannot be written: {reason}")]
    Unwritten {
        /// The file, or standard output.
        path: String,
        /// What the system says.
        reason: String,
    },
    /// The time limit ended the search or the audit; the best so far was shown.
    #[error("no answer was found and audited within the time limit of {} s: what is shown is the best so far, and no file was written", .0.as_secs_f64())]
    Unfinished(Duration),
    /// There is an answer, and the time limit ended what was asked for beside it.
    #[error("the answer was found, and {what} did not end within the time limit of {} s: no file was written; allow more by `time_limit` (--time-limit), or ask for less", limit.as_secs_f64())]
    Late {
        /// What took too long.
        what: &'static str,
        /// What was allowed.
        limit: Duration,
    },
    /// The time limit ended the solution of an equation.
    #[error("no solution was found within the time limit of {} s: allow more by --time-limit", .0.as_secs_f64())]
    Unsolved(Duration),
    /// A check failed.
    #[error("{0}")]
    Check(String),
}

impl From<FileError> for Failure {
    fn from(error: FileError) -> Self {
        Self::Problem(error.into())
    }
}

impl Failure {
    /// The failure to write `path`.
    pub(crate) fn unwritable(path: &Path, error: &std::io::Error) -> Self {
        Self::Unwritable { path: path.display().to_string(), reason: error.to_string() }
    }

    /// The failure of writing itself.
    pub(crate) fn unwritten(path: &Path, error: &std::io::Error) -> Self {
        Self::Unwritten { path: path.display().to_string(), reason: error.to_string() }
    }

    /// Prints the message to standard error, behind the warnings that no result shows now, and returns the exit code.
    pub(crate) fn report(&self) -> ExitCode {
        let held = std::mem::take(&mut *lock(&HELD));
        held.iter().for_each(|text| warn(text));
        print(&self.message());
        ExitCode::from(self.exit_code())
    }

    /// The exit code that says so.
    pub(crate) fn exit_code(&self) -> u8 {
        match self {
            Self::Check(_) | Self::Unwritten { .. } => 1,
            Self::Problem(error) if error.is_numerical() => 3,
            Self::Unfinished(_) | Self::Unsolved(_) | Self::Late { .. } => 3,
            Self::Usage(_) | Self::Problem(_) | Self::Plot(_) | Self::Unwritable { .. } => 2,
        }
    }

    /// The message on one line, then the line of the file with a caret where there is one, then advice.
    pub(crate) fn message(&self) -> String {
        let words = match self {
            Self::Problem(error) => told(error),
            other => format!("{}\n", legible(&other.to_string())),
        };
        format!("error: {words}")
    }
}

/// Why a command that was called by another program has no result.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct Refusal {
    /// The exit code that the command would have ended with.
    pub exit_code: u8,
    /// What it would have told on standard error, without `error: `.
    pub message: String,
}

impl From<Failure> for Refusal {
    fn from(failure: Failure) -> Self {
        Self::new(failure.exit_code(), &failure.message())
    }
}

impl Refusal {
    pub(crate) fn new(exit_code: u8, told: &str) -> Self {
        let message = told.strip_prefix("error: ").unwrap_or(told).trim_end().to_owned();
        Self { exit_code, message }
    }
}

/// An error as the command line tells it: the message on one line, then the line of the file with a caret where there is one, then advice.
#[must_use]
pub fn told(error: &shtaerman::Error) -> String {
    let mut words = format!("{}\n", legible(&error.to_string()));
    if let shtaerman::Error::File(fault) | shtaerman::Error::Beyond(fault) = error {
        words.push_str(&snippet(fault));
        if let Some(help) = fault.help() {
            // Lines to be added to the file stand on lines of their own.
            let shown: Vec<String> = help.lines().map(legible).collect();
            words.push_str(&format!("help: {}\n", shown.join("\n  ")));
        }
    }
    words
}

/// One line for standard error.
pub(crate) fn say(kind: &str, text: &str) {
    print(&format!("{kind}: {}\n", legible(text)));
}

/// A warning, once, unless none are wanted.
pub(crate) fn warn(text: &str) {
    let is_new = lock(&SAID).insert(text.to_owned());
    if is_new && !is_quiet() {
        say("warning", text);
    }
}

/// Keeps warnings that the result will show: where there is none, they are said beside the error, whose cause they may be.
pub(crate) fn hold(texts: impl Iterator<Item = String>) {
    lock(&HELD).extend(texts);
}

/// The result has shown what was held.
pub(crate) fn release() {
    lock(&HELD).clear();
}

static HELD: Mutex<Vec<String>> = Mutex::new(Vec::new());
static SAID: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

fn lock<T>(mutex: &'static Mutex<T>) -> MutexGuard<'static, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

static QUIET: AtomicBool = AtomicBool::new(false);

/// From here on nothing but errors goes to standard error.
pub(crate) fn be_quiet() {
    QUIET.store(true, Ordering::Relaxed);
}

pub(crate) fn is_quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// A path as a message or a table shows it.
pub(crate) fn shown(path: &Path) -> String {
    legible(&path.display().to_string())
}

/// Writes to standard error; where that is closed or full, nobody is left to be told.
pub(crate) fn print(text: &str) {
    let stream = std::io::stderr();
    let text = if has_colours(&stream) { painted_message(text) } else { text.to_owned() };
    let _ = stream.lock().write_all(text.as_bytes());
}

/// Longest source line that is shown, in bytes.
const LONGEST_LINE: usize = 400;

/// The faulty line with a caret; empty where there is none to show.
fn snippet(fault: &FileError) -> String {
    let Some(excerpt) = Excerpt::of(fault) else { return String::new() };
    let mut drawn = String::new();
    let handler =
        GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor()).with_context_lines(0);
    // Drawing into a string cannot fail; should it, the message stands without its snippet.
    if handler.render_report(&mut drawn, &excerpt).is_err() {
        return String::new();
    }
    // The handler begins with a heading of its own; ours stands above already.
    let body = drawn.find('╭').map_or("", |at| &drawn[at..]);
    if body.is_empty() { String::new() } else { format!("  {body}") }
}

/// One line of a source with the place at fault, for the snippet drawer; what a terminal would obey is written out.
#[derive(Debug, thiserror::Error)]
#[error("")]
struct Excerpt {
    source_name: String,
    line: String,
    /// Index of the line, and of the first character at fault in it.
    place: (usize, usize),
    /// The bytes of the line at fault.
    span: SourceSpan,
}

impl Excerpt {
    /// None without a place, and for a line too long to be shown.
    fn of(fault: &FileError) -> Option<Self> {
        let (source, span) = (fault.source_text()?, fault.span()?);
        let (before, after) = source.split_at_checked(span.start)?;
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let line_end = after.find('\n').map_or(source.len(), |at| span.start + at);
        if line_end - line_start > LONGEST_LINE {
            return None;
        }
        let end = span.end.clamp(span.start, line_end);
        let in_front = obeyed_no_more(&before[line_start..]);
        let marked = obeyed_no_more(source.get(span.start..end)?);
        let behind = obeyed_no_more(source.get(end..line_end)?.trim_end_matches('\r'));
        Some(Self {
            source_name: legible(fault.source_name()),
            place: (before.matches('\n').count(), before[line_start..].chars().count()),
            span: (in_front.len()..in_front.len() + marked.len()).into(),
            line: in_front + &marked + &behind,
        })
    }
}

/// A part of a line as it is drawn: tabs stay, which the drawer sets itself.
fn obeyed_no_more(part: &str) -> String {
    part.split('\t').map(legible).collect::<Vec<_>>().join("\t")
}

impl Diagnostic for Excerpt {
    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(self)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(std::iter::once(LabeledSpan::new_with_span(None, self.span))))
    }
}

/// Gives the full line whatever part of it is asked for: without context lines the drawer asks for the span alone.
impl SourceCode for Excerpt {
    fn read_span<'a>(
        &'a self,
        _span: &SourceSpan,
        _lines_before: usize,
        _lines_after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let span = (0, self.line.len()).into();
        let (line, column) = self.place;
        Ok(Box::new(MietteSpanContents::new_named(
            self.source_name.clone(),
            self.line.as_bytes(),
            span,
            line,
            column,
            1,
        )))
    }
}

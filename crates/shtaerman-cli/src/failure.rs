//! Why a command ends without its result, and the exit code that says so.

use std::path::Path;
use std::process::ExitCode;

use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource, SourceCode,
};
use shtaerman::document::FileError;

use crate::plot::PlotError;

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
    /// A file cannot be written.
    #[error("{path} cannot be written: {reason}")]
    Unwritable {
        /// The file.
        path: String,
        /// What the system says.
        reason: String,
    },
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

    /// Prints the message to standard error and returns the exit code.
    pub(crate) fn report(&self) -> ExitCode {
        eprint!("{}", self.message());
        ExitCode::from(self.exit_code())
    }

    fn exit_code(&self) -> u8 {
        match self {
            Self::Check(_) => 1,
            Self::Problem(error) if error.is_numerical() => 3,
            Self::Usage(_) | Self::Problem(_) | Self::Plot(_) | Self::Unwritable { .. } => 2,
        }
    }

    /// The message on one line, then the line of the file with a caret where there is one, then advice.
    fn message(&self) -> String {
        let mut message = format!("error: {self}\n");
        if let Self::Problem(shtaerman::Error::File(fault)) = self {
            message.push_str(&snippet(fault));
            if let Some(help) = fault.help() {
                message.push_str(&format!("help: {help}\n"));
            }
        }
        message
    }
}

/// Longest source line that is shown.
const LONGEST_LINE: usize = 400;

/// The faulty line with a caret; empty where there is none to show.
fn snippet(fault: &FileError) -> String {
    let (Some(source), Some(span)) = (fault.source_text(), fault.span()) else {
        return String::new();
    };
    let line_length =
        source[..span.start.min(source.len())].rfind('\n').map_or(span.start, |at| span.start - at)
            + source[span.start.min(source.len())..]
                .find('\n')
                .unwrap_or(source.len().saturating_sub(span.start));
    if line_length > LONGEST_LINE {
        return String::new();
    }
    let first_line_end = source[span.start..].find('\n').map_or(source.len(), |at| span.start + at);
    let excerpt = Excerpt {
        text: NamedSource::new(fault.source_name(), source.to_owned()),
        span: span.start..span.end.clamp(span.start, first_line_end),
    };
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

/// A place in a source, for the snippet drawer.
#[derive(Debug, thiserror::Error)]
#[error("")]
struct Excerpt {
    text: NamedSource<String>,
    span: std::ops::Range<usize>,
}

impl Diagnostic for Excerpt {
    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(&self.text)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(std::iter::once(LabeledSpan::new_with_span(None, self.span.clone()))))
    }
}

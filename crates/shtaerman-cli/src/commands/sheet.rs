//! `--report`: what a command found as a page that is printed, signed and kept.

use std::path::Path;

use shtaerman::document::load_bytes;
use shtaerman::file::ProblemFile;
use shtaerman::{Contact, Warning, WarningCode};

use super::problem_file;
use crate::Failure;
use crate::arguments::ReportArguments;
use crate::failure::shown;
use crate::output::{Content, Outputs, Printer};
use crate::plot::Size;
use crate::report::{self, ContactPicture, Entry, Sheet, Told, contact_picture};
use crate::snippets;

/// Size of the picture of a contact.
const PICTURE: Size = Size { width: 860, height: 540 };

/// Where a report goes.
pub(super) struct ReportFile<'a> {
    pub(super) path: &'a Path,
    /// What prints it, for a PDF.
    printer: Option<Printer>,
}

impl<'a> ReportFile<'a> {
    /// The report that was asked for; that it cannot be is told before anything is computed.
    pub(super) fn of(arguments: &'a ReportArguments) -> Result<Option<Self>, Failure> {
        let Some(path) = arguments.report.as_deref() else { return Ok(None) };
        let suffix = path.extension().map(|suffix| suffix.to_string_lossy().to_ascii_lowercase());
        let printer = match suffix.as_deref() {
            Some("html" | "htm") => None,
            Some("pdf") => {
                Some(Printer::find("write --report FILE.html, which any browser prints")?)
            }
            _ => {
                let message = format!("--report {}: must end in .html or .pdf", path.display());
                return Err(Failure::Usage(message));
            }
        };
        Ok(Some(Self { path, printer }))
    }

    /// Adds the report to what is written; where a table is shown on the terminal (`is_told`), it is said below it.
    pub(super) fn add(
        &self,
        outputs: &mut Outputs<'_>,
        sheet: &Sheet,
        is_told: bool,
    ) -> Result<(), Failure> {
        let html = sheet.html();
        let content = match &self.printer {
            None => Content::from(html),
            Some(printer) => Content::from(printer.pdf(&html)?),
        };
        outputs.file(self.path, content);
        if is_told {
            outputs.result(None, format!("report: {}\n", shown(self.path)));
        }
        Ok(())
    }
}

/// The command of this process, as a shell takes it again.
pub(super) fn command() -> String {
    let words = std::env::args_os().skip(1);
    let quoted: Vec<String> = words.map(|word| snippets::quoted(&word.to_string_lossy())).collect();
    format!("shtaerman {}", quoted.join(" "))
}

/// The report, of this title, about a contact that was found for a file of this name, with what is doubted about it: inputs, model, words, picture, checks.
pub(super) fn of_contact(
    [title, name]: [&str; 2],
    command: &str,
    told: &Told,
    file: &ProblemFile,
    (contact, doubts): (&Contact, &[Warning]),
) -> Result<Sheet, Failure> {
    let mut sheet = of_file(title, command, told, file);
    // What was found may differ from what the file says.
    sheet.problem(contact.problem());
    sheet.words(report::sentences(contact, file.units()));
    let wanted = ContactPicture {
        name: name.to_owned(),
        units: file.units().clone(),
        ..ContactPicture::default()
    };
    sheet.picture(
        "Pressure over the base; below it base, asperities and the deformed body.",
        &contact_picture(contact, &wanted)?,
        Some(PICTURE),
    )?;
    // An error a little above what was aimed at is no doubt of an engineer's: it is stated with the answer.
    let is_accuracy = |warning: &&Warning| warning.code == WarningCode::ToleranceNotMet;
    let warnings = contact.warnings_in(file.units());
    let (accuracy, other): (Vec<_>, Vec<_>) = warnings.iter().chain(doubts).partition(is_accuracy);
    sheet.warnings(other.iter().map(|warning| warning.message.as_str()));
    for warning in accuracy {
        sheet.accuracy(&warning.message);
    }
    Ok(sheet)
}

/// The report about a file: inputs and model.
pub(super) fn of_file(title: &str, command: &str, told: &Told, file: &ProblemFile) -> Sheet {
    let mut sheet = Sheet::new(title, command, told);
    sheet.document(file.document());
    sheet.problem(file.problem());
    if let Some(path) = file.measured_profile()
        && let Ok(content) = load_bytes(path)
    {
        sheet.file(&problem_file::name(path), &content);
    }
    sheet
}

/// Options of the command line, those that were given, as inputs of a report.
pub(super) fn options(given: &[(&str, Option<&str>)]) -> Vec<Entry> {
    let given = given.iter().filter_map(|(name, text)| Some((name, (*text)?)));
    given.map(|(name, text)| Entry::option(name, text)).collect()
}

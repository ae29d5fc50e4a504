//! Sense checks of a study: of its file before anything is solved, and of the cases in which slips show.

use shtaerman::file::AnyFile;
use shtaerman_study::{Doubt, Input, Study, Summary};

use super::problem_file::refuse;
use crate::Failure;
use crate::arguments::SenseArguments;
use crate::report::StudyUnits;

/// Ends with `--strict` where the file alone, with the first value of all that varies, is doubtful: before anything is solved.
pub(super) fn check_input(
    study: &Study,
    overrides: &[String],
    sense: SenseArguments,
) -> Result<(), Failure> {
    match study.first(overrides)? {
        AnyFile::Problem(file) => refuse(&sense, file.input_checks()).map(|_| ()),
        AnyFile::Equation(_) => Ok(()),
    }
}

/// How many of the cases in which slips show were looked at, and the doubts about them, a line each, which `--strict` refuses.
pub(super) fn doubts(
    study: &Study,
    summary: &Summary,
    overrides: &[String],
    sense: SenseArguments,
) -> Result<(usize, Vec<String>), Failure> {
    let (looked_at, doubts) = study.sense_checks(summary, overrides);
    let units = StudyUnits::new(study, overrides)?;
    let line = |doubt: &Doubt| {
        let more = match doubt.count - 1 {
            0 => String::new(),
            more => format!(" ({more} more of the {looked_at} cases that were looked at)"),
        };
        format!("{}{more}", line(study, &units, doubt))
    };
    let lines: Vec<String> = doubts.iter().map(line).collect();
    if sense.strict && !lines.is_empty() {
        return Err(Failure::Usage(format!("--strict: {}", lines.join("; "))));
    }
    Ok((looked_at, lines))
}

/// A doubt with its case.
pub(super) fn line(study: &Study, units: &StudyUnits, doubt: &Doubt) -> String {
    let inputs = study.variables().iter().zip(study.inputs(doubt.case));
    let shown = |key: &str, value: &Input| format!("{key} = {}", units.value(key, value));
    let inputs: Vec<String> =
        inputs.map(|(variable, value)| shown(&variable.key, &value)).collect();
    format!("case {} ({}): {}", doubt.case, inputs.join(", "), doubt.warning.message)
}

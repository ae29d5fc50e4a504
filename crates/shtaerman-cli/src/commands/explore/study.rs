//! Cases of a study for the page.

use std::ops::Range;

use serde::Deserialize;
use serde_json::{Map, Value, json};
use shtaerman_study::Study;

use super::asked::Asked;
use crate::Failure;
use crate::commands::study_sense;
use crate::report;

/// Most cases of a study on the page, and of one question.
const MOST_CASES: usize = 10_000;
const MOST_TOGETHER: usize = 4096;

/// Some cases of a study.
#[derive(Debug, Deserialize)]
pub(super) struct AskedStudy {
    #[serde(flatten)]
    study: Asked,
    from: usize,
    count: usize,
}

impl AskedStudy {
    /// The study and the range of the cases.
    fn read(&self) -> Result<(Study, Range<usize>), Failure> {
        let study = self.study.study()?;
        let cases = study.cases();
        if cases > MOST_CASES {
            return Err(Failure::Usage(format!(
                "the study has {cases} cases, the page runs up to {MOST_CASES}: `shtaerman sweep` runs any number"
            )));
        }
        let from = self.from.min(cases);
        Ok((study, from..from.saturating_add(self.count.min(MOST_TOGETHER)).min(cases)))
    }
}

/// What is doubtful about the cases, which are solved once more: a line for each kind, and how many cases have it.
pub(super) fn doubts(asked: &AskedStudy) -> Result<Value, Failure> {
    let (study, range) = asked.read()?;
    let cases: Vec<usize> = range.clone().collect();
    let found = study.sense_checks_of(&cases, &[]);
    let units = report::StudyUnits::new(&study, &[])?;
    let told = found.iter().map(|doubt| {
        json!({
            "code": doubt.warning.code,
            "count": doubt.count,
            "message": study_sense::line(&study, &units, doubt),
        })
    });
    Ok(json!({ "cases": study.cases(), "to": range.end, "doubts": told.collect::<Vec<_>>() }))
}

/// The rows of the cases, by columns, as `sweep` keeps them.
pub(super) fn told(asked: &AskedStudy) -> Result<Value, Failure> {
    let (study, Range { start: from, end }) = asked.read()?;
    let cases = study.cases();
    let rows = study.solve(from..end);
    let variables: Vec<&str> = study.variables().iter().map(|one| one.key.as_str()).collect();
    let outputs: Vec<&str> = study.outputs().iter().map(|output| output.name.as_str()).collect();
    let chosen = report::StudyUnits::new(&study, &[])?;
    let units: Map<String, Value> = variables
        .iter()
        .chain(&outputs)
        .filter_map(|name| {
            let unit = chosen.chosen(name)?;
            Some(((*name).to_owned(), json!({ "factor": unit.factor, "label": unit.label })))
        })
        .collect();
    Ok(json!({
        "cases": cases,
        "from": from,
        "to": end,
        "variables": variables,
        "outputs": outputs,
        "units": units,
        "columns": report::columns(&study, &rows),
        "is_dimensionless": study.is_dimensionless(),
    }))
}

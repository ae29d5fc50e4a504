//! Cases of a study for the page.

use serde::Deserialize;
use serde_json::{Map, Value, json};

use super::asked::Asked;
use crate::Failure;
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

/// The rows of the cases, by columns, as `sweep` keeps them.
pub(super) fn told(asked: &AskedStudy) -> Result<Value, Failure> {
    let study = asked.study.study()?;
    let cases = study.cases();
    if cases > MOST_CASES {
        return Err(Failure::Usage(format!(
            "the study has {cases} cases, the page runs up to {MOST_CASES}: `shtaerman sweep` runs any number"
        )));
    }
    let from = asked.from.min(cases);
    let end = from.saturating_add(asked.count.min(MOST_TOGETHER)).min(cases);
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

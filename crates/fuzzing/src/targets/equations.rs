//! Equation files, solved with their audit.

use std::sync::OnceLock;

use shtaerman::equation::{EquationFile, SolvedEquation};

use crate::check::Outcome;
use crate::{Random, check, files};

/// Points of the solution.
const POINTS: usize = 21;

/// Solves and audits an equation that was made; the answer keeps the schema and holds numbers.
pub(super) fn case(random: &mut Random) -> Result<Outcome, String> {
    static SCHEMA: OnceLock<Result<jsonschema::Validator, String>> = OnceLock::new();
    let schema = SCHEMA.get_or_init(|| check::read_schema("equation")).as_ref()?;
    let text = files::equation(random);
    let file = match EquationFile::parse(&text, "made.toml") {
        Ok(file) => file,
        Err(error) => return check::refusal(&error.to_string(), &text),
    };
    let solved = match file.equation().solve().and_then(SolvedEquation::audited) {
        Ok(solved) => solved,
        Err(error) => return check::refusal(&error.to_string(), &text),
    };
    let answer = solved.places(POINTS).and_then(|places| solved.answer(places));
    let answer = answer.map_err(|error| format!("{error}: {}", check::excerpt(&text)))?;
    let is_known = !answer.solution.phi.iter().flatten().any(|value| value.is_nan());
    check::holds(is_known, "the solution is not a number", &text)?;
    let answer = serde_json::to_value(&answer);
    let answer = answer.map_err(|error| format!("{error}: {}", check::excerpt(&text)))?;
    check::schema(schema, &answer, &text)?;
    Ok(Outcome::Accepted)
}

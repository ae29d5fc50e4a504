//! What every message and every answer must be.

use std::any::Any;

use serde_json::Value;
use shtaerman_input::legible;

/// What became of a case that did not fail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// The input was taken.
    Accepted,
    /// The input was refused with a message.
    Refused,
}

/// Longest message, as the command line shows it, in bytes: what `legible` leaves of a text, with its escapes.
const LONGEST_MESSAGE: usize = 8000;

/// What a panic said.
pub(crate) fn panicked(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    format!("panic: {}", text.unwrap_or("without a text"))
}

/// A refusal, whose message must be there, and one printable line of bounded length as it is shown.
pub(crate) fn refusal(message: &str, input: &str) -> Result<Outcome, String> {
    let shown = legible(message);
    let is_sound = !shown.trim().is_empty()
        && shown.len() <= LONGEST_MESSAGE
        && !shown.chars().any(char::is_control);
    if is_sound {
        Ok(Outcome::Refused)
    } else {
        Err(format!("message {shown:?} of {}", excerpt(input)))
    }
}

/// Fails with the input where something that must hold does not.
pub(crate) fn holds(condition: bool, what: &str, input: &str) -> Result<(), String> {
    if condition { Ok(()) } else { Err(format!("{what}: {}", excerpt(input))) }
}

/// Fails where an answer is not what the schema describes. JSON writes what is no finite number as null, which a schema allows in few places.
pub(crate) fn schema(
    schema: &jsonschema::Validator,
    answer: &Value,
    input: &str,
) -> Result<(), String> {
    let fault = schema.iter_errors(answer).next();
    fault.map_or(Ok(()), |error| {
        Err(format!("schema, {}: {error}: {}", error.instance_path(), excerpt(input)))
    })
}

/// The schema of a name from the repository.
pub(crate) fn read_schema(name: &str) -> Result<jsonschema::Validator, String> {
    let path = format!("{}/../../schema/{name}.schema.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).map_err(|error| format!("{path}: {error}"))?;
    let value: Value = serde_json::from_str(&text).map_err(|error| format!("{path}: {error}"))?;
    jsonschema::draft202012::new(&value).map_err(|error| format!("{path}: {error}"))
}

/// An input as a report shows it.
pub(crate) fn excerpt(input: &str) -> String {
    const LONGEST: usize = 3000;
    let text: String = input.chars().take(LONGEST).collect();
    format!("{text:?}")
}

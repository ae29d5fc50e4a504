//! Problem files, solved with their audit.

use std::sync::OnceLock;

use shtaerman::file;
use shtaerman::{Answer, Contact, PressureCurve};

use crate::check::Outcome;
use crate::{Random, check, files};

/// Points of the pressure curve.
const POINTS: usize = 41;

/// Solves and audits a file that was made; the answer keeps the schema and holds numbers.
pub(super) fn case(random: &mut Random) -> Result<Outcome, String> {
    static SCHEMA: OnceLock<Result<jsonschema::Validator, String>> = OnceLock::new();
    let schema = SCHEMA.get_or_init(|| check::read_schema("answer")).as_ref()?;
    let text = files::problem(random);
    let solved = file::parse(&text, "made.toml").and_then(|problem| problem.solve()?.audited());
    let contact = match solved {
        Ok(contact) => contact,
        Err(error) => return check::refusal(&error.to_string(), &text),
    };
    numbers(&contact, &text)?;
    let curve = PressureCurve::along(&contact, POINTS);
    let curve = curve.map_err(|error| format!("{error}: {}", check::excerpt(&text)))?;
    // A smooth corner has an infinite pressure.
    let is_known = !curve.pressure.iter().any(|pressure| pressure.is_nan());
    check::holds(is_known, "the pressure is not a number", &text)?;
    let answer = serde_json::to_value(Answer::new(&contact, curve));
    let answer = answer.map_err(|error| format!("{error}: {}", check::excerpt(&text)))?;
    check::schema(schema, &answer, &text)?;
    Ok(Outcome::Accepted)
}

fn numbers(contact: &Contact, text: &str) -> Result<(), String> {
    let all = [contact.settlement(), contact.tilt(), contact.force(), contact.moment()];
    check::holds(all.iter().all(|value| value.is_finite()), &format!("not finite, {all:?}"), text)?;
    let zones = contact.zones();
    let is_ordered = zones.iter().all(|[left, right]| left <= right)
        && zones.windows(2).all(|pair| pair[0][1] <= pair[1][0]);
    check::holds(is_ordered, &format!("zones out of order, {zones:?}"), text)
}

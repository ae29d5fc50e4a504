//! Quantities with units.

use shtaerman_input::quantity::{DisplayUnit, engineering_with_digits, parse};

use crate::broken::broken;
use crate::check::Outcome;
use crate::{Random, check, written};

/// Digits that give a value back to the last bit.
const ALL_DIGITS: usize = 17;

/// Parses a text; what is taken is finite, and lengths and pressures are read back as they are shown.
pub(super) fn case(random: &mut Random) -> Result<Outcome, String> {
    let mut text = written::quantity(random);
    if random.one_in(2) {
        text = broken(random, &text);
    }
    let quantity = match parse(&text) {
        Ok(quantity) => quantity,
        Err(error) => {
            let span = error.span();
            check::holds(text.get(span).is_some(), "the place lies outside the text", &text)?;
            return check::refusal(&error.to_string(), &text);
        }
    };
    let value = quantity.value;
    check::holds(value.is_finite(), "not finite", &text)?;
    let unit = random.of(&["m", "Pa", "N"]);
    let shown = engineering_with_digits(value, DisplayUnit::prefixed(unit), ALL_DIGITS);
    let again = parse(&shown).map(|quantity| quantity.value);
    // Below the smallest normal number a prefix costs digits.
    let is_same = value.abs() < 1e-290 || again.as_ref() == Ok(&value);
    check::holds(is_same, &format!("{value:e} is shown as {shown}, read as {again:?}"), &text)?;
    Ok(Outcome::Accepted)
}

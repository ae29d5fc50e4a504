//! Whether a file and its answer are those of mechanics, or of a slip in the input.

use super::located::ProblemFile;
use super::physical;
use crate::answer::wide_base;
use crate::document::{Document, Value, ValueKind};
use crate::quantity::{self, Measure};
use crate::{Contact, Error, Warning, WarningCode};

/// Keys of moduli.
const MODULI: [&str; 4] = [
    "foundation.young_modulus",
    "foundation.coating.young_modulus",
    "foundation.grading_modulus",
    "body.young_modulus",
];
/// Key of the yield stress.
const YIELD_STRESS: &str = "foundation.yield_stress";

impl ProblemFile {
    /// `yield_stress` of `[foundation]` (Pa), if there is one.
    ///
    /// # Errors
    /// [`Error::File`] for a value that is no positive stress: none in a problem that was read.
    pub fn yield_stress(&self) -> Result<Option<f64>, Error> {
        let foundation = self.document().reader().table("foundation")?;
        Ok(foundation.map(|table| physical::yield_stress(&table)).transpose()?.flatten())
    }

    /// What an engineer would doubt about the file alone, before anything is solved: a base wider than machines have, a modulus or a yield stress without a unit that no solid has, and a trace whose header has something in place of a unit that is none.
    #[must_use]
    pub fn input_checks(&self) -> Vec<Warning> {
        let mut found = Vec::new();
        found.extend(wide_base(self.problem(), self.units()));
        found.extend(soft_moduli(self.document()));
        found.extend(self.doubts.iter().cloned());
        let stress = bare(self.document(), YIELD_STRESS);
        found.extend(stress.and_then(|stress| Warning::low_yield_stress(YIELD_STRESS, stress)));
        found
    }

    /// What an engineer would doubt about an answer to this file: [`ProblemFile::input_checks`], [`Contact::sense_checks`], and pressures above the yield stress.
    #[must_use]
    pub fn sense_checks(&self, contact: &Contact) -> Vec<Warning> {
        let mut found = self.input_checks();
        let of_contact = contact.sense_checks_in(self.units());
        // The width is that of the file.
        found.extend(of_contact.into_iter().filter(|one| one.code != WarningCode::WideBase));
        let (name, pressure) = contact.telling_pressure();
        if let Ok(Some(limit)) = self.yield_stress()
            && pressure > limit
        {
            let shown = |value| self.units().shown(value, Measure::Pressure);
            let message = format!(
                "the {name}, {}, is above the yield stress, {}: `shtaerman stress` says where and when the body yields",
                shown(pressure),
                shown(limit)
            );
            found.push(Warning { code: WarningCode::AboveYield, message });
        }
        found
    }
}

/// Moduli without a unit that no solid has.
fn soft_moduli(document: &Document) -> impl Iterator<Item = Warning> {
    MODULI.into_iter().filter_map(|key| Warning::soft_modulus(key, bare(document, key)?))
}

/// A fault of one modulus beside another, with the likely slip.
pub(super) fn advised(document: &Document, error: Error) -> Error {
    match error {
        Error::File(fault)
            if fault.help().is_none()
                && fault.field().is_some_and(|field| field.ends_with("modulus")) =>
        {
            let slips: Vec<String> = soft_moduli(document).map(|one| one.message).collect();
            match slips.is_empty() {
                true => Error::File(fault),
                false => Error::File(fault.with_help(slips.join("\n"))),
            }
        }
        other => other,
    }
}

/// The value of a key that was written without a unit, in quotes or not.
fn bare(document: &Document, key: &str) -> Option<f64> {
    match document.get(key).map(Value::kind)? {
        ValueKind::Integer(value) => Some(*value as f64),
        ValueKind::Float(value) => Some(*value),
        ValueKind::String(text) => {
            let read = quantity::parse(text).ok()?;
            (!read.unit_written()).then_some(read.value)
        }
        _ => None,
    }
}

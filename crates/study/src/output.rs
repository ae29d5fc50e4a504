//! What is kept of an answer.

use shtaerman::{Contact, Errors};

/// A quantity of an answer, by the name that it has in the JSON answer.
#[derive(Debug, Clone, Copy)]
pub struct Output {
    /// Its name.
    pub name: &'static str,
    value: fn(&Contact) -> f64,
    /// The stated error, where the answer states one for this quantity.
    error: fn(&Errors) -> Option<f64>,
}

/// All outputs, in the order of the answer.
const OUTPUTS: [Output; 13] = [
    Output { name: "theta0", value: Contact::theta0, error: |_| None },
    Output { name: "settlement", value: Contact::settlement, error: |e| Some(e.settlement) },
    Output { name: "tilt", value: Contact::tilt, error: |e| Some(e.tilt) },
    Output { name: "force", value: Contact::force, error: |e| Some(e.force) },
    Output { name: "moment", value: Contact::moment, error: |e| Some(e.moment) },
    Output { name: "pressure_left", value: Contact::pressure_left, error: |e| Some(e.pressure) },
    Output {
        name: "pressure_middle",
        value: Contact::pressure_middle,
        error: |e| Some(e.pressure),
    },
    Output { name: "pressure_right", value: Contact::pressure_right, error: |e| Some(e.pressure) },
    Output { name: "mean_pressure", value: Contact::mean_pressure, error: |_| None },
    Output {
        name: "peak_pressure",
        value: Contact::peak_pressure,
        error: |e| Some(e.peak_pressure.unwrap_or(e.pressure)),
    },
    Output { name: "peak_pressure_at", value: Contact::peak_pressure_at, error: |_| None },
    Output {
        name: "contact_width",
        value: Contact::contact_width,
        // Each zone has two ends.
        error: |_| None,
    },
    Output {
        name: "number_of_zones",
        value: |contact| contact.zones().len() as f64,
        error: |_| None,
    },
];

impl Output {
    /// The output of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        OUTPUTS.into_iter().find(|output| output.name == name)
    }

    /// The names of all.
    #[must_use]
    pub fn names() -> Vec<&'static str> {
        OUTPUTS.iter().map(|output| output.name).collect()
    }

    /// Those that a study has which names none.
    #[must_use]
    pub(crate) fn usual() -> Vec<Self> {
        ["settlement", "tilt", "force", "peak_pressure", "contact_width"]
            .into_iter()
            .filter_map(Self::named)
            .collect()
    }

    /// The value (SI units, or none for a dimensionless problem).
    #[must_use]
    pub fn value(&self, contact: &Contact) -> f64 {
        (self.value)(contact)
    }

    /// The stated error of the value, where there is one.
    #[must_use]
    pub fn error(&self, contact: &Contact) -> Option<f64> {
        let errors = contact.error()?;
        if self.name == "contact_width" {
            // Each zone has two ends, of which those at the walls are exact.
            return Some(2.0 * errors.zones? * contact.zones().len() as f64);
        }
        (self.error)(&errors)
    }
}

//! Quantities that every contact has.

use shtaerman::{Contact, Errors, Load, Rotational, Swept, SweptErrors, Vertical};

/// A quantity of an answer, by the name that it has in the JSON answer.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Quantity {
    /// Its name.
    pub(crate) name: &'static str,
    value: fn(&Contact) -> f64,
    /// The stated error, where the answer states one for this quantity.
    error: fn(&Errors) -> Option<f64>,
    /// The same of a case of a sweep, where a sweep tells it.
    swept: Option<OfSwept>,
    swept_error: Option<OfSwept>,
}

/// A case of a sweep, for the outputs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SweptCase {
    pub(crate) theta0: f64,
    pub(crate) load: Load,
    pub(crate) contact: Swept,
    pub(crate) errors: SweptErrors,
}

type Value = fn(&Contact) -> f64;
type OfSwept = fn(&SweptCase) -> f64;

impl Quantity {
    const fn new(name: &'static str, value: Value) -> Self {
        Self { name, value, error: |_| None, swept: None, swept_error: None }
    }

    const fn with_error(self, error: fn(&Errors) -> Option<f64>) -> Self {
        Self { error, ..self }
    }

    const fn with_swept(self, swept: OfSwept) -> Self {
        Self { swept: Some(swept), ..self }
    }

    const fn with_swept_error(self, error: OfSwept) -> Self {
        Self { swept_error: Some(error), ..self }
    }

    /// Whether a sweep tells it.
    pub(crate) const fn is_swept(&self) -> bool {
        self.swept.is_some()
    }

    /// What a sweep tells of it.
    pub(crate) fn swept(&self, case: &SweptCase) -> Option<f64> {
        self.swept.map(|value| value(case))
    }

    /// Its error in a sweep, where there is one.
    pub(crate) fn swept_error(&self, case: &SweptCase) -> Option<f64> {
        self.swept_error.map(|error| error(case))
    }

    /// The value (SI units, or none for a dimensionless problem).
    pub(crate) fn value(&self, contact: &Contact) -> f64 {
        (self.value)(contact)
    }

    /// The stated error of the value, where there is one.
    pub(crate) fn error(&self, contact: &Contact) -> Option<f64> {
        let errors = contact.error()?;
        if self.name == "contact_width" {
            // Each zone has two ends, of which those at the walls are exact.
            return Some(2.0 * errors.zones? * contact.zones().len() as f64);
        }
        (self.error)(&errors)
    }
}

/// Quantities of every contact, in the order of the answer. What is prescribed has no error in a sweep.
pub(crate) const QUANTITIES: [Quantity; 14] = [
    Quantity::new("theta0", Contact::theta0).with_swept(|case| case.theta0),
    Quantity::new("settlement", Contact::settlement)
        .with_error(|e| Some(e.settlement))
        .with_swept(|case| case.contact.settlement)
        .with_swept_error(|case| match case.load.vertical() {
            Vertical::Force(_) => case.errors.displacement,
            Vertical::Settlement(_) => 0.0,
        }),
    Quantity::new("tilt", Contact::tilt)
        .with_error(|e| Some(e.tilt))
        .with_swept(|case| case.contact.tilt)
        .with_swept_error(|case| match case.load.rotational() {
            Rotational::Moment(_) | Rotational::Eccentricity(_) => case.errors.displacement,
            Rotational::Tilt(_) => 0.0,
        }),
    Quantity::new("force", Contact::force)
        .with_error(|e| Some(e.force))
        .with_swept(|case| case.contact.force)
        .with_swept_error(|case| match case.load.vertical() {
            Vertical::Force(_) => 0.0,
            Vertical::Settlement(_) => case.errors.force,
        }),
    Quantity::new("moment", Contact::moment)
        .with_error(|e| Some(e.moment))
        .with_swept(|case| case.contact.moment)
        .with_swept_error(|case| match case.load.rotational() {
            Rotational::Moment(_) => 0.0,
            Rotational::Eccentricity(_) | Rotational::Tilt(_) => case.errors.force,
        }),
    Quantity::new("pressure_left", Contact::pressure_left)
        .with_error(|e| Some(e.pressure))
        .with_swept(|case| case.contact.pressure_left)
        .with_swept_error(|case| case.errors.pressure),
    Quantity::new("pressure_middle", Contact::pressure_middle).with_error(|e| Some(e.pressure)),
    Quantity::new("pressure_right", Contact::pressure_right)
        .with_error(|e| Some(e.pressure))
        .with_swept(|case| case.contact.pressure_right)
        .with_swept_error(|case| case.errors.pressure),
    // Over the two half-widths of the base.
    Quantity::new("mean_pressure", Contact::mean_pressure)
        .with_swept(|case| 0.5 * case.contact.force),
    Quantity::new("mean_contact_pressure", Contact::mean_contact_pressure),
    Quantity::new("peak_pressure", Contact::peak_pressure)
        .with_error(|e| Some(e.peak_pressure.unwrap_or(e.pressure))),
    Quantity::new("peak_pressure_at", Contact::peak_pressure_at),
    Quantity::new("contact_width", Contact::contact_width),
    Quantity::new("number_of_zones", |contact| contact.zones().len() as f64),
];

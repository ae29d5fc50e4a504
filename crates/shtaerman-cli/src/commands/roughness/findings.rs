//! What was found of a rough surface, and how it is written.

use serde::Serialize;
use shtaerman::Roughness;
use shtaerman::asperities::{BearingCurve, BearingFit, Fit};
use shtaerman::quantity::{Dimension, engineering};

use crate::Failure;
use crate::arguments::Law;
use crate::output::Content;
use crate::report::{Table, significant};

/// Digits of numbers for people.
const DIGITS: usize = 6;

/// Everything the command writes; SI units.
#[derive(Debug, Serialize)]
pub(super) struct Findings {
    schema: &'static str,
    method: &'static str,
    pub(super) state: Option<State>,
    pub(super) plasticity_index: Option<f64>,
    pub(super) curve: Option<Curve>,
    pub(super) linear: Option<LawReport>,
    pub(super) power: Option<LawReport>,
    /// The value of `foundation.roughness`.
    roughness: Option<Snippet>,
    notes: Vec<String>,
    /// What an engineer would doubt.
    pub(super) warnings: Vec<String>,
}

/// The layer at the working pressure.
#[derive(Debug, Serialize)]
pub(super) struct State {
    pub(super) pressure: f64,
    pub(super) compliance: f64,
    pub(super) approach: Option<f64>,
    pub(super) separation: Option<f64>,
    pub(super) contact_share: Option<f64>,
    pub(super) contacts: Option<f64>,
    pub(super) bearing_share: Option<f64>,
}

impl State {
    pub(super) fn new(pressure: f64, compliance: f64) -> Self {
        Self {
            pressure,
            compliance,
            approach: None,
            separation: None,
            contact_share: None,
            contacts: None,
            bearing_share: None,
        }
    }
}

/// A bearing curve.
#[derive(Debug, Serialize)]
pub(super) struct Curve {
    b: f64,
    nu: f64,
    height: f64,
    shares: Option<[f64; 2]>,
    r_squared: Option<f64>,
    largest_deviation: Option<f64>,
}

impl Curve {
    pub(super) fn given(curve: &BearingCurve) -> Self {
        Self {
            b: curve.coefficient(),
            nu: curve.exponent(),
            height: curve.height(),
            shares: None,
            r_squared: None,
            largest_deviation: None,
        }
    }

    pub(super) fn fitted(fit: &BearingFit) -> Self {
        Self {
            shares: Some(fit.shares),
            r_squared: Some(fit.r_squared),
            largest_deviation: Some(fit.largest_deviation),
            ..Self::given(&fit.curve)
        }
    }
}

/// A law, with its fit where it was fitted.
#[derive(Debug, Serialize)]
pub(super) struct LawReport {
    coefficient: f64,
    exponent: f64,
    fit: Option<FitReport>,
}

#[derive(Debug, Serialize)]
struct FitReport {
    offset: f64,
    pressures: [f64; 2],
    approaches: [f64; 2],
    r_squared: f64,
    largest_deviation: f64,
    relative_deviation: f64,
    deviates_at: f64,
}

impl LawReport {
    pub(super) fn exact(roughness: Roughness) -> Self {
        let (coefficient, exponent) = match roughness {
            Roughness::Linear { compliance } => (compliance, 1.0),
            Roughness::Power { coefficient, exponent } => (coefficient, exponent),
            _ => (0.0, 1.0),
        };
        Self { coefficient, exponent, fit: None }
    }

    pub(super) fn fitted(fit: &Fit) -> Self {
        let report = FitReport {
            offset: fit.offset,
            pressures: fit.pressures,
            approaches: fit.approaches,
            r_squared: fit.r_squared,
            largest_deviation: fit.largest_deviation,
            relative_deviation: fit.relative_deviation(),
            deviates_at: fit.deviates_at,
        };
        Self { fit: Some(report), ..Self::exact(fit.roughness) }
    }

    fn snippet(&self) -> Snippet {
        if self.exponent == 1.0 {
            Snippet::Compliance(self.coefficient)
        } else {
            Snippet::Power { coefficient: self.coefficient, exponent: self.exponent }
        }
    }
}

/// As in a problem file.
#[derive(Debug, Clone, Copy, Serialize)]
#[serde(untagged)]
enum Snippet {
    Compliance(f64),
    Power { coefficient: f64, exponent: f64 },
}

impl Snippet {
    fn toml(self) -> String {
        match self {
            Self::Compliance(compliance) => format!("roughness = \"{compliance:e} m/Pa\""),
            Self::Power { coefficient, exponent } => {
                format!("roughness = {{ coefficient = {coefficient:e}, exponent = {exponent} }}")
            }
        }
    }
}

impl Findings {
    pub(super) fn new(method: &'static str) -> Self {
        Self {
            schema: "shtaerman-roughness/1",
            method,
            state: None,
            plasticity_index: None,
            curve: None,
            linear: None,
            power: None,
            roughness: None,
            notes: Vec::new(),
            warnings: Vec::new(),
        }
    }

    pub(super) fn note(&mut self, note: String) {
        self.notes.push(note);
    }

    /// Takes this law for the problem file.
    pub(super) fn choose(&mut self, law: Law) -> Result<(), Failure> {
        let (chosen, missing) = match law {
            Law::Linear => (&self.linear, "--law linear: needs a working --pressure"),
            Law::Power => (&self.power, "--law power: needs a --range of pressures to fit"),
        };
        let chosen = chosen.as_ref().ok_or_else(|| Failure::Usage(missing.to_owned()))?;
        self.roughness = Some(chosen.snippet());
        Ok(())
    }

    /// One row a quantity, SI.
    pub(super) fn csv(&self) -> Content<'_> {
        let rows = self
            .rows()
            .into_iter()
            .map(|row| vec![row.name, row.value.to_string(), row.kind.unit()]);
        Content::csv(&["quantity", "value", "unit"], rows)
    }

    pub(super) fn table(&self) -> String {
        let mut table = Table::new(&["", ""]);
        for row in self.rows() {
            table.row(vec![row.name, row.kind.text(row.value)]);
        }
        let mut text = table.to_string();
        for (kind, said) in [("warning", &self.warnings), ("note", &self.notes)] {
            said.iter().for_each(|said| text.push_str(&format!("\n{kind}: {said}\n")));
        }
        if let Some(snippet) = self.roughness {
            text.push_str(&format!("\n[foundation]\n{}\n", snippet.toml()));
        }
        text
    }

    fn rows(&self) -> Vec<Row> {
        let mut rows = Vec::new();
        let mut add = |name: &str, value: Option<f64>, kind: Kind| {
            rows.extend(value.map(|value| Row { name: name.to_owned(), value, kind }));
        };
        if let Some(curve) = &self.curve {
            add("bearing curve b", Some(curve.b), Kind::Number);
            add("bearing curve nu", Some(curve.nu), Kind::Number);
            add("height R", Some(curve.height), Kind::Of(Dimension::LENGTH));
            add("fitted from share", curve.shares.map(|shares| shares[0]), Kind::Number);
            add("to share", curve.shares.map(|shares| shares[1]), Kind::Number);
            add("R^2 of ln eta", curve.r_squared, Kind::Number);
            add("largest deviation of eta", curve.largest_deviation, Kind::Number);
        }
        if let Some(state) = &self.state {
            let length = Kind::Of(Dimension::LENGTH);
            add("working pressure", Some(state.pressure), Kind::Of(Dimension::PRESSURE));
            add("compliance chi there", Some(state.compliance), Kind::Of(Dimension::COMPLIANCE));
            add("approach", state.approach, length);
            add("separation of the mean plane", state.separation, length);
            add("share in contact", state.contact_share, Kind::Number);
            add("asperities in contact per area", state.contacts, Kind::Density);
            add("share of the bearing curve", state.bearing_share, Kind::Number);
        }
        add("plasticity index", self.plasticity_index, Kind::Number);
        for (name, law) in [("linear", &self.linear), ("power", &self.power)] {
            let Some(law) = law else { continue };
            let mut add = |what: &str, value: f64, kind: Kind| {
                add(&format!("{name}: {what}"), Some(value), kind);
            };
            if name == "linear" {
                add("chi", law.coefficient, Kind::Of(Dimension::COMPLIANCE));
            } else {
                add("B", law.coefficient, Kind::Coefficient);
                add("kappa", law.exponent, Kind::Number);
            }
            let Some(fit) = &law.fit else { continue };
            add("from pressure", fit.pressures[0], Kind::Of(Dimension::PRESSURE));
            add("to pressure", fit.pressures[1], Kind::Of(Dimension::PRESSURE));
            add("R^2", fit.r_squared, Kind::Number);
            add("largest deviation", fit.largest_deviation, Kind::Of(Dimension::LENGTH));
            add("over the range of the approach", fit.relative_deviation, Kind::Number);
            add("deviates most at", fit.deviates_at, Kind::Of(Dimension::PRESSURE));
            if fit.offset != 0.0 {
                add("first touch at the separation", -fit.offset, Kind::Of(Dimension::LENGTH));
            }
        }
        rows
    }
}

struct Row {
    name: String,
    value: f64,
    kind: Kind,
}

/// What a value measures.
#[derive(Clone, Copy)]
enum Kind {
    Number,
    Of(Dimension),
    /// `1/m^2`.
    Density,
    /// `m/Pa^kappa`.
    Coefficient,
}

impl Kind {
    fn unit(self) -> String {
        match self {
            Self::Number => String::new(),
            Self::Of(dimension) => dimension.unit(),
            Self::Density => "1/m^2".to_owned(),
            Self::Coefficient => "m/Pa^kappa".to_owned(),
        }
    }

    fn text(self, value: f64) -> String {
        match self {
            Self::Of(dimension) => engineering(value, dimension),
            Self::Number => significant(value, DIGITS),
            Self::Density | Self::Coefficient => {
                format!("{} {}", significant(value, DIGITS), self.unit())
            }
        }
    }
}

//! What a finite-element program reads: comments that say what the numbers are, and the tables.

use shtaerman::finite_elements::{LoadCurve, Overclosure, Penalty, Units};
use shtaerman::{Contact, Datum, Problem, Rotational, Roughness};

use super::deck::{Deck, field};
use super::significant;
use crate::arguments::Program;

/// Digits of numbers in comments.
const DIGITS: usize = 6;
/// Characters of the name of a problem file that are shown.
const NAME: usize = 120;

/// An input file that is being written.
pub(crate) struct Model {
    deck: Deck,
    program: Program,
    units: Units,
    /// Length of a plane punch out of the plane (m).
    length: Option<f64>,
}

/// The rough layer.
pub(crate) struct SurfaceExport {
    pub(crate) contact: Contact,
    pub(crate) table: Overclosure,
    /// The penalty stiffness, or why there is none.
    pub(crate) penalty: Result<Penalty, String>,
    pub(crate) share: f64,
    pub(crate) reach: f64,
}

/// The whole contact as a spring.
pub(crate) struct ForceExport<'a> {
    pub(crate) problem: &'a Problem,
    pub(crate) curve: LoadCurve,
    pub(crate) datum: Option<Datum>,
}

impl Model {
    pub(crate) fn new(program: Program, units: Units, length: Option<f64>, file: &str) -> Self {
        let mut deck = Deck::default();
        let name: String = file.chars().take(NAME).collect();
        let version = env!("CARGO_PKG_VERSION");
        let reader = match program {
            Program::Abaqus => "Abaqus",
            Program::CalculiX => "CalculiX",
        };
        deck.comment(&format!("Contact of {name} for {reader}, by shtaerman {version}"));
        deck.line(&units.comment());
        Self { deck, program, units, length }
    }

    pub(crate) fn text(self) -> String {
        self.deck.text()
    }

    /// A value of this SI size in the units of the model, with its unit.
    fn shown(&self, value: f64, unit: f64, name: &str) -> String {
        format!("{} {name}", significant(value / unit, DIGITS))
    }

    fn pressure(&self, value: f64) -> String {
        let [_, _, name] = self.units.names();
        self.shown(value, self.units.pressure(), name)
    }

    fn displacement(&self, value: f64) -> String {
        let [_, name, _] = self.units.names();
        self.shown(value, self.units.length(), name)
    }

    /// Pressure-overclosure and penalty.
    pub(crate) fn surface(&mut self, export: &SurfaceExport) {
        let SurfaceExport { contact, table, share, reach, .. } = export;
        self.law(contact.problem().foundation().roughness());
        let (mean, peak) =
            (self.pressure(contact.mean_pressure()), self.pressure(contact.peak_pressure()));
        self.deck.comment(&format!(
            "Table: {} points, from zero to {} times the largest pressure of this contact, {peak}.",
            table.points().len(),
            significant(*reach, DIGITS)
        ));
        if table.deviation() > 0.0 {
            self.deck.comment(&format!(
                "Straight lines between them are within {} of the law above {mean}, the mean pressure on the base, and below it within the same share of the overclosure under that.",
                significant(*share, 3)
            ));
        }
        self.deck.comment(match self.program {
            Program::Abaqus => "Beyond the last point Abaqus goes on with the last slope.",
            Program::CalculiX => "Beyond the last point CalculiX keeps the last pressure: see that no pressure of the model gets there. CalculiX uses tables in contact of TYPE=NODE TO SURFACE; with SURFACE TO SURFACE version 2.20 gives no pressure without a message, or breaks down.",
        });
        self.deck.line("*SURFACE INTERACTION, NAME=ROUGH_LAYER");
        self.deck.line("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR");
        let (pressure, length) = (self.units.pressure(), self.units.length());
        self.deck.rows(table.points().iter().map(|[p, v]| [p / pressure, v / length]));
        self.penalty(export);
    }

    fn law(&mut self, roughness: Roughness) {
        let [_, length, pressure] = self.units.names();
        let one = self.displacement(roughness.displacement(self.units.pressure()));
        match roughness {
            Roughness::Power { exponent, .. } => self.deck.comment(&format!(
                "Rough layer: overclosure in {length} = {one} (pressure in {pressure})^{exponent}",
                one = significant(
                    roughness.displacement(self.units.pressure()) / self.units.length(),
                    DIGITS
                )
            )),
            _ => {
                self.deck.comment(&format!("Rough layer: overclosure = {one} for each {pressure}. This law is linear: in place of the table, and without an end, these two lines are the same."));
                self.linear(1.0 / roughness.displacement(1.0));
            }
        }
    }

    /// A linear law as a comment, its stiffness in Pa/m.
    fn linear(&mut self, stiffness: f64) {
        let unit = self.units.pressure() / self.units.length();
        self.deck.line("** *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR");
        self.deck.line(&format!("** {}", field(stiffness / unit)));
    }

    fn penalty(&mut self, export: &SurfaceExport) {
        let penalty = match &export.penalty {
            Ok(penalty) => penalty,
            Err(reason) => return self.deck.comment(&format!("No penalty stiffness: {reason}")),
        };
        let (mean, settlement) =
            (self.pressure(penalty.mean_pressure), self.displacement(penalty.settlement));
        self.deck.comment(&format!(
            "Penalty: where the layer is modelled otherwise (as by gasket elements), a penalty contact in series with it adds {mean}/k to the settlement since lift-off, {settlement} here. From this k on that is at most {} of it:",
            significant(penalty.share, 3)
        ));
        self.linear(penalty.stiffness);
    }

    /// Factors from SI to the model: of forces (N, N/m), moments (N m, N), lengths.
    fn loads(&self) -> [f64; 2] {
        let length = self.length.unwrap_or(1.0);
        [length, length / self.units.length()]
    }

    fn span(&self) -> String {
        match self.length {
            Some(length) => format!(
                "Forces and moments are those of {} of the punch out of the plane.",
                self.displacement(length)
            ),
            None => "Forces and moments are those of the whole punch.".to_owned(),
        }
    }

    fn accuracy(&mut self, curve: &LoadCurve, of: &str) {
        self.deck.comment(&format!(
            "{} solved points, each with a relative error of {:.0e} or less (estimate); straight lines between them are off by at most {:.1e} of the range of the {of} (estimate).",
            curve.points.len(),
            curve.relative_error.max(1e-16),
            curve.deviation.max(1e-16)
        ));
        let span = self.span();
        self.deck.comment(&span);
    }

    /// `P(delta)`.
    pub(crate) fn force(&mut self, export: &ForceExport<'_>) {
        let ForceExport { problem, curve, datum } = export;
        let stays = match problem.load().rotational() {
            Rotational::Tilt(tilt) => format!("at the tilt {} rad", significant(tilt, DIGITS)),
            _ => "at the eccentricity M/P of the file".to_owned(),
        };
        self.deck.comment(&format!("Force against settlement since lift-off, {stays}."));
        let against = match datum {
            Some(Datum::Distance(x)) => {
                format!(
                    "The settlement is that relative to the surface at x = {}.",
                    self.displacement(*x)
                )
            }
            Some(Datum::Depth(depth)) => format!(
                "The settlement is that relative to the point at the depth {} under the middle.",
                self.displacement(*depth)
            ),
            None => format!("The settlement is measured against: {}.", problem.gauge()),
        };
        self.deck.comment(&against);
        self.accuracy(curve, "settlement");
        match self.program {
            Program::Abaqus => {
                self.deck.comment("Connector: first node on the body, second on the punch, first local direction into the body. Beyond its ends the force is constant: zero after lift-off.");
                self.deck.line("*CONNECTOR BEHAVIOR, NAME=PUNCH_FORCE");
                self.deck.line("*CONNECTOR ELASTICITY, COMPONENT=1, NONLINEAR");
            }
            Program::CalculiX => {
                self.deck.comment("Spring: first node moves with the body and lies outside of it, on the far side of the second, which is on the punch; so pressing lengthens the spring. Define *ELEMENT, TYPE=SPRINGA, ELSET=PUNCH_FORCE before. Use *STEP, NLGEOM and small increments: without NLGEOM CalculiX takes the first slope alone, and beyond the ends the force is constant: zero after lift-off.");
                self.deck.line("*SPRING, ELSET=PUNCH_FORCE, NONLINEAR");
            }
        }
        let ([force, _], length) = (self.loads(), self.units.length());
        self.deck.rows(curve.points.iter().map(|[u, p]| [p * force, u / length]));
    }

    /// `M(-alpha)`.
    pub(crate) fn moment(&mut self, curve: &LoadCurve) {
        self.deck.comment("Moment against rotation in rad, under the force of the file; a positive moment and a positive rotation press the side of positive x into the body.");
        self.accuracy(curve, "rotation");
        match self.program {
            Program::Abaqus => {
                self.deck.comment("Connector: first node on the body, second on the punch; the rotation about the third local direction, with the sign above. Beyond its ends the moment is constant.");
                self.deck.line("*CONNECTOR BEHAVIOR, NAME=PUNCH_MOMENT");
                self.deck.line("*CONNECTOR ELASTICITY, COMPONENT=6, NONLINEAR");
            }
            Program::CalculiX => {
                self.deck.comment("Spring: second node the ROT NODE of a *RIGID BODY, whose displacements are the rotations of the punch, first node fixed beside it along the axis of the rotation; so turning lengthens the spring. Define *ELEMENT, TYPE=SPRINGA, ELSET=PUNCH_MOMENT before, and use *STEP, NLGEOM and small increments. Beyond its ends the moment is constant.");
                self.deck.line("*SPRING, ELSET=PUNCH_MOMENT, NONLINEAR");
            }
        }
        let [_, moment] = self.loads();
        self.deck.rows(curve.points.iter().map(|[u, m]| [m * moment, *u]));
    }
}

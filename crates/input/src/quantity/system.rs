//! Systems of units in which results are shown.

use super::format::Step;
use super::parse::parse;
use super::{AxisUnit, Dimension, DisplayUnit, QuantityError, axis_unit, engineering_with_digits};

/// What a shown number measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Measure {
    /// A place, a width, a radius, a depth below the surface.
    Length,
    /// A settlement, a height of a profile, a gap.
    Displacement,
    /// A pressure, a stress, a modulus.
    Pressure,
    /// A force for each unit of length along the punch.
    ForcePerLength,
    /// A force.
    Force,
    /// A moment for each unit of length along the punch.
    MomentPerLength,
    /// A moment.
    Moment,
    /// An angle.
    Angle,
    /// Displacement for each unit of pressure.
    Compliance,
}

impl Measure {
    const ALL: [Self; 9] = [
        Self::Length,
        Self::Displacement,
        Self::Pressure,
        Self::ForcePerLength,
        Self::Force,
        Self::MomentPerLength,
        Self::Moment,
        Self::Angle,
        Self::Compliance,
    ];

    /// The dimension of its units.
    #[must_use]
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Length | Self::Displacement => Dimension::LENGTH,
            Self::Pressure => Dimension::PRESSURE,
            Self::ForcePerLength => Dimension::FORCE_PER_LENGTH,
            Self::Force => Dimension::FORCE,
            Self::MomentPerLength => Dimension::MOMENT_PER_LENGTH,
            Self::Moment => Dimension::MOMENT,
            Self::Angle => Dimension::NONE,
            Self::Compliance => Dimension::COMPLIANCE,
        }
    }

    /// The unit of SI that takes prefixes.
    fn usual(self) -> DisplayUnit {
        match self {
            Self::Angle => DisplayUnit::angle(),
            // N m/m is N, which has prefixes.
            Self::MomentPerLength | Self::Force => DisplayUnit::prefixed("N"),
            other => other.dimension().into(),
        }
    }
}

/// Metres in an inch, newtons in a pound-force, pascals in a pound-force for each square inch; exact by definition but for the rounding of the last.
const INCH: f64 = 0.0254;
const POUND_FORCE: f64 = 4.448_221_615_260_5;
const PSI: f64 = POUND_FORCE / (INCH * INCH);

/// The smallest step of a unit stands for everything below the next.
const LEAST: i32 = i32::MIN;
const INCHES: &[Step] = &[Step::new(LEAST, -6, "µin"), Step::new(-3, 0, "in")];
const PRESSURES: &[Step] =
    &[Step::new(LEAST, 0, "psi"), Step::new(3, 3, "ksi"), Step::new(6, 6, "Msi")];
const FORCES_PER_INCH: &[Step] = &[Step::new(LEAST, 0, "lbf/in"), Step::new(3, 3, "kip/in")];
const FORCES: &[Step] = &[Step::new(LEAST, 0, "lbf"), Step::new(3, 3, "kip")];
const MOMENTS_PER_INCH: &[Step] = &[Step::new(LEAST, 0, "lbf in/in"), Step::new(3, 3, "kip in/in")];
const MOMENTS: &[Step] = &[Step::new(LEAST, 0, "lbf in"), Step::new(3, 3, "kip in")];

/// The units in which tables, plots and columns show results; SI with prefixes unless others were chosen.
///
/// ```
/// use shtaerman_input::quantity::{Measure, OutputUnits};
///
/// let inch = OutputUnits::named("inch").unwrap();
/// assert_eq!(inch.shown(5e-3, Measure::Length), "0.19685 in");
/// assert_eq!(inch.shown(3e-6, Measure::Displacement), "118.11 µin");
/// let own = OutputUnits::default().with(Measure::Pressure, "ksi")?;
/// assert_eq!(own.shown(350e6, Measure::Pressure), "50.7632 ksi");
/// assert_eq!(own.shown(5e-3, Measure::Length), "5 mm");
/// # Ok::<(), shtaerman_input::quantity::QuantityError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OutputUnits {
    chosen: Vec<(Measure, DisplayUnit)>,
    /// Whether they were chosen, be it SI.
    are_own: bool,
}

impl OutputUnits {
    /// The names of systems.
    pub const SYSTEMS: [&str; 3] = ["si", "mm", "inch"];

    /// A system by its name: `si`, with prefixes; `mm`, millimetres, micrometres for displacements, newtons and megapascals; `inch`, inches and pounds-force.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let chosen = match name {
            "si" => Vec::new(),
            "mm" => Self::millimetres(),
            "inch" => Self::inches(),
            _ => return None,
        };
        Some(Self { chosen, are_own: true })
    }

    fn millimetres() -> Vec<(Measure, DisplayUnit)> {
        [
            (Measure::Length, "mm", -3),
            (Measure::Displacement, "µm", -6),
            (Measure::Pressure, "MPa", 6),
            (Measure::ForcePerLength, "N/mm", 3),
            (Measure::Force, "N", 0),
            (Measure::MomentPerLength, "N mm/mm", 0),
            (Measure::Moment, "N mm", -3),
            (Measure::Compliance, "µm/MPa", -12),
        ]
        .map(|(measure, symbol, exponent)| (measure, DisplayUnit::fixed(symbol, exponent)))
        .into()
    }

    fn inches() -> Vec<(Measure, DisplayUnit)> {
        vec![
            (Measure::Length, DisplayUnit::stepped(INCH, INCHES)),
            (Measure::Displacement, DisplayUnit::stepped(INCH, INCHES)),
            (Measure::Pressure, DisplayUnit::stepped(PSI, PRESSURES)),
            (Measure::ForcePerLength, DisplayUnit::stepped(POUND_FORCE / INCH, FORCES_PER_INCH)),
            (Measure::Force, DisplayUnit::stepped(POUND_FORCE, FORCES)),
            (Measure::MomentPerLength, DisplayUnit::stepped(POUND_FORCE, MOMENTS_PER_INCH)),
            (Measure::Moment, DisplayUnit::stepped(POUND_FORCE * INCH, MOMENTS)),
            (Measure::Compliance, DisplayUnit::of_size("µin/ksi", 1e-9 * INCH / PSI)),
        ]
    }

    /// The same with a unit of one's own for what is measured, such as `ksi`.
    ///
    /// # Errors
    /// [`QuantityError`] for what is no unit of that dimension.
    pub fn with(&self, measure: Measure, unit: &str) -> Result<Self, QuantityError> {
        let text = format!("1 {}", unit.trim());
        let quantity = parse(&text)?;
        let size = quantity.of(measure.dimension(), &text)?;
        let mut chosen = self.chosen.clone();
        chosen.retain(|(known, _)| *known != measure);
        chosen.push((measure, DisplayUnit::of_size(unit.trim(), size)));
        Ok(Self { chosen, are_own: true })
    }

    /// Whether units were chosen; columns of a file are then in these, and their heads say so.
    #[must_use]
    pub fn are_chosen(&self) -> bool {
        self.are_own
    }

    /// Whether the unit of what is measured was chosen.
    #[must_use]
    pub fn has(&self, measure: Measure) -> bool {
        self.chosen.iter().any(|(known, _)| *known == measure)
    }

    /// The unit of what is measured.
    #[must_use]
    pub fn unit(&self, measure: Measure) -> DisplayUnit {
        let chosen = self.chosen.iter().find(|(known, _)| *known == measure);
        chosen.map_or_else(|| measure.usual(), |(_, unit)| unit.clone())
    }

    /// A value of SI with its unit and at most 6 digits.
    #[must_use]
    pub fn shown(&self, value: f64, measure: Measure) -> String {
        super::engineering(value, self.unit(measure))
    }

    /// The same with at most so many digits.
    #[must_use]
    pub fn shown_with_digits(&self, value: f64, measure: Measure, digits: usize) -> String {
        engineering_with_digits(value, self.unit(measure), digits)
    }

    /// One unit for all values of an axis.
    #[must_use]
    pub fn axis(&self, largest: f64, measure: Measure) -> AxisUnit {
        axis_unit(largest, self.unit(measure))
    }

    /// The one unit of a column, whatever its values: that of SI without a prefix where none was chosen.
    #[must_use]
    pub fn column(&self, measure: Measure) -> AxisUnit {
        if !self.has(measure) {
            let label = match measure {
                Measure::Angle => "rad".to_owned(),
                Measure::MomentPerLength | Measure::Force => "N".to_owned(),
                other => other.dimension().unit(),
            };
            return AxisUnit { factor: 1.0, label };
        }
        self.unit(measure).whole()
    }

    /// All that is measured, with the units chosen for it.
    pub fn iter(&self) -> impl Iterator<Item = (Measure, DisplayUnit)> + '_ {
        Measure::ALL.into_iter().map(|measure| (measure, self.unit(measure)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_are_read_back_as_the_units_they_stand_for() {
        for name in OutputUnits::SYSTEMS {
            for (measure, _) in OutputUnits::default().iter() {
                let units = OutputUnits::named(name).unwrap();
                for value in [3.7e-9, 2.5e-4, 1.0, 125.0, 8e5, 2.2e11] {
                    let text = units.shown_with_digits(value, measure, 15);
                    let read = parse(&text).unwrap().of(measure.dimension(), &text).unwrap();
                    assert!(
                        (read / value - 1.0).abs() < 1e-13,
                        "{name} {measure:?} {value}: {text}"
                    );
                    let column = units.column(measure);
                    let text = format!("{:e} {}", value * column.factor, column.label);
                    let read = parse(&text).unwrap().of(measure.dimension(), &text).unwrap();
                    assert!(
                        (read / value - 1.0).abs() < 1e-13,
                        "{name} {measure:?} {value}: {text}"
                    );
                    let axis = units.axis(value, measure);
                    let text = format!("{:e} {}", value * axis.factor, axis.label);
                    let read = parse(&text).unwrap().of(measure.dimension(), &text).unwrap();
                    assert!(
                        (read / value - 1.0).abs() < 1e-13,
                        "{name} {measure:?} {value}: {text}"
                    );
                }
            }
        }
    }

    #[test]
    fn inches_are_shown_as_people_write_them() {
        let inch = OutputUnits::named("inch").unwrap();
        for (value, measure, text) in [
            (0.0254, Measure::Length, "1 in"),
            (2.54e-5, Measure::Length, "0.001 in"),
            (2.54e-6, Measure::Displacement, "100 µin"),
            (350e6, Measure::Pressure, "50.7632 ksi"),
            (200e9, Measure::Pressure, "29.0075 Msi"),
            (8e5, Measure::ForcePerLength, "4.56812 kip/in"),
            (0.0, Measure::Length, "0 in"),
        ] {
            assert_eq!(inch.shown(value, measure), text);
        }
    }

    #[test]
    fn a_unit_of_another_dimension_is_refused() {
        let units = OutputUnits::default();
        let said = units.with(Measure::Pressure, "mm").unwrap_err().to_string();
        assert!(said.contains("a pressure") && said.contains("mm"), "{said}");
        assert!(units.with(Measure::Length, "furlong").is_err());
        assert!(!units.are_chosen() && units.with(Measure::Length, "mil").unwrap().are_chosen());
    }
}

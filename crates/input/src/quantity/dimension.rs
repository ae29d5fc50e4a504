//! Dimensions: the exponents of length, mass and time.

use std::fmt;

/// The dimension of a quantity, `length^l mass^m time^t`.
///
/// Angles are dimensionless (the radian is 1), so [`Dimension::NONE`] covers plain numbers and
/// angles alike.
///
/// ```
/// use shtaerman_input::quantity::Dimension;
/// assert_eq!(Dimension::PRESSURE.to_string(), "a pressure (Pa)");
/// assert_eq!(Dimension::new(0, 2, -5).to_string(), "a quantity in kg^2 s^-5");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Dimension {
    length: i8,
    mass: i8,
    time: i8,
}

impl Dimension {
    /// A plain number, or an angle.
    pub const NONE: Self = Self::new(0, 0, 0);
    /// A length, m.
    pub const LENGTH: Self = Self::new(1, 0, 0);
    /// An area, m^2.
    pub const AREA: Self = Self::new(2, 0, 0);
    /// A curvature or a wave number, 1/m.
    pub const CURVATURE: Self = Self::new(-1, 0, 0);
    /// A pressure, a stress or an elastic modulus, Pa = kg/(m s^2).
    pub const PRESSURE: Self = Self::new(-1, 1, -2);
    /// Displacement for each unit of pressure, m/Pa: the roughness compliance.
    pub const COMPLIANCE: Self = Self::new(2, -1, 2);
    /// Pressure for each unit of displacement, Pa/m: the inverse of a compliance.
    pub const SUBGRADE_MODULUS: Self = Self::new(-2, 1, -2);
    /// Force for each unit of length along the punch, N/m.
    pub const FORCE_PER_LENGTH: Self = Self::new(0, 1, -2);
    /// Moment for each unit of length along the punch, N m/m, which is N.
    pub const MOMENT_PER_LENGTH: Self = Self::new(1, 1, -2);
    /// A force, N. The same dimension as [`Dimension::MOMENT_PER_LENGTH`].
    pub const FORCE: Self = Self::MOMENT_PER_LENGTH;
    /// A moment or an energy, N m = J.
    pub const MOMENT: Self = Self::new(2, 1, -2);
    /// A mass, kg.
    pub const MASS: Self = Self::new(0, 1, 0);
    /// A time, s.
    pub const TIME: Self = Self::new(0, 0, 1);

    /// A dimension from its exponents of length, mass and time.
    #[must_use]
    pub const fn new(length: i8, mass: i8, time: i8) -> Self {
        Self { length, mass, time }
    }

    /// The exponents of length, mass and time.
    #[must_use]
    pub const fn exponents(self) -> [i8; 3] {
        [self.length, self.mass, self.time]
    }

    /// The dimension of a product; none if an exponent leaves the range of `i8`.
    #[must_use]
    pub fn checked_mul(self, other: Self) -> Option<Self> {
        Some(Self {
            length: self.length.checked_add(other.length)?,
            mass: self.mass.checked_add(other.mass)?,
            time: self.time.checked_add(other.time)?,
        })
    }

    /// The dimension of a whole power; none if an exponent leaves the range of `i8`.
    #[must_use]
    pub fn checked_pow(self, power: i8) -> Option<Self> {
        Some(Self {
            length: self.length.checked_mul(power)?,
            mass: self.mass.checked_mul(power)?,
            time: self.time.checked_mul(power)?,
        })
    }

    /// What a quantity of this dimension is called, with its article, if it has a name.
    #[must_use]
    pub fn name(self) -> Option<&'static str> {
        self.entry().map(|entry| entry.name)
    }

    /// The SI unit of this dimension, such as `Pa` or `kg^2 s^-5`; empty for a plain number.
    #[must_use]
    pub fn unit(self) -> String {
        self.entry().map_or_else(|| self.base_units(), |entry| entry.unit.to_owned())
    }

    /// How a quantity of this dimension may be written, for messages: `"5 mm"` with its quotes.
    #[must_use]
    pub fn example(self) -> String {
        match self.entry() {
            Some(entry) => entry.example.to_owned(),
            None => format!("\"1 {}\"", self.base_units()),
        }
    }

    fn entry(self) -> Option<&'static Named> {
        NAMED.iter().find(|entry| entry.dimension == self)
    }

    fn base_units(self) -> String {
        let factors = [("kg", self.mass), ("m", self.length), ("s", self.time)];
        let written: Vec<String> = factors
            .iter()
            .filter(|(_, exponent)| *exponent != 0)
            .map(|(unit, exponent)| match exponent {
                1 => (*unit).to_owned(),
                _ => format!("{unit}^{exponent}"),
            })
            .collect();
        written.join(" ")
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.entry() {
            Some(entry) if entry.unit.is_empty() => formatter.write_str(entry.name),
            Some(entry) => write!(formatter, "{} ({})", entry.name, entry.unit),
            None => write!(formatter, "a quantity in {}", self.base_units()),
        }
    }
}

struct Named {
    dimension: Dimension,
    name: &'static str,
    unit: &'static str,
    example: &'static str,
}

const fn named(
    dimension: Dimension,
    name: &'static str,
    unit: &'static str,
    example: &'static str,
) -> Named {
    Named { dimension, name, unit, example }
}

const NAMED: &[Named] = &[
    named(Dimension::NONE, "a plain number or an angle", "", "0.5 or \"0.1 mrad\""),
    named(Dimension::LENGTH, "a length", "m", "\"5 mm\""),
    named(Dimension::AREA, "an area", "m^2", "\"5 mm^2\""),
    named(Dimension::CURVATURE, "an inverse length", "1/m", "\"5 1/m\""),
    named(Dimension::PRESSURE, "a pressure", "Pa", "\"200 GPa\""),
    named(Dimension::COMPLIANCE, "a compliance", "m/Pa", "\"0.1 µm/MPa\""),
    named(Dimension::SUBGRADE_MODULUS, "a subgrade modulus", "Pa/m", "\"10 MPa/µm\""),
    named(Dimension::FORCE_PER_LENGTH, "a force per length", "N/m", "\"1 MN/m\""),
    named(
        Dimension::MOMENT_PER_LENGTH,
        "a force or a moment per length",
        "N m/m",
        "\"100 N\" or \"100 N m/m\"",
    ),
    named(Dimension::MOMENT, "a moment", "N m", "\"100 N m\""),
    named(Dimension::MASS, "a mass", "kg", "\"2 kg\""),
    named(Dimension::TIME, "a time", "s", "\"3 s\""),
];

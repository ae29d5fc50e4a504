//! The table of units and prefixes.
//!
//! Factors are kept as whole numbers and powers of ten, so that a decimal unit costs no rounding:
//! `0.1 mm` is the double nearest to `0.0001`. Exact by definition: inch, foot, yard, mil
//! (international yard, 1959), pound-force (with g = 9.80665 m/s^2), bar, atmosphere; NIST SP 811,
//! appendix B.

use std::f64::consts::PI;

use super::dimension::Dimension;

/// A factor `numerator/denominator * 10^exponent` to SI, and its dimension.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scale {
    pub(super) numerator: f64,
    pub(super) denominator: f64,
    pub(super) exponent: i64,
    pub(super) dimension: Dimension,
}

impl Scale {
    pub(super) const ONE: Self = decimal(0, Dimension::NONE);

    /// The product, none if powers overflow.
    pub(super) fn checked_mul(self, other: Self) -> Option<Self> {
        Some(Self {
            numerator: self.numerator * other.numerator,
            denominator: self.denominator * other.denominator,
            exponent: self.exponent.checked_add(other.exponent)?,
            dimension: self.dimension.checked_mul(other.dimension)?,
        })
    }

    /// The whole power, none if powers overflow.
    pub(super) fn checked_pow(self, power: i8) -> Option<Self> {
        let (numerator, denominator) = if power < 0 {
            (self.denominator, self.numerator)
        } else {
            (self.numerator, self.denominator)
        };
        let size = i32::from(power.unsigned_abs());
        Some(Self {
            numerator: numerator.powi(size),
            denominator: denominator.powi(size),
            exponent: self.exponent.checked_mul(i64::from(power))?,
            dimension: self.dimension.checked_pow(power)?,
        })
    }
}

struct Unit {
    symbol: &'static str,
    prefixes: &'static str,
    scale: Scale,
}

const fn decimal(exponent: i64, dimension: Dimension) -> Scale {
    Scale { numerator: 1.0, denominator: 1.0, exponent, dimension }
}

const fn ratio(numerator: f64, denominator: f64, exponent: i64, dimension: Dimension) -> Scale {
    Scale { numerator, denominator, exponent, dimension }
}

const fn unit(symbol: &'static str, prefixes: &'static str, scale: Scale) -> Unit {
    Unit { symbol, prefixes, scale }
}

/// Of the prefixes, `µ` (U+00B5) and `μ` (U+03BC) are the same, and `u` stands for them in ASCII.
const SI: &str = "pnuµμmckMGT";
const SI_OF_METRE: &str = "pnuµμmcdkMGT";
const SI_OF_PASCAL: &str = "pnuµμmchkMGT";
const SI_OF_ANGLE: &str = "nuµμm";
const NO_PREFIX: &str = "";

/// One pound-force is exactly 4.4482216152605 N.
const POUND_FORCE: f64 = 44_482_216_152_605.0;
const POUND_FORCE_EXPONENT: i64 = -13;
/// One inch is exactly 254e-4 m.
const INCH: f64 = 254.0;
const INCH_EXPONENT: i64 = -4;
const FOOT: f64 = 3048.0;
const PSI_EXPONENT: i64 = POUND_FORCE_EXPONENT - 2 * INCH_EXPONENT;

const fn pounds(ounces: f64, exponent: i64) -> Scale {
    ratio(POUND_FORCE * ounces, 16.0, POUND_FORCE_EXPONENT + exponent, Dimension::FORCE)
}

const fn psi(exponent: i64) -> Scale {
    ratio(POUND_FORCE, INCH * INCH, PSI_EXPONENT + exponent, Dimension::PRESSURE)
}

const UNITS: &[Unit] = &[
    unit("m", SI_OF_METRE, decimal(0, Dimension::LENGTH)),
    unit("Pa", SI_OF_PASCAL, decimal(0, Dimension::PRESSURE)),
    unit("N", SI, decimal(0, Dimension::FORCE)),
    unit("g", SI, decimal(-3, Dimension::MASS)),
    unit("t", NO_PREFIX, decimal(3, Dimension::MASS)),
    unit("s", SI, decimal(0, Dimension::TIME)),
    unit("min", NO_PREFIX, ratio(60.0, 1.0, 0, Dimension::TIME)),
    unit("h", NO_PREFIX, ratio(3600.0, 1.0, 0, Dimension::TIME)),
    unit("J", SI, decimal(0, Dimension::MOMENT)),
    unit("bar", SI, decimal(5, Dimension::PRESSURE)),
    unit("atm", NO_PREFIX, ratio(101_325.0, 1.0, 0, Dimension::PRESSURE)),
    unit("in", NO_PREFIX, ratio(INCH, 1.0, INCH_EXPONENT, Dimension::LENGTH)),
    unit("ft", NO_PREFIX, ratio(FOOT, 1.0, -4, Dimension::LENGTH)),
    unit("yd", NO_PREFIX, ratio(9144.0, 1.0, -4, Dimension::LENGTH)),
    unit("mil", NO_PREFIX, ratio(INCH, 1.0, INCH_EXPONENT - 3, Dimension::LENGTH)),
    unit("thou", NO_PREFIX, ratio(INCH, 1.0, INCH_EXPONENT - 3, Dimension::LENGTH)),
    unit("uin", NO_PREFIX, ratio(INCH, 1.0, INCH_EXPONENT - 6, Dimension::LENGTH)),
    unit("µin", NO_PREFIX, ratio(INCH, 1.0, INCH_EXPONENT - 6, Dimension::LENGTH)),
    unit("μin", NO_PREFIX, ratio(INCH, 1.0, INCH_EXPONENT - 6, Dimension::LENGTH)),
    unit("psi", NO_PREFIX, psi(0)),
    unit("ksi", NO_PREFIX, psi(3)),
    unit("Msi", NO_PREFIX, psi(6)),
    unit(
        "psf",
        NO_PREFIX,
        ratio(POUND_FORCE, FOOT * FOOT, POUND_FORCE_EXPONENT + 8, Dimension::PRESSURE),
    ),
    unit("lbf", NO_PREFIX, pounds(16.0, 0)),
    unit("kip", NO_PREFIX, pounds(16.0, 3)),
    unit("ozf", NO_PREFIX, pounds(1.0, 0)),
    unit("kgf", NO_PREFIX, ratio(980_665.0, 1.0, -5, Dimension::FORCE)),
    unit("dyn", NO_PREFIX, decimal(-5, Dimension::FORCE)),
    unit("rad", SI_OF_ANGLE, decimal(0, Dimension::NONE)),
    unit("deg", NO_PREFIX, ratio(PI, 180.0, 0, Dimension::NONE)),
    unit("°", NO_PREFIX, ratio(PI, 180.0, 0, Dimension::NONE)),
];

const fn power_of_prefix(prefix: char) -> Option<i64> {
    match prefix {
        'p' => Some(-12),
        'n' => Some(-9),
        'u' | 'µ' | 'μ' => Some(-6),
        'm' => Some(-3),
        'c' => Some(-2),
        'd' => Some(-1),
        'h' => Some(2),
        'k' => Some(3),
        'M' => Some(6),
        'G' => Some(9),
        'T' => Some(12),
        _ => None,
    }
}

/// The scale of a unit symbol with or without a prefix; none if there is no such unit.
pub(super) fn look_up(symbol: &str) -> Option<Scale> {
    if let Some(unit) = UNITS.iter().find(|unit| unit.symbol == symbol) {
        return Some(unit.scale);
    }
    let prefix = symbol.chars().next()?;
    let exponent = power_of_prefix(prefix)?;
    let rest = &symbol[prefix.len_utf8()..];
    let unit = UNITS.iter().find(|unit| unit.symbol == rest && unit.prefixes.contains(prefix))?;
    Some(Scale { exponent: unit.scale.exponent + exponent, ..unit.scale })
}

/// Words that people write for units, and what is read for them.
const WORDS: &[(&str, &str)] = &[
    ("inch", "in"),
    ("inches", "in"),
    ("\"", "in"),
    ("zoll", "in"),
    ("mils", "mil"),
    ("thous", "thou"),
    ("microinch", "uin"),
    ("microinches", "uin"),
    ("foot", "ft"),
    ("feet", "ft"),
    ("yard", "yd"),
    ("yards", "yd"),
    ("metre", "m"),
    ("metres", "m"),
    ("meter", "m"),
    ("meters", "m"),
    ("micron", "µm"),
    ("microns", "µm"),
    ("µ", "µm"),
    ("μ", "µm"),
    ("micrometre", "µm"),
    ("micrometres", "µm"),
    ("micrometer", "µm"),
    ("micrometers", "µm"),
    ("mikrometer", "µm"),
    ("millimetre", "mm"),
    ("millimetres", "mm"),
    ("millimeter", "mm"),
    ("millimeters", "mm"),
    ("centimetre", "cm"),
    ("centimetres", "cm"),
    ("centimeter", "cm"),
    ("centimeters", "cm"),
    ("zentimeter", "cm"),
    ("nanometre", "nm"),
    ("nanometres", "nm"),
    ("nanometer", "nm"),
    ("nanometers", "nm"),
    ("newton", "N"),
    ("newtons", "N"),
    ("pascal", "Pa"),
    ("pascals", "Pa"),
    ("lb", "lbf"),
    ("lbs", "lbf"),
    ("kp", "kgf"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("radian", "rad"),
    ("radians", "rad"),
    ("sec", "s"),
    ("joule", "J"),
    ("tonne", "t"),
];

/// The symbol of a unit whose name is written out, in any case of letters.
pub(crate) fn spelled_out(written: &str) -> Option<&'static str> {
    let lower = written.to_lowercase();
    WORDS.iter().find(|(word, _)| *word == lower).map(|(_, symbol)| *symbol)
}

/// Symbols proposed for an unknown unit, the usual ones first: of `mpa` comes `MPa`, not `mPa`.
const PROPOSED: &[&str] = &[
    "MPa", "GPa", "kPa", "Pa", "hPa", "mm", "µm", "um", "nm", "m", "km", "cm", "kN", "MN", "N",
    "mN", "kg", "g", "s", "bar", "mbar", "atm", "in", "ft", "yd", "mil", "thou", "uin", "psi",
    "ksi", "Msi", "psf", "lbf", "kip", "ozf", "kgf", "dyn", "rad", "mrad", "µrad", "urad", "deg",
    "J", "kJ", "t",
];

/// What was perhaps meant by an unknown unit.
pub(super) fn suggest(written: &str) -> Option<String> {
    if let Some(symbol) = spelled_out(written) {
        return Some(symbol.to_owned());
    }
    let lower = written.to_lowercase();
    // Before a change of case: Nmm is N mm run together, and not a slip for nm.
    if let Some(product) = split(written) {
        return Some(product);
    }
    if let Some(symbol) = PROPOSED.iter().find(|symbol| symbol.to_lowercase() == lower) {
        return Some((*symbol).to_owned());
    }
    crate::nearest(written, PROPOSED.iter().copied()).map(str::to_owned)
}

/// Two known units run together, written apart.
fn split(written: &str) -> Option<String> {
    (1..written.len()).filter(|at| written.is_char_boundary(*at)).find_map(|at| {
        let (left, right) = written.split_at(at);
        (look_up(left).is_some() && look_up(right).is_some()).then(|| format!("{left} {right}"))
    })
}

/// The unit symbols, for a message that has no better help.
pub(super) fn catalogue() -> String {
    let symbols: Vec<&str> =
        UNITS.iter().map(|unit| unit.symbol).filter(|symbol| symbol.is_ascii()).collect();
    format!("{} (with SI prefixes such as µm, kN, GPa)", symbols.join(", "))
}

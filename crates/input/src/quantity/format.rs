//! SI values written for people, with prefixes in steps of a thousand.

use super::Dimension;

/// The digits that [`engineering`] writes at most.
const DEFAULT_DIGITS: usize = 6;

/// More digits than this say nothing about a 64-bit float.
const MOST_DIGITS: usize = 17;

/// Without a prefix, numbers from `1e-4` up to below `1e6` are written without an exponent.
const PLAIN_EXPONENTS: std::ops::Range<i32> = -4..6;

const PREFIXES: [(i32, &str); 9] =
    [(-12, "p"), (-9, "n"), (-6, "µ"), (-3, "m"), (0, ""), (3, "k"), (6, "M"), (9, "G"), (12, "T")];

/// A number in SI units, or of no dimension, as short as it can be read back: with an exponent where digits would only count zeros.
///
/// ```
/// use shtaerman_input::quantity::plain;
/// assert_eq!(["0.005", "1e300"], [plain(0.005), plain(1e300)].each_ref().map(String::as_str));
/// ```
#[must_use]
pub fn plain(value: f64) -> String {
    if value == 0.0 || !value.is_finite() || (1e-7..1e16).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// The unit in which values of one kind are shown, and the prefixes it takes.
///
/// A [`Dimension`] converts to the unit usual for it; angles, which have no dimension, are asked
/// for by [`DisplayUnit::angle`].
#[derive(Debug, Clone, PartialEq)]
pub struct DisplayUnit {
    symbol: String,
    /// One of this unit is `size 10^exponent` in SI.
    size: f64,
    exponent: i32,
    /// The powers of ten of the least and the greatest prefix.
    prefixes: (i32, i32),
    /// Symbols of its own for powers of ten, in place of prefixes.
    steps: &'static [Step],
}

/// A power of ten of a unit that has a symbol of its own, such as the `ksi` of `psi`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Step {
    /// Values from this power of ten on, in the unit without a step, are shown by it.
    from: i32,
    power: i32,
    symbol: &'static str,
}

impl Step {
    pub(super) const fn new(from: i32, power: i32, symbol: &'static str) -> Self {
        Self { from, power, symbol }
    }
}

impl DisplayUnit {
    /// A plain number.
    pub const NUMBER: Self =
        Self { symbol: String::new(), size: 1.0, exponent: 0, prefixes: (0, 0), steps: &[] };

    /// An angle: `rad`, `mrad`, `µrad`, `nrad`.
    #[must_use]
    pub fn angle() -> Self {
        Self { symbol: "rad".to_owned(), prefixes: (-9, 0), ..Self::NUMBER }
    }

    /// A unit without prefixes, `10^exponent` in SI.
    #[must_use]
    pub fn fixed(symbol: &str, exponent: i32) -> Self {
        Self { symbol: symbol.to_owned(), exponent, ..Self::NUMBER }
    }

    /// A unit of SI whose first symbol takes the prefixes from `p` to `T`.
    #[must_use]
    pub fn prefixed(symbol: &str) -> Self {
        Self { symbol: symbol.to_owned(), prefixes: (-12, 12), ..Self::NUMBER }
    }

    /// A unit without prefixes, `size` in SI.
    #[must_use]
    pub fn of_size(symbol: &str, size: f64) -> Self {
        Self { symbol: symbol.to_owned(), size, ..Self::NUMBER }
    }

    /// A unit of this size with symbols of its own for powers of ten, from small to large; the first stands for everything below the second.
    pub(super) fn stepped(size: f64, steps: &'static [Step]) -> Self {
        let whole = steps.iter().find(|step| step.power == 0);
        let symbol = whole.map_or(String::new(), |step| step.symbol.to_owned());
        Self { symbol, size, steps, ..Self::NUMBER }
    }

    /// The unit without prefix or step, for columns.
    pub(super) fn whole(&self) -> AxisUnit {
        AxisUnit { factor: power_of_ten(-self.exponent) / self.size, label: self.symbol.clone() }
    }

    /// The power of ten and the symbol for a value with decimal exponent `exponent`.
    fn step(&self, exponent: i32) -> (i32, String) {
        if let Some(step) = self.steps.iter().rev().find(|step| step.from <= exponent) {
            return (step.power, step.symbol.to_owned());
        }
        let (power, prefix) = self.prefix(exponent);
        (power, format!("{prefix}{}", self.symbol))
    }

    /// The symbol without prefix.
    #[must_use]
    pub fn symbol(&self) -> &str {
        &self.symbol
    }

    /// The power of ten and the symbol of the prefix for a value with decimal exponent `exponent`.
    fn prefix(&self, exponent: i32) -> (i32, &'static str) {
        let (least, greatest) = self.prefixes;
        let wanted = (exponent.div_euclid(3) * 3).clamp(least, greatest);
        PREFIXES.iter().find(|(power, _)| *power == wanted).copied().unwrap_or((0, ""))
    }
}

impl From<Dimension> for DisplayUnit {
    fn from(dimension: Dimension) -> Self {
        match dimension {
            Dimension::NONE => Self::NUMBER,
            Dimension::LENGTH
            | Dimension::PRESSURE
            | Dimension::SUBGRADE_MODULUS
            | Dimension::FORCE_PER_LENGTH
            | Dimension::MOMENT_PER_LENGTH
            | Dimension::MOMENT
            | Dimension::TIME => Self::prefixed(&dimension.unit()),
            // Roughness compliances are some tenths of this, and m/Pa takes prefixes badly.
            Dimension::COMPLIANCE => Self::fixed("µm/MPa", -12),
            _ => Self::fixed(&dimension.unit(), 0),
        }
    }
}

/// Writes an SI value with a prefix and at most 6 significant digits: `3.1234 µm`, `120 MPa`.
///
/// Trailing zeros are dropped. Beyond the prefixes (below 1 p, from 1000 T) and for units without
/// prefixes the number takes an exponent. A value that is not finite is named in words.
///
/// ```
/// use shtaerman_input::quantity::{Dimension, DisplayUnit, engineering};
/// assert_eq!(engineering(1.2e8, Dimension::PRESSURE), "120 MPa");
/// assert_eq!(engineering(8e5, Dimension::FORCE_PER_LENGTH), "800 kN/m");
/// assert_eq!(engineering(1.2e-13, Dimension::COMPLIANCE), "0.12 µm/MPa");
/// assert_eq!(engineering(2.5e-4, DisplayUnit::angle()), "250 µrad");
/// ```
#[must_use]
pub fn engineering(value: f64, unit: impl Into<DisplayUnit>) -> String {
    engineering_with_digits(value, unit, DEFAULT_DIGITS)
}

/// As [`engineering`] with at most `digits` significant digits, from 1 to 17.
///
/// With 17 digits, [`super::parse`] gives the value back to the last bit.
#[must_use]
pub fn engineering_with_digits(value: f64, unit: impl Into<DisplayUnit>, digits: usize) -> String {
    let unit = unit.into();
    let value = value / unit.size;
    let Some(decimal) = Decimal::of(value, digits.clamp(1, MOST_DIGITS)) else {
        return unbounded(value).to_owned();
    };
    let shown = decimal.exponent - unit.exponent;
    if decimal.is_zero() {
        return joined("0", &unit.symbol);
    }
    let (power, symbol) = unit.step(shown);
    let number = decimal.shown(shown - power, unit.prefixes != (0, 0));
    match number {
        Some(number) => joined(&number, &symbol),
        None => joined(&decimal.scientific(shown), &unit.symbol),
    }
}

fn joined(number: &str, symbol: &str) -> String {
    if symbol.is_empty() { number.to_owned() } else { format!("{number} {symbol}") }
}

fn unbounded(value: f64) -> &'static str {
    if value.is_nan() {
        "not a number"
    } else if value > 0.0 {
        "infinite"
    } else {
        "minus infinite"
    }
}

/// A number rounded to some decimal digits: `d1.d2d3... * 10^exponent`.
struct Decimal {
    sign: &'static str,
    /// Without trailing zeros, but never empty.
    digits: String,
    /// The power of ten of the first digit.
    exponent: i32,
}

impl Decimal {
    /// The rounding to `digits` figures; none if the value is not finite.
    fn of(value: f64, digits: usize) -> Option<Self> {
        if !value.is_finite() {
            return None;
        }
        // Rounded before the prefix is chosen, so that 999.9999 Pa becomes 1 kPa and not 1000 Pa.
        let written = format!("{:.*e}", digits - 1, value.abs());
        let (mantissa, exponent) = written.split_once('e')?;
        let all = mantissa.replace('.', "");
        let kept = all.trim_end_matches('0');
        Some(Self {
            sign: if value < 0.0 { "-" } else { "" },
            digits: if kept.is_empty() { "0" } else { kept }.to_owned(),
            exponent: exponent.parse().ok()?,
        })
    }

    fn is_zero(&self) -> bool {
        self.digits == "0"
    }

    /// The number with its first digit at 10^`exponent`, if it can do without a power of ten.
    fn shown(&self, exponent: i32, prefixed: bool) -> Option<String> {
        let plain = if prefixed { 0..3 } else { PLAIN_EXPONENTS };
        if self.is_zero() {
            return Some("0".to_owned());
        }
        plain.contains(&exponent).then(|| self.plain(exponent))
    }

    fn plain(&self, exponent: i32) -> String {
        let Ok(whole) = usize::try_from(exponent + 1) else {
            let zeros = usize::try_from(-1 - exponent).unwrap_or(0);
            return format!("{}0.{}{}", self.sign, "0".repeat(zeros), self.digits);
        };
        if whole == 0 {
            return format!("{}0.{}", self.sign, self.digits);
        }
        if self.digits.len() <= whole {
            return format!("{}{:0<whole$}", self.sign, self.digits);
        }
        let (before, after) = self.digits.split_at(whole);
        format!("{}{before}.{after}", self.sign)
    }

    fn scientific(&self, exponent: i32) -> String {
        let (first, rest) = self.digits.split_at(1);
        let point = if rest.is_empty() { "" } else { "." };
        format!("{}{first}{point}{rest}e{exponent}", self.sign)
    }
}

/// One scale for all values of a plot axis: `shown = value * factor`, in the unit `label`.
#[derive(Debug, Clone, PartialEq)]
pub struct AxisUnit {
    /// Multiplies an SI value into the unit of the label; finite and positive.
    pub factor: f64,
    /// The unit with its prefix, such as `µm`; empty for plain numbers.
    pub label: String,
}

/// The prefix that brings values up to `max_abs` (SI) into `[1, 1000)`, as far as prefixes reach.
///
/// Zero, and values that are not finite, give the unit without prefix.
///
/// ```
/// use shtaerman_input::quantity::{Dimension, axis_unit};
/// let axis = axis_unit(3e-6, Dimension::LENGTH);
/// assert_eq!((axis.factor, axis.label.as_str()), (1e6, "µm"));
/// ```
#[must_use]
pub fn axis_unit(max_abs: f64, unit: impl Into<DisplayUnit>) -> AxisUnit {
    let unit = unit.into();
    let exponent = match Decimal::of(max_abs.abs() / unit.size, MOST_DIGITS) {
        Some(decimal) if !decimal.is_zero() => decimal.exponent,
        _ => unit.exponent,
    };
    let (power, label) = unit.step(exponent - unit.exponent);
    AxisUnit { factor: power_of_ten(-(power + unit.exponent)) / unit.size, label }
}

/// Correctly rounded: positive powers up to 22 are exact, and a quotient rounds once.
fn power_of_ten(power: i32) -> f64 {
    let size = 10f64.powi(power.abs());
    if power < 0 { 1.0 / size } else { size }
}

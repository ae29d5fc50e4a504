//! The grammar of quantities: a number, then a unit expression.

use super::error::{QuantityError, QuantityErrorKind};
use super::limits::{MAXIMUM_LENGTH, MAXIMUM_POWER};
use super::number::{self, Number};
use super::units::{self, Scale};
use super::value::Quantity;

/// Reads a quantity such as `5 mm`, `200GPa`, `0.1 µm/MPa` or `1.5 kN mm/mm`.
///
/// A number (sign, digits, point, exponent) and, optionally, a unit expression: units with SI
/// prefixes, products by a space, `*` or `·`, quotients by `/` from left to right, whole powers
/// (`^2`, `**2`, `²`), parentheses, and `1/m`. A space behind a quotient (`N/mm mm`) is refused
/// because readers differ on it. Letter case matters.
///
/// # Errors
/// [`QuantityError`] with its place in the text, for any text that is no finite quantity or is
/// longer than [`MAXIMUM_LENGTH`] bytes.
///
/// ```
/// use shtaerman_input::quantity::{Dimension, parse};
/// let modulus = parse("200 N/mm^2")?;
/// assert_eq!((modulus.value, modulus.dimension), (2e8, Dimension::PRESSURE));
/// assert_eq!(
///     parse("200 mpa").unwrap_err().to_string(),
///     "has the unknown unit mpa, did you mean MPa?",
/// );
/// # Ok::<(), shtaerman_input::quantity::QuantityError>(())
/// ```
pub fn parse(text: &str) -> Result<Quantity, QuantityError> {
    if text.len() > MAXIMUM_LENGTH {
        let kind = QuantityErrorKind::TooLong(text.len());
        return Err(QuantityError::new(kind, 0..text.len()));
    }
    let start = text.len() - text.trim_start().len();
    let end = text.trim_end().len();
    if start >= end {
        return Err(QuantityError::new(QuantityErrorKind::Empty, 0..text.len()));
    }
    let number = number::read(text, start)?;
    let mut reader = UnitReader { text: &text[..end], at: number.end, first: true };
    reader.skip_spaces();
    let unit_start = reader.at;
    let scale = reader.whole()?;
    let value = evaluate(number, scale, start..end)?;
    let unit = (unit_start < end).then_some((unit_start, end));
    Ok(Quantity { value, dimension: scale.dimension, unit })
}

fn evaluate(
    number: Number<'_>,
    scale: Scale,
    span: std::ops::Range<usize>,
) -> Result<f64, QuantityError> {
    let value = number.shifted(scale.exponent) * scale.numerator / scale.denominator;
    if number.is_zero() {
        return Ok(0.0);
    }
    if !value.is_finite() {
        return Err(QuantityError::new(QuantityErrorKind::TooLarge, span));
    }
    if value == 0.0 {
        return Err(QuantityError::new(QuantityErrorKind::TooSmall, span));
    }
    Ok(value)
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Operator {
    Times,
    /// A product without a sign between.
    Space,
    Over,
}

/// Where the last division of a chain stands, to tell how a space behind it may be read.
#[derive(Debug, Clone, Copy)]
struct Division {
    slash: usize,
    divisor: usize,
}

struct UnitReader<'a> {
    text: &'a str,
    at: usize,
    /// Nothing of the unit has been read yet, so a leading operator joins it to the number.
    first: bool,
}

impl<'a> UnitReader<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn skip_spaces(&mut self) {
        self.at += self.rest().len() - self.rest().trim_start().len();
    }

    fn fail<T>(&self, kind: QuantityErrorKind, start: usize) -> Result<T, QuantityError> {
        Err(QuantityError::new(kind, start..self.at.max(start)))
    }

    /// The unit expression up to the end of the text.
    fn whole(&mut self) -> Result<Scale, QuantityError> {
        if self.rest().is_empty() {
            return Ok(Scale::ONE);
        }
        let scale = self.chain()?;
        if self.at < self.text.len() {
            let start = self.at;
            self.at += 1;
            return self.fail(QuantityErrorKind::Parenthesis, start);
        }
        Ok(scale)
    }

    /// Factors joined by operators, up to a closing parenthesis or the end.
    fn chain(&mut self) -> Result<Scale, QuantityError> {
        let start = self.at;
        let joined =
            std::mem::take(&mut self.first) && matches!(self.peek(), Some('/' | '*' | '·' | '⋅'));
        let mut scale = if joined { Scale::ONE } else { self.factor("")? };
        let mut division = None;
        loop {
            let factor_end = self.at;
            self.skip_spaces();
            let operator_start = self.at;
            let Some(operator) = self.operator() else { return Ok(scale) };
            let sign = &self.text[operator_start..self.at];
            self.skip_spaces();
            let factor_start = self.at;
            let factor = self.factor(sign)?;
            match (operator, division) {
                (Operator::Space, Some(division)) => {
                    return self.ambiguous(start, division, factor_end, factor_start);
                }
                (Operator::Over, _) => {
                    division = Some(Division { slash: operator_start, divisor: factor_start });
                }
                _ => {}
            }
            let power = if operator == Operator::Over { -1 } else { 1 };
            let product = factor.checked_pow(power).and_then(|factor| scale.checked_mul(factor));
            let Some(product) = product else {
                return self.fail(QuantityErrorKind::PowerOverflow, start);
            };
            scale = product;
        }
    }

    /// The operator before the next factor; none at the end of the chain.
    fn operator(&mut self) -> Option<Operator> {
        let sign = self.peek()?;
        let operator = match sign {
            ')' => return None,
            '*' | '·' | '⋅' => Operator::Times,
            '/' => Operator::Over,
            _ => return Some(Operator::Space),
        };
        self.at += sign.len_utf8();
        Some(operator)
    }

    fn ambiguous(
        &self,
        start: usize,
        division: Division,
        divisor_end: usize,
        factor_start: usize,
    ) -> Result<Scale, QuantityError> {
        let head = &self.text[start..division.slash];
        let divisor = &self.text[division.divisor..divisor_end];
        let factor = &self.text[factor_start..self.at];
        let kind = QuantityErrorKind::Ambiguous {
            written: self.text[start..self.at].to_owned(),
            grouped: format!("{head}/({divisor} {factor})"),
            chained: format!("{head}/{divisor}*{factor}"),
        };
        self.fail(kind, start)
    }

    /// A unit, a parenthesis or the 1 of `1/m`, with its power. `before` is the operator before it.
    fn factor(&mut self, before: &str) -> Result<Scale, QuantityError> {
        let start = self.at;
        let base = match self.peek() {
            Some('(') => self.parenthesis()?,
            Some('0'..='9' | '.') => return self.one(),
            Some(sign) if is_unit_sign(sign) => self.unit()?,
            Some('*' | '·' | '⋅' | '/' | ')') | None if !before.trim().is_empty() => {
                return self.fail(QuantityErrorKind::UnitMissing(before.to_owned()), start);
            }
            Some(')') => {
                self.at += 1;
                return self.fail(QuantityErrorKind::Parenthesis, start);
            }
            Some(sign) if starts_power(sign) => {
                self.at += sign.len_utf8();
                return self.fail(QuantityErrorKind::Power, start);
            }
            Some(sign) => {
                self.at += sign.len_utf8();
                return self.fail(QuantityErrorKind::UnknownCharacter(sign), start);
            }
            None => return self.fail(QuantityErrorKind::UnitMissing(before.to_owned()), start),
        };
        let Some(power) = self.power()? else { return Ok(base) };
        match base.checked_pow(power) {
            Some(scale) => Ok(scale),
            None => self.fail(QuantityErrorKind::PowerOverflow, start),
        }
    }

    /// Recursion is bounded by [`MAXIMUM_LENGTH`].
    fn parenthesis(&mut self) -> Result<Scale, QuantityError> {
        let start = self.at;
        self.at += 1;
        self.skip_spaces();
        if matches!(self.peek(), Some(')')) {
            self.at += 1;
            return self.fail(QuantityErrorKind::UnitMissing("(".to_owned()), start);
        }
        if self.rest().is_empty() {
            return self.fail(QuantityErrorKind::Parenthesis, start);
        }
        self.first = false;
        let scale = self.chain()?;
        if self.peek() != Some(')') {
            self.at = start + 1;
            return self.fail(QuantityErrorKind::Parenthesis, start);
        }
        self.at += 1;
        Ok(scale)
    }

    /// The 1 of `1/m`; any other number is out of place in a unit.
    fn one(&mut self) -> Result<Scale, QuantityError> {
        let start = self.at;
        let digits = self.rest().bytes().take_while(|byte| matches!(byte, b'0'..=b'9' | b'.'));
        self.at += digits.count();
        let written = &self.text[start..self.at];
        let divides = self.rest().trim_start().starts_with('/');
        if written == "1" && divides {
            return Ok(Scale::ONE);
        }
        self.fail(QuantityErrorKind::NumberInUnit(written.to_owned()), start)
    }

    fn unit(&mut self) -> Result<Scale, QuantityError> {
        let start = self.at;
        let length = self.rest().chars().take_while(|sign| is_unit_sign(*sign)).map(char::len_utf8);
        self.at += length.sum::<usize>();
        let symbol = &self.text[start..self.at];
        let Some(scale) = units::look_up(symbol) else {
            let unit = symbol.to_owned();
            let suggestion = units::suggest(symbol);
            return self.fail(QuantityErrorKind::UnknownUnit { unit, suggestion }, start);
        };
        let digits: String = self.rest().chars().take_while(char::is_ascii_digit).collect();
        if !digits.is_empty() {
            self.at += digits.len();
            return self
                .fail(QuantityErrorKind::BareDigit { unit: symbol.to_owned(), digits }, start);
        }
        Ok(scale)
    }

    /// The power behind a factor, if there is one.
    fn power(&mut self) -> Result<Option<i8>, QuantityError> {
        let raised = self.rest().chars().take_while(|sign| superscript(*sign).is_some());
        let digits: String = raised.clone().filter_map(superscript).collect();
        if !digits.is_empty() {
            let start = self.at;
            self.at += raised.map(char::len_utf8).sum::<usize>();
            return self.power_from(&digits, start).map(Some);
        }
        let spaced = self.rest().trim_start();
        let sign_length = match spaced {
            _ if spaced.starts_with('^') => 1,
            _ if spaced.starts_with("**") => 2,
            _ => return Ok(None),
        };
        let start = self.at + self.rest().len() - spaced.len();
        self.at = start + sign_length;
        self.skip_spaces();
        let length = self.rest().bytes().take_while(|byte| b"+-.0123456789".contains(byte)).count();
        let digits = &self.rest()[..length];
        self.at += length;
        self.power_from(digits, start).map(Some)
    }

    fn power_from(&self, digits: &str, start: usize) -> Result<i8, QuantityError> {
        match digits.parse::<i8>() {
            Ok(power) if power.unsigned_abs() <= MAXIMUM_POWER => Ok(power),
            _ => self.fail(QuantityErrorKind::Power, start),
        }
    }
}

fn is_unit_sign(sign: char) -> bool {
    sign.is_alphabetic() || sign == '°'
}

fn starts_power(sign: char) -> bool {
    sign == '^' || superscript(sign).is_some()
}

fn superscript(sign: char) -> Option<char> {
    Some(match sign {
        '⁰' => '0',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        '⁴' => '4',
        '⁵' => '5',
        '⁶' => '6',
        '⁷' => '7',
        '⁸' => '8',
        '⁹' => '9',
        '⁻' => '-',
        _ => return None,
    })
}

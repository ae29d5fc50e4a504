//! The number at the head of a quantity.

use super::error::{QuantityError, QuantityErrorKind};

/// A decimal number as written, not yet rounded: `mantissa * 10^exponent`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Number<'a> {
    negative: bool,
    /// Digits with at most one point.
    mantissa: &'a str,
    exponent: i64,
    /// Where in the text the number ends.
    pub(super) end: usize,
}

impl Number<'_> {
    /// The double nearest to this number times a power of ten; infinite or zero beyond the range.
    pub(super) fn shifted(self, power: i64) -> f64 {
        let exponent = self.exponent.saturating_add(power);
        let size: f64 = format!("{}e{exponent}", self.mantissa).parse().unwrap_or(f64::NAN);
        if self.negative { -size } else { size }
    }

    pub(super) fn is_zero(self) -> bool {
        !self.mantissa.bytes().any(|byte| matches!(byte, b'1'..=b'9'))
    }
}

/// Reads the number that begins at byte `start`.
pub(super) fn read(text: &str, start: usize) -> Result<Number<'_>, QuantityError> {
    let (negative, unsigned) = read_sign(text, start);
    let mantissa_end = skip_mantissa(text, unsigned);
    let mantissa = &text[unsigned..mantissa_end];
    if !mantissa.bytes().any(|byte| byte.is_ascii_digit()) {
        return Err(not_a_number(text, start, unsigned));
    }
    let (exponent, end) = read_exponent(text, mantissa_end);
    let number = Number { negative, mantissa, exponent, end };
    refuse_other_forms(text, start, end)?;
    Ok(number)
}

fn read_sign(text: &str, start: usize) -> (bool, usize) {
    match text[start..].chars().next() {
        Some('+') => (false, start + 1),
        // U+2212, the minus of typeset text.
        Some(minus @ ('-' | '−')) => (true, start + minus.len_utf8()),
        _ => (false, start),
    }
}

fn skip_digits(text: &str, start: usize) -> usize {
    start + text[start..].bytes().take_while(u8::is_ascii_digit).count()
}

fn skip_mantissa(text: &str, start: usize) -> usize {
    let whole = skip_digits(text, start);
    if text[whole..].starts_with('.') { skip_digits(text, whole + 1) } else { whole }
}

/// An `e` is an exponent only with digits behind it; otherwise it begins a unit.
fn read_exponent(text: &str, start: usize) -> (i64, usize) {
    if !text[start..].starts_with(['e', 'E']) {
        return (0, start);
    }
    let (negative, digits) = read_sign(text, start + 1);
    let end = skip_digits(text, digits);
    if end == digits {
        return (0, start);
    }
    let size = text[digits..end].parse::<i64>().unwrap_or(i64::MAX);
    (if negative { -size } else { size }, end)
}

fn not_a_number(text: &str, start: usize, unsigned: usize) -> QuantityError {
    let word: String = text[unsigned..].chars().take_while(|sign| sign.is_alphabetic()).collect();
    let end = unsigned + word.len();
    if matches!(word.to_lowercase().as_str(), "nan" | "inf" | "infinity") {
        let written = text[start..end].to_owned();
        return QuantityError::new(QuantityErrorKind::NotFinite(written), start..end);
    }
    QuantityError::new(QuantityErrorKind::NoNumber, start..text.trim_end().len().max(start))
}

/// Decimal commas, separators of thousands and `10^6` get the right form in the answer.
fn refuse_other_forms(text: &str, start: usize, end: usize) -> Result<(), QuantityError> {
    let tail: String = text[end..]
        .chars()
        .take_while(|sign| sign.is_ascii_digit() || ",._^".contains(*sign))
        .collect();
    let all = end + tail.len();
    let error = |all: usize, instead: String| {
        let written = text[start..all].to_owned();
        let kind = QuantityErrorKind::NumberForm { written, instead };
        Err(QuantityError::new(kind, start..all))
    };
    let written = &text[start..all];
    match tail.chars().next() {
        Some('^') => error(all, "powers of ten as in 1e6".to_owned()),
        Some('_') => error(all, written.replace(['_', ','], "")),
        Some(',') => error(all, without_comma(written)),
        _ => match thousands(text, end) {
            Some(all) => error(all, text[start..all].replace(' ', "")),
            None => Ok(()),
        },
    }
}

/// `1,5` is 1.5; `1,500` may be either, so both are named; in `1.500,5` and `1,500.5` what comes last is the decimal one.
fn without_comma(written: &str) -> String {
    let bare = written.replace([',', '_'], "");
    let groups: Vec<&str> = written.split(',').collect();
    match groups.as_slice() {
        [_, rest] if rest.contains('.') => bare,
        [whole, rest] if whole.contains('.') => format!("{}.{rest}", whole.replace('.', "")),
        [whole, rest] if rest.len() == 3 => format!("{bare} or {whole}.{rest}"),
        [whole, rest] => format!("{whole}.{rest}"),
        _ => bare,
    }
}

/// The end of groups of three digits that follow after single spaces, as in `1 000 000`.
fn thousands(text: &str, mut end: usize) -> Option<usize> {
    let start = end;
    while text[end..].starts_with(' ') {
        let after = skip_digits(text, end + 1);
        if after != end + 4 {
            break;
        }
        end = after;
    }
    (end > start).then_some(end)
}

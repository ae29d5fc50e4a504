//! Numbers for people.

/// `value` with this many significant digits, without trailing zeros; scientific outside `[1e-4, 1e7)`.
#[must_use]
pub(crate) fn significant(value: f64, digits: usize) -> String {
    let digits = digits.max(1);
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".to_owned() } else { value.to_string() };
    }
    let scientific = format!("{value:.*e}", digits - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..7).contains(&exponent) {
        let decimals = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
        return trimmed(&format!("{value:.decimals$}")).to_owned();
    }
    format!("{}e{exponent}", trimmed(mantissa))
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

#[cfg(test)]
mod tests {
    use super::significant;

    #[test]
    fn shows_what_is_significant() {
        for (value, digits, text) in [
            (0.0, 6, "0"),
            (49.216738984, 6, "49.2167"),
            (-0.00015, 3, "-0.00015"),
            (1.5e-9, 6, "1.5e-9"),
            (9.999999, 3, "10"),
            (123456789.0, 4, "1.235e8"),
            (1234.5, 2, "1234"),
        ] {
            assert_eq!(significant(value, digits), text);
        }
    }
}

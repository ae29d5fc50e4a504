//! Input files of finite-element programs: comments, keywords and rows of numbers.

use std::fmt::Write;

/// Characters that a number may take: both programs read no more, `CalculiX` without a word.
const FIELD: usize = 20;
/// Digits behind the point, as many as fit with a sign and an exponent of two digits.
const DECIMALS: usize = 13;
/// Characters of a comment after which it goes on in the next line.
const LINE: usize = 96;

/// The text of an input file.
#[derive(Debug, Default)]
pub(crate) struct Deck(String);

impl Deck {
    /// A comment, on as many lines as it takes.
    pub(crate) fn comment(&mut self, text: &str) {
        let mut line = "**".to_owned();
        for word in text.split(' ') {
            if line.len() > 2 && line.chars().count() + 1 + word.chars().count() > LINE {
                self.line(&line);
                line = "**".to_owned();
            }
            line.push(' ');
            line.push_str(word);
        }
        self.line(&line);
    }

    /// A keyword, a data line, or a comment as it is.
    pub(crate) fn line(&mut self, text: &str) {
        self.0.push_str(text);
        self.0.push('\n');
    }

    /// Rows of numbers.
    pub(crate) fn rows<const N: usize>(&mut self, rows: impl IntoIterator<Item = [f64; N]>) {
        for row in rows {
            let _ = writeln!(self.0, "{}", row.map(field).join(", "));
        }
    }

    /// The whole text.
    pub(crate) fn text(self) -> String {
        self.0
    }
}

/// A number with a decimal point, within the characters that a field may take.
pub(crate) fn field(value: f64) -> String {
    if value == 0.0 {
        return "0.".to_owned();
    }
    let text = (0..=DECIMALS).rev().map(|decimals| format!("{value:.decimals$e}"));
    let text = text.into_iter().find(|text| text.len() <= FIELD).unwrap_or_default();
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let mantissa = if mantissa.contains('.') { mantissa.trim_end_matches('0') } else { mantissa };
    let point = if mantissa.contains('.') { "" } else { "." };
    format!("{mantissa}{point}e{exponent}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_fit_their_fields_and_have_a_point() {
        for value in [
            1.0,
            -1.0,
            1.0 / 3.0,
            -2.0 / 3.0e9,
            7.123456789012345e-123,
            -7.123456789012345e-300,
            f64::MAX,
            8e7,
            1.2e-14,
        ] {
            let text = field(value);
            assert!(text.len() <= 20 && text.contains('.'), "{text}");
            let read: f64 = text.parse().unwrap();
            assert!((read / value - 1.0).abs() < 1e-11, "{text} {value}");
        }
        assert_eq!([field(0.0), field(-0.0), field(8e7)], ["0.", "0.", "8.e7"]);
    }

    #[test]
    fn long_comments_are_cut_between_words() {
        let mut deck = Deck::default();
        deck.comment(&"word ".repeat(60));
        deck.rows([[0.0, 1.5]]);
        let text = deck.text();
        assert!(text.lines().all(|line| line.chars().count() <= 96));
        assert!(text.ends_with("\n0., 1.5e0\n") && text.matches("word").count() == 60);
    }
}

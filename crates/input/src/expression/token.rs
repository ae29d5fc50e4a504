//! From characters to tokens.

use std::ops::Range;

use super::error::{ErrorReason, ExpressionError};
use super::function::Binary;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Token {
    Number(f64),
    Name,
    Operator(Binary),
    Open,
    Close,
    Comma,
    End,
}

/// Reads one token after another; it never looks further than the token it returns.
pub(super) struct Lexer<'a> {
    text: &'a str,
    position: usize,
}

impl<'a> Lexer<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Lexer { text, position: 0 }
    }

    /// The next token and its bytes; [`Token::End`] for ever after the last.
    pub(super) fn next(&mut self) -> Result<(Token, Range<usize>), ExpressionError> {
        let rest = &self.text[self.position..];
        let start = self.text.len() - rest.trim_start().len();
        let rest = &self.text[start..];
        let Some(first) = rest.chars().next() else {
            self.position = self.text.len();
            return Ok((Token::End, self.position..self.position));
        };
        let (token, length) = match number_length(rest.as_bytes()) {
            0 if starts_name(first) => (Token::Name, name_length(rest)),
            0 => symbol(rest).ok_or_else(|| stray(first, start))?,
            length => (number(&rest[..length], start)?, length),
        };
        self.position = start + length;
        Ok((token, start..self.position))
    }
}

fn stray(character: char, start: usize) -> ExpressionError {
    ExpressionError {
        reason: ErrorReason::StrayCharacter { character },
        span: start..start + character.len_utf8(),
    }
}

fn symbol(rest: &str) -> Option<(Token, usize)> {
    use Binary::*;
    let two = [("**", Power), ("<=", LessEqual), (">=", GreaterEqual)];
    if let Some((_, operator)) = two.iter().find(|(sign, _)| rest.starts_with(sign)) {
        return Some((Token::Operator(*operator), 2));
    }
    let token = match rest.as_bytes().first()? {
        b'+' => Token::Operator(Add),
        b'-' => Token::Operator(Subtract),
        b'*' => Token::Operator(Multiply),
        b'/' => Token::Operator(Divide),
        b'^' => Token::Operator(Power),
        b'<' => Token::Operator(Less),
        b'>' => Token::Operator(Greater),
        b'(' => Token::Open,
        b')' => Token::Close,
        b',' => Token::Comma,
        _ => return None,
    };
    Some((token, 1))
}

fn starts_name(character: char) -> bool {
    character.is_alphabetic() || character == '_'
}

fn name_length(rest: &str) -> usize {
    let ends = |c: char| !(starts_name(c) || c.is_ascii_digit());
    rest.find(ends).unwrap_or(rest.len())
}

fn digits(bytes: &[u8]) -> usize {
    bytes.iter().take_while(|byte| byte.is_ascii_digit()).count()
}

/// Bytes of the number at the start, 0 if there is none: `12`, `5.`, `.5`, `1e-3`.
fn number_length(bytes: &[u8]) -> usize {
    let whole = digits(bytes);
    let mut length = whole;
    if bytes.get(length) == Some(&b'.') {
        let fraction = digits(&bytes[length + 1..]);
        if whole + fraction == 0 {
            return 0;
        }
        length += 1 + fraction;
    }
    if length > 0 { length + exponent_length(&bytes[length..]) } else { 0 }
}

/// Bytes of an exponent at the start; 0 if the `e` has no digits (it is then a name).
fn exponent_length(bytes: &[u8]) -> usize {
    if !matches!(bytes.first(), Some(b'e' | b'E')) {
        return 0;
    }
    let sign = usize::from(matches!(bytes.get(1), Some(b'+' | b'-')));
    match digits(&bytes[1 + sign..]) {
        0 => 0,
        count => 1 + sign + count,
    }
}

fn number(text: &str, start: usize) -> Result<Token, ExpressionError> {
    let fail = |reason| ExpressionError { reason, span: start..start + text.len() };
    let mantissa = text.split(['e', 'E']).next().unwrap_or(text);
    let is_zero = !mantissa.bytes().any(|byte| matches!(byte, b'1'..=b'9'));
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && (value != 0.0 || is_zero) => Ok(Token::Number(value)),
        Ok(0.0) => Err(fail(ErrorReason::NumberTooSmall { text: shorten(text) })),
        _ => Err(fail(ErrorReason::NumberTooLarge { text: shorten(text) })),
    }
}

/// At most 40 characters of a text, so that a message stays readable.
pub(super) fn shorten(text: &str) -> String {
    match text.char_indices().nth(40) {
        Some((cut, _)) => format!("{}...", &text[..cut]),
        None => text.to_owned(),
    }
}

//! What can be wrong with the text of an expression.

use std::fmt;
use std::ops::Range;

use thiserror::Error;

use crate::quantity::{self, Dimension, Quantity, engineering};

/// Why a text is not an expression, and where.
///
/// [`reason`](Self::reason) says what was wrong with its values, [`help`](Self::help) says what
/// would be right, [`span`](Self::span) is the range of bytes of the text to point at (it can be
/// empty only when the text is).
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{reason}")]
pub struct ExpressionError {
    /// What was wrong.
    pub reason: ErrorReason,
    /// Bytes of the text to point at; both ends are on character boundaries.
    pub span: Range<usize>,
}

/// The kinds of [`ExpressionError`], each with the values that caused it.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ErrorReason {
    /// Nothing but white space.
    #[error("the expression is empty")]
    Empty,
    /// More bytes than are read.
    #[error("the expression has {bytes} bytes, more than the {limit} that are read")]
    TooLong {
        /// Length of the text.
        bytes: usize,
        /// Longest text that is read.
        limit: usize,
    },
    /// Brackets, powers or signs inside one another beyond the limit.
    #[error("brackets, powers and signs are nested more than {limit} deep")]
    TooDeep {
        /// Deepest nesting that is read.
        limit: usize,
    },
    /// A character that begins nothing.
    #[error("the character `{}` has no meaning here", character.escape_debug())]
    StrayCharacter {
        /// The character.
        character: char,
    },
    /// A number beyond the largest double-precision number, about 1.8e308.
    #[error("the number {text} is too large: the largest is about 1.8e308")]
    NumberTooLarge {
        /// The number as written, shortened.
        text: String,
    },
    /// A number that is not zero but would be rounded to zero.
    #[error("the number {text} is too small: it would be rounded to zero")]
    NumberTooSmall {
        /// The number as written, shortened.
        text: String,
    },
    /// A name that is neither a variable nor a constant.
    #[error("`{name}` is neither a variable nor a constant")]
    UnknownName {
        /// The name as written, shortened.
        name: String,
        /// The nearest known name, if one is near.
        suggestion: Option<String>,
        /// All names that would be understood.
        known: Vec<String>,
    },
    /// A name with arguments that is not a function.
    #[error("there is no function `{name}`")]
    UnknownFunction {
        /// The name as written, shortened.
        name: String,
        /// The nearest known function, if one is near.
        suggestion: Option<String>,
    },
    /// A function named without its arguments.
    #[error("`{name}` is a function and needs its arguments in brackets")]
    FunctionWithoutArguments {
        /// The function.
        name: String,
    },
    /// Too few or too many arguments.
    #[error("`{name}` takes {arity}, but {found} {}", if *found == 1 { "was given" } else { "were given" })]
    ArgumentCount {
        /// The function.
        name: String,
        /// How many it takes.
        arity: Arity,
        /// How many were given.
        found: usize,
    },
    /// An operator, bracket or comma with no value beside it.
    #[error("a value is missing {} `{neighbour}`", if *after { "after" } else { "before" })]
    MissingOperand {
        /// The operator, bracket or comma.
        neighbour: String,
        /// Whether the value is missing after it (else before it).
        after: bool,
    },
    /// Two values side by side: products must be written out.
    #[error("an operator is missing between `{left}` and `{right}`")]
    MissingOperator {
        /// End of the left value, shortened.
        left: String,
        /// Start of the right value, shortened.
        right: String,
    },
    /// A bracket that is never closed (the span is the opening one).
    #[error("this bracket is never closed")]
    UnclosedBracket,
    /// A closing bracket with no opening one.
    #[error("this bracket closes nothing")]
    UnopenedBracket,
    /// A comma outside the arguments of a function.
    #[error("a comma separates the arguments of a function and has no meaning here")]
    StrayComma,
    /// `a < b < c`.
    #[error("comparisons cannot be chained")]
    ChainedComparison,
}

/// How many arguments a function takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Arity {
    /// This many.
    Exactly(usize),
    /// This many or more.
    AtLeast(usize),
}

impl Arity {
    pub(super) fn allows(self, count: usize) -> bool {
        match self {
            Arity::Exactly(wanted) => count == wanted,
            Arity::AtLeast(wanted) => count >= wanted,
        }
    }
}

impl fmt::Display for Arity {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Arity::Exactly(1) => write!(formatter, "1 argument"),
            Arity::Exactly(count) => write!(formatter, "{count} arguments"),
            Arity::AtLeast(count) => write!(formatter, "{count} or more arguments"),
        }
    }
}

impl ExpressionError {
    /// What would be right, as one sentence, where there is something to say.
    pub fn help(&self) -> Option<String> {
        use ErrorReason::*;
        let help = match &self.reason {
            Empty => "write a formula such as `x^2/2`, or `0` for a flat base".to_owned(),
            TooLong { .. } => "give a profile of this size as a table of points".to_owned(),
            TooDeep { .. } => "write the formula with fewer brackets".to_owned(),
            StrayCharacter { character } => return help_for_character(*character),
            UnknownName { name, suggestion, known } => help_for_name(name, suggestion, known),
            UnknownFunction { suggestion: Some(near), .. } => format!("did you mean `{near}`?"),
            FunctionWithoutArguments { name } => format!("write {name}(...)"),
            MissingOperator { left, right } if is_number(left) && is_number(right) => {
                "write a number without spaces and with one decimal point".to_owned()
            }
            MissingOperator { left, right } => match in_si(left, right) {
                Some(value) => {
                    format!(
                        "a formula is in SI units, metres for lengths: {left} {right} is {}",
                        engineering(value, Dimension::NONE)
                    )
                }
                None => format!("write {left}*{right}"),
            },
            StrayComma => "the decimal mark is a point: write 0.5, not 0,5".to_owned(),
            ChainedComparison => "write (a < b)*(b < c) for a < b < c".to_owned(),
            UnclosedBracket => "close it with `)`".to_owned(),
            UnopenedBracket => "remove it, or open it with `(`".to_owned(),
            _ => return None,
        };
        Some(help)
    }

    /// The line of the text that holds the span, and under it carets below the span.
    ///
    /// `text` is the text that was parsed. Long lines are cut to the neighbourhood of the span.
    pub fn pointed_at(&self, text: &str) -> String {
        const AROUND: usize = 30;
        let start = floor_boundary(text, self.span.start);
        let end = floor_boundary(text, self.span.end.max(start));
        let before: Vec<char> =
            text[..start].chars().rev().take_while(|&c| c != '\n').take(AROUND).collect();
        let marked: Vec<char> =
            text[start..end].chars().take_while(|&c| c != '\n').take(2 * AROUND).collect();
        let after = text[end..].chars().take_while(|&c| c != '\n').take(AROUND);
        let line: String = before.iter().rev().chain(&marked).copied().chain(after).collect();
        let line = line.replace(|c: char| c.is_control(), " ");
        format!("{line}\n{}{}", " ".repeat(before.len()), "^".repeat(marked.len().max(1)))
    }
}

fn is_number(text: &str) -> bool {
    text.starts_with(|first: char| first.is_ascii_digit() || first == '.')
}

fn floor_boundary(text: &str, index: usize) -> usize {
    let mut index = index.min(text.len());
    while !text.is_char_boundary(index) {
        index -= 1;
    }
    index
}

fn help_for_character(character: char) -> Option<String> {
    let help = match character {
        '\u{2212}' | '\u{2013}' | '\u{2014}' => "write `-` for minus",
        '\u{b7}' | '\u{d7}' | '\u{22c5}' => "write `*` for a product",
        '\u{f7}' | ':' => "write `/` for a quotient",
        '\u{b2}' | '\u{b3}' => "write `^` for a power, as in x^2",
        '\u{221a}' => "write sqrt(...)",
        '[' | ']' | '{' | '}' => "use round brackets",
        '|' => "write abs(...) for the absolute value",
        '=' | '!' => "the comparisons are < <= > >=",
        '&' => "write (a < b)*(c < d) for both conditions",
        ';' => "the arguments of a function are separated by commas",
        '%' => "write the number itself, 0.05 for 5 %",
        _ => return None,
    };
    Some(help.to_owned())
}

fn help_for_name(name: &str, suggestion: &Option<String>, known: &[String]) -> String {
    if ["inf", "infinity", "nan"].contains(&name.to_ascii_lowercase().as_str()) {
        return "infinite and undefined constants cannot be written".to_owned();
    }
    // A power without its sign, such as x2.
    let base = name.trim_end_matches(|last: char| last.is_ascii_digit());
    let power = &name[base.len()..];
    if !power.is_empty() && power != "1" && known.iter().any(|known| known == base) {
        return format!("did you mean `{base}^{power}`?");
    }
    match suggestion {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("the names are {}", known.join(", ")),
    }
}

/// The SI value of a number with a unit of length behind it; none where it is something else.
fn in_si(number: &str, unit: &str) -> Option<f64> {
    let text = format!("{number} {unit}");
    quantity::parse(&text).ok().filter(Quantity::unit_written)?.of(Dimension::LENGTH, &text).ok()
}

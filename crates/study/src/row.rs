//! One case of a study: what went in and what came out.

use std::fmt;

/// The value of a varied key.
#[derive(Debug, Clone, PartialEq)]
pub enum Input {
    /// A number, SI.
    Number(f64),
    /// A whole number of a list.
    Whole(i64),
    /// What the list of the study says, such as a profile.
    Text(String),
}

impl Input {
    /// The number, where it is one.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(value) => Some(*value),
            Self::Whole(value) => Some(*value as f64),
            Self::Text(_) => None,
        }
    }
}

impl fmt::Display for Input {
    /// As it would be written behind the key: numbers with all digits that tell them apart.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value) => write!(formatter, "{value:?}"),
            Self::Whole(value) => write!(formatter, "{value}"),
            Self::Text(text) => formatter.write_str(text),
        }
    }
}

/// A solved case, or the reason why there is no answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Number of the case, from 0.
    pub case: usize,
    /// The varied values, in the order of the study.
    pub inputs: Vec<Input>,
    /// The outputs; NaN where there is no answer.
    pub outputs: Vec<f64>,
    /// Their stated errors, where the answer states them.
    pub errors: Vec<Option<f64>>,
    /// `bound` or `estimate`; empty where no error is stated.
    pub error_kind: String,
    /// Codes of the warnings and sense checks of the answer, such as `high_pressure`, with spaces between; those of cases that a sweep solves together are not looked for.
    pub warnings: String,
    /// Why there is no answer; empty where there is one.
    pub reason: String,
}

impl Row {
    /// Whether there is an answer.
    #[must_use]
    pub fn is_answered(&self) -> bool {
        self.reason.is_empty()
    }
}

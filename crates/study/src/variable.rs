//! The varied keys of a study.

use crate::{Distribution, Input};

/// How one key is varied.
#[derive(Debug, Clone, PartialEq)]
pub enum Variation {
    /// These values, one after the other.
    Values(Vec<Input>),
    /// Drawn from a distribution.
    Drawn(Distribution),
}

/// A varied key of the problem file.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// The dotted key, such as `load.force`.
    pub key: String,
    /// Its values.
    pub variation: Variation,
}

impl Variable {
    /// Whether all of its values are numbers.
    #[must_use]
    pub fn is_number(&self) -> bool {
        match &self.variation {
            Variation::Values(values) => values.iter().all(|value| value.number().is_some()),
            Variation::Drawn(_) => true,
        }
    }
}

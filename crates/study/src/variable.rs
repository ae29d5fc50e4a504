//! The varied keys of a study.

use crate::{Distribution, Input};

/// How one key is varied.
#[derive(Debug, Clone, PartialEq)]
pub enum Variation {
    /// These values, one after the other.
    Values(Vec<Input>),
    /// So many values from end to end, both of them exact, as far apart as the distribution has it: uniform or log-uniform. They are computed when asked for, and take no room.
    Spaced(Distribution, usize),
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

impl Variation {
    /// How many values it has; none where they are drawn.
    #[must_use]
    pub fn count(&self) -> Option<usize> {
        match self {
            Self::Values(values) => Some(values.len()),
            Self::Spaced(_, count) => Some(*count),
            Self::Drawn(_) => None,
        }
    }

    /// The value of this index, below the [count](Self::count).
    pub(crate) fn value(&self, index: usize) -> Input {
        match self {
            Self::Values(values) => values[index.min(values.len() - 1)].clone(),
            Self::Spaced(distribution, count) => Input::Number(spaced(distribution, index, *count)),
            Self::Drawn(distribution) => Input::Number(distribution.quantile(0.5)),
        }
    }

    /// All values that are numbers, of a list or a range.
    pub fn numbers(&self) -> impl Iterator<Item = f64> + '_ {
        (0..self.count().unwrap_or(0)).filter_map(|index| self.value(index).number())
    }
}

/// One of `count` values from end to end; the ends are exact.
fn spaced(distribution: &Distribution, index: usize, count: usize) -> f64 {
    let last = count.saturating_sub(1).max(1);
    match *distribution {
        Distribution::Uniform { from, .. } | Distribution::LogUniform { from, .. }
            if index == 0 =>
        {
            from
        }
        Distribution::Uniform { to, .. } | Distribution::LogUniform { to, .. } if index == last => {
            to
        }
        _ => distribution.quantile(index as f64 / last as f64),
    }
}

impl Variable {
    /// Whether all of its values are numbers.
    #[must_use]
    pub fn is_number(&self) -> bool {
        match &self.variation {
            Variation::Values(values) => values.iter().all(|value| value.number().is_some()),
            Variation::Spaced(..) | Variation::Drawn(_) => true,
        }
    }
}

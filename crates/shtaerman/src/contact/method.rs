//! How a contact was solved.

use std::fmt;

/// A method of solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum MethodName {
    /// The degenerate kernel of the paper, by Chebyshev series.
    Spectral,
    /// Sinc collocation on panels between the bends of the base.
    Sinc,
    /// Polynomials on many panels, with fast products.
    Panels,
    /// The spectral relation of the equation of the first kind, on a smooth surface.
    FirstKind,
}

impl MethodName {
    /// Name as in answers: `spectral`, `sinc`, `panels` or `first_kind`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Spectral => "spectral",
            Self::Sinc => "sinc",
            Self::Panels => "panels",
            Self::FirstKind => "first_kind",
        }
    }
}

impl fmt::Display for MethodName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Method and size of a solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Method {
    /// Which it is.
    pub name: MethodName,
    /// Highest Chebyshev degree kept, or number of nodes.
    pub n: usize,
}

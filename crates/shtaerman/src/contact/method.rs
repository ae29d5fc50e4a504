//! How a contact was solved.

/// Method and size of a solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Method {
    /// Name of the method: `spectral`, `sinc`, `panels` or `first_kind`.
    pub name: &'static str,
    /// Highest Chebyshev degree kept, or number of nodes.
    pub n: usize,
}

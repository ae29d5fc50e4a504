//! How far collocation goes.

/// Most nodes of all panels together, and cubes of their numbers, added up over Newton steps.
#[derive(Debug, Clone, Copy)]
pub(super) struct Effort {
    pub(super) nodes: usize,
    pub(super) work: f64,
}

impl Effort {
    /// About ten seconds.
    pub(super) const MOST: Self = Self { nodes: 2400, work: 1e11 };
    /// About half a second, as long as an answer on panels with fast products takes.
    pub(super) const LITTLE: Self = Self { nodes: 900, work: 3e9 };
}

//! The base of the punch, as the audit sees it.

/// The base `f(x)`, enclosed.
pub trait Profile {
    /// A lower and an upper bound of `f(x)`.
    fn height(&self, x: f64) -> [f64; 2];

    /// The same for all places of an interval but finitely many.
    fn range(&self, interval: [f64; 2]) -> [f64; 2];

    /// Bounds of `|f^(n)|/n!` on an interval for `n` from 0 to `order`, infinite where none is known; fewer where the profile gives no more.
    fn taylor_bounds(&self, interval: [f64; 2], order: usize) -> Vec<f64>;
}

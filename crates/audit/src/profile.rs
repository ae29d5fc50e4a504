//! The base of the punch, as the audit sees it.

/// The base `f(x)`, enclosed. Several threads ask for it.
pub trait Profile: Sync {
    /// A lower and an upper bound of `f(x)`.
    fn height(&self, x: f64) -> [f64; 2];

    /// The same at several places from left to right, into as many entries.
    fn heights(&self, places: &[f64], found: &mut [[f64; 2]]) {
        for (range, x) in found.iter_mut().zip(places) {
            *range = self.height(*x);
        }
    }

    /// The same for all places of an interval but finitely many.
    fn range(&self, interval: [f64; 2]) -> [f64; 2];

    /// Bounds of `|f^(n)|/n!` on an interval for `n` from 0 to `order`, infinite where none is known; fewer where the profile gives no more.
    fn taylor_bounds(&self, interval: [f64; 2], order: usize) -> Vec<f64>;

    /// What it takes to ask for these bounds on an interval, in looks at a panel, 0.28 us each: after some millions of them an audit gives up.
    fn looks(&self, interval: [f64; 2]) -> u64;
}

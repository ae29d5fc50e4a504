//! What an answer leaves of tension and penetration.

use serde::Serialize;

/// What the answer leaves of tension and penetration, checked between its nodes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Complementarity {
    /// Largest tension in the zones over the largest pressure.
    pub tension: f64,
    /// Largest penetration beside the zones over the size of the displacements compared there.
    pub penetration: f64,
}

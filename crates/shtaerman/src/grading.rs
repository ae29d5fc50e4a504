//! A foundation whose modulus grows with depth.

use serde::{Deserialize, Serialize};

/// `E(y) = modulus (y / 1 m)^exponent` at the depth `y`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Grading {
    /// `mu`.
    pub exponent: f64,
    /// Young's modulus at the depth of one metre (Pa).
    pub modulus: f64,
}

//! The way out of what a smooth surface refuses: a small roughness in place of 0.

use super::Error;
use crate::quantity::plain;

/// What a message adds where one is known.
pub(super) fn or_roughness(roughness: Option<f64>) -> String {
    roughness.map_or(String::new(), |roughness| {
        format!("; or give a small roughness instead of 0, such as {} m/Pa", plain(roughness))
    })
}

impl Error {
    /// The same with a roughness in place of 0 that may serve, where the error is one that a roughness helps.
    pub(crate) fn with_roughness(mut self, other: Option<f64>) -> Self {
        if let Self::WorkLimit { roughness }
        | Self::Rings { roughness, .. }
        | Self::NotAccurate { roughness, .. }
        | Self::ZonesTooClose { roughness, .. } = &mut self
        {
            *roughness = other;
        }
        self
    }
}

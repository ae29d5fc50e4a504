//! A place of an interval.

use std::f64::consts::PI;

/// A place of an interval by its distances from both ends, of which the smaller has all its digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// From the left end.
    pub from_left: f64,
    /// From the right end.
    pub from_right: f64,
}

impl Place {
    /// `phi` of `x = c + b cos phi`, which counts from the right end.
    #[must_use]
    pub fn angle(&self) -> f64 {
        let length = self.from_left + self.from_right;
        if self.from_right < self.from_left {
            2.0 * (self.from_right / length).sqrt().asin()
        } else {
            PI - 2.0 * (self.from_left / length).sqrt().asin()
        }
    }

    /// `cos phi`.
    #[must_use]
    pub fn cosine(&self) -> f64 {
        let length = self.from_left + self.from_right;
        if self.from_right < self.from_left {
            1.0 - 2.0 * self.from_right / length
        } else {
            2.0 * self.from_left / length - 1.0
        }
    }
}

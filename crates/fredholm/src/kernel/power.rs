//! The power kernel `|x - s|^-mu`.

use super::{Kernel, Pair, Singularity, Split};
use crate::{Error, Interval};

/// `K(x, s) = |x - s|^-mu`, `0 < mu < 1`, on a finite interval: the plane punch on a half-plane whose modulus grows as
/// the power `mu` of the depth, and creep with a power law. Positive.
///
/// It is square-summable for `mu < 1/2` only, compact for every `mu < 1`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Power {
    interval: Interval,
    exponent: f64,
}

impl Power {
    /// `|x - s|^-exponent` on `interval`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `0 < exponent < 1`.
    pub fn new(interval: Interval, exponent: f64) -> Result<Self, Error> {
        if exponent > 0.0 && exponent < 1.0 {
            Ok(Self { interval, exponent })
        } else {
            Err(Error::InvalidParameter {
                name: "exponent",
                value: exponent,
                requirement: "between 0 and 1, both excluded",
            })
        }
    }

    /// `mu`.
    #[must_use]
    pub fn exponent(&self) -> f64 {
        self.exponent
    }
}

impl Kernel for Power {
    fn interval(&self) -> Interval {
        self.interval
    }

    fn singularity(&self) -> Singularity {
        Singularity::Power { exponent: self.exponent }
    }

    fn split(&self, _x: f64, _s: f64, _distance: f64) -> Split {
        // d^-mu = 1 + mu sigma(d)
        Split { factor: self.exponent, rest: 1.0 }
    }

    fn pair(&self, _x: f64, _s: f64, distance: f64) -> Pair {
        Pair { value: distance.powf(-self.exponent), factor: self.exponent }
    }

    fn is_even(&self) -> bool {
        true
    }
}

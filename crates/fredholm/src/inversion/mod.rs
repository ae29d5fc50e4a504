//! Explicit inversions of equations of the first kind: what a profile, smooth or with kinks, makes of the pressure under it.
//!
//! On an interval, with `x = c + b cos t`, the logarithm maps `cos k t` to `(pi/k) cos k t`. The pressure under a profile `f = sum f_k cos k t` is then the conjugate of its slope,
//! `F = sum k f_k cos k t`, over `-pi b sin t`: [`Conjugate`] is `F` for slopes of any kind, by a short series or on panels against the pole of the conjugation.
//!
//! The kernels `int_0^inf t^mu J_k(r t) J_k(s t) dt` of disks, and of plane ground whose modulus grows as a power of the depth, split into two transforms of Abel's
//! ([`AbelTransform`] of a [`Shape`], with the [`Powers`] of the exponent); a [`Kink`] on such ground has closed forms, a smooth profile is a sum of [`ultraspherical`] polynomials, which
//! the kernel maps to multiples of themselves. Rings have Legendre functions of half an odd degree, [`RingKernel`].
//!
//! All of them give what a pressure displaces beside its interval as well, so that several intervals can be coupled.

mod angular;
mod conjugate;
mod harmonics;
mod kink;
mod panels;
mod powers;
mod roots;
mod rule;
mod series;
mod shape;
mod toroidal;
mod transform;
pub mod ultraspherical;

pub use angular::Angular;
pub use conjugate::Conjugate;
pub use harmonics::Harmonics;
pub use kink::Kink;
pub use powers::{PLAIN, Powers, TURN};
pub use rule::integral;
pub use series::Series;
pub use shape::{Shape, Symmetry, Weight};
pub use toroidal::RingKernel;
pub use transform::AbelTransform;

use std::f64::consts::PI;

/// Rounding of a quantity relative to what is added up in it.
const ROUNDING: f64 = 32.0 * f64::EPSILON;
/// Rounding of a value that a few operations make, relative to the largest of them.
const OF_A_VALUE: f64 = 4.0 * f64::EPSILON;
/// Coefficients or differences this small relative to the largest value, that do not fall when a panel is halved, are noise.
pub(crate) const NOISE: f64 = 1e-11;
/// Last coefficients relative to the largest value that count as resolved, at best.
const RESOLVED: f64 = 4e-16;
/// A slope at a kink, or a jump where panels meet, is rounding below this share of the largest slope: panels are made to meet, as a jump would be a pole.
const HARMLESS: f64 = 1e-9;
/// Panels are halved at most this often.
const DEEPEST: u32 = 44;
/// Most steps of an iteration that ends by itself: as many halvings are twice the digits of a double.
const STEPS: usize = 120;
/// `(sqrt(5) - 1)/2`: its multiples never fall in with a wave.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

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

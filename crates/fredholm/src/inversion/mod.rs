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

mod accuracy;
mod angular;
mod conjugate;
mod harmonics;
mod kink;
mod panels;
mod place;
mod powers;
mod roots;
mod rule;
mod series;
mod shape;
mod slopes;
mod toroidal;
mod transform;
pub mod ultraspherical;

pub use angular::Angular;
pub use conjugate::Conjugate;
pub use harmonics::Harmonics;
pub use kink::Kink;
pub use place::Place;
pub use powers::{PLAIN, Powers, TURN};
pub use rule::integral;
pub use series::Series;
pub use shape::{Shape, Symmetry, Weight};
pub use slopes::{Slopes, few_waves};
pub use toroidal::RingKernel;
pub use transform::AbelTransform;

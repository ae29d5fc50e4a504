//! Symmetric kernels, their singularities and their spectral relations (paper, section 1).
//!
//! To add a kernel, write one file here: implement [`Kernel`] (value and split of the singularity) and, where one is
//! known, [`SpectralRelation`].

mod logarithm;
mod potential;
mod relation;
mod singularity;

pub use logarithm::Logarithm;
pub(crate) use potential::EndMoments;
pub use potential::{LogarithmicPotential, end_moments};
pub use relation::{Gram, Moments, Parity, SpectralRelation};
pub use singularity::{Singularity, Split};

use crate::Interval;

/// A symmetric kernel `K(x, s) = K(s, x)` on a finite interval `L`, smooth but for its singularity at `x = s`.
pub trait Kernel {
    /// The interval `L`.
    fn interval(&self) -> Interval;

    /// What the kernel does as `x -> s`.
    fn singularity(&self) -> Singularity;

    /// The split `K(x, s) = A(x, s) sigma(|x - s|) + B(x, s)` with the function `sigma` of [`Kernel::singularity`]
    /// and smooth `A`, `B`.
    ///
    /// `distance` is `|x - s|`, handed in because near the ends of the interval the caller knows it to more digits
    /// than the difference of `x` and `s` holds.
    fn split(&self, x: f64, s: f64, distance: f64) -> Split;

    /// `K(x, s)`; infinite at `x = s` for a singular kernel.
    fn value(&self, x: f64, s: f64) -> f64 {
        let distance = (x - s).abs();
        self.split(x, s, distance).value(self.singularity(), distance)
    }
}

//! Kernel 5 on a finite interval: the Macdonald function, `|x - s|^-mu K_mu(kappa |x - s|)` on `(-a, a)`.

mod half_line;
mod profile;
mod relation;
mod spheroidal;

use std::sync::Arc;

pub use half_line::MacdonaldHalfLine;
pub(crate) use profile::MacdonaldProfile;
pub use relation::MacdonaldRelation;

use super::{Kernel, Pair, Singularity, Split};
use crate::{Error, Interval};

/// Least and most decay lengths in the half-length of the interval.
const LENGTHS: std::ops::RangeInclusive<f64> = 1e-20..=1e5;

/// `K(x, s) = |x - s|^-mu K_mu(kappa |x - s|)`, `|mu| < 1/2`, `kappa > 0`, on `(-a, a)`, with the Macdonald function `K_mu`: the strip punch on a
/// half-space whose modulus grows as the power `2 mu` of the depth, the load varying along the strip as `cos(kappa y)`. Positive; `kappa` is
/// the inverse of the decay length, in 1 over the unit of `x`.
///
/// Because `K_-mu = K_mu`, a negative order gives the kernel `|x - s|^|mu| K_|mu|(kappa |x - s|)`.
///
/// Singularity: `2^(mu-1) Gamma(mu) kappa^-mu |x - s|^-2mu` for `mu > 0`, `-ln|x - s|` for `mu = 0`; bounded for `mu < 0`, but with a bend
/// `|x - s|^(2 |mu|)`. Fourier symbol: `sqrt(pi) (2 kappa)^-mu Gamma(1/2 - mu) (kappa^2 + omega^2)^(mu - 1/2)`.
///
/// The kernel is tabulated when it is made, in 0.1 to 0.5 ms; a value then takes some tens of ns.
///
/// ```
/// use fredholm::collocation::solve_adaptive;
/// use fredholm::kernel::Macdonald;
///
/// let kernel = Macdonald::new(1.0, 0.2, 1.0)?;
/// let found = solve_adaptive(&kernel, 0.5, |_| 1.0, 1e-11)?;
/// // Two independent Nystrom methods.
/// assert!((found.solution.integral(|_| 1.0) - 0.710_743_213_120_55).abs() < 1e-12);
/// # Ok::<(), fredholm::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Macdonald {
    interval: Interval,
    profile: Arc<MacdonaldProfile>,
}

impl Macdonald {
    /// The kernel on `(-half_length, half_length)` with the order `mu` and the decay `kappa`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `|order| < 1/2`, `half_length` and `decay` are finite and positive, and
    /// `1e-20 <= decay * half_length <= 1e5`.
    pub fn new(half_length: f64, order: f64, decay: f64) -> Result<Self, Error> {
        let interval = Interval::symmetric(half_length)?;
        let product = decay * half_length;
        if decay > 0.0 && decay.is_finite() && !LENGTHS.contains(&product) {
            return Err(Error::InvalidParameter {
                name: "decay * half_length",
                value: product,
                requirement: "between 1e-20 and 1e5: for less the kernel is a power or a logarithm and a constant, for more the \
                              ends do not know of each other (use the half-line)",
            });
        }
        let profile = MacdonaldProfile::new(order, decay, 2.0 * product)?;
        Ok(Self { interval, profile: Arc::new(profile) })
    }

    /// `a`.
    #[must_use]
    pub fn half_length(&self) -> f64 {
        self.interval.right()
    }

    /// `mu`.
    #[must_use]
    pub fn order(&self) -> f64 {
        self.profile.order()
    }

    /// `kappa`.
    #[must_use]
    pub fn decay(&self) -> f64 {
        self.profile.decay()
    }

    /// Whether `int int K^2 dx ds` is finite, `mu < 1/4`; the operator is compact for every `mu < 1/2`, and the degenerate kernel converges, the slower the
    /// larger `mu` is.
    #[must_use]
    pub fn is_square_summable(&self) -> bool {
        self.order() < 0.25
    }
}

impl Kernel for Macdonald {
    fn interval(&self) -> Interval {
        self.interval
    }

    fn singularity(&self) -> Singularity {
        self.profile.singularity()
    }

    fn split(&self, _x: f64, _s: f64, distance: f64) -> Split {
        self.profile.split(distance)
    }

    fn pair(&self, _x: f64, _s: f64, distance: f64) -> Pair {
        self.profile.pair(distance)
    }

    fn is_even(&self) -> bool {
        true
    }

    fn decay_length(&self) -> f64 {
        self.decay().recip()
    }

    /// *Measured* for the order 0 and 12 digits: 45, 90, 195 nodes for 10, 40, 120 decay lengths in half the interval.
    fn first_half_count(&self) -> f64 {
        32.0 + 1.5 * self.decay() * self.half_length()
    }
}

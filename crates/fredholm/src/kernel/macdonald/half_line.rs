//! Kernel 5 on the half-line: the Macdonald function, `|x - s|^-mu K_mu(kappa |x - s|)` on `(0, infinity)`.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use super::profile::MacdonaldProfile;
use crate::basis::laguerre;
use crate::basis::laguerre_moments::Panels;
use crate::kernel::{
    EndExponents, Expansion, Gram, Kernel, Moments, Pair, Parity, Singularity, SpectralRelation,
    Split,
};
use crate::{Error, Interval, memory};

/// Range of the decay `kappa`: powers of distances in units of `1/kappa` overflow beyond it.
const DECAYS: std::ops::RangeInclusive<f64> = 1e-50..=1e50;
/// The profile is tabulated to where the kernel underflows, in decay lengths.
const TABULATED: f64 = 1e3;
/// Decay lengths on which solutions are compared and shown.
const SHOWN: f64 = 12.0;
/// The factor of the singular function fades around this distance, in decay lengths, with this sharpness. Measured: nearer it would have to be resolved by more
/// nodes, farther off a truncated section would ring.
const CUTOFF: [f64; 2] = [8.0, 6.0];

/// `K(x, s) = |x - s|^-mu K_mu(kappa |x - s|)`, `|mu| < 1/2`, `kappa > 0`, on `(0, infinity)`, with the Macdonald function `K_mu`. Positive;
/// `kappa` is the inverse of the decay length, in 1 over the unit of `x`.
///
/// Spectral relation, with Laguerre polynomials and `alpha = mu - 1/2`: `phi_n = e^(-kappa x) L_n^(alpha)(2 kappa x)`, `w = x^alpha`,
///
/// `lambda_n = sqrt(pi/(2 kappa)) Gamma(1/2 - mu) Gamma(n + 1/2 + mu)/n!`, `h_n = (2 kappa)^(-mu - 1/2) Gamma(n + 1/2 + mu)/n!`,
///
/// so that all factors of the bilinear expansion are the same, `lambda_n/h_n = sqrt(pi) (2 kappa)^mu Gamma(1/2 - mu)`. Gram matrix:
/// `R = A A^T/(2 kappa)` with the lower triangular Toeplitz matrix `A_kj = (alpha)_(k-j)/(k-j)!`.
///
/// The operator is not compact in `L_2(0, infinity)`: its spectrum is continuous and fills `[0, G^(0)]`, see [`symbol_at_zero`](Self::symbol_at_zero).
/// Degenerate kernels converge, but at no uniform rate. Collocation works on a finite section:
/// [`solve_half_line`](crate::collocation::solve_half_line).
///
/// ```
/// use fredholm::kernel::{MacdonaldHalfLine, SpectralRelation};
///
/// let kernel = MacdonaldHalfLine::new(0.3, 1.0)?;
/// assert!((kernel.eigenvalue(5) - 4.105_397_724_819_213).abs() < 1e-14);
/// // L_100 (2 kappa x) alone is 3e100 here, and the exponential 1e-109.
/// let mut values = vec![0.0; 101];
/// kernel.eigenfunctions(250.0, &mut values);
/// assert!((values[100] / 8.019_080_503_765_137e-9 - 1.0).abs() < 1e-12);
/// # Ok::<(), fredholm::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct MacdonaldHalfLine {
    interval: Interval,
    profile: Arc<MacdonaldProfile>,
    /// The same with `kappa = 1` and a cutoff of its own: collocation works in decay lengths.
    unit_profile: Arc<MacdonaldProfile>,
}

impl MacdonaldHalfLine {
    /// The kernel with the order `mu` and the decay `kappa`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `|order| < 1/2` and `1e-50 <= decay <= 1e50`.
    pub fn new(order: f64, decay: f64) -> Result<Self, Error> {
        if !DECAYS.contains(&decay) {
            return Err(Error::InvalidParameter {
                name: "decay",
                value: decay,
                requirement: "between 1e-50 and 1e50: the kernel decays as exp(-decay |x - s|), and its powers overflow beyond",
            });
        }
        let profile = Arc::new(MacdonaldProfile::new(order, decay, TABULATED)?);
        let unit_profile = MacdonaldProfile::new(order, 1.0, TABULATED)?;
        let unit_profile = Arc::new(unit_profile.with_cutoff(CUTOFF[0], CUTOFF[1]));
        Ok(Self { interval: Interval::half_line(0.0)?, profile, unit_profile })
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

    /// `G^(0) = int K(|u|) du = sqrt(pi) 2^-mu Gamma(1/2 - mu) kappa^(mu - 1)` over the whole line: the upper end of the continuous spectrum `[0, G^(0)]`.
    /// The equation of the second kind is solvable for `lambda > -1/G^(0)`.
    #[must_use]
    pub fn symbol_at_zero(&self) -> f64 {
        let mu = self.order();
        PI.sqrt() * 2f64.powf(-mu) * libm::tgamma(0.5 - mu) * self.decay().powf(mu - 1.0)
    }

    /// The kernel with `kappa = 1` as a function of the distance: with `xi = kappa x` the operator is that kernel's times [`unit_scale`](Self::unit_scale).
    pub(crate) fn unit_profile(&self) -> &MacdonaldProfile {
        &self.unit_profile
    }

    /// `kappa^(mu - 1)`.
    pub(crate) fn unit_scale(&self) -> f64 {
        self.decay().powf(self.order() - 1.0)
    }

    /// `mu - 1/2`.
    fn alpha(&self) -> f64 {
        self.order() - 0.5
    }

    /// `Gamma(n + 1/2 + mu)/n!`.
    fn gamma_ratio(&self, n: usize) -> f64 {
        laguerre::gamma_ratio(n, self.order() + 0.5)
    }

    fn panels(&self) -> Panels {
        Panels { alpha: self.alpha(), scale: 2.0 * self.decay() }
    }
}

impl Kernel for MacdonaldHalfLine {
    fn interval(&self) -> Interval {
        self.interval
    }

    /// Twelve decay lengths.
    fn extent(&self) -> Interval {
        Interval::new(0.0, SHOWN / self.decay()).unwrap_or(self.interval)
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
}

impl SpectralRelation for MacdonaldHalfLine {
    fn weight_exponents(&self) -> EndExponents {
        EndExponents { left: self.alpha(), right: 0.0 }
    }

    fn weight_rest(&self, _n: usize, _x: f64) -> f64 {
        1.0
    }

    fn eigenvalue(&self, n: usize) -> f64 {
        let scale = (FRAC_PI_2 / self.decay()).sqrt() * libm::tgamma(0.5 - self.order());
        scale * self.gamma_ratio(n)
    }

    fn norm(&self, n: usize) -> f64 {
        (2.0 * self.decay()).powf(-self.order() - 0.5) * self.gamma_ratio(n)
    }

    fn expansion_factor(&self, _n: usize) -> f64 {
        let mu = self.order();
        PI.sqrt() * (2.0 * self.decay()).powf(mu) * libm::tgamma(0.5 - mu)
    }

    fn parity(&self) -> Parity {
        Parity::None
    }

    fn eigenfunctions(&self, x: f64, values: &mut [f64]) {
        let functions = laguerre::Functions::at(self.alpha(), 2.0 * self.decay() * x);
        values.iter_mut().zip(functions).for_each(|(value, phi)| *value = phi);
    }

    fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        laguerre::sum(self.alpha(), coefficients, 2.0 * self.decay() * x)
    }

    fn gram(&self, count: usize) -> Result<Gram, Error> {
        memory::admit(count, 16.0 * (count as f64).powi(2))?;
        let column = laguerre::binomials(self.alpha(), count);
        let unit = 0.5 / self.decay();
        let mut entries = vec![0.0; count * count];
        for k in 0..count {
            for m in 0..=k {
                // R_(k+1, m+1) - R_km is the product of two entries of the first column of A.
                let before = if m == 0 { 0.0 } else { entries[(k - 1) * count + m - 1] };
                let entry = before + unit * column[k] * column[m];
                entries[k * count + m] = entry;
                entries[m * count + k] = entry;
            }
        }
        Ok(Gram::Dense { order: count, entries })
    }

    /// Coefficients of `f`, up to 1024. A function that does not decay as `e^(-kappa x)` does, or nearly so, is not resolved: for
    /// `f = e^(-beta x)` the coefficients fall as `|(beta - kappa)/(beta + kappa)|^n`.
    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error> {
        let norms = |n| self.norm(n);
        self.panels().expand(f, &norms)
    }

    fn moments(&self, f: &dyn Fn(f64) -> f64, count: usize) -> Result<Moments, Error> {
        self.panels().moments(f, count)
    }

    fn mass(&self, n: usize) -> f64 {
        // int e^(-y/2) L_n^(alpha)(y) y^alpha dy = (-1)^n 2^(alpha+1) Gamma(n + alpha + 1)/n!
        let sign = if n.is_multiple_of(2) { 1.0 } else { -1.0 };
        sign * self.decay().powf(-self.order() - 0.5) * self.gamma_ratio(n)
    }
}

//! Kernel 6: the integral of Weber and Sonine, the harmonics of a power of the distance on a disk.

mod coefficients;
mod cutoff;
mod dyadic;
mod factor;
mod gram;
mod homogeneous;
mod many;
mod relation;
mod value;

pub(crate) use homogeneous::Homogeneous;

use std::sync::Arc;

use self::value::Tables;
use super::{Kernel, Pair, Singularity, Split};
use crate::quadrature::jacobi::Jacobi;
use crate::{Error, Interval};

/// Beyond it `P_n^(mu, gamma-1/2)` overflows at degrees in use.
const LARGEST_ORDER: f64 = 100.0;

/// `W(x, s) = int_0^inf J_mu(t x) J_mu(t s) t^(2 gamma) dt` on `(0, a)` with the measure `s ds`; `0 <= mu <= 100`, `|gamma| < 1/2`. Positive.
///
/// The potential of a pressure `p(s) cos(m u)` on a disk for the influence function `R^(-1-2 gamma)` is `2 pi 2^(-2 gamma) Gamma(1/2-gamma)/Gamma(1/2+gamma)
/// int_0^a W p s ds cos(m u)` with `mu = m`; for `gamma = 0`, `1/R`, it is `2 pi int W p s ds`: the circular punch on an elastic half-space (`m = 0`) and
/// its tilt (`m = 1`). `gamma` between 0 and 1/2 is the half-space whose modulus grows as the power `2 gamma` of the depth.
///
/// The measure is part of the kernel. With plain `ds` the operator is not compact for `gamma = 0` (its spectrum is an interval) and unbounded for
/// `gamma > 0`; with `s ds` it is compact for all `|gamma| < 1/2`, square-summable for `gamma < 1/4`.
///
/// Spectral relation: `phi_n = x^mu P_n^(mu, gamma-1/2)(1 - 2 x^2/a^2)`, `w = (a^2 - s^2)^(gamma-1/2)` beside the measure,
///
/// `lambda_n = 2^(2 gamma-1) Gamma(n+gamma+1/2) Gamma(n+mu+gamma+1/2) / (n! Gamma(n+mu+1))`,
///
/// `h_n = a^(2 mu+2 gamma+1) / (2 (2n+mu+gamma+1/2)) Gamma(n+mu+1) Gamma(n+gamma+1/2) / (n! Gamma(n+mu+gamma+1/2))`.
///
/// (By Rodrigues' formula, Sonine's first integral and the discontinuous integral of Weber and Schafheitlin, DLMF 18.5, 10.22.) Values are accurate to about
/// 1e-14 wherever they do not overflow; those that do are the largest double. Right-hand sides for which expansions converge fast are `x^mu` times
/// a smooth function of `x^2`.
///
/// ```
/// use fredholm::collocation::solve_adaptive;
/// use fredholm::kernel::{SpectralRelation, WeberSonine};
///
/// let disk = WeberSonine::new(1.0, 0.0, 0.0)?;
/// assert!((disk.eigenvalue(0) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// let found = solve_adaptive(&disk, 1.0, |_| 1.0, 1e-11)?;
/// let exact = 0.479_479_198_852_840; // p(0), two Nystrom methods
/// assert!((found.solution.evaluate(0.0, 1.0) - exact).abs() < 1e-12);
/// # Ok::<(), fredholm::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct WeberSonine {
    interval: Interval,
    radius: f64,
    order: f64,
    exponent: f64,
    tables: Arc<Tables>,
}

/// Within what share of the radius potentials of order 0 have their value at the centre but for this much: they leave it as `x^(2-2 gamma)` at least, where functions are
/// smooth.
const CENTRE: f64 = 1e-16;

impl WeberSonine {
    /// The kernel with the order `mu` and the exponent `gamma` on `(0, radius)`. Builds tables of its one variable, in about a millisecond.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `radius` is finite and positive with `radius^(2 mu + 2 gamma + 1)` in the range of a double, `0 <= order <= 100` and
    /// `-1/2 < exponent < 1/2`.
    pub fn new(radius: f64, order: f64, exponent: f64) -> Result<Self, Error> {
        let refuse =
            |name, value, requirement| Err(Error::InvalidParameter { name, value, requirement });
        if !(radius.is_finite() && radius > 0.0) {
            return refuse("radius", radius, "finite and positive");
        }
        if !(0.0..=LARGEST_ORDER).contains(&order) {
            return refuse(
                "order",
                order,
                "between 0 and 100: below, the kernel need not be positive; above, its eigenfunctions overflow",
            );
        }
        if !(exponent > -0.5 && exponent < 0.5) {
            return refuse(
                "exponent",
                exponent,
                "between -1/2 and 1/2, both excluded: the kernel is not integrable above and, of order 0, infinite below",
            );
        }
        // h_n has the former power, R_km the latter.
        for power in [2.0 * order + 2.0 * exponent + 1.0, 2.0 * order + 2.0] {
            let size = radius.powf(power);
            if !(1e-280..1e280).contains(&size) {
                return refuse(
                    "radius",
                    radius,
                    "such that radius^(2 order + 2) stays between 1e-280 and 1e280: norms have that size, so scale lengths",
                );
            }
        }
        Ok(Self {
            interval: Interval::new(0.0, radius)?,
            radius,
            order,
            exponent,
            tables: Arc::new(Tables::new(radius, order, exponent)),
        })
    }

    /// `a`.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// `mu`.
    #[must_use]
    pub fn order(&self) -> f64 {
        self.order
    }

    /// `gamma`.
    #[must_use]
    pub fn exponent(&self) -> f64 {
        self.exponent
    }

    /// Value and factor at two different points, the factor as far from the diagonal as it is known: without the cutoff.
    pub(crate) fn uncut(&self, x: f64, s: f64, distance: f64) -> Pair {
        self.tables.uncut(x, s, distance)
    }

    fn polynomials(&self) -> Jacobi {
        Jacobi::new(self.order, self.exponent - 0.5)
    }
}

impl Kernel for WeberSonine {
    fn interval(&self) -> Interval {
        self.interval
    }

    fn singularity(&self) -> Singularity {
        Singularity::Power { exponent: 2.0 * self.exponent }
    }

    fn split(&self, x: f64, s: f64, distance: f64) -> Split {
        if x == s {
            return self.tables.on_diagonal(x);
        }
        let Pair { value, factor } = self.pair(x, s, distance);
        Split { factor, rest: value - factor * self.singularity().value(distance) }
    }

    fn pair(&self, x: f64, s: f64, distance: f64) -> Pair {
        self.tables.pair(x, s, distance)
    }

    fn pairs(
        &self,
        x: f64,
        points: &[f64],
        distances: &[f64],
        values: &mut [f64],
        factors: &mut [f64],
    ) {
        self.tables.many(x, (points, distances), values, Some(factors));
    }

    fn values(
        &self,
        x: f64,
        points: &[f64],
        distances: &[f64],
        values: &mut [f64],
        _room: &mut [f64],
    ) {
        self.tables.many(x, (points, distances), values, None);
    }

    fn measure(&self, s: f64) -> f64 {
        s
    }

    /// For the order 0, else none: potentials of functions that are not `x^mu` times a smooth one leave 0 as `x^(1-2 gamma)`.
    fn settled(&self) -> f64 {
        let power = 2.0 - 2.0 * self.exponent.max(0.0);
        if self.order == 0.0 { CENTRE.powf(1.0 / power) * self.radius } else { 0.0 }
    }

    /// `1 - 2 gamma` at `a`; at 0 solutions are `x^mu` times a smooth function of `x^2`, if the right-hand side is, else there are terms with
    /// `1 - 2 gamma` too.
    fn end_exponent(&self) -> f64 {
        let at_rim = (1.0 - 2.0 * self.exponent).min(1.0);
        if self.order > 0.0 { at_rim.min(self.order) } else { at_rim }
    }

    fn centre_exponent(&self) -> f64 {
        self.order
    }

    /// `x^mu`, with which harmonics are integrated: the moment of a tilt has `mu = 1`.
    fn mass_function(&self, x: f64) -> f64 {
        if self.order == 0.0 { 1.0 } else { x.powf(self.order) }
    }

    fn value(&self, x: f64, s: f64) -> f64 {
        if x == s { self.tables.at(x) } else { self.tables.value(x, s, (x - s).abs()) }
    }
}

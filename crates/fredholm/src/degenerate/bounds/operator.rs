//! What the error bounds of all approximations at one parameter share.

use super::amplification::amplification;
use super::approximation::{Approximation, Parts};
use super::enclosure::Kind;
use super::ends::EndInfluence;
use super::iterated::difference;
use crate::basis::ChebyshevSeries;
use crate::degenerate::split::check_parameter;
use crate::kernel::{Logarithm, SpectralRelation, end_moments};
use crate::{Error, StructuredOperator};

/// Degree up to which the residual is formed mode by mode, over that of the approximation.
const REACH: usize = 4;
/// The least degree up to which it is.
const LEAST: usize = 64;

/// The residual `r = g - q - theta K q` of polynomials `q`, `K` the logarithmic kernel on `(-1, 1)`.
///
/// ```
/// use fredholm::bounds::{Kind, ResidualOperator};
/// use fredholm::kernel::{Logarithm, SpectralRelation};
/// use fredholm::{DegenerateSystem, basis::ChebyshevSeries};
///
/// let (kernel, theta) = (Logarithm::unit(), 2.0);
/// let one = ChebyshevSeries::new(vec![1.0]);
/// let solution = DegenerateSystem::new(&kernel, theta, 100)?.solve(&one.moments(101));
/// let residuals = ResidualOperator::new(&kernel, theta, 100)?;
/// let approximation = residuals.approximation(&one, solution.correction(), Kind::Bound)?;
/// assert!(approximation.error_supremum() < 1.3e-4);
/// let force = approximation.functional(&approximation);
/// assert!((force.value - 0.499_882_473_167).abs() < force.radius && force.radius < 2e-11);
/// # Ok::<(), fredholm::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct ResidualOperator<'k> {
    parameter: f64,
    amplification: f64,
    products: StructuredOperator<'k, Logarithm>,
}

impl<'k> ResidualOperator<'k> {
    /// For approximations and right-hand sides of at most this degree.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a negative or not finite parameter, or an interval other than `(-1, 1)`;
    /// [`Error::TooLarge`] beyond memory.
    pub fn new(kernel: &'k Logarithm, parameter: f64, degree: usize) -> Result<Self, Error> {
        let last = degree.saturating_add(1).saturating_mul(REACH).max(LEAST);
        check_parameter(parameter)?;
        Self::with_products(StructuredOperator::new(kernel, last)?, parameter)
    }

    /// The same with products that are shared by several parameters: those of degree `M` admit approximations of degree `M/4 - 1`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a negative or not finite parameter, an interval other than `(-1, 1)`, or products of a degree
    /// below 64.
    pub fn with_products(
        products: StructuredOperator<'k, Logarithm>,
        parameter: f64,
    ) -> Result<Self, Error> {
        check_parameter(parameter)?;
        let half_length = products.kernel().half_length();
        if half_length != 1.0 {
            return Err(Error::InvalidParameter {
                name: "half_length",
                value: half_length,
                requirement: "1: scale the equation to (-1, 1)",
            });
        }
        if products.kernel().expansion_factor(0) != std::f64::consts::LN_2 {
            return Err(Error::InvalidParameter {
                name: "first factor of the expansion",
                value: products.kernel().expansion_factor(0),
                requirement: "ln 2: the kernel without a gauge",
            });
        }
        if products.degree() < LEAST {
            return Err(Error::InvalidParameter {
                name: "degree of the products",
                value: products.degree() as f64,
                requirement: "at least 64",
            });
        }
        Ok(Self { parameter, amplification: amplification(parameter), products })
    }

    /// `theta`.
    #[must_use]
    pub fn parameter(&self) -> f64 {
        self.parameter
    }

    /// `C(theta)` in `max |theta K A^{-1} r| <= C(theta) ||r||`: what the norm of the residual counts for in the error at a point.
    #[must_use]
    pub fn amplification(&self) -> f64 {
        self.amplification
    }

    /// The highest degree of right-hand sides and approximations.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.products.degree() / REACH - 1
    }

    /// The approximation `q = g - s` with its residual; `s` by its coefficients. Two products of four times the degree.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] when the degree of `g` or `s` exceeds [`degree`](Self::degree) or a coefficient is not finite.
    pub fn approximation(
        &self,
        right_hand_side: &ChebyshevSeries,
        correction: &[f64],
        kind: Kind,
    ) -> Result<Approximation, Error> {
        let density = difference(right_hand_side, correction);
        self.check(&density)?;
        let moments = self.products.product(&density);
        let kernel = self.products.kernel();
        let residual: Vec<f64> = (moments.iter().enumerate())
            .map(|(m, moment)| {
                let s = correction.get(m).copied().unwrap_or(0.0);
                s - self.parameter * kernel.expansion_factor(m) * moment
            })
            .collect();
        let parts = Parts {
            right: right_hand_side.coefficients().to_vec(),
            correction: correction.to_vec(),
            residual_moments: self.products.product(&residual),
            moments,
            residual,
        };
        Ok(Approximation::new(self.parameter, self.amplification, kind, parts))
    }

    /// The approximation `k - s` of the influence function `A^{-1} k` of the end values, `k(x) = ln(1/(1 - x))`; `s` by its
    /// coefficients, from the system with the moments [`end_moments`]. Two products of four times the degree.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] when the degree of `s` exceeds [`degree`](Self::degree) or a coefficient is not finite.
    pub fn end_influence(&self, correction: &[f64]) -> Result<EndInfluence, Error> {
        self.check(correction)?;
        let count = self.products.degree() + 1;
        let kernel = self.products.kernel();
        let smooth = self.products.product(correction);
        let moments: Vec<f64> =
            end_moments(count).iter().zip(&smooth).map(|(e, s)| e - s).collect();
        let residual: Vec<f64> = (moments.iter().enumerate())
            .map(|(m, moment)| {
                let s = correction.get(m).copied().unwrap_or(0.0);
                s - self.parameter * kernel.expansion_factor(m) * moment
            })
            .collect();
        let residual_moments = self.products.product(&residual);
        Ok(EndInfluence::new(self.parameter, correction, moments, residual, &residual_moments))
    }

    fn check(&self, density: &[f64]) -> Result<(), Error> {
        if density.len() > self.degree() + 1 {
            return Err(Error::InvalidParameter {
                name: "degree of the approximation",
                value: density.len() as f64 - 1.0,
                requirement: "at most that of the residual operator",
            });
        }
        match density.iter().find(|c| !c.is_finite()) {
            Some(&value) => {
                Err(Error::InvalidParameter { name: "coefficient", value, requirement: "finite" })
            }
            None => Ok(()),
        }
    }
}

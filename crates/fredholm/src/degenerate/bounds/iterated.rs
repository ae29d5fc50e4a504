//! The iterated solution.

use crate::basis::ChebyshevSeries;
use crate::kernel::LogarithmicPotential;

/// One exact application of the logarithmic kernel on `(-1, 1)` to an approximate solution `q = g - s`:
///
/// `q_1(x) = g(x) - theta int_{-1}^{1} ln(1/|x - s|) q(s) ds`, with error `p - q_1 = -theta K (p - q)`.
///
/// For the degenerate solution of degree `n` its end values converge as `n^-4 ln n`, where those of `q` do as `n^-2`. Inside it
/// is the better of the two only from about `n = 2 theta` on: below, `theta K` amplifies the error.
///
/// ```
/// use fredholm::bounds::IteratedSolution;
/// use fredholm::kernel::{Logarithm, SpectralRelation};
/// use fredholm::{DegenerateSystem, basis::ChebyshevSeries};
///
/// let kernel = Logarithm::unit();
/// let right = ChebyshevSeries::new(vec![1.0]);
/// let plain = DegenerateSystem::new(&kernel, 2.0, 40)?.solve(&right.moments(41));
/// let iterated = IteratedSolution::new(2.0, &right, plain.correction());
/// let exact = 0.564_321_309_702; // by sinc collocation
/// assert!((plain.evaluate(1.0, 1.0) - exact).abs() > 6e-4);
/// assert!((iterated.evaluate(1.0, 1.0) - exact).abs() < 3e-6);
/// # Ok::<(), fredholm::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct IteratedSolution {
    parameter: f64,
    potential: LogarithmicPotential,
}

impl IteratedSolution {
    /// Of `q = g - s` at the parameter `theta`, from the series of `g` and the coefficients of `s`
    /// ([`DegenerateSolution::correction`](crate::DegenerateSolution::correction)).
    #[must_use]
    pub fn new(parameter: f64, right_hand_side: &ChebyshevSeries, correction: &[f64]) -> Self {
        Self::of(parameter, &ChebyshevSeries::new(difference(right_hand_side, correction)))
    }

    /// Of the polynomial `q` itself.
    pub(super) fn of(parameter: f64, density: &ChebyshevSeries) -> Self {
        Self { parameter, potential: LogarithmicPotential::new(density) }
    }

    /// `q_1(x)`, given `g(x)`; `x` in `[-1, 1]`. Cost: 5 operations a coefficient.
    #[must_use]
    pub fn evaluate(&self, x: f64, right_hand_side: f64) -> f64 {
        right_hand_side - self.correction(x)
    }

    /// `theta (K q)(x)`.
    #[must_use]
    pub fn correction(&self, x: f64) -> f64 {
        self.parameter * self.potential.evaluate(x)
    }
}

/// The coefficients of `g - s`.
pub(super) fn difference(right: &ChebyshevSeries, correction: &[f64]) -> Vec<f64> {
    let mut density = right.coefficients().to_vec();
    density.resize(density.len().max(correction.len()), 0.0);
    for (c, s) in density.iter_mut().zip(correction) {
        *c -= s;
    }
    density
}

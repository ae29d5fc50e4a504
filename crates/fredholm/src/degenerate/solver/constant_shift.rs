//! A positive kernel less a constant: the logarithm on a long interval.

use super::DegenerateSolver;
use crate::DegenerateSolution;
use crate::Error;
use crate::kernel::{Logarithm, SpectralRelation};

/// A denominator below this counts as zero.
const SINGULAR: f64 = 1e-12;

/// `phi + lambda (K - c) phi = f` for a logarithmic kernel `K` that is positive and a constant `c`: a rank-one step beside the positive system,
///
/// `phi = phi_f + lambda c t phi_1`, `t = int phi dx = int phi_f dx / (1 - lambda c int phi_1 dx)`,
///
/// with the responses `phi_f`, `phi_1` of `1 + lambda K` to `f` and 1.
///
/// The logarithm `ln 1/|x - s|` on an interval of length `2a > 4` is not positive (its capacity `a/2` exceeds 1); with the gauge
/// `l = a` it is `ln a/|x - s|`, positive, less the constant `ln a`:
///
/// ```
/// use fredholm::degenerate::ConstantShift;
/// use fredholm::kernel::{Logarithm, SpectralRelation};
/// use fredholm::SincOperator;
///
/// let (a, lambda) = (3.0f64, 0.05);
/// let positive = Logarithm::with_gauge(a, a)?;
/// let shifted = ConstantShift::new(&positive, a.ln(), lambda, 500)?;
/// let phi = shifted.solve(&positive.moments(&f64::cos, 501)?.values)?;
///
/// let plain = SincOperator::new(&Logarithm::new(a)?, 60)?;
/// let independent = &plain.solve(lambda, &[plain.sample(f64::cos)?])?[0];
/// assert!((phi.integral - independent.integral(|_| 1.0)).abs() < 1e-9);
/// assert!((phi.evaluate(1.0, 1f64.cos()) - independent.evaluate(1.0, 1f64.cos())).abs() < 1e-5);
/// # Ok::<(), fredholm::Error>(())
/// ```
#[derive(Debug)]
pub struct ConstantShift<'k> {
    solver: DegenerateSolver<'k, Logarithm>,
    level: DegenerateSolution<'k, Logarithm>,
    /// `lambda c`.
    strength: f64,
    /// `1 - lambda c int phi_1 dx`.
    denominator: f64,
}

/// The solution for one right-hand side.
#[derive(Debug, Clone)]
pub struct ShiftedSolution<'s, 'k> {
    response: DegenerateSolution<'k, Logarithm>,
    level: &'s DegenerateSolution<'k, Logarithm>,
    /// `lambda c t`.
    share: f64,
    /// `int phi dx`.
    pub integral: f64,
}

impl<'k> ConstantShift<'k> {
    /// The system for `phi + parameter (kernel - constant) phi = f`, with Chebyshev polynomials up to `degree`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a constant that is not finite; [`Error::Singular`] where the denominator is zero to rounding: `-1/parameter`
    /// is an eigenvalue; those of [`DegenerateSolver::new`].
    pub fn new(
        kernel: &'k Logarithm,
        constant: f64,
        parameter: f64,
        degree: usize,
    ) -> Result<Self, Error> {
        if !constant.is_finite() {
            return Err(Error::InvalidParameter {
                name: "constant",
                value: constant,
                requirement: "finite",
            });
        }
        let solver = DegenerateSolver::new(kernel, parameter, degree)?;
        let level = solver.solve(&kernel.moments(&|_| 1.0, degree + 1)?.values)?;
        let strength = parameter * constant;
        let denominator = 1.0 - strength * level.projections()[0];
        if denominator.abs() < SINGULAR {
            return Err(Error::Singular { parameter, smallest: denominator });
        }
        Ok(Self { solver, level, strength, denominator })
    }

    /// `1 - lambda c int phi_1 dx`: where it is near zero, errors grow by its inverse.
    #[must_use]
    pub fn denominator(&self) -> f64 {
        self.denominator
    }

    /// The solution for the moments of `f`.
    ///
    /// # Errors
    /// Those of [`DegenerateSolver::solve`].
    pub fn solve(&self, moments: &[f64]) -> Result<ShiftedSolution<'_, 'k>, Error> {
        let response = self.solver.solve(moments)?;
        let integral = response.projections()[0] / self.denominator;
        Ok(ShiftedSolution {
            response,
            level: &self.level,
            share: self.strength * integral,
            integral,
        })
    }
}

impl ShiftedSolution<'_, '_> {
    /// `phi(x)`, given `f(x)`.
    #[must_use]
    pub fn evaluate(&self, x: f64, right_hand_side: f64) -> f64 {
        self.response.evaluate(x, right_hand_side) + self.share * self.level.evaluate(x, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SincOperator;

    #[test]
    fn agrees_with_collocation_on_long_intervals() {
        for (a, lambda) in [(2.5, 0.1), (2.5, 7.0), (10.0, 1.0), (1000.0, 0.01)] {
            let kernel = Logarithm::with_gauge(a, a).unwrap();
            let shifted = ConstantShift::new(&kernel, a.ln(), lambda, 2000).unwrap();
            let f = |x: f64| 1.0 + x / a + (x / a).powi(2);
            let phi = shifted.solve(&kernel.moments(&f, 2001).unwrap().values).unwrap();
            let operator = SincOperator::new(&Logarithm::new(a).unwrap(), 90).unwrap();
            let independent = &operator.solve(lambda, &[operator.sample(f).unwrap()]).unwrap()[0];
            let integral = independent.integral(|_| 1.0);
            assert!(
                (phi.integral - integral).abs() < 1e-9 * integral.abs(),
                "a = {a}: {} {integral}",
                phi.integral
            );
            for x in [-a, -0.3 * a, 0.0, a] {
                let (one, two) = (phi.evaluate(x, f(x)), independent.evaluate(x, f(x)));
                assert!(
                    (one - two).abs() < 1e-4 * two.abs().max(1e-3),
                    "a = {a}, x = {x}: {one} {two}"
                );
            }
        }
    }

    #[test]
    fn a_positive_kernel_needs_no_shift() {
        let kernel = Logarithm::unit();
        let shifted = ConstantShift::new(&kernel, 0.0, 2.0, 100).unwrap();
        let moments = kernel.moments(&f64::exp, 101).unwrap().values;
        let plain = DegenerateSolver::new(&kernel, 2.0, 100).unwrap().solve(&moments).unwrap();
        assert_eq!(shifted.solve(&moments).unwrap().integral, plain.projections()[0]);
        assert_eq!(shifted.denominator(), 1.0);
    }

    #[test]
    fn refuses_a_singular_parameter() {
        // The constant that makes the denominator vanish, from the response itself.
        let kernel = Logarithm::unit();
        let force = 1.0 - ConstantShift::new(&kernel, 1.0, 1.0, 60).unwrap().denominator();
        let error = ConstantShift::new(&kernel, 1.0 / force, 1.0, 60).unwrap_err();
        assert!(matches!(error, Error::Singular { .. }), "{error}");
        assert!(ConstantShift::new(&kernel, f64::NAN, 1.0, 60).is_err());
    }
}

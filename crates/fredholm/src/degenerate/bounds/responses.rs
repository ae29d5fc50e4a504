//! The answers to the right-hand sides `1`, `x` and `f`, and what is given of their combination.

use super::approximation::Approximation;
use super::combination::Combination;
use super::enclosure::Enclosure;
use crate::Error;

/// What is given of a coefficient `c` and the projection `<u, p>` that belongs to it, `u = 1` or `x`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Given {
    /// The coefficient.
    Coefficient(f64),
    /// The projection `int u p dx`.
    Projection(f64),
    /// The quotient `kappa` of the coefficient and its projection, `c = kappa int u p dx`: the rank-one step beside a positive kernel. The logarithm on `(-a, a)`,
    /// scaled to `(-1, 1)`, is `ln(1/|x - s|) - ln a`, so that `p + theta K p = g` has `kappa = theta ln a` for `u = 1` and `f = -g`.
    Proportion(f64),
    /// The quotient `e` of the projections, `int x p dx = e int p dx`: for the second only; as the first it counts as a projection of 0.
    Quotient(f64),
}

/// Approximations of `A^{-1} 1`, `A^{-1} x` and `A^{-1} f` at one parameter, `A = 1 + theta K`.
#[derive(Debug, Clone)]
pub struct Responses {
    bases: [Approximation; 2],
    free: Approximation,
    /// `<1, A^{-1} 1>` and `<x, A^{-1} x>`.
    energies: [Enclosure; 2],
}

impl Responses {
    /// From the approximations for the right-hand sides `1`, `x` and `f`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] when the parameters or the degrees of the operators differ, or when the first two right-hand sides are not `1` and `x`.
    pub fn new(
        constant: Approximation,
        linear: Approximation,
        free: Approximation,
    ) -> Result<Self, Error> {
        for other in [&linear, &free] {
            if other.parameter != constant.parameter {
                return Err(Error::InvalidParameter {
                    name: "parameter of a response",
                    value: other.parameter,
                    requirement: "the same for all",
                });
            }
            if !other.matches(&constant) {
                return Err(Error::InvalidParameter {
                    name: "degree of the operator of a response",
                    value: other.tail.last() as f64,
                    requirement: "the same for all",
                });
            }
        }
        for (index, base) in [&constant, &linear].into_iter().enumerate() {
            let given = base.right_hand_side().coefficients();
            let wrong = (given.iter().chain(&[0.0; 2]).enumerate()).find(|&(m, &c)| {
                m < given.len().max(index + 1) && c != f64::from(u8::from(m == index))
            });
            if let Some((_, &value)) = wrong {
                return Err(Error::InvalidParameter {
                    name: "coefficient of a right-hand side",
                    value,
                    requirement: "that of 1 for the first and of x for the second response",
                });
            }
        }
        let energies = [constant.functional(&constant), linear.functional(&linear)];
        Ok(Self { bases: [constant, linear], free, energies })
    }

    /// The approximations of `A^{-1} 1` and `A^{-1} x`.
    #[must_use]
    pub fn bases(&self) -> &[Approximation; 2] {
        &self.bases
    }

    /// The approximation of `A^{-1} f`.
    #[must_use]
    pub fn free(&self) -> &Approximation {
        &self.free
    }

    /// `<1, A^{-1} 1>` and `<x, A^{-1} x>`; `<1, A^{-1} x> = 0` by symmetry.
    #[must_use]
    pub fn energies(&self) -> &[Enclosure; 2] {
        &self.energies
    }

    /// The solution `p = c_1 A^{-1} 1 + c_2 A^{-1} x - A^{-1} f` of which one of each pair is given, with the approximation `q` that has
    /// the coefficients the approximations by themselves give: it meets given projections.
    #[must_use]
    pub fn combine(&self, given: [Given; 2]) -> Combination<'_> {
        let projection = |index: usize, c: f64| {
            c * self.bases[index].moments()[index] - self.free.moments()[index]
        };
        let coefficient = |index: usize, projection: f64| {
            (projection + self.free.moments()[index]) / self.bases[index].moments()[index]
        };
        let proportion = |index: usize, factor: f64| {
            let denominator = 1.0 - factor * self.bases[index].moments()[index];
            -factor * self.free.moments()[index] / denominator
        };
        let first = match given[0] {
            Given::Coefficient(c) => c,
            Given::Proportion(factor) => proportion(0, factor),
            Given::Projection(value) => coefficient(0, value),
            Given::Quotient(_) => coefficient(0, 0.0),
        };
        let second = match given[1] {
            Given::Coefficient(c) => c,
            Given::Proportion(factor) => proportion(1, factor),
            Given::Projection(value) => coefficient(1, value),
            Given::Quotient(e) => coefficient(1, e * projection(0, first)),
        };
        self.combine_with(given, [first, second])
    }

    /// The same with other coefficients of `q`, for instance the enclosed ones of an earlier combination.
    #[must_use]
    pub fn combine_with(&self, given: [Given; 2], coefficients: [f64; 2]) -> Combination<'_> {
        Combination::new(self, given, coefficients)
    }
}

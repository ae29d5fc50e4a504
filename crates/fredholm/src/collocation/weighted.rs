//! The equation with a weight on the density, as Newton's method for a nonlinear equation meets it.

use std::borrow::Cow;
use std::f64::consts::FRAC_1_SQRT_2;

use super::assembly::Part;
use super::estimate::largest;
use super::{SincOperator, SincSolution};
use crate::Error;
use crate::linear::Factored;

/// `1 + lambda K w` for weights `w >= 0` at the nodes, factored.
///
/// With the scaled matrix `S` it is `1 + lambda sqrt(w) S sqrt(w)`: symmetric, and positive where the operator is. Weights that are even to the last bit keep the
/// parity of an even kernel, `N^3/12` multiplications; others take `N^3/3`.
#[derive(Debug, Clone)]
pub struct WeightedFactor<'o> {
    operator: &'o SincOperator,
    parameter: f64,
    factored: Parts,
}

/// The factored matrix, whole or by parity.
#[derive(Debug, Clone)]
enum Parts {
    Whole {
        /// Square roots of the weights.
        roots: Vec<f64>,
        /// Square roots of the masses of all nodes.
        masses: Vec<f64>,
        factored: Factored,
    },
    /// For each block the square roots of the weights at its nodes.
    Blocks(Vec<(Vec<f64>, Factored)>),
}

impl<'o> WeightedFactor<'o> {
    pub(super) fn new(
        operator: &'o SincOperator,
        parameter: f64,
        weights: &[f64],
    ) -> Result<Self, Error> {
        if let Some(&value) = weights.iter().find(|weight| weight.is_nan() || **weight < 0.0) {
            let requirement = "not negative";
            return Err(Error::InvalidParameter { name: "weight", value, requirement });
        }
        let roots: Vec<f64> = weights.iter().map(|weight| weight.sqrt()).collect();
        let is_even = roots.iter().zip(roots.iter().rev()).all(|(one, other)| one == other);
        let factored = if operator.blocks().len() > 1 && is_even {
            let factored = operator.blocks().iter().map(|block| {
                // Of an even function the part is its values, of which the odd block has none at the middle.
                let roots = roots[roots.len() - block.order()..].to_vec();
                let whole = || block.matrix.as_slice();
                let factored = Factored::weighted(
                    |j, column| block.column(j, column),
                    whole,
                    &roots,
                    parameter,
                )?;
                Ok((roots, factored))
            });
            Parts::Blocks(factored.collect::<Result<_, Error>>()?)
        } else {
            let columns = |j: usize, column: &mut [f64]| operator.column(j, column);
            let whole = || operator.whole_matrix();
            let factored = Factored::weighted(columns, whole, &roots, parameter)?;
            let masses = operator.node_masses().iter().map(|mass| mass.sqrt()).collect();
            Parts::Whole { roots, masses, factored }
        };
        Ok(Self { operator, parameter, factored })
    }

    /// Solves `phi + lambda K(w phi) = f` for a right-hand side given by its values at the nodes. The solution is `phi`; its integrals are those of the density
    /// `w phi`, and its potential is `K(w phi)`.
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless there is one value for each node, [`Error::NotFinite`] for NaN or an infinity.
    pub fn solve(&self, right_hand_side: &[f64]) -> Result<SincSolution, Error> {
        let scaled = self.scaled(right_hand_side)?;
        let steepest = match &self.factored {
            Parts::Whole { roots, .. } => largest(roots),
            Parts::Blocks(parts) => {
                parts.iter().fold(0.0, |most, (roots, _)| largest(roots).max(most))
            }
        };
        let like = (right_hand_side, self.parameter.abs() * steepest * steepest);
        Ok(self.operator.finish_like(like, self.parameter, right_hand_side, &scaled))
    }

    /// What the integrals of that add up, as [`SincSolution::node_masses`], without the potential, which takes as long as the solution.
    ///
    /// # Errors
    /// As [`WeightedFactor::solve`].
    pub fn node_masses(&self, right_hand_side: &[f64]) -> Result<Vec<f64>, Error> {
        Ok(self.operator.masses(&self.scaled(right_hand_side)?))
    }

    /// The densities of the blocks, scaled by the roots of the masses.
    fn scaled(&self, right_hand_side: &[f64]) -> Result<Vec<Vec<f64>>, Error> {
        self.operator.require_values(right_hand_side)?;
        let solved = |roots: &[f64], factored: &Factored, mut z: Vec<f64>| {
            z.iter_mut().zip(roots).for_each(|(z, root)| *z *= root);
            factored.solve(&mut z);
            // The density, scaled by the roots of the masses alone.
            z.iter_mut().zip(roots).for_each(|(z, root)| *z *= root);
            z
        };
        Ok(match &self.factored {
            Parts::Whole { roots, masses, factored } => {
                let z = right_hand_side.iter().zip(masses).map(|(f, mass)| mass * f).collect();
                self.operator.restricted(&solved(roots, factored, z))
            }
            Parts::Blocks(parts) => (self.operator.blocks().iter().zip(parts))
                .map(|(block, (roots, factored))| {
                    solved(roots, factored, block.scaled(right_hand_side))
                })
                .collect(),
        })
    }
}

impl SincOperator {
    /// The factored equation `phi + parameter K(w phi) = f` with the weights `w >= 0` at the nodes: a step of Newton's method for `phi + parameter K P(phi) = f`
    /// has `w = P'(phi)`.
    ///
    /// ```
    /// use fredholm::SincOperator;
    /// use fredholm::kernel::Logarithm;
    ///
    /// // Half the weight is half the parameter.
    /// let operator = SincOperator::new(&Logarithm::unit(), 30)?;
    /// let f = operator.sample(f64::exp)?;
    /// let one = operator.factor_weighted(3.0, &vec![0.5; operator.count()])?.solve(&f)?;
    /// let other = &operator.solve(1.5, &[f])?[0];
    /// assert!((one.evaluate(0.3, 0.3f64.exp()) - other.evaluate(0.3, 0.3f64.exp())).abs() < 1e-13);
    /// # Ok::<(), fredholm::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless there is one weight for each node, [`Error::NotFinite`] or [`Error::InvalidParameter`] for one that is not finite or
    /// negative; as [`SincOperator::factor`].
    pub fn factor_weighted(
        &self,
        parameter: f64,
        weights: &[f64],
    ) -> Result<WeightedFactor<'_>, Error> {
        super::operator::require_finite_parameter(parameter)?;
        self.require_values(weights)?;
        WeightedFactor::new(self, parameter, weights)
    }

    /// `f - parameter K p` for a density `p` and a function `f` given at the nodes, to be evaluated anywhere; its integrals are those of `p`.
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless there is one value for each node, [`Error::NotFinite`] for NaN or an infinity.
    pub fn response(
        &self,
        parameter: f64,
        right_hand_side: &[f64],
        density: &[f64],
    ) -> Result<SincSolution, Error> {
        self.require_values(right_hand_side)?;
        self.require_values(density)?;
        let scaled = density.iter().zip(self.node_masses()).map(|(p, mass)| p * mass.sqrt());
        let restricted = self.restricted(&scaled.collect::<Vec<_>>());
        Ok(self.finish_like((density, 1.0), parameter, right_hand_side, &restricted))
    }

    /// What a density scaled by the roots of the masses is to the blocks.
    fn restricted(&self, scaled: &[f64]) -> Vec<Vec<f64>> {
        (self.blocks().iter())
            .map(|block| {
                let mut part = block.restrict(scaled);
                if block.part == Part::Even && scaled.len() % 2 == 1 {
                    part[0] *= FRAC_1_SQRT_2;
                }
                part
            })
            .collect()
    }

    /// The column of a node of `S` for all nodes from the diagonal on, from its parts.
    fn column(&self, j: usize, column: &mut [f64]) {
        let [even, odd] = match self.blocks() {
            [even, odd] => [even, odd],
            blocks => return blocks.iter().for_each(|whole| whole.column(j, column)),
        };
        let (middle, skipped) = (self.count() / 2, even.order() - odd.order());
        // Nodes left of the middle are images of those on the right.
        let at = if j < middle { self.count() - 1 - j - middle } else { j - middle };
        let sums = even.row(at);
        let (left, right) = column.split_at_mut(middle.saturating_sub(j));
        let first = at * usize::from(j >= middle);
        // The middle node is its own image, and has no part that is odd.
        let Some(at) = at.checked_sub(skipped) else {
            right.iter_mut().zip(sums).for_each(|(value, sum)| *value = FRAC_1_SQRT_2 * sum);
            right[0] = sums[0];
            return;
        };
        let differences = odd.row(at);
        let on_left = sums[skipped..].iter().zip(differences).take(left.len());
        for (value, (sum, difference)) in left.iter_mut().rev().zip(on_left) {
            *value = 0.5 * (sum + difference);
        }
        let (own, right) = right.split_at_mut(skipped.saturating_sub(first));
        own.iter_mut().for_each(|value| *value = FRAC_1_SQRT_2 * sums[0]);
        let first = first.max(skipped);
        let sign = if j < middle { -1.0 } else { 1.0 };
        let on_right = sums[first..].iter().zip(&differences[first - skipped..]);
        for (value, (sum, difference)) in right.iter_mut().zip(on_right) {
            *value = 0.5 * (sum + sign * difference);
        }
    }

    /// `S` for all nodes.
    fn whole_matrix(&self) -> Cow<'_, [f64]> {
        if let [whole] = self.blocks() {
            return Cow::Borrowed(&whole.matrix);
        }
        let count = self.count();
        let mut matrix = vec![0.0; count * count];
        for j in 0..count {
            self.column(j, &mut matrix[j * count + j..(j + 1) * count]);
            for i in j..count {
                matrix[i * count + j] = matrix[j * count + i];
            }
        }
        Cow::Owned(matrix)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::Interval;
    use crate::collocation::SincGrid;
    use crate::kernel::{Kernel, Logarithm, Singularity, Split, WeberSonine};

    /// The logarithm without its parity.
    struct Plain(Logarithm);

    impl Kernel for Plain {
        fn interval(&self) -> Interval {
            self.0.interval()
        }
        fn singularity(&self) -> Singularity {
            self.0.singularity()
        }
        fn split(&self, x: f64, s: f64, distance: f64) -> Split {
            self.0.split(x, s, distance)
        }
    }

    #[test]
    fn the_matrix_is_put_together_from_its_parts() {
        let kernel = Logarithm::unit();
        let grid = Arc::new(SincGrid::new(&kernel, 20).unwrap());
        for panels in [&[(-1.0, 1.0)][..], &[(-1.0, 0.0), (0.0, 1.0)], &[(-1.0, -0.2), (0.2, 1.0)]]
        {
            let by_parity = SincOperator::on_panels(&kernel, Arc::clone(&grid), panels).unwrap();
            let whole = SincOperator::on_panels(&Plain(kernel), Arc::clone(&grid), panels).unwrap();
            assert!(by_parity.blocks().len() == 2 && whole.blocks().len() == 1);
            for (one, two) in by_parity.whole_matrix().iter().zip(whole.whole_matrix().iter()) {
                assert!((one - two).abs() < 1e-14, "{one} {two}");
            }
        }
    }

    #[test]
    fn solutions_satisfy_their_equation() {
        let disk = WeberSonine::new(1.0, 0.0, 0.0).unwrap();
        let operators = [
            SincOperator::new(&Logarithm::unit(), 40).unwrap(),
            SincOperator::new(&disk, 40).unwrap(),
        ];
        for operator in operators {
            let f = operator.sample(|x| 1.0 + x).unwrap();
            let weights = operator.sample(|x| 0.2 + (x - 0.3).powi(2)).unwrap();
            let solution = operator.factor_weighted(20.0, &weights).unwrap().solve(&f).unwrap();
            let density: Vec<f64> =
                solution.values().iter().zip(&weights).map(|(phi, w)| w * phi).collect();
            let again = operator.response(20.0, &f, &density).unwrap();
            for (one, two) in solution.values().iter().zip(again.values()) {
                assert!((one - two).abs() < 1e-13, "{one} {two}");
            }
            assert!((solution.integral(|_| 1.0) - again.integral(|_| 1.0)).abs() < 1e-14);
        }
    }

    #[test]
    fn even_weights_keep_the_parity() {
        let kernel = Logarithm::unit();
        let grid = Arc::new(SincGrid::new(&kernel, 30).unwrap());
        for panels in [&[(-1.0, 1.0)][..], &[(-1.0, 0.0), (0.0, 1.0)]] {
            let by_parity = SincOperator::on_panels(&kernel, Arc::clone(&grid), panels).unwrap();
            let whole = SincOperator::on_panels(&Plain(kernel), Arc::clone(&grid), panels).unwrap();
            let f = by_parity.sample(|x| (1.0 + 0.3 * x).exp()).unwrap();
            let weights = by_parity.sample(|x| 0.1 + x * x).unwrap();
            let mirrored = weights.iter().zip(weights.iter().rev());
            let weights: Vec<f64> = mirrored.map(|(one, other)| 0.5 * (one + other)).collect();
            let one = by_parity.factor_weighted(20.0, &weights).unwrap();
            assert!(matches!(one.factored, Parts::Blocks(_)));
            let one = one.solve(&f).unwrap();
            let two = whole.factor_weighted(20.0, &weights).unwrap().solve(&f).unwrap();
            for (one, two) in one.values().iter().zip(two.values()) {
                assert!((one - two).abs() < 1e-13, "{one} {two}");
            }
            assert!((one.integral(|x| x) - two.integral(|x| x)).abs() < 1e-14);
        }
    }

    #[test]
    fn refuses_weights_below_zero() {
        let operator = SincOperator::new(&Logarithm::unit(), 8).unwrap();
        assert!(operator.factor_weighted(1.0, &[-1.0; 17]).is_err());
        assert!(operator.factor_weighted(1.0, &[f64::NAN; 17]).is_err());
        assert!(operator.factor_weighted(1.0, &[1.0; 16]).is_err());
        assert!(operator.response(1.0, &[1.0; 17], &[1.0; 16]).is_err());
    }
}

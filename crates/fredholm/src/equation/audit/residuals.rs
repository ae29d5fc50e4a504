//! The residual of a solution, looked at until polynomials resolve it.

use super::leaf::legendre;
use super::tree::{Leaf, Tree};
use crate::Error;
use crate::equation::Solution;
use crate::quadrature::gauss_legendre;

/// Nodes of a part of a panel.
const NODES: usize = 6;
/// A part is halved where the last two Legendre coefficients are above this share of what they are part of: the mean square is then known to the square of that.
const RESOLVED: f64 = 0.05;
/// Most halvings of a panel: 48 places resolve what 20 nodes of the solution can do.
const HALVINGS: usize = 3;
/// A residual below this many units of its parts is rounding, which no polynomial resolves.
const NOISE: f64 = 32.0 * f64::EPSILON;
/// Places, of half a part, at which the polynomial through its nodes is evaluated for the largest value.
const BETWEEN: [f64; 9] = [-1.0, -0.96, -0.8, -0.45, 0.0, 0.45, 0.8, 0.96, 1.0];

/// Norms of residuals.
pub(super) struct Residuals {
    /// `int r^2 dm` for the resampled solution.
    pub(super) square: f64,
    /// The largest `|f - phi - parameter K q|` for the solution itself.
    pub(super) largest: f64,
    /// The largest difference of the solution and its resampling.
    pub(super) misfit: f64,
}

/// What is looked at.
struct Look<'l, 's> {
    tree: &'l Tree<'l>,
    parameter: f64,
    f: &'l dyn Fn(f64) -> f64,
    solution: &'l Solution<'s>,
    rule: [(f64, f64); NODES],
    found: Residuals,
}

/// The residual at a place: of the resampled solution, of the solution itself, and what would be rounding.
struct At {
    resampled: f64,
    own: f64,
    noise: f64,
}

impl Residuals {
    pub(super) fn new(
        tree: &Tree<'_>,
        parameter: f64,
        f: &dyn Fn(f64) -> f64,
        solution: &Solution<'_>,
    ) -> Result<Self, Error> {
        let gauss = gauss_legendre(NODES)?;
        let rule = std::array::from_fn(|j| (gauss.nodes[j], gauss.weights[j]));
        let found = Self { square: 0.0, largest: 0.0, misfit: 0.0 };
        let mut look = Look { tree, parameter, f, solution, rule, found };
        for leaf in tree.panels() {
            look.part(leaf, (-1.0, 1.0), 0)?;
        }
        // The axis of a disk has no measure.
        let (left, right) = (tree.interval().left(), tree.interval().right());
        for (leaf, x) in [(tree.panels().next(), left), (tree.panels().last(), right)] {
            if let (Some(leaf), true) = (leaf, tree.measure(x) > 0.0) {
                look.at(leaf, x)?;
            }
        }
        Ok(look.found)
    }
}

impl Look<'_, '_> {
    fn at(&mut self, leaf: &Leaf, x: f64) -> Result<At, Error> {
        let (value, own) = ((self.f)(x), self.solution.evaluate(x));
        let resampled = self.tree.evaluate(leaf, x);
        let potential = self.parameter * self.tree.potential(x);
        let at = At {
            resampled: value - potential - resampled,
            own: value - potential - own,
            noise: NOISE * (value.abs() + potential.abs() + own.abs()),
        };
        if !at.resampled.is_finite() {
            return Err(Error::NotFinite { what: "residual", at: x, value: at.resampled });
        }
        self.found.largest = self.found.largest.max(at.own.abs());
        self.found.misfit = self.found.misfit.max((own - resampled).abs());
        Ok(at)
    }

    /// Adds a part of a panel, given by shares of its half.
    fn part(&mut self, leaf: &Leaf, (from, to): (f64, f64), depth: usize) -> Result<(), Error> {
        let (middle, half) = (from.midpoint(to), 0.5 * (to - from));
        let mut values = [[0.0; NODES]; 2];
        let (mut square, mut noise) = (0.0, 0.0f64);
        for (j, (t, weight)) in self.rule.into_iter().enumerate() {
            let x = leaf.at(middle + half * t);
            let at = self.at(leaf, x)?;
            (values[0][j], values[1][j]) = (at.resampled, at.own);
            noise = noise.max(at.noise);
            let length = 0.5 * leaf.length() * half * weight;
            square += length * self.tree.measure(x) * at.resampled * at.resampled;
        }
        let series = values.map(|values| self.series(&values));
        let is_done = depth == HALVINGS || series.iter().all(|series| is_resolved(series, noise));
        if !is_done {
            self.part(leaf, (from, middle), depth + 1)?;
            return self.part(leaf, (middle, to), depth + 1);
        }
        self.found.square += square;
        let [_, own] = series;
        for t in BETWEEN {
            let value: f64 = legendre(t).iter().zip(own).map(|(p, c)| p * c).sum();
            self.found.largest = self.found.largest.max(value.abs());
        }
        Ok(())
    }

    /// The coefficients of the polynomial through values at the nodes.
    fn series(&self, values: &[f64; NODES]) -> [f64; NODES] {
        let mut series = [0.0; NODES];
        for ((t, weight), value) in self.rule.iter().zip(values) {
            for (k, (c, p)) in series.iter_mut().zip(legendre(*t)).enumerate() {
                *c += (k as f64 + 0.5) * weight * p * value;
            }
        }
        series
    }
}

fn is_resolved(series: &[f64; NODES], noise: f64) -> bool {
    let size = series.iter().fold(0.0f64, |most, c| most.max(c.abs()));
    let last = series[NODES - 1].abs().max(series[NODES - 2].abs());
    size <= noise || last <= RESOLVED * size
}

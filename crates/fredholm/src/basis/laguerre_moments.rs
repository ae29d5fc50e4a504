//! Integrals of a function with Laguerre functions.

use super::laguerre::Functions;
use crate::Error;
use crate::kernel::{Expansion, Moments};
use crate::quadrature::gauss_jacobi;

/// Nodes of the Gauss rule on a panel.
const NODES: usize = 24;
/// Phase of the fastest function over half a panel: its Legendre coefficients are rounding from degree 30 on.
const HALF_PHASE: f64 = 8.0;
/// The Legendre coefficients of `f` on a panel are small from here on if the rule, exact to degree 47, resolves the product.
const RESOLVED_FROM: usize = 17;
/// Coefficients below this, relative to the largest value, count as rounding.
const ROUNDING: f64 = 2e-15;
/// Coefficients below this that do not fall as a panel is halved are rounding of `f` itself.
const PLATEAU: f64 = 1e-9;
/// How often a panel is halved.
const DEPTH: u32 = 40;
/// Most panels.
const MOST_PANELS: usize = 20_000;
/// Beyond the turning point `u = 2 sqrt(k + 1)` the functions die out within this distance.
const MARGIN: f64 = 9.0;
/// Widest panel.
const WIDEST: f64 = 1.0;
/// Fewest and most coefficients tried.
const COUNTS: [usize; 2] = [32, 1024];
/// An expansion that is this close between the nodes, relative to the largest value, resolves the function.
const EXPANDED: f64 = 1e-12;

/// Quadrature for the functions `e^{-y/2} L_k^{(alpha)}(y)`, `y = scale x`.
///
/// In `u = sqrt(y)` they oscillate evenly, as `cos(2 sqrt(k) u)`, up to the turning point `u = 2 sqrt(k)`: a composite Gauss rule in `u` whose panels suit the
/// highest index, and are halved where `f` asks for it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Panels {
    pub(crate) alpha: f64,
    pub(crate) scale: f64,
}

/// A panel with the values of `f` at its nodes.
struct Panel {
    left: f64,
    width: f64,
    values: Vec<f64>,
}

/// `f` on all panels.
struct Sampled {
    panels: Vec<Panel>,
    largest: f64,
    /// The largest coefficient that was not resolved, relative to the largest value.
    unresolved: f64,
}

/// Gauss's rule of Legendre with the polynomials at its nodes.
struct Legendre {
    nodes: Vec<f64>,
    weights: Vec<f64>,
    /// `(l + 1/2) w_j P_l(t_j)`, a row for each `l` from [`RESOLVED_FROM`] on.
    rows: Vec<Vec<f64>>,
}

impl Panels {
    /// `int_0^inf f phi_k dx`, `k < count`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] when `f` is not finite where the functions are not yet small.
    pub(crate) fn moments(self, f: &dyn Fn(f64) -> f64, count: usize) -> Result<Moments, Error> {
        let rule = Legendre::new()?;
        let sampled = self.sample(f, count, &rule)?;
        let mut values = vec![0.0; count];
        for panel in &sampled.panels {
            for (j, value) in panel.values.iter().enumerate() {
                let u = panel.at(rule.nodes[j]);
                // dx = 2 u du/scale
                let factor = value * rule.weights[j] * panel.width * u / self.scale;
                for (moment, phi) in values.iter_mut().zip(Functions::at(self.alpha, u * u)) {
                    *moment += factor * phi;
                }
            }
        }
        Ok(Moments { values, error: sampled.unresolved, resolved: sampled.unresolved <= EXPANDED })
    }

    /// The coefficients of `f = sum c_n phi_n` with the norms `h_n`, as many as resolve it.
    ///
    /// # Errors
    /// As [`moments`](Self::moments).
    pub(crate) fn expand(
        self,
        f: &dyn Fn(f64) -> f64,
        norm: &dyn Fn(usize) -> f64,
    ) -> Result<Expansion, Error> {
        let rule = Legendre::new()?;
        let mut count = COUNTS[0];
        loop {
            let sampled = self.sample(f, count, &rule)?;
            let mut coefficients = self.weighted(f, count, &rule, &sampled)?;
            coefficients.iter_mut().enumerate().for_each(|(n, c)| *c /= norm(n));
            let error = self.error(f, &coefficients, &sampled)?;
            let resolved = error <= EXPANDED;
            if resolved || count >= COUNTS[1] {
                trim(&mut coefficients, sampled.largest);
                return Ok(Expansion { coefficients, error, resolved });
            }
            count *= 2;
        }
    }

    /// `int f phi_n x^alpha dx`.
    fn weighted(
        self,
        f: &dyn Fn(f64) -> f64,
        count: usize,
        rule: &Legendre,
        sampled: &Sampled,
    ) -> Result<Vec<f64>, Error> {
        let power = 2.0 * self.alpha + 1.0;
        let jacobi = gauss_jacobi(NODES, 0.0, power)?;
        let scale = 2.0 * self.scale.powf(-self.alpha - 1.0);
        let mut sums = vec![0.0; count];
        let mut add = |u: f64, factor: f64| {
            for (sum, phi) in sums.iter_mut().zip(Functions::at(self.alpha, u * u)) {
                *sum += factor * phi;
            }
        };
        for panel in &sampled.panels {
            let half = 0.5 * panel.width;
            if panel.left == 0.0 {
                // u^power is the weight of the rule, (1 + t)^power half^power.
                for (t, weight) in jacobi.nodes.iter().zip(&jacobi.weights) {
                    let u = panel.at(*t);
                    add(u, scale * weight * half.powf(power + 1.0) * self.value(f, u)?);
                }
            } else {
                for (j, value) in panel.values.iter().enumerate() {
                    let u = panel.at(rule.nodes[j]);
                    add(u, scale * rule.weights[j] * half * u.powf(power) * value);
                }
            }
        }
        Ok(sums)
    }

    /// Largest error of an expansion midway between nodes, relative to the largest value.
    fn error(
        self,
        f: &dyn Fn(f64) -> f64,
        coefficients: &[f64],
        sampled: &Sampled,
    ) -> Result<f64, Error> {
        let mut worst = 0.0f64;
        for panel in &sampled.panels {
            for t in [-0.7, -0.1, 0.5, 0.99] {
                let u = panel.at(t);
                let sum = super::laguerre::sum(self.alpha, coefficients, u * u);
                worst = worst.max((sum - self.value(f, u)?).abs());
            }
        }
        Ok(if sampled.largest > 0.0 { worst / sampled.largest } else { 0.0 })
    }

    fn value(self, f: &dyn Fn(f64) -> f64, u: f64) -> Result<f64, Error> {
        let at = u * u / self.scale;
        let value = f(at);
        if value.is_finite() {
            Ok(value)
        } else {
            Err(Error::NotFinite { what: "function", at, value })
        }
    }

    /// Panels for the functions below `count`, halved until they resolve `f`.
    fn sample(
        self,
        f: &dyn Fn(f64) -> f64,
        count: usize,
        rule: &Legendre,
    ) -> Result<Sampled, Error> {
        let frequency = 2.0 * (count as f64 + 1.0).sqrt();
        let end = frequency + MARGIN;
        let pieces = (end / (2.0 * HALF_PHASE / frequency).min(WIDEST)).ceil();
        let width = end / pieces;
        let mut sampled = Sampled { panels: Vec::new(), largest: 0.0, unresolved: 0.0 };
        // From right to left, so that the stack gives them from left to right.
        let first = |k| (k as f64 * width, width, 0, f64::INFINITY);
        let mut waiting: Vec<(f64, f64, u32, f64)> =
            (0..pieces as usize).rev().map(first).collect();
        while let Some((left, width, depth, before)) = waiting.pop() {
            let mut panel = Panel { left, width, values: Vec::with_capacity(NODES) };
            for t in &rule.nodes {
                let value = self.value(f, panel.at(*t))?;
                sampled.largest = sampled.largest.max(value.abs());
                panel.values.push(value);
            }
            let tail = rule.tail(&panel.values);
            let plateau = tail > 0.25 * before && tail <= PLATEAU * sampled.largest;
            if tail <= ROUNDING * sampled.largest {
                sampled.panels.push(panel);
            } else if !plateau
                && depth < DEPTH
                && sampled.panels.len() + waiting.len() < MOST_PANELS
            {
                waiting.push((left + 0.5 * width, 0.5 * width, depth + 1, tail));
                waiting.push((left, 0.5 * width, depth + 1, tail));
            } else {
                // What a panel adds to an integral goes with its width.
                sampled.unresolved = sampled.unresolved.max(tail * width / sampled.largest);
                sampled.panels.push(panel);
            }
        }
        Ok(sampled)
    }
}

impl Panel {
    /// `u` of a point of `[-1, 1]`.
    fn at(&self, t: f64) -> f64 {
        self.left + 0.5 * self.width * (1.0 + t)
    }
}

impl Legendre {
    fn new() -> Result<Self, Error> {
        let rule = gauss_jacobi(NODES, 0.0, 0.0)?;
        let rows = (RESOLVED_FROM..NODES - 1)
            .map(|l| {
                (rule.nodes.iter().zip(&rule.weights))
                    .map(|(t, weight)| (l as f64 + 0.5) * weight * legendre(l, *t))
                    .collect()
            })
            .collect();
        Ok(Self { nodes: rule.nodes, weights: rule.weights, rows })
    }

    /// The largest of the high coefficients of a function.
    fn tail(&self, values: &[f64]) -> f64 {
        let coefficient = |row: &Vec<f64>| crate::linear::dot(row, values).abs();
        self.rows.iter().map(coefficient).fold(0.0, f64::max)
    }
}

fn legendre(degree: usize, t: f64) -> f64 {
    let (mut previous, mut current) = (0.0, 1.0);
    for l in 0..degree {
        let l = l as f64;
        (previous, current) = (current, ((2.0 * l + 1.0) * t * current - l * previous) / (l + 1.0));
    }
    current
}

/// Drops the trailing coefficients that are rounding: the functions do not exceed 1.
fn trim(coefficients: &mut Vec<f64>, largest: f64) {
    let matters = |c: &f64| c.abs() > 0.2 * ROUNDING * largest;
    let kept = coefficients.iter().rposition(matters).map_or(1, |last| last + 1);
    coefficients.truncate(kept);
}

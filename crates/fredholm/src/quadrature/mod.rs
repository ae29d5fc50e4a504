//! Quadrature that does not mind what happens at the ends.

pub(crate) mod jacobi;
pub(crate) mod map;
pub(crate) mod panels;
pub(crate) mod partition;
pub(crate) mod places;

use jacobi::{Argument, GaussNode, Jacobi};
use map::{Node as Image, RANGE};

use crate::{Error, Interval};

/// A quadrature rule `int_L g w dm = sum_j weights[j] g(nodes[j])`; its nodes are places, or know more than their place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Rule<Node = f64> {
    pub(crate) nodes: Vec<Node>,
    pub(crate) weights: Vec<f64>,
}

/// A node of a rule on an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// `x`.
    pub position: f64,
    /// `x - left`, to full relative precision.
    pub from_left: f64,
    /// `right - x`, to full relative precision.
    pub from_right: f64,
    /// Weight.
    pub weight: f64,
}

/// The double-exponential rule on `(-1, 1)` with `2 half_count + 1` nodes from left to right: the trapezoidal rule after
/// `x = tanh(pi/2 sinh t)`, `|t| <= 3.2` (H. Takahasi and M. Mori, Publ. RIMS 9 (1974) 721). Logarithms and roots at the ends cost nothing;
/// integrands must be analytic inside.
///
/// ```
/// let integral: f64 = fredholm::quadrature::double_exponential(40).map(|n| n.weight * n.from_right.ln()).sum();
/// assert!((integral - (2.0 * 2f64.ln() - 2.0)).abs() < 1e-14);
/// ```
pub fn double_exponential(half_count: usize) -> impl Iterator<Item = Node> {
    let step = RANGE / half_count.max(1) as f64;
    let interval = Interval::unit();
    (0..=2 * half_count).map(move |j| {
        let image = Image::at(interval, (j as f64 - half_count as f64) * step);
        let Image { position, from_left, from_right, derivative } = image;
        Node { position, from_left, from_right, weight: step * derivative }
    })
}

/// A rule for `int_0^1 g(d) dd` of functions that are powers of the distance `d` from the left end, or several of them that change over at distances of any order: that of Gauss with `count` nodes after
/// `d = u^8`. Of `(d + c)^-q`, `0 <= q <= 1/2`, 12 to 24 nodes leave less than `count^-4` (measured, for `c` from 0 to `1e-3`).
///
/// # Errors
/// [`Error::InvalidParameter`] for no nodes.
///
/// ```
/// let rule = fredholm::quadrature::gauss_graded(20)?;
/// let sum: f64 = rule.iter().map(|node| node.weight / (1e-9 + node.from_left).sqrt()).sum();
/// assert!((sum - 2.0 * ((1.0f64 + 1e-9).sqrt() - 1e-9f64.sqrt())).abs() < 2e-6);
/// # Ok::<(), fredholm::Error>(())
/// ```
pub fn gauss_graded(count: usize) -> Result<Vec<Node>, Error> {
    let graded = |node: Node| {
        let u = node.from_left;
        let (from_left, from_right) =
            (u.powi(8), node.from_right * (1.0 + u) * (1.0 + u * u) * (1.0 + u.powi(4)));
        Node { position: from_left, from_left, from_right, weight: 8.0 * node.weight }
    };
    Ok(gauss_power(count, 7.0)?.into_iter().map(graded).collect())
}

/// The Gauss rule of `count` nodes for `int_0^1 g(u) u^exponent du`, exact for polynomials `g` up to the degree `2 count - 1`, with nodes and weights accurate relative to
/// themselves.
///
/// # Errors
/// [`Error::InvalidParameter`] unless the exponent is above -1, and for no nodes.
///
/// ```
/// let rule = fredholm::quadrature::gauss_power(8, -0.7)?;
/// let sum: f64 = rule.iter().map(|node| node.weight * node.from_left.powi(3)).sum();
/// assert!((sum * 3.3 - 1.0).abs() < 1e-14);
/// # Ok::<(), fredholm::Error>(())
/// ```
pub fn gauss_power(count: usize, exponent: f64) -> Result<Vec<Node>, Error> {
    let nodes = Jacobi::new(exponent, 0.0).gauss(count)?;
    let node = |node: &GaussNode| {
        let Argument { from_one, from_minus_one } = node.argument;
        let weight = node.weight;
        Node { position: from_one, from_left: from_one, from_right: from_minus_one, weight }
    };
    Ok(nodes.iter().rev().map(node).collect())
}

/// The Gauss rule of `count` nodes for `int_{-1}^{1} g(t) (1 - t)^right (1 + t)^left dt`, both exponents above -1: nodes ascending, absolute error
/// of the weights about `1e-15 count` of their sum.
///
/// # Errors
/// [`Error::InvalidParameter`] for exponents out of range or no nodes.
pub(crate) fn gauss_jacobi(count: usize, right: f64, left: f64) -> Result<Rule, Error> {
    let rule = bilby::GaussJacobi::new(count, right, left).map_err(|_| {
        let exponent = if right > -1.0 { left } else { right };
        Error::InvalidParameter {
            name: "exponent of the weight",
            value: exponent,
            requirement: "greater than -1, for a rule with at least one node",
        }
    })?;
    Ok(Rule { nodes: rule.nodes().to_vec(), weights: rule.weights().to_vec() })
}

/// The Gauss rule of `count` nodes for `int_{-1}^{1} g(t) dt`, nodes ascending, in time proportional to `count` (I. Bogaert, SIAM J. Sci. Comput. 36 (2014) A1008).
///
/// # Errors
/// [`Error::InvalidParameter`] for no nodes.
pub(crate) fn gauss_legendre(count: usize) -> Result<Rule, Error> {
    let rule = bilby::GaussLegendre::new(count).map_err(|_| Error::InvalidParameter {
        name: "number of nodes",
        value: count as f64,
        requirement: "at least 1",
    })?;
    Ok(Rule { nodes: rule.nodes().to_vec(), weights: rule.weights().to_vec() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_of_jacobi_integrates_powers() {
        for (right, left) in [(-0.5, -0.5), (0.3, -0.99), (-0.8, 0.0), (0.0, 5.0)] {
            let rule = gauss_jacobi(24, right, left).unwrap();
            for power in 0..47 {
                let found: f64 = (rule.nodes.iter().zip(&rule.weights))
                    .map(|(t, w)| w * (0.5 + 0.5 * t).powi(power))
                    .sum();
                // 2^(right+left+1) B(right+1, left+power+1)
                let p = f64::from(power);
                let exact = ((right + left + 1.0) * std::f64::consts::LN_2
                    + libm::lgamma(right + 1.0)
                    + libm::lgamma(left + p + 1.0)
                    - libm::lgamma(right + left + p + 2.0))
                .exp();
                let total: f64 = rule.weights.iter().sum();
                assert!(
                    (found - exact).abs() < 1e-13 * total,
                    "{right} {left} {power}: {found} {exact}"
                );
            }
        }
        assert!(gauss_jacobi(0, 0.0, 0.0).is_err());
        assert!(gauss_jacobi(3, 0.0, -1.0).is_err());
    }

    #[test]
    fn powers_that_change_over_leave_as_little_as_is_said() {
        for count in [12, 16, 20, 24] {
            let rule = gauss_graded(count).unwrap();
            for q in [0.0f64, 0.05, 0.25, 0.4, 0.5] {
                for c in [0.0f64, 1e-12, 3e-9, 1e-7, 1e-5, 1e-3] {
                    let exact = ((1.0 + c).powf(1.0 - q) - c.powf(1.0 - q)) / (1.0 - q);
                    let term = |node: &Node| node.weight * (node.from_left + c).powf(-q);
                    let sum: f64 = rule.iter().map(term).sum();
                    let allowed = (count as f64).powi(-4);
                    assert!((sum / exact - 1.0).abs() < allowed, "{count} {q} {c}: {sum} {exact}");
                }
            }
        }
    }
}

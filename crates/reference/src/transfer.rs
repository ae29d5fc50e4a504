//! Kernels of plane ground that a transfer function describes.

use crate::rule::Rule;

/// Nodes of a panel of `u` and of `t`.
const NODES: usize = 24;
/// `exp(-u)` is rounding beyond this `u`.
const LAST: f64 = 42.0;
/// Panels of `u` are so long at most, turn by so many radians at most, and halve so many times towards 0, where stiff ground on soft ground changes its transfer function.
const LONGEST: f64 = 0.5;
const TURN: f64 = 6.0;
const HALVINGS: usize = 20;

/// `m ln(1/d) + int_0^inf ((M(u) - m)/u) cos(u d/h) du` for a transfer function `M` that is `m` at 0 and tends to 1 as `exp(-u)` does or faster.
///
/// With `int_0^inf ((1 - exp(-u))/u) cos(ut) du = ln(1 + 1/t^2)/2` it is `m ln(1/d) + (1-m) ln(1 + (h/d)^2)/2 + R(d/h)`, where `R(t)`, the integral over `(M - 1 + (1-m) exp(-u))/u`, has no
/// singularity nearer than `t = i`: it is interpolated on panels of `t` that double.
pub struct Transferred {
    length: f64,
    far_share: f64,
    rule: Rule,
    /// Ends of a panel of `t` and the values of `R` at its nodes.
    panels: Vec<([f64; 2], Vec<f64>)>,
}

impl Transferred {
    /// The kernel for distances up to `farthest`, with `h`, `m` and `M`.
    #[must_use]
    pub fn new(length: f64, far_share: f64, transfer: &dyn Fn(f64) -> f64, farthest: f64) -> Self {
        let rule = Rule::new(NODES);
        let g = |u: f64| (transfer(u) - 1.0 + (1.0 - far_share) * (-u).exp()) / u;
        let far = farthest / length;
        let mut panels = Vec::new();
        let (mut left, mut right) = (0.0, far.min(1.0));
        while left < far {
            let spectrum = spectrum(&rule, &g, right);
            let values = rule.nodes.iter().map(|node| {
                let t = 0.5 * ((left + right) + (right - left) * node);
                spectrum.iter().rev().map(|[u, weight]| weight * (u * t).cos()).sum()
            });
            panels.push(([left, right], values.collect()));
            (left, right) = (right, (2.0 * right).min(far));
        }
        Self { length, far_share, rule, panels }
    }

    /// The value at the distance `d`.
    #[must_use]
    pub fn value(&self, distance: f64) -> f64 {
        let t = distance / self.length;
        // ln(1 + 1/t^2)/2 without an overflow where t is small
        let near = if t < 1.0 { 0.5 * (t * t).ln_1p() - t.ln() } else { 0.5 * t.powi(-2).ln_1p() };
        (1.0 - self.far_share) * near - self.far_share * distance.ln() + self.smooth(t)
    }

    /// `R(t)`.
    fn smooth(&self, t: f64) -> f64 {
        let index = self.panels.partition_point(|([_, right], _)| *right < t);
        let Some(([left, right], values)) = self.panels.get(index).or(self.panels.last()) else {
            return 0.0;
        };
        self.rule.interpolate(values, ((t - left) - (right - t)) / (right - left))
    }
}

/// Nodes `u` with the weights of the quadrature times `g`, for cosines up to `t`.
fn spectrum(rule: &Rule, g: &dyn Fn(f64) -> f64, t: f64) -> Vec<[f64; 2]> {
    let first = LONGEST * 0.5f64.powi(HALVINGS as i32);
    let (mut found, mut left) = (Vec::new(), 0.0);
    while left < LAST {
        let length = if left == 0.0 { first } else { left.min(LONGEST).min(TURN / t) };
        let nodes = rule.nodes.iter().zip(&rule.weights);
        found.extend(nodes.map(|(node, weight)| {
            let u = left + 0.5 * length * (1.0 + node);
            [u, 0.5 * length * weight * g(u)]
        }));
        left += length;
    }
    found
}

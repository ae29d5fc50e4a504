//! Quadrature with powers at the ends of its panels, which knows nothing of any spectral relation.

use crate::kernel::{EndExponents, SpectralRelation};
use crate::quadrature::double_exponential;

/// Below this distance a kernel is taken from the split of its diagonal.
const CLOSE: f64 = 1e-200;

/// A node of a panel `(start, start + length)`, or the mirror image, with a power at its start.
pub(super) struct Node {
    /// `x`.
    pub(super) position: f64,
    /// Distance to the start.
    pub(super) distance: f64,
    /// The distance to the power `1 + beta` of the start, which does not underflow.
    pub(super) raised: f64,
    /// Weight, that of the power `distance^beta` included.
    pub(super) weight: f64,
}

/// The rule for `int |x - start|^beta g(x) dx` from `start` to `end`: with `u = (distance/length)^(1+beta)` nothing of the power remains, however near `beta` is to -1.
pub(super) fn panel(
    start: f64,
    end: f64,
    beta: f64,
    half_count: usize,
) -> impl Iterator<Item = Node> {
    let length = (end - start).abs();
    let power = 1.0 + beta;
    let total = length.powf(power) / power;
    double_exponential(half_count).map(move |node| {
        // u from its own distance to 0 or to 1, whichever is smaller.
        let (u, rest) = (0.5 * node.from_left, 0.5 * node.from_right);
        let logarithm = if u < 0.5 { u.ln() } else { (-rest).ln_1p() };
        let to_end = -length * (logarithm / power).exp_m1();
        let distance = length * (logarithm / power).exp();
        let position = if distance <= to_end {
            start + (end - start).signum() * distance
        } else {
            end - (end - start).signum() * to_end
        };
        Node {
            position,
            distance,
            raised: length.powf(power) * u,
            weight: 0.5 * node.weight * total,
        }
    })
}

/// The panels that make `int_L g w dm`, `w` without its smooth part: from both ends to the middle, or from the left end outwards on a half-line.
pub(super) fn weighted(relation: &dyn SpectralRelation, half_count: usize) -> Vec<(f64, f64)> {
    let interval = relation.interval();
    let EndExponents { left, right } = relation.weight_exponents();
    let extent = relation.extent();
    let middle = extent.centre();
    let near = panel(interval.left(), middle, left, half_count).map(|node| {
        let other = end_power(interval.right(), node.position, right);
        (node.position, node.weight * other)
    });
    let mut nodes: Vec<(f64, f64)> = near.collect();
    if interval.is_finite() {
        nodes.extend(panel(interval.right(), middle, right, half_count).map(|node| {
            (node.position, node.weight * (node.position - interval.left()).powf(left))
        }));
    } else {
        let scale = extent.half_length();
        nodes.extend(
            tail(middle, scale, half_count)
                .map(|(x, weight)| (x, weight * (x - interval.left()).powf(left))),
        );
    }
    nodes
}

fn end_power(end: f64, x: f64, exponent: f64) -> f64 {
    if end.is_finite() && exponent != 0.0 { (end - x).powf(exponent) } else { 1.0 }
}

/// `int_start^inf g dx` for `g` that decays exponentially: `x = start + scale e^(pi/2 sinh t)`, cut where exponentials have vanished.
pub(super) fn tail(start: f64, scale: f64, half_count: usize) -> impl Iterator<Item = (f64, f64)> {
    let (first, last) = (-3.2f64, 2.4f64);
    let count = 3 * half_count;
    let step = (last - first) / count as f64;
    (0..=count).map(move |i| {
        let t = first + step * i as f64;
        let distance = scale * (std::f64::consts::FRAC_PI_2 * t.sinh()).exp();
        (start + distance, step * std::f64::consts::FRAC_PI_2 * t.cosh() * distance)
    })
}

/// The panels that make `int_L K(x, s) g(s) w(s) dm(s)` for one `x` inside, `w` without its smooth part: `(s, weight times kernel times measure)`.
pub(super) fn kernel_rule(
    relation: &dyn SpectralRelation,
    x: f64,
    half_count: usize,
) -> Vec<(f64, f64)> {
    let interval = relation.interval();
    let EndExponents { left, right } = relation.weight_exponents();
    let singularity = relation.singularity();
    let q = singularity.exponent().max(0.0);
    let powers = |s: f64| end_power(interval.right(), s, right) * (s - interval.left()).powf(left);
    let mut nodes = Vec::new();
    let mut outer = |end: f64, beta: f64| {
        let middle = 0.5 * (x + end);
        for node in panel(end, middle, beta, half_count) {
            let s = node.position;
            let distance = (x - end).abs() - node.distance;
            let opposite = if end == interval.left() {
                end_power(interval.right(), s, right)
            } else {
                (s - interval.left()).powf(left)
            };
            let value = relation.pair(x, s, distance).value;
            nodes.push((s, node.weight * opposite * value * relation.measure(s)));
        }
        inner(relation, x, middle, q, half_count, &powers, &mut nodes);
    };
    outer(interval.left(), left);
    if interval.is_finite() {
        outer(interval.right(), right);
        return nodes;
    }
    let middle = x + relation.extent().half_length();
    inner(relation, x, middle, q, half_count, &powers, &mut nodes);
    let beyond = tail(middle, relation.extent().half_length(), half_count).map(|(s, weight)| {
        (s, weight * powers(s) * relation.measure(s) * relation.pair(x, s, s - x).value)
    });
    nodes.extend(beyond);
    nodes
}

/// The panel that begins at the diagonal.
fn inner(
    relation: &dyn SpectralRelation,
    x: f64,
    end: f64,
    q: f64,
    half_count: usize,
    powers: &dyn Fn(f64) -> f64,
    nodes: &mut Vec<(f64, f64)>,
) {
    let at = relation.split(x, x, 0.0);
    for node in panel(x, end, -q, half_count) {
        let s = node.position;
        // K d^q
        let value = if q > 0.0 && node.distance < CLOSE {
            // d^q = d / d^(1-q)
            let power = node.distance / node.raised;
            at.factor * (1.0 - power) / q + at.rest * power
        } else {
            relation.pair(x, s, node.distance).value * node.distance.powf(q)
        };
        nodes.push((s, node.weight * value * powers(s) * relation.measure(s)));
    }
}

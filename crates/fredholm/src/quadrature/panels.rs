//! Quadrature with powers at the ends of its panels, which knows nothing of any spectral relation.

use super::double_exponential;
use crate::kernel::{EndExponents, Kernel, SpectralRelation};

/// Below this distance a kernel is taken from the split of its diagonal.
const CLOSE: f64 = 1e-200;

/// A node of a panel `(start, start + length)`, or the mirror image, with a power at its start.
pub(crate) struct Node {
    /// `x`.
    pub(crate) position: f64,
    /// Distance to the start.
    pub(crate) distance: f64,
    /// The distance to the power `1 + beta` of the start, which does not underflow.
    pub(crate) raised: f64,
    /// Weight, that of the power `distance^beta` included.
    pub(crate) weight: f64,
}

/// The rule for `int |x - start|^beta g(x) dx` from `start` to `end`: with `u = (distance/length)^(1+beta)` nothing of the power remains, however near `beta` is to -1.
pub(crate) fn panel(
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
pub(crate) fn weighted(relation: &dyn SpectralRelation, half_count: usize) -> Vec<(f64, f64)> {
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
            (node.position, node.weight * power(node.position - interval.left(), left))
        }));
    } else {
        let scale = extent.half_length();
        nodes.extend(
            tail(middle, scale, half_count)
                .map(|(x, weight)| (x, weight * power(x - interval.left(), left))),
        );
    }
    nodes
}

fn end_power(end: f64, x: f64, exponent: f64) -> f64 {
    if end.is_finite() && exponent != 0.0 { (end - x).powf(exponent) } else { 1.0 }
}

/// `int_start^inf g dx` for `g` that decays exponentially: `x = start + scale e^(pi/2 sinh t)`, cut where exponentials have vanished.
pub(crate) fn tail(start: f64, scale: f64, half_count: usize) -> impl Iterator<Item = (f64, f64)> {
    // What lies before the first node is 1e-18 of the scale.
    let (first, last) = (-3.95f64, 2.4f64);
    let count = 3 * half_count;
    let step = (last - first) / count as f64;
    (0..=count).map(move |i| {
        let t = first + step * i as f64;
        let distance = scale * (std::f64::consts::FRAC_PI_2 * t.sinh()).exp();
        (start + distance, step * std::f64::consts::FRAC_PI_2 * t.cosh() * distance)
    })
}

/// The panels that make `int_L K(x, s) g(s) w(s) dm(s)` for one `x` of the closed interval, `w` the powers of the distances to the ends: `(s, weight times kernel
/// times measure)`.
pub(crate) fn kernel_rule(
    kernel: &dyn Kernel,
    exponents: EndExponents,
    x: f64,
    half_count: usize,
) -> Vec<(f64, f64)> {
    let interval = kernel.interval();
    let EndExponents { left, right } = exponents;
    let powers = |s: f64| end_power(interval.right(), s, right) * power(s - interval.left(), left);
    let mut nodes = Vec::new();
    let mut sides = vec![(interval.left(), left)];
    if interval.is_finite() {
        sides.push((interval.right(), right));
    }
    for (end, beta) in sides.into_iter().filter(|(end, _)| *end != x) {
        let middle = 0.5 * (x + end);
        for node in panel(end, middle, beta, half_count) {
            let s = node.position;
            let opposite = if end == interval.left() {
                end_power(interval.right(), s, right)
            } else {
                power(s - interval.left(), left)
            };
            let value = kernel.pair(x, s, (x - end).abs() - node.distance).value;
            nodes.push((s, node.weight * opposite * value * kernel.measure(s)));
        }
        inner(kernel, x, middle, half_count, &powers, &mut nodes);
    }
    if !interval.is_finite() {
        let middle = x + kernel.extent().half_length();
        inner(kernel, x, middle, half_count, &powers, &mut nodes);
        let beyond = tail(middle, kernel.extent().half_length(), half_count).map(|(s, weight)| {
            (s, weight * powers(s) * kernel.measure(s) * kernel.pair(x, s, s - x).value)
        });
        nodes.extend(beyond);
    }
    nodes
}

fn power(distance: f64, exponent: f64) -> f64 {
    if exponent == 0.0 { 1.0 } else { distance.powf(exponent) }
}

/// The panel that begins at the diagonal.
fn inner(
    kernel: &dyn Kernel,
    x: f64,
    end: f64,
    half_count: usize,
    powers: &dyn Fn(f64) -> f64,
    nodes: &mut Vec<(f64, f64)>,
) {
    let q = kernel.singularity().exponent().max(0.0);
    let at = kernel.split(x, x, 0.0);
    for node in panel(x, end, -q, half_count) {
        let s = node.position;
        // K d^q
        let value = if q > 0.0 && node.distance < CLOSE {
            // d^q = d / d^(1-q)
            let power = node.distance / node.raised;
            at.factor * (1.0 - power) / q + at.rest * power
        } else {
            kernel.pair(x, s, node.distance).value * power(node.distance, q)
        };
        nodes.push((s, node.weight * value * powers(s) * kernel.measure(s)));
    }
}

//! The density whose error is bounded: a polynomial on each panel, and its potential.

use crate::chebyshev::{evaluate, nodes};
use crate::kernel::{Kernel, Singularity};
use crate::legendre::{self, MOMENTS, ORDER, RULE, Seen, potentials};

/// Clusters farther from a place than this many of their radii are seen by their moments.
const FAR: f64 = 3.0;
/// Unit of rounding.
const UNIT: f64 = 0.5 * f64::EPSILON;

/// A polynomial on `[left, right]`.
#[derive(Debug, Clone)]
pub(crate) struct Panel {
    pub(crate) left: f64,
    pub(crate) right: f64,
    pub(crate) coefficients: [f64; ORDER],
    /// A bound of its size.
    pub(crate) largest: f64,
    /// A bound of its size less its mean.
    pub(crate) swing: f64,
}

impl Panel {
    pub(crate) fn new(left: f64, right: f64, coefficients: [f64; ORDER]) -> Self {
        let swing: f64 = coefficients[1..].iter().map(|c| c.abs()).sum();
        Self { left, right, coefficients, largest: swing + coefficients[0].abs(), swing }
    }

    pub(crate) fn middle(&self) -> f64 {
        0.5 * (self.left + self.right)
    }

    pub(crate) fn half(&self) -> f64 {
        0.5 * (self.right - self.left)
    }

    /// A bound of `int |q|`.
    pub(crate) fn mass(&self) -> f64 {
        2.0 * self.half() * self.largest
    }

    pub(crate) fn evaluate(&self, x: f64) -> f64 {
        let t = ((x - self.left) - (self.right - x)) / (self.right - self.left);
        legendre::evaluate(&self.coefficients, t.clamp(-1.0, 1.0))
    }

    /// Places of the Gauss nodes, with their weights.
    pub(crate) fn nodes(&self) -> impl Iterator<Item = (f64, f64)> {
        let (middle, half) = (self.middle(), self.half());
        RULE.nodes.iter().zip(&RULE.weights).map(move |(t, w)| (middle + half * t, half * w))
    }

    /// Values at the Gauss nodes.
    pub(crate) fn at_nodes(&self) -> impl Iterator<Item = f64> {
        RULE.nodes.iter().map(|t| legendre::evaluate(&self.coefficients, *t))
    }

    /// The potential `int sigma(|x - t|) q(t) dt` and a bound of its rounding.
    fn potential(&self, singularity: Singularity, x: f64) -> (f64, f64) {
        let half = self.half();
        let (from_left, to_right) = ((x - self.left) / half, (self.right - x) / half);
        let at = Seen { z: 0.5 * (from_left - to_right), to_right, from_left };
        let moments = potentials(singularity, at);
        let (mut sum, mut size) = (0.0, 0.0);
        for (k, (c, moment)) in self.coefficients.iter().zip(&moments).enumerate() {
            sum += c * moment;
            // The recurrences run with errors of some units for each step, see the book.
            size += c.abs() * (moment.abs() * 4.0 + 8.0 * (1.0 + k as f64));
        }
        match singularity {
            Singularity::Logarithm => {
                let mass = 2.0 * half * self.coefficients[0];
                let scale = half.ln();
                let rounding = half * size + 4.0 * mass.abs() * scale.abs();
                (half * sum + mass * scale, UNIT * rounding)
            }
            Singularity::Power(mu) => {
                let scale = half.powf(1.0 - mu);
                (scale * sum, UNIT * scale * size * (2.0 / (1.0 - mu)))
            }
        }
    }
}

/// Panels that lie together, seen from afar.
#[derive(Debug, Clone)]
struct Cluster {
    first: usize,
    last: usize,
    centre: f64,
    radius: f64,
    moments: [f64; MOMENTS],
    weighted: [f64; MOMENTS],
    mass: f64,
    largest: f64,
    children: Option<[usize; 2]>,
}

/// Polynomials on panels from left to right, zero elsewhere.
#[derive(Debug, Clone)]
pub(crate) struct Density {
    pub(crate) kernel: Kernel,
    pub(crate) panels: Vec<Panel>,
    clusters: Vec<Cluster>,
    /// Chebyshev coefficients of the regular part of the potential, for a row.
    regular: Vec<f64>,
}

impl Density {
    pub(crate) fn new(kernel: Kernel, panels: Vec<Panel>) -> Self {
        let mut density = Self { kernel, panels, clusters: Vec::new(), regular: Vec::new() };
        if !density.panels.is_empty() {
            density.gather(0, density.panels.len());
        }
        if let Kernel::Row { period } = kernel {
            density.regular = density.regular_part(period);
        }
        density
    }

    /// The cluster of these panels, after those of its parts; its index.
    fn gather(&mut self, first: usize, last: usize) -> usize {
        let (left, right) = (self.panels[first].left, self.panels[last - 1].right);
        let (centre, radius) = (0.5 * (left + right), 0.5 * (right - left));
        let mut cluster = Cluster {
            first,
            last,
            centre,
            radius,
            moments: [0.0; MOMENTS],
            weighted: [0.0; MOMENTS],
            mass: self.panels[first..last].iter().map(Panel::mass).sum(),
            largest: self.panels[first..last].iter().fold(0.0, |most, p| most.max(p.largest)),
            children: None,
        };
        if last - first > 1 {
            let middle = usize::midpoint(first, last);
            let children = [self.gather(first, middle), self.gather(middle, last)];
            for child in children {
                let child = &self.clusters[child];
                shift(
                    &child.moments,
                    child.radius / radius,
                    (child.centre - centre) / radius,
                    &mut cluster.moments,
                );
            }
            cluster.children = Some(children);
        } else {
            for panel in &self.panels[first..last] {
                let own = RULE.moments(&panel.coefficients).map(|moment| moment * panel.half());
                shift(
                    &own,
                    panel.half() / radius,
                    (panel.middle() - centre) / radius,
                    &mut cluster.moments,
                );
            }
        }
        cluster.weighted = Cluster::weighted(&cluster.moments, self.kernel.singularity());
        self.clusters.push(cluster);
        self.clusters.len() - 1
    }

    /// The largest size.
    pub(crate) fn largest(&self) -> f64 {
        self.clusters.last().map_or(0.0, |root| root.largest)
    }

    /// The panel of a place, if there is one; of two the left.
    pub(crate) fn panel_at(&self, x: f64) -> Option<usize> {
        let index = self.panels.partition_point(|panel| panel.right < x);
        self.panels.get(index).is_some_and(|panel| panel.left <= x).then_some(index)
    }

    /// `q(x)`.
    pub(crate) fn evaluate(&self, x: f64) -> f64 {
        self.panel_at(x).map_or(0.0, |index| self.panels[index].evaluate(x))
    }

    /// `int K(x, t) q(t) dt` and a bound of its rounding.
    pub(crate) fn potential(&self, x: f64) -> (f64, f64) {
        if self.panels.is_empty() {
            return (0.0, 0.0);
        }
        match self.kernel {
            Kernel::Logarithm => {
                let (value, error) = self.singular(x);
                (-value, error)
            }
            Kernel::Power { .. } => self.singular(x),
            Kernel::Row { period } => {
                let (mut value, mut error) = (0.0, 0.0);
                for image in [x, x - period, x + period] {
                    let (part, rounding) = self.singular(image);
                    value -= part;
                    error += rounding;
                }
                let (part, rounding) = self.regular_at(x);
                (value + part, error + rounding)
            }
        }
    }

    /// `int sigma(|x - t|) q(t) dt`.
    fn singular(&self, x: f64) -> (f64, f64) {
        let singularity = self.kernel.singularity();
        let (mut sum, mut error) = (0.0, 0.0);
        let mut stack = [0usize; 64];
        let mut depth = 1;
        stack[0] = self.clusters.len() - 1;
        while depth > 0 {
            depth -= 1;
            let cluster = &self.clusters[stack[depth]];
            let z = (x - cluster.centre) / cluster.radius;
            if z.abs() >= FAR {
                let (value, rounding) =
                    cluster.from_afar(singularity, z, (x - cluster.centre).abs());
                sum += value;
                error += rounding;
            } else if let Some(children) = cluster.children {
                stack[depth] = children[0];
                stack[depth + 1] = children[1];
                depth += 2;
            } else {
                for panel in &self.panels[cluster.first..cluster.last] {
                    let (value, rounding) = panel.potential(singularity, x);
                    sum += value;
                    error += rounding;
                }
            }
        }
        (sum, error)
    }

    /// Calls `visit(distance, mass, largest, length)` for parts of the density, with the least distance of `x` from each; parts nearer than their own length are single panels.
    pub(crate) fn parts(&self, x: f64, visit: &mut impl FnMut(f64, f64, f64, f64)) {
        if self.panels.is_empty() {
            return;
        }
        let images: &[f64] = match self.kernel {
            Kernel::Row { period } => &[0.0, -period, period],
            Kernel::Logarithm | Kernel::Power { .. } => &[0.0],
        };
        for image in images {
            self.visit(self.clusters.len() - 1, x + image, visit);
        }
    }

    fn visit(&self, index: usize, x: f64, visit: &mut impl FnMut(f64, f64, f64, f64)) {
        let cluster = &self.clusters[index];
        let distance = ((x - cluster.centre).abs() - cluster.radius).max(0.0);
        if distance >= cluster.radius {
            visit(distance, cluster.mass, cluster.largest, 2.0 * cluster.radius);
            return;
        }
        if let Some(children) = cluster.children {
            children.into_iter().for_each(|child| self.visit(child, x, visit));
            return;
        }
        for panel in &self.panels[cluster.first..cluster.last] {
            let distance = ((x - panel.middle()).abs() - panel.half()).max(0.0);
            visit(distance, panel.mass(), panel.largest, 2.0 * panel.half());
        }
    }

    /// The part of a row's potential beside three logarithms, `K = -sum ln|d + j L| + 3 ln L - ln 2 pi + sum (zeta(2k) - 1)/k (d/L)^2k` over `j = -1, 0, 1`: it has its
    /// singularities two periods away.
    fn regular_part(&self, period: f64) -> Vec<f64> {
        let at = nodes(REGULAR);
        let values: Vec<f64> = (at.places.iter())
            .map(|x| self.integral_with(|t| regular_kernel((x - t) / period, period)))
            .collect();
        at.coefficients(&values).collect()
    }

    fn integral_with(&self, kernel: impl Fn(f64) -> f64) -> f64 {
        let mut sum = 0.0;
        for panel in &self.panels {
            for ((x, weight), t) in panel.nodes().zip(&RULE.nodes) {
                sum += weight * legendre::evaluate(&panel.coefficients, *t) * kernel(x);
            }
        }
        sum
    }

    fn regular_at(&self, x: f64) -> (f64, f64) {
        let value = evaluate(&self.regular, x);
        // What the series leaves out falls as (2 + sqrt 3)^-k; the rest is rounding of some fifty terms.
        let mass = self.clusters.last().map_or(0.0, |root| root.mass);
        (value, 128.0 * UNIT * mass * 4.0)
    }
}

/// Nodes of the regular part of a row: `(2 + sqrt 3)^-REGULAR` is below rounding.
const REGULAR: usize = 32;

/// `-ln(2 sin(pi u)/(L^3 u (1 - u^2)))`, `0 <= u <= 1` the share of the distance in the period.
fn regular_kernel(u: f64, period: f64) -> f64 {
    use std::f64::consts::PI;
    let u = u.abs();
    let rest = (1.0 - u).max(0.0);
    let sine = |v: f64| if v == 0.0 { PI } else { (PI * v).sin() / v };
    // From the nearer zero of the sine.
    let quotient =
        if u < rest { sine(u) / (rest * (1.0 + u)) } else { sine(rest) / (u * (1.0 + u)) };
    3.0 * period.ln() - (2.0 * quotient).ln()
}

/// Adds the moments of a part, `int q ((t - c')/r')^k` from `int q ((t - c)/r)^k`, with `ratio = r/r'` and `offset = (c - c')/r'`.
fn shift(moments: &[f64; MOMENTS], ratio: f64, offset: f64, into: &mut [f64; MOMENTS]) {
    // Horner's scheme on the binomials: (offset + ratio t)^k, one power after the other.
    let mut row = *moments;
    into[0] += row[0];
    for (k, entry) in into.iter_mut().enumerate().skip(1) {
        // row[j] = int q (offset + ratio t)^k t^j
        for j in 0..MOMENTS - k {
            row[j] = offset * row[j] + ratio * row[j + 1];
        }
        *entry += row[0];
    }
}

impl Cluster {
    /// The moments with the factors of the expansion of the kernel: `1/k` of the logarithm, `(mu)_k/k!` of the power.
    fn weighted(moments: &[f64; MOMENTS], singularity: Singularity) -> [f64; MOMENTS] {
        let mut factor = 1.0;
        let mut weighted = *moments;
        for (k, entry) in weighted.iter_mut().enumerate().skip(1) {
            let n = k as f64;
            match singularity {
                Singularity::Logarithm => factor = 1.0 / n,
                Singularity::Power(mu) => factor *= (mu + n - 1.0) / n,
            }
            *entry *= factor;
        }
        weighted
    }

    /// Its potential by moments at `z` radii, the distance `d`, from its centre.
    fn from_afar(&self, singularity: Singularity, z: f64, d: f64) -> (f64, f64) {
        let inverse = 1.0 / z;
        let terms = ((37.0 / z.abs().ln()).ceil() as usize).clamp(2, MOMENTS - 1);
        let mut sum = 0.0;
        for moment in self.weighted[1..=terms].iter().rev() {
            sum = inverse * (moment + sum);
        }
        match singularity {
            Singularity::Logarithm => {
                let scale = d.ln();
                let error = self.mass * (2.0 * scale.abs() + 4.0);
                (self.moments[0] * scale - sum, UNIT * error)
            }
            Singularity::Power(mu) => {
                let scale = d.powf(-mu);
                (scale * (self.moments[0] + sum), UNIT * scale * self.mass * 8.0)
            }
        }
    }
}

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
        let mut found = [(0.0, 0.0)];
        self.potentials(&[x], &mut found);
        found[0]
    }

    /// The same at places that lie together, which costs less than one by one.
    pub(crate) fn potentials(&self, places: &[f64], found: &mut [(f64, f64)]) {
        found.fill((0.0, 0.0));
        if self.panels.is_empty() {
            return;
        }
        match self.kernel {
            Kernel::Logarithm => self.add_singular(places, -1.0, found),
            Kernel::ShiftedLogarithm { constant } => {
                self.add_singular(places, -1.0, found);
                self.add_constant(constant, found);
            }
            Kernel::Power { .. } => self.add_singular(places, 1.0, found),
            Kernel::Row { period } => {
                for image in [0.0, -period, period] {
                    let images: Vec<f64> = places.iter().map(|x| x + image).collect();
                    self.add_singular(&images, -1.0, found);
                }
                for (entry, x) in found.iter_mut().zip(places) {
                    let (value, rounding) = self.regular_at(*x);
                    *entry = (entry.0 + value, entry.1 + rounding);
                }
            }
        }
    }

    /// Adds `sign int sigma(|x - t|) q(t) dt`.
    fn add_singular(&self, places: &[f64], sign: f64, found: &mut [(f64, f64)]) {
        let singularity = self.kernel.singularity();
        let first = places.iter().copied().fold(f64::INFINITY, f64::min);
        let last = places.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let mut scratch = Scratch::default();
        let mut stack = vec![self.clusters.len() - 1];
        while let Some(index) = stack.pop() {
            let cluster = &self.clusters[index];
            let distance = (first - cluster.centre).max(cluster.centre - last);
            if distance >= FAR * cluster.radius {
                cluster.add_from_afar(singularity, places, distance, sign, (&mut scratch, found));
            } else if let Some(children) = cluster.children {
                stack.extend(children);
            } else {
                for panel in &self.panels[cluster.first..cluster.last] {
                    for (entry, x) in found.iter_mut().zip(places) {
                        let z = (x - cluster.centre).abs();
                        let (value, rounding) = if z >= FAR * cluster.radius {
                            cluster.potential_afar(singularity, *x, &mut scratch)
                        } else {
                            panel.potential(singularity, *x)
                        };
                        *entry = (entry.0 + sign * value, entry.1 + rounding);
                    }
                }
            }
        }
    }

    /// Adds `constant int q`. Interpolation reproduces it, so that windows need not know of it.
    fn add_constant(&self, constant: f64, found: &mut [(f64, f64)]) {
        let Some(root) = self.clusters.last() else { return };
        // Sums along a tree of at most 16 levels, products, and the constant itself.
        let rounding = 32.0 * UNIT * constant.abs() * root.mass;
        for entry in found {
            *entry = (entry.0 + constant * root.moments[0], entry.1 + rounding);
        }
    }

    /// Calls `visit(distance, mass, largest, length)` for parts of the density, with the least distance of `x` from each; parts nearer than their own length are single panels.
    pub(crate) fn parts(&self, x: f64, visit: &mut impl FnMut(f64, f64, f64, f64)) {
        if self.panels.is_empty() {
            return;
        }
        let images: &[f64] = match self.kernel {
            Kernel::Row { period } => &[0.0, -period, period],
            Kernel::Logarithm | Kernel::ShiftedLogarithm { .. } | Kernel::Power { .. } => &[0.0],
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

    /// Adds its potential by moments at places that are at least this far from its centre.
    fn add_from_afar(
        &self,
        singularity: Singularity,
        places: &[f64],
        distance: f64,
        sign: f64,
        (scratch, found): (&mut Scratch, &mut [(f64, f64)]),
    ) {
        let least = distance / self.radius;
        let terms = ((37.0 / least.ln()).ceil() as usize).clamp(2, MOMENTS - 1);
        let Scratch { inverses, sums } = scratch;
        inverses.clear();
        inverses.extend(places.iter().map(|x| self.radius / (x - self.centre)));
        sums.clear();
        sums.resize(places.len(), 0.0);
        // All places advance together: their sums do not wait for each other.
        for moment in self.weighted[1..=terms].iter().rev() {
            for (sum, inverse) in sums.iter_mut().zip(inverses.iter()) {
                *sum = inverse * (moment + *sum);
            }
        }
        for ((entry, x), sum) in found.iter_mut().zip(places).zip(sums.iter()) {
            let d = (x - self.centre).abs();
            let (value, rounding) = match singularity {
                Singularity::Logarithm => {
                    let scale = d.ln();
                    let error = self.mass * (2.0 * scale.abs() + 4.0);
                    (self.moments[0] * scale - sum, UNIT * error)
                }
                Singularity::Power(mu) => {
                    let scale = d.powf(-mu);
                    (scale * (self.moments[0] + sum), UNIT * scale * self.mass * 8.0)
                }
            };
            *entry = (entry.0 + sign * value, entry.1 + rounding);
        }
    }

    /// The same at one place.
    fn potential_afar(
        &self,
        singularity: Singularity,
        x: f64,
        scratch: &mut Scratch,
    ) -> (f64, f64) {
        let mut found = [(0.0, 0.0)];
        let distance = (x - self.centre).abs();
        self.add_from_afar(singularity, &[x], distance, 1.0, (scratch, &mut found));
        found[0]
    }
}

/// Sums of many places, kept between clusters.
#[derive(Default)]
struct Scratch {
    inverses: Vec<f64>,
    sums: Vec<f64>,
}

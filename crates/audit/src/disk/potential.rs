//! Potentials of densities on a disk: from afar by Gauss and Legendre's rule, beside a place by the singularity of the kernel in closed form.

use std::cell::{Cell, OnceCell};

use super::kernel::Harmonic;
use super::tree::{Seen, Tree};
use crate::allowance::UNIT;
use crate::kernel::Singularity;
use crate::legendre::{ORDER, RULE, evaluate_at};
use crate::near::{Distances, Recurrence};
use crate::panel::Panel;

/// A panel this many times as far from the axis at one end as at the other is cut about the place: on shorter ones the factors of the kernel are polynomials of degree 23 but for `5.8^-24`.
const LONG: f64 = 2.0;
/// It is cut at this share of the place on both sides of it, and outside where the distance has grown so much.
const ABOUT: f64 = 1.0 / 3.0;
const GROWTH: f64 = 4.0;
/// Places are at least this far from the axis, relative to the panel there: so near to it potentials do not change.
const AT_AXIS: f64 = 1e-16;
/// Looks at panels in the plane that take as long as one on a disk.
const LOOKS: u64 = 8;
/// Roundings of the factor of a singularity, of its product with the density and of its part in the kernel.
const FACTORS: f64 = 8.0;

/// A density `q(r) cos(m phi)` by its panels from the axis outwards.
pub(crate) struct Radial {
    kernel: Harmonic,
    panels: Vec<Panel>,
    /// Of each panel `q s ds` at its nodes.
    masses: Vec<[f64; ORDER]>,
    tree: OnceCell<Tree>,
    recurrence: Recurrence,
    exponent: f64,
    rounding: f64,
    looks: Cell<u64>,
}

impl Radial {
    pub(crate) fn new(kernel: Harmonic, exponent: f64, panels: Vec<Panel>) -> Self {
        let masses = (panels.iter())
            .map(|panel| {
                let mut masses = panel.at_nodes();
                for (mass, (s, w)) in masses.iter_mut().zip(panel.nodes()) {
                    *mass *= w * s;
                }
                masses
            })
            .collect();
        let singularity =
            if exponent > 0.0 { Singularity::Power(exponent) } else { Singularity::Logarithm };
        let recurrence = Recurrence::new(singularity);
        let rounding = UNIT * kernel.rounding();
        Self {
            kernel,
            panels,
            masses,
            tree: OnceCell::new(),
            recurrence,
            exponent,
            rounding,
            looks: Cell::new(0),
        }
    }

    /// How often panels, or several together, were looked at from a place, in looks of the plane.
    pub(crate) fn looks(&self) -> u64 {
        self.looks.get()
    }

    /// Counts what takes as long as so many looks.
    pub(crate) fn count(&self, looks: u64) {
        self.looks.set(self.looks.get() + looks);
    }

    pub(crate) fn panels(&self) -> &[Panel] {
        &self.panels
    }

    /// `q(r)`; of two panels that of the left.
    pub(crate) fn evaluate(&self, r: f64) -> f64 {
        let index = self.panels.partition_point(|panel| panel.right < r);
        let panel = self.panels.get(index).filter(|panel| panel.left <= r);
        panel.map_or(0.0, |panel| panel.evaluate(r))
    }

    /// `int u(r) q(r) r dr`.
    pub(crate) fn integral(&self, u: impl Fn(f64) -> f64) -> f64 {
        let parts = self.panels.iter().zip(&self.masses);
        parts
            .flat_map(|(panel, masses)| panel.nodes().zip(masses))
            .map(|((s, _), m)| m * u(s))
            .sum()
    }

    /// `int K_m(r, s) q(s) s ds` and its rounding.
    pub(crate) fn potential(&self, r: f64) -> (f64, f64) {
        if r == 0.0 && self.kernel.is_turning() {
            return (0.0, 0.0);
        }
        let mut sums = Sums::default();
        let tree = self.tree.get_or_init(|| Tree::new(&self.panels, &self.masses));
        let mut looks = 0;
        tree.see(r, |seen| {
            looks += LOOKS;
            match seen {
                Seen::Far(cluster) => {
                    let (nodes, distances, masses) = cluster.seen(r);
                    sums.add_far(masses, &self.kernel.values(r, &nodes, &distances));
                }
                Seen::Near(index) => {
                    let panel = &self.panels[index];
                    if panel.right > LONG * panel.left {
                        self.add_cut(panel, r, &mut sums);
                    } else {
                        let whole = Part::new(panel.left, panel.right);
                        self.add_near(&whole, &self.masses[index], r, &mut sums);
                    }
                }
            }
        });
        self.looks.set(self.looks.get() + looks);
        (sums.value, self.rounding * sums.size + UNIT * sums.rounding)
    }

    /// Adds a panel that reaches far from the place or to the axis.
    fn add_cut(&self, panel: &Panel, r: f64, sums: &mut Sums) {
        let r = r.max(AT_AXIS * panel.right).max(f64::MIN_POSITIVE);
        let (inner, outer) = (r - ABOUT * r, r + ABOUT * r);
        let mut left = panel.left;
        let mut next = inner;
        while left < panel.right {
            let right = if next < panel.right { next } else { panel.right };
            if right > left {
                let part = Part::new(left, right);
                let own = part.nodes.map(|s| panel.own(s));
                let mut masses = evaluate_at(&panel.coefficients, &own);
                for ((mass, s), w) in masses.iter_mut().zip(&part.nodes).zip(&RULE.weights) {
                    *mass *= part.half * w * s;
                }
                if inner <= left && right <= outer {
                    self.add_near(&part, &masses, r, sums);
                } else {
                    let distances = part.nodes.map(|s| (r - s).abs());
                    sums.add_far(&masses, &self.kernel.values(r, &part.nodes, &distances));
                }
                left = right;
            }
            next = if next < outer { outer } else { r + GROWTH * (next - r) };
        }
    }

    /// Adds masses at the nodes of an interval about the place or beside it: `int K q s ds = int R q s ds + int L sigma q s ds`.
    fn add_near(&self, part: &Part, masses: &[f64; ORDER], r: f64, sums: &mut Sums) {
        let split = self.kernel.split(r, &part.nodes, part.half);
        let mut density = [0.0; ORDER];
        for j in 0..ORDER {
            sums.value += masses[j] * split.regular[j];
            sums.size += (masses[j] * split.size[j]).abs();
            density[j] = masses[j] * split.singular[j] / (part.half * RULE.weights[j]);
        }
        // In half-lengths of the interval.
        let density = Panel::new(-1.0, 1.0, RULE.expand(&density));
        let distances = Distances {
            from_left: [(r - part.left) / part.half],
            to_right: [(part.right - r) / part.half],
        };
        let sign = if self.exponent > 0.0 { 1.0 } else { -1.0 };
        let scale = if self.exponent > 0.0 { 1.0 } else { 0.0 };
        let [[value], [rounding]] = self.recurrence.potentials(&density, scale, &distances);
        sums.value += part.half * sign * value;
        sums.rounding += part.half * (rounding + FACTORS * value.abs());
    }
}

/// An interval with its nodes.
struct Part {
    left: f64,
    right: f64,
    half: f64,
    nodes: [f64; ORDER],
}

impl Part {
    fn new(left: f64, right: f64) -> Self {
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        Self { left, right, half, nodes: RULE.nodes.map(|t| middle + half * t) }
    }
}

/// A potential, what its rounding is relative to, and other roundings in units of the machine.
#[derive(Default)]
struct Sums {
    value: f64,
    size: f64,
    rounding: f64,
}

impl Sums {
    fn add_far(&mut self, masses: &[f64; ORDER], kernel: &[f64; ORDER]) {
        for (mass, value) in masses.iter().zip(kernel) {
            self.value += mass * value;
            self.size += (mass * value).abs();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::legendre::ORDER;
    use std::f64::consts::PI;

    fn constant(left: f64, right: f64, value: f64) -> Panel {
        let mut coefficients = [0.0; ORDER];
        coefficients[0] = value;
        Panel::new(left, right, coefficients)
    }

    /// Closed forms: a uniform pressure on a disk of radius 1 gives `int K_0 s ds = pi` at the axis and 2 at the rim; that with `q = r` in the first harmonic `2/3` at the rim
    /// (H. Hertz's and Boussinesq's tables: K. L. Johnson, Contact Mechanics, 1985, sec. 3.4).
    #[test]
    fn uniform_pressure() {
        let panels = || vec![constant(0.0, 0.3, 1.0), constant(0.3, 1.0, 1.0)];
        let density = Radial::new(Harmonic::new(0, 0.0), 0.0, panels());
        for (r, exact) in [(0.0, PI), (1.0, 2.0)] {
            let (found, rounding) = density.potential(r);
            assert!((found - exact).abs() < 1e-14 && rounding < 1e-13, "{r}: {found} {exact}");
        }
        // 2 E(r) inside, E the complete integral of the modulus r: by the rule of the trapezia.
        for r in [0.1, 0.3, 0.77] {
            let count = 200;
            let sum: f64 = (0..count)
                .map(|k| PI * (f64::from(k) + 0.5) / f64::from(count))
                .map(|phi| (1.0 - (r * phi.sin()).powi(2)).sqrt())
                .sum();
            let exact = sum * PI / f64::from(count);
            let (found, _) = density.potential(r);
            assert!((found - exact).abs() < 1e-14, "{r}: {found} {exact}");
        }
    }

    /// Graded ground: at the axis `K_0(0, s) = pi G s^-(1+mu)`, so that a uniform pressure has `pi G/(1-mu)`.
    #[test]
    fn graded_ground() {
        for mu in [0.1, 0.5, 0.9] {
            let density = Radial::new(Harmonic::new(0, mu), mu, vec![constant(0.0, 1.0, 1.0)]);
            let gamma = libm::tgamma;
            let strength = 2f64.powf(mu) * gamma(0.5 * (1.0 + mu)) / gamma(0.5 * (1.0 - mu));
            let exact = PI * strength / (1.0 - mu);
            let (found, _) = density.potential(0.0);
            assert!((found - exact).abs() < 1e-12 * exact, "{mu}: {found} {exact}");
        }
    }

    /// Panels that are graded to the rim, to a step inside and to the axis, against another rule: on them, at their ends, beside them and at the axis.
    #[test]
    fn potentials_are_those_of_shells() {
        let mut ends = vec![0.0, 0.05, 0.11, 0.3];
        ends.extend((0..12).map(|k| 0.5 - 0.2 * 0.25f64.powi(k + 1)));
        ends.push(0.5);
        ends.extend((0..12).rev().map(|k| 0.5 + 0.2 * 0.25f64.powi(k + 1)));
        ends.extend((0..8).map(|k| 1.0 - 0.3 * 0.25f64.powi(k)));
        ends.push(1.0);
        let panels: Vec<Panel> = (ends.windows(2).enumerate())
            .map(|(i, pair)| {
                let mut coefficients = [0.0; ORDER];
                for (k, c) in coefficients.iter_mut().enumerate() {
                    let sign = if (k * (k + i) / 2) % 2 == 1 { -1.0 } else { 1.0 };
                    *c = sign * 0.2f64.powi(k as i32) * if pair[0] < 0.5 { 1.0 } else { 0.3 };
                }
                Panel::new(pair[0], pair[1], coefficients)
            })
            .collect();
        let mut places = vec![0.0, 1e-17, 1e-9, 1e-4];
        for panel in &panels {
            let width = panel.right - panel.left;
            places.extend(
                [0.0, 1e-7, 1e-3, 0.0923, 0.5, 0.7377, 0.999].map(|t| panel.left + t * width),
            );
        }
        places.push(1.0);
        for mu in [0.0, 0.05, 0.3, 0.8] {
            for order in [0, 1] {
                let kernel = Harmonic::new(order, mu);
                let density = Radial::new(kernel.clone(), mu, panels.clone());
                for r in places.iter().copied() {
                    let exact = super::super::shells::potential(&kernel, mu, &panels, r);
                    let (found, rounding) = density.potential(r);
                    // Both are rounded; beside the axis relative to what is about it.
                    let off = (found - exact).abs();
                    assert!(off <= 3.0 * rounding + 1e-16, "{mu} {order} {r:e}: {found} {exact}");
                    assert!(rounding < 1e-14 * if mu == 0.05 { 10.0 } else { 4.0 }, "{rounding:e}");
                }
            }
        }
    }
}

//! Potentials of densities on a disk, by Gauss and Legendre's rule on shells that shrink to the place.

use super::kernel::Harmonic;
use crate::density::Panel;
use crate::legendre::RULE;

/// Each shell about a place ends at this share of its distance: 16 nodes integrate what is singular there to `3^-32`.
const SHRINK: f64 = 0.25;
/// What is nearer to the place is taken by the leading term of the kernel, which is off by this times the change of the pressure on its way from 0 to the radius.
const ROUNDING: f64 = 1e-24;
/// Beside the axis shells end at this share of the kernel, and here, so that powers stay in range.
const SHALLOW: f64 = 1e-17;
const SMALLEST: f64 = 1e-150;

/// A density `q(r) cos(m phi)` by its panels from the axis outwards.
pub(crate) struct Radial {
    kernel: Harmonic,
    panels: Vec<Panel>,
    /// Of each panel its nodes with `q s ds`.
    masses: Vec<Vec<(f64, f64)>>,
    exponent: f64,
    rounding: f64,
}

impl Radial {
    pub(crate) fn new(kernel: Harmonic, exponent: f64, panels: Vec<Panel>) -> Self {
        let masses = (panels.iter())
            .map(|panel| {
                (panel.nodes().zip(panel.at_nodes())).map(|((s, w), q)| (s, w * s * q)).collect()
            })
            .collect();
        let rounding = 0.5 * f64::EPSILON * kernel.rounding();
        Self { kernel, panels, masses, exponent, rounding }
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
        self.masses.iter().flatten().map(|(s, mass)| mass * u(*s)).sum()
    }

    /// `int K_m(r, s) q(s) s ds` and its rounding.
    pub(crate) fn potential(&self, r: f64) -> (f64, f64) {
        let (mut sum, mut size) = (0.0, 0.0);
        for (panel, masses) in self.panels.iter().zip(&self.masses) {
            let distance = (panel.left - r).max(r - panel.right);
            if distance >= 2.0 * panel.half() {
                for (s, mass) in masses {
                    let term = mass * self.kernel.value(r, *s, (r - s).abs());
                    sum += term;
                    size += term.abs();
                }
            } else if distance < 0.0 {
                self.add_shells(panel, r, -1.0, [0.0, r - panel.left], (&mut sum, &mut size));
                self.add_shells(panel, r, 1.0, [0.0, panel.right - r], (&mut sum, &mut size));
            } else {
                let side = if panel.left >= r { 1.0 } else { -1.0 };
                let far = distance + 2.0 * panel.half();
                self.add_shells(panel, r, side, [distance, far], (&mut sum, &mut size));
            }
        }
        (sum, self.rounding * size)
    }

    /// Adds the part of a panel on one side of the place, between these distances.
    fn add_shells(
        &self,
        panel: &Panel,
        r: f64,
        side: f64,
        [near, far]: [f64; 2],
        (sum, size): (&mut f64, &mut f64),
    ) {
        let mu = self.exponent;
        let least =
            (r * ROUNDING.powf(1.0 / (2.0 - mu))).max(SHALLOW.powf(1.0 / (1.0 - mu)).max(SMALLEST));
        let at = |d: f64| {
            // At the axis rounding may step beyond it.
            let s = (r + side * d).max(0.0);
            s * panel.evaluate(s) * self.kernel.value(r, s, d)
        };
        let mut outer = far;
        while outer > near {
            if near == 0.0 && outer <= least {
                // int_0^h d^-mu = h^(1-mu)/(1-mu), int_0^h -ln d = h (1 - ln h), the logarithm over r.
                let rest = if mu == 0.0 { panel.evaluate(r) } else { 0.0 };
                *sum += outer * (at(outer) / (1.0 - mu) + rest);
                return;
            }
            let inner = (SHRINK * outer).max(near);
            let (middle, half) = (0.5 * (inner + outer), 0.5 * (outer - inner));
            for (t, weight) in RULE.nodes.iter().zip(&RULE.weights) {
                let value = half * weight * at(middle + half * t);
                *sum += value;
                *size += value.abs();
            }
            outer = inner;
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
}

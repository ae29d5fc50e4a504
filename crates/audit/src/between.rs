//! What lies between the numbers of the machine: the tip of a base may, as that of `|x - 0.1 - 0.2|^q` does, and then the pressure under it is larger than at any number.

use std::ops::Range;

use crate::allowance::UNIT;
use crate::density::Density;
use crate::kernel::{Kernel, Singularity};
use crate::narrow::{VICINITY, density_variation, nearby};
use crate::panel::Panel;
use crate::profile::Profile;
use crate::residual::{Bounded, Residual, blur};

/// No two places of a base are farther apart.
const FARTHEST: f64 = 2.0;

/// What presses: `delta - alpha x - f - theta K q`, of a contact whose potential is known at places.
pub(crate) struct Pressing<'a> {
    pub(crate) base: &'a dyn Profile,
    pub(crate) theta: f64,
    pub(crate) settlement: f64,
    pub(crate) tilt: f64,
    /// What the numbers given may be off by, relative to their sizes.
    pub(crate) scaled: f64,
}

impl Pressing<'_> {
    /// The least height. A tip at an end is followed to the inside: by its rounding it may lie beyond, where a base may have no heights.
    fn low(&self, [left, right]: [f64; 2]) -> f64 {
        let blur = blur(left.abs().max(right.abs()));
        let [about, within] =
            [[left - blur, right + blur], [left, right]].map(|at| self.base.range(at)[0]);
        if about.is_finite() { about.min(within) } else { within }
    }

    /// A bound of what presses at any place of a window, by the potential at both of its ends, with its rounding, and how far it may lie below these between them.
    ///
    /// Of the base only the least height counts, so that it does not matter which side of a jump a number lies on.
    pub(crate) fn most(&self, window: [f64; 2], potentials: [(f64, f64); 2], dip: f64) -> f64 {
        let ([left, right], low) = (window, self.low(window));
        let turned = (-self.tilt * left).max(-self.tilt * right);
        let [one, other] = potentials.map(|(potential, rounding)| potential - rounding);
        let elastic = self.theta * (one.min(other) - dip);
        let sizes = [self.settlement, turned, low, elastic].map(f64::abs).iter().sum::<f64>();
        // One rounding of each term and of what they add up to.
        (self.settlement + turned - low) - elastic + (4.0 * UNIT + 2.0 * self.scaled) * sizes
    }
}

impl Residual<'_> {
    /// A bound of what presses at any place of windows that could not be resolved, if it is more than `known`.
    pub(crate) fn presses<'w>(
        &self,
        windows: impl Iterator<Item = &'w Bounded>,
        known: f64,
    ) -> f64 {
        let Self { profile: base, theta, settlement, tilt, scaled, .. } = *self;
        let pressing = Pressing { base, theta, settlement, tilt, scaled };
        let narrow = windows.filter(|window| window.is_narrow);
        narrow.fold(known, |most, window| {
            let Bounded { left, right, least, .. } = *window;
            // What the least residual leaves to the pressure, with a tip at an end.
            let beyond = (base.range([left, right])[0] - pressing.low([left, right])).max(0.0);
            if self.density.evaluate(0.5 * (left + right)) - least + beyond <= most {
                return most;
            }
            let dip = match Steady::new(self.density, [left, right]) {
                Some(steady) => steady.dip(),
                None => self.potential_variation([left, right]),
            };
            let potentials = [left, right].map(|x| self.density.potential(x));
            most.max(pressing.most([left, right], potentials, dip))
        })
    }
}

/// A density beside a window as a constant on the one zone that the window touches, which is not negative, and what it differs from it.
pub(crate) struct Steady<'a> {
    density: &'a Density,
    window: [f64; 2],
    constant: f64,
    /// By how much the density is less where it is negative.
    negative: f64,
    /// The panels of the zone, and the zone.
    panels: Range<usize>,
    zone: [f64; 2],
}

impl<'a> Steady<'a> {
    /// None where the window touches several zones.
    pub(crate) fn new(density: &'a Density, window: [f64; 2]) -> Option<Self> {
        let panels = &density.panels;
        let first = panels.partition_point(|panel| panel.right < window[0]);
        let last = panels.partition_point(|panel| panel.left <= window[1]);
        let is_cut = |pair: &[Panel]| pair[0].right < pair[1].left;
        if first >= last {
            let (panels, zone) = (0..0, window);
            return Some(Self { density, window, constant: 0.0, negative: 0.0, panels, zone });
        }
        if panels[first..last].windows(2).any(is_cut) {
            return None;
        }
        let start = panels[..=first].windows(2).rposition(is_cut).map_or(0, |index| index + 1);
        let end = panels[first..].windows(2).position(is_cut);
        let end = end.map_or(panels.len(), |at| first + at + 1);
        let zone = [panels[start].left, panels[end - 1].right];
        let middle = (0.5 * (window[0] + window[1])).clamp(zone[0], zone[1]);
        let value = density.evaluate(middle);
        let [constant, negative] = [value.max(0.0), (-value).max(0.0)];
        Some(Self { density, window, constant, negative, panels: start..end, zone })
    }

    /// How far the potential between two places of the window may lie below the smaller one of their potentials.
    ///
    /// Of the constant it is nowhere below: its potential is concave in the zone and falls beside it. What the density differs from that changes its potential by at most
    /// `int |q - constant| |sigma(|x - t|) - sigma(|y - t|)| dt`, which is bounded in the vicinity and on shells beyond, each twice as far away as the one before.
    pub(crate) fn dip(&self) -> f64 {
        let singularity = self.density.kernel.singularity();
        let width = self.window[1] - self.window[0];
        if width == 0.0 {
            return 0.0;
        }
        let mut distance = VICINITY * width;
        let mut dip = self.differs(distance) * nearby(singularity, width, VICINITY + 1.0);
        while distance < FARTHEST {
            let slopes = match singularity {
                Singularity::Logarithm => std::f64::consts::LN_2,
                Singularity::Power(mu) => distance.powf(-mu) * (1.0 - 0.5f64.powf(mu)),
            };
            distance *= 2.0;
            dip += self.differs(distance) * 2.0 * width * slopes;
        }
        dip
    }

    /// By how much the density differs from the constant within a distance of the window, also where it repeats.
    fn differs(&self, distance: f64) -> f64 {
        let [left, right] = [self.window[0] - distance, self.window[1] + distance];
        let within = [left.max(self.zone[0]), right.min(self.zone[1])];
        let mut most = self.negative;
        if !self.panels.is_empty() {
            most += density_variation(self.density, within);
        }
        let images: &[f64] = match self.density.kernel {
            Kernel::Row { period } => &[0.0, -period, period],
            Kernel::Logarithm
            | Kernel::ShiftedLogarithm { .. }
            | Kernel::Layered(_)
            | Kernel::Power { .. } => &[0.0],
        };
        for (index, panel) in self.density.panels.iter().enumerate() {
            let is_own = self.panels.contains(&index);
            let touches = |image: f64| panel.left + image < right && panel.right + image > left;
            if images.iter().any(|image| (!is_own || *image != 0.0) && touches(*image)) {
                let mean = if is_own { self.constant } else { 0.0 };
                most = most.max((panel.coefficients[0] - mean).abs() + panel.swing);
            }
        }
        most
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::legendre::{ORDER, RULE};

    /// Panels of `value` on zones, the finer the nearer to their ends.
    fn panels(zones: &[[f64; 2]], value: impl Fn(f64) -> f64) -> Vec<Panel> {
        let halvings = |[left, right]: [f64; 2]| {
            let middle = 0.5 * (left + right);
            let shares: Vec<f64> =
                std::iter::once(0.0).chain((0..40).rev().map(|k| 0.5f64.powi(k))).collect();
            let rising: Vec<f64> =
                shares.iter().map(|share| left + share * (middle - left)).collect();
            let falling =
                shares.into_iter().rev().skip(1).map(move |share| right - share * (right - middle));
            rising.into_iter().chain(falling).collect::<Vec<f64>>()
        };
        let ends = zones.iter().map(|zone| halvings(*zone));
        let pairs = ends
            .flat_map(|ends| ends.windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>());
        let panel = |[left, right]: [f64; 2]| {
            let at = |t: &f64| value(0.5 * (left + right) + 0.5 * (right - left) * t);
            let values: Vec<f64> = RULE.nodes.iter().map(at).collect();
            Panel::new(left, right, RULE.expand(&<[f64; ORDER]>::try_from(values).unwrap()))
        };
        pairs.map(panel).collect()
    }

    /// Potentials between two places are compared with those at both.
    #[test]
    fn potentials_dip_no_deeper() {
        let kernels = [
            Kernel::Logarithm,
            Kernel::Row { period: 2.0 },
            Kernel::Power { exponent: 0.3 },
            Kernel::Power { exponent: 0.7 },
        ];
        let densities: [fn(f64) -> f64; 4] =
            [|_| 1.0, |x| 1.3 + (3.0 * x).sin(), |x| 0.4 - x, |x| 1.0 - (x - 0.25).abs().powf(0.4)];
        let mut most = 0.0f64;
        for kernel in kernels {
            for (index, value) in densities.into_iter().enumerate() {
                for zones in [&[[-1.0, 1.0]][..], &[[-1.0, -0.2], [-0.1, 0.25], [0.25, 0.9]]] {
                    let density = Density::new(kernel, panels(zones, value));
                    let potential = |x: f64| density.potential(x).0;
                    for [from, to] in
                        [[-1.0, -0.9], [0.25, 0.3], [0.2, 0.25], [0.85, 0.9], [0.4, 0.41]]
                    {
                        for width in [1e-3, 1e-6, 1e-9] {
                            let steady = |x: f64| Steady::new(&density, [x, x + width]).unwrap();
                            for share in [0.0, 0.5, 1.0] {
                                let x = from + share * (to - from - width);
                                let dip = steady(x).dip();
                                let least = potential(x).min(potential(x + width));
                                let deepest = (1..20)
                                    .map(|k| least - potential(x + width * f64::from(k) / 20.0))
                                    .fold(f64::NEG_INFINITY, f64::max);
                                most = most.max((deepest - 1e-14) / dip);
                                assert!(
                                    deepest <= dip + 1e-14,
                                    "{kernel:?} {index} {x} {width}: {deepest:e} {dip:e}"
                                );
                                if index == 0 && zones.len() == 1 && kernel != kernels[1] {
                                    assert!(dip <= 1e-13 * width, "{kernel:?} {x}: {dip:e}");
                                }
                            }
                        }
                    }
                }
            }
        }
        assert!(most > 1e-3, "the bound is idle: {most:e}");
    }
}

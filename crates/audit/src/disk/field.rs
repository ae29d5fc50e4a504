//! The residual of one harmonic.

use super::kernel::mass;
use super::potential::Radial;
use super::{DiskProblem, UNIT};
use crate::between::Pressing;
use crate::layer;
use crate::profile::Profile;
use crate::sample::{compared, is_short};
use crate::sampled::Field;

/// A harmonic of the pressure, as the answer has it and on panels.
pub(super) struct Resampled<'a> {
    pub(super) density: Radial,
    own: Box<dyn Fn(f64) -> f64 + Sync + 'a>,
    /// What was added to the answer's at most, so that it carries its load.
    changed: f64,
    /// Force or moment.
    total: f64,
}

impl<'a> Resampled<'a> {
    pub(super) fn new(
        density: Radial,
        own: Box<dyn Fn(f64) -> f64 + Sync + 'a>,
        changed: f64,
        total: f64,
    ) -> Self {
        Self { density, own, changed, total }
    }

    /// What the panels miss of the pressure between the nodes where they resolve it, and an estimate of its potential: it changes its sign on each, so that squares are added.
    fn misfit(&self, exponent: f64) -> [f64; 2] {
        let (mut most, mut squares) = (0.0f64, 0.0);
        for panel in self.density.panels() {
            let missed =
                compared(panel, &*self.own).iter().fold(0.0f64, |most, (.., off)| most.max(*off));
            // At the places where the residual is formed the pressure is the answer's own.
            most = most.max(if is_short(panel) { 0.0 } else { missed });
            squares += (missed * ring(2.0 * panel.half(), exponent)).powi(2);
        }
        [most, squares.sqrt()]
    }
}

/// A bound of the potential of a density of size one on a ring of this width.
pub(super) fn ring(width: f64, exponent: f64) -> f64 {
    let whole = mass(exponent);
    let narrow = if exponent == 0.0 {
        width * (6.0 + 2.0 * width.ln().abs())
    } else {
        whole * 4.0 * width.powf(1.0 - exponent)
    };
    whole.min(narrow)
}

/// A harmonic with its residual `w = q^kappa + theta K q - (delta - alpha r - f)`.
pub(super) struct Part<'a> {
    pub(super) density: Radial,
    pub(super) settlement: f64,
    pub(super) tilt: f64,
    pub(super) total: f64,
    /// A bound of `int K s ds`.
    pub(super) mass: f64,
    own: Box<dyn Fn(f64) -> f64 + Sync + 'a>,
    profile: Option<&'a dyn Profile>,
    theta: f64,
    layer: f64,
    scaled: f64,
    is_bilateral: bool,
    changed: f64,
    misfit: f64,
    /// Rounding of the pressure that both harmonics were taken from, where this one is small beside it.
    rounding: f64,
}

impl<'a> Part<'a> {
    pub(super) fn new(
        problem: &DiskProblem<'a>,
        resampled: Resampled<'a>,
        [settlement, tilt]: [f64; 2],
        profile: Option<&'a dyn Profile>,
        rounding: f64,
    ) -> Self {
        let [missed, misfit] = resampled.misfit(problem.exponent);
        Self {
            mass: mass(problem.exponent),
            settlement,
            tilt,
            total: resampled.total,
            density: resampled.density,
            own: resampled.own,
            profile,
            theta: problem.theta,
            layer: problem.layer,
            scaled: problem.scaled,
            is_bilateral: problem.is_bilateral,
            changed: resampled.changed + missed,
            misfit,
            rounding,
        }
    }

    /// How far the pressure that was judged is from that of the answer.
    pub(super) fn changed(&self) -> f64 {
        self.changed
    }

    /// `q(r)` of the answer, in a zone.
    fn own(&self, r: f64) -> f64 {
        let index = self.density.panels().partition_point(|panel| panel.right < r);
        let is_inside = self.density.panels().get(index).is_some_and(|panel| panel.left <= r);
        if is_inside { (self.own)(r) } else { 0.0 }
    }

    /// `[int w u r dr, int u^2 r dr]` by the middles of the panels.
    pub(super) fn mean(&self, u: &dyn Fn(f64) -> f64) -> [f64; 2] {
        let mut sums = [0.0; 2];
        for panel in self.density.panels() {
            let r = panel.middle();
            let weight = (panel.right - panel.left) * r;
            sums[0] += weight * u(r) * self.residual(r).0;
            sums[1] += weight * u(r) * u(r);
        }
        sums
    }

    /// A bound of a constant whose norm is this where both pressures are positive: on the panels where the pressure is firm but for what it may have lost of them.
    pub(super) fn firm(&self, norm: f64, is_bilateral: bool) -> f64 {
        let area = |least: f64| -> f64 {
            let panels = self.density.panels().iter();
            let firm = panels.filter(|panel| panel.coefficients[0] - panel.swing >= least);
            let areas = firm.map(|panel| panel.right * panel.right - panel.left * panel.left);
            std::f64::consts::PI * areas.sum::<f64>()
        };
        if is_bilateral {
            return norm / area(f64::NEG_INFINITY).sqrt();
        }
        let largest = self.density.panels().iter().fold(0.0f64, |most, p| most.max(p.largest));
        let known = (1..40).map(|k| {
            let least = largest * 0.5f64.powi(k);
            norm / (area(least) - (norm / least).powi(2)).max(0.0).sqrt()
        });
        known.filter(|bound| !bound.is_nan()).fold(f64::INFINITY, f64::min)
    }
}

impl Field for Part<'_> {
    fn residual(&self, r: f64) -> (f64, f64) {
        let q = self.own(r);
        // What pulls by rounding is cut off.
        let q = if self.is_bilateral || self.profile.is_none() { q } else { q.max(0.0) };
        let layer = layer::displacement(self.layer, q);
        let (potential, rounding) = self.density.potential(r);
        let [low, high] = self.profile.map_or([0.0; 2], |profile| profile.height(r));
        let height = 0.5 * (low + high);
        let value = layer + self.theta * potential - (self.settlement - self.tilt * r - height);
        let given = self.settlement.abs() + self.tilt.abs() * r + height.abs();
        let size = 4.0 * (layer.abs() + self.theta * potential.abs() + given);
        let scaled = self.scaled * (self.theta * potential.abs() + given);
        let noise = self.theta * (rounding + self.misfit) + self.rounding;
        (value, noise + 0.5 * (high - low) + UNIT * size + scaled)
    }

    /// What the potential falls below that at both ends is left out.
    fn presses(&self, window: [f64; 2]) -> f64 {
        let Self { theta, settlement, tilt, scaled, .. } = *self;
        let Some(base) = self.profile else { return f64::NEG_INFINITY };
        let potentials = window.map(|r| self.density.potential(r));
        Pressing { base, theta, settlement, tilt, scaled }.most(window, potentials, 0.0)
    }

    fn looks(&self) -> u64 {
        self.density.looks()
    }

    fn count(&self, looks: u64) {
        self.density.count(looks);
    }

    fn profile(&self) -> Option<&dyn Profile> {
        self.profile
    }
}

//! The stress field below a pressure.

use std::f64::consts::PI;

use super::complex::Complex;
use super::panel::{Panel, Potential, SEAM, Seen};
use super::sampling::Effort;
use super::{Stress, sampling};
use crate::Error;
use crate::error::{finite, require};

/// Distances from an end of a panel, relative to its length, that count as the end.
const AT_END: f64 = 1e-18;
/// Distances beyond this, relative to that of the farthest panel from the origin, are taken as this: stresses are below `1e-100` of the pressure there, and the cube does not overflow.
const FARTHEST: f64 = 1e100;
/// Depths below this, relative to the shortest panel, are taken as this.
const LEAST_DEPTH: f64 = 1e-16;

/// Stresses in the homogeneous half-plane `y > 0` under a normal pressure `p(s)` without friction, plane strain, tension positive.
///
/// With `F(z) = int p(s)/(z - s) ds`, `z = x + i y`, `y` the depth:
///
/// `sigma_x + sigma_y = (2/pi) Im F`, `sigma_x - sigma_y = (2y/pi) Re F'`, `tau_xy = -(y/pi) Im F'`, `sigma_z = nu (sigma_x + sigma_y)`.
///
/// For a pressure repeated with the period `L`, `F(z) = (pi/L) int p(s) cot(pi (z - s)/L) ds`. Exact to rounding at any depth, see the
/// book; on the surface `sigma_x = sigma_y = -p`.
#[derive(Debug, Clone)]
pub struct StressField {
    panels: Vec<Panel>,
    period: Option<f64>,
    /// Whether the panels fill the period.
    is_closed: bool,
    poisson_ratio: f64,
    /// Units of length and stress: all inside is without dimensions.
    pub(super) units: [f64; 2],
    shortest: f64,
    farthest: f64,
    error: f64,
}

impl StressField {
    /// The field of `pressure(panel, distance from its left end, distance from its right end)` on panels `[left, right]` from left to right.
    ///
    /// On each panel the pressure must be smooth inside: cut at kinks and steps. At the ends it may jump, vanish like any power of the distance, or grow like one above -1: it
    /// is asked at distances down to `1e-33` of the length, and at 0, where it may be infinite. `period` repeats all panels.
    /// Nodes are doubled until two sets of them agree to `2e-14` of the mean pressure or rounding is met: see [`StressField::error`].
    ///
    /// ```
    /// use shtaerman::StressField;
    ///
    /// // Hertz: the largest shear stress is 0.300283 p0 at the depth 0.786151 a.
    /// let pressure = |_: usize, left: f64, right: f64| (left * right).sqrt();
    /// let field = StressField::from_pressure(&[[-1.0, 1.0]], None, 0.3, pressure)?;
    /// let shear = field.stress(0.0, 0.786151)?.max_shear();
    /// assert!((shear - 0.300283).abs() < 5e-7);
    /// # Ok::<(), shtaerman::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for panels that are empty, overlap, or exceed the period, and for a Poisson's ratio beyond `(-1, 0.5]`;
    /// [`Error::Overflow`] for a pressure that is not finite inside a panel.
    pub fn from_pressure(
        panels: &[[f64; 2]],
        period: Option<f64>,
        poisson_ratio: f64,
        pressure: impl Fn(usize, f64, f64) -> f64,
    ) -> Result<Self, Error> {
        Self::within(panels, period, poisson_ratio, Effort::FULL, &pressure)
    }

    /// The same with a given effort.
    pub(super) fn within(
        panels: &[[f64; 2]],
        period: Option<f64>,
        poisson_ratio: f64,
        effort: Effort,
        pressure: &dyn Fn(usize, f64, f64) -> f64,
    ) -> Result<Self, Error> {
        require(
            poisson_ratio > -1.0 && poisson_ratio <= 0.5,
            "poisson_ratio",
            poisson_ratio,
            "greater than -1 and at most 0.5",
        )?;
        check(panels, period)?;
        let (mut panels, error) = sampling::resolved(panels, period, effort, pressure)?;
        let is_closed = is_closed(&panels, period);
        if is_closed {
            Panel::close(&mut panels);
        }
        let shortest = panels.iter().map(Panel::length).fold(f64::INFINITY, f64::min);
        let reach = panels.iter().map(|panel| panel.left.abs().max(panel.right.abs()));
        let farthest = FARTHEST * reach.fold(0.0, f64::max);
        Ok(Self {
            panels,
            period,
            is_closed,
            poisson_ratio,
            units: [1.0; 2],
            shortest,
            farthest,
            error,
        })
    }

    /// The same field in units of length and stress.
    pub(super) fn in_units(mut self, length: f64, stress: f64) -> Self {
        self.units = [length, stress];
        self
    }

    /// Adds the error of the pressure itself, in the units of the field.
    pub(super) fn with_pressure_error(mut self, error: f64) -> Self {
        self.error += error;
        self
    }

    /// Poisson's ratio.
    #[must_use]
    pub fn poisson_ratio(&self) -> f64 {
        self.poisson_ratio
    }

    /// The period of a pressure that is repeated.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        self.period.map(|period| period * self.units[0])
    }

    /// The panels, from left to right.
    #[must_use]
    pub fn panels(&self) -> Vec<[f64; 2]> {
        let scaled = |x: f64| x * self.units[0];
        self.panels.iter().map(|panel| [scaled(panel.left), scaled(panel.right)]).collect()
    }

    /// The zones of contact: panels that touch are one.
    #[must_use]
    pub fn zones(&self) -> Vec<[f64; 2]> {
        let mut zones: Vec<[f64; 2]> = Vec::new();
        for [left, right] in self.panels() {
            match zones.last_mut() {
                Some(last) if last[1] == left => last[1] = right,
                _ => zones.push([left, right]),
            }
        }
        zones
    }

    /// The ends of panels under which the pressure, and with it the stress, is infinite, from left to right.
    #[must_use]
    pub fn infinite_corners(&self) -> Vec<f64> {
        let ends = |panel: &Panel| [(panel.left, panel.ends[0]), (panel.right, panel.ends[1])];
        let infinite = self.panels.iter().flat_map(ends).filter(|(_, p)| p.is_infinite());
        let mut places: Vec<f64> = infinite.map(|(x, _)| x * self.units[0]).collect();
        places.dedup();
        places
    }

    /// Number of nodes that a stress is summed over.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.panels.iter().map(Panel::nodes).sum()
    }

    /// The estimated error of a stress: the largest difference of two independent sets of nodes at test points down to the surface, over all panels, and for a
    /// contact the error of its pressure. Near a corner with infinite pressure it is meant relative to the local stress.
    #[must_use]
    pub fn error(&self) -> f64 {
        self.error * self.units[1]
    }

    /// `P`, per unit length; of a periodic pressure per period.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.panels.iter().map(Panel::force).sum::<f64>() * self.units[0] * self.units[1]
    }

    /// The pressure at `x`: zero beside the panels, perhaps infinite at the end of one.
    #[must_use]
    pub fn pressure(&self, x: f64) -> f64 {
        self.surface(x / self.units[0]) * self.units[1]
    }

    /// The stress at `x` and `depth`. On the surface `-p` in both directions; at the end of a panel with a jump of the pressure, where the limit depends on
    /// the direction, the larger `p` of both sides is taken; under an infinite corner it is infinite. Depths less than `1e-16` of the shortest panel
    /// count as that, and so do distances beyond `1e100` of the farthest end of a panel.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless `x` is finite and `depth` is finite and not negative.
    pub fn stress(&self, x: f64, depth: f64) -> Result<Stress, Error> {
        finite("x", x)?;
        require(depth >= 0.0 && depth.is_finite(), "depth", depth, "finite and not negative")?;
        let [length, stress] = self.units;
        Ok(self.stress0(x / length, depth / length).scaled(stress))
    }

    pub(super) fn stress0(&self, x: f64, depth: f64) -> Stress {
        if depth == 0.0 {
            let pressure = self.surface(x);
            return self.assembled([-2.0 * pressure, 0.0, 0.0]);
        }
        let depth = depth.clamp(LEAST_DEPTH * self.shortest, self.farthest);
        let x = x.clamp(-self.farthest, self.farthest);
        let potential = self.potential::<false>(x, depth);
        self.assembled(parts(&potential, depth))
    }

    /// From `sigma_x + sigma_y`, `sigma_x - sigma_y` and `tau_xy`.
    fn assembled(&self, [sum, difference, shear]: [f64; 3]) -> Stress {
        Stress {
            sigma_x: 0.5 * (sum + difference),
            sigma_y: 0.5 * (sum - difference),
            sigma_z: if self.poisson_ratio == 0.0 { 0.0 } else { self.poisson_ratio * sum },
            tau_xy: shear,
        }
    }

    pub(super) fn potential<const CUBES: bool>(&self, x: f64, depth: f64) -> Potential {
        let x = self.reduced(x);
        let mut sum = [Complex::ZERO; 3];
        for panel in &self.panels {
            let part = panel.potential::<CUBES>(panel.seen(x, depth));
            sum = [0, 1, 2].map(|i| sum[i] + part[i]);
        }
        sum
    }

    /// The same place in the period about the middle of all panels.
    pub(super) fn reduced(&self, x: f64) -> f64 {
        let [Some(first), Some(last)] = [self.panels.first(), self.panels.last()] else {
            return x;
        };
        let [left, right] = [first.left, last.right];
        match self.period {
            Some(period) if !(left..=right).contains(&x) => {
                let x = x - period * ((x - left.midpoint(right)) / period).round();
                if self.is_closed { x.clamp(left, right) } else { x }
            }
            _ => x,
        }
    }

    /// `p` at `x`.
    pub(super) fn surface(&self, x: f64) -> f64 {
        let x = self.reduced(x);
        let mut pressure = 0.0f64;
        for panel in &self.panels {
            let Seen { from_left, to_right, .. } = panel.seen(x, 0.0);
            let slack = AT_END * panel.length();
            let found = if from_left.abs() <= slack {
                panel.ends[0]
            } else if to_right.abs() <= slack {
                panel.ends[1]
            } else if from_left > 0.0 && to_right > 0.0 {
                self.inside(panel, x)
            } else {
                continue;
            };
            if found.abs() > pressure.abs() {
                pressure = found;
            }
        }
        pressure
    }

    /// `p = -Im F/pi` on the panel itself.
    pub(super) fn inside(&self, panel: &Panel, x: f64) -> f64 {
        -panel.potential::<false>(panel.seen(x, 0.0))[0].im / PI
    }

    pub(super) fn inner(&self) -> &[Panel] {
        &self.panels
    }

    pub(super) fn is_closed(&self) -> bool {
        self.is_closed
    }

    pub(super) fn inner_period(&self) -> Option<f64> {
        self.period
    }
}

/// Whether the panels fill their period.
fn is_closed(panels: &[Panel], period: Option<f64>) -> bool {
    let ends = panels.first().zip(panels.last());
    ends.zip(period).is_some_and(|((first, last), period)| {
        (last.right - first.left - period).abs() <= SEAM * period
    })
}

/// `sigma_x + sigma_y`, `sigma_x - sigma_y`, `tau_xy`.
pub(super) fn parts([value, first, _]: &Potential, depth: f64) -> [f64; 3] {
    let unit = 2.0 / PI;
    [unit * value.im, unit * depth * first.re, -0.5 * unit * depth * first.im]
}

fn check(panels: &[[f64; 2]], period: Option<f64>) -> Result<(), Error> {
    require(!panels.is_empty(), "number of panels", 0.0, "at least 1")?;
    let mut before = f64::NEG_INFINITY;
    for &[left, right] in panels {
        finite("panel", left)?;
        finite("panel", right)?;
        require(left >= before, "panel", left, "to the right of the one before")?;
        require(right - left > f64::MIN_POSITIVE, "panel", right, "longer than nothing")?;
        before = right;
    }
    if let Some(period) = period {
        let reach = before - panels[0][0];
        let fits = period.is_finite() && reach <= period * (1.0 + SEAM);
        require(fits, "period", period, "finite and at least as long as all panels")?;
    }
    Ok(())
}

//! A solution on the half-line, which can be evaluated up to where it was asked for.

use super::map::Map;
use super::section::{Nodal, Section};
use crate::collocation::solution::sine_of_turns;
use crate::kernel::MacdonaldHalfLine;

/// A point this close to a node, in steps, is that node.
const AT_NODE: f64 = 1e-13;
/// Sharpness of the fade of the interpolated function: `erfc` of it is rounding.
const SHARPNESS: f64 = 6.0;

/// The solution of `phi + lambda int_0^inf K phi ds = f` for `0 <= x <= x_max`.
///
/// Between the nodes `U = K phi` is interpolated: `v_j = (U_j - U(0)) chi(x_j)` with a smooth `chi` that is 1 up to `x_max` and fades before the end
/// of the section, `tau = t(x)/h`, and
///
/// `U(x) = U(0) + (sin(pi tau)/pi) sum_j (-1)^j v_j/(tau - j)`.
#[derive(Debug, Clone)]
pub struct HalfLineSolution {
    pub(super) map: Map,
    step: f64,
    left: usize,
    decay: f64,
    end: f64,
    parameter: f64,
    /// `K phi` over the potential of the kernel with `kappa = 1`.
    scale: f64,
    origin: f64,
    /// `(-1)^j v_j`.
    bubble: Vec<f64>,
    pub(super) integral: Option<f64>,
    pub(super) estimate: HalfLineEstimate,
    pub(super) converged: bool,
    pub(super) count: usize,
    section: f64,
}

/// Estimates of the errors of a [`HalfLineSolution`]: likely, not guaranteed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HalfLineEstimate {
    /// Of the largest error of the solution for `0 <= x <= x_max`, both parts and rounding together.
    pub solution: f64,
    /// The part of it that comes from the number of nodes.
    pub nodes: f64,
    /// The part of it that comes from the end of the section.
    pub section: f64,
    /// Of the error of the integral; infinite where there is none.
    pub integral: f64,
}

impl HalfLineSolution {
    pub(super) fn new(
        section: &Section,
        nodal: &Nodal,
        kernel: &MacdonaldHalfLine,
        parameter: f64,
        [x_max, end, length]: [f64; 3],
    ) -> Self {
        let decay = kernel.decay();
        let (middle, half) = (0.5 * (length + end), 0.5 * (length - end));
        let mut sign = if section.left.is_multiple_of(2) { 1.0 } else { -1.0 };
        let bubble = section.positions.iter().zip(&nodal.potential).map(|(x, u)| {
            let fade = 0.5 * libm::erfc(SHARPNESS * (x - middle) / half);
            let value = sign * (u - nodal.at_origin) * fade;
            sign = -sign;
            value
        });
        Self {
            map: section.map,
            step: section.step,
            left: section.left,
            decay,
            end: x_max,
            parameter,
            scale: kernel.unit_scale(),
            origin: nodal.at_origin,
            bubble: bubble.collect(),
            integral: None,
            estimate: HalfLineEstimate {
                solution: f64::INFINITY,
                nodes: f64::INFINITY,
                section: f64::INFINITY,
                integral: f64::INFINITY,
            },
            converged: false,
            count: section.positions.len(),
            section: length / decay,
        }
    }

    /// `lambda`.
    #[must_use]
    pub fn parameter(&self) -> f64 {
        self.parameter
    }

    /// `x_max`, up to which the solution can be evaluated.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.end
    }

    /// `phi(x)` for `0 <= x <= x_max`, given `f(x)`; NaN elsewhere, where nothing is known.
    #[must_use]
    pub fn evaluate(&self, x: f64, right_hand_side: f64) -> f64 {
        right_hand_side - self.parameter * self.evaluate_potential(x)
    }

    /// `int_0^inf K(x, s) phi(s) ds` for `0 <= x <= x_max`; NaN elsewhere.
    #[must_use]
    pub fn evaluate_potential(&self, x: f64) -> f64 {
        if !(0.0..=self.end).contains(&x) {
            return f64::NAN;
        }
        let x = self.decay * x;
        if x < f64::MIN_POSITIVE {
            return self.scale * self.origin;
        }
        self.scale * (self.origin + self.interpolate(self.map.inverse(x)))
    }

    /// `int_0^inf phi dx`; `None` where the integral of `f` does not converge, or so slowly that no quadrature shows it.
    #[must_use]
    pub fn integral(&self) -> Option<f64> {
        self.integral
    }

    /// Estimates of the errors.
    #[must_use]
    pub fn estimate(&self) -> &HalfLineEstimate {
        &self.estimate
    }

    /// Whether the estimates meet the tolerance; if not, this is the best that was reached.
    #[must_use]
    pub fn converged(&self) -> bool {
        self.converged
    }

    /// Number of nodes.
    #[must_use]
    pub fn node_count(&self) -> usize {
        self.count
    }

    /// Length of the section of the half-line that was solved, beyond `x_max` by 46 decay lengths or more.
    #[must_use]
    pub fn section(&self) -> f64 {
        self.section
    }

    /// Step of `t`.
    pub(super) fn step(&self) -> f64 {
        self.step
    }

    /// Points midway between the nodes, up to `x_max`.
    pub(super) fn midway(&self) -> impl Iterator<Item = f64> + '_ {
        (0..self.count)
            .map(|j| self.map.at((j as f64 + 0.5 - self.left as f64) * self.step).position)
            .map(|x| x / self.decay)
            .take_while(|x| *x <= self.end)
    }

    fn interpolate(&self, t: f64) -> f64 {
        let tau = t / self.step;
        let nearest = tau.round();
        // Whole numbers apart from the small offset: next to a node the quotient must be as accurate as the sine.
        let (offset, place) = (tau - nearest, nearest + self.left as f64);
        if offset.abs() < AT_NODE {
            let sign = if nearest % 2.0 == 0.0 { 1.0 } else { -1.0 };
            return self.bubble.get(place as usize).map_or(0.0, |v| sign * v);
        }
        let sum: f64 = (self.bubble.iter().enumerate())
            .map(|(index, value)| value / (offset + (place - index as f64)))
            .sum();
        sum * sine_of_turns(tau, nearest)
    }
}

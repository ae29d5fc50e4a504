//! The equivalent stresses that a maximum is looked for of, with their gradients.

use std::f64::consts::PI;

use serde::Serialize;

use super::field::parts;
use super::{Stress, StressField};

/// A criterion of yield.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Criterion {
    /// Yield where [`Stress::von_mises`] reaches the yield stress.
    VonMises,
    /// Yield where [`Stress::tresca`], twice the largest shear stress, reaches the yield stress.
    Tresca,
}

impl Criterion {
    /// The equivalent stress.
    #[must_use]
    pub fn of(self, stress: &Stress) -> f64 {
        match self {
            Self::VonMises => stress.von_mises(),
            Self::Tresca => stress.tresca(),
        }
    }

    /// The same from `sigma_x + sigma_y` and the radius of Mohr's circle.
    pub(super) fn of_parts(self, sum: f64, radius: f64, poisson_ratio: f64) -> f64 {
        let across = (0.5 - poisson_ratio) * sum.abs();
        match self {
            Self::VonMises => (3.0 * radius * radius + across * across).sqrt(),
            Self::Tresca => (2.0 * radius).max(radius + across),
        }
    }
}

impl StressField {
    /// The equivalent stress and its gradient, without dimensions; for Tresca those of the larger branch.
    pub(super) fn slope(&self, criterion: Criterion, [x, y]: [f64; 2]) -> (f64, [f64; 2]) {
        let potential = self.potential::<true>(x, y);
        let [sum, difference, shear] = parts(&potential, y);
        let [_, first, second] = potential;
        let unit = 2.0 / PI;
        // F is analytic: d/dy = i d/dx.
        let sum_slope = [unit * first.im, unit * first.re];
        let difference_slope = [unit * y * second.re, unit * (first.re - y * second.im)];
        let shear_slope = [-0.5 * unit * y * second.im, -0.5 * unit * (first.im + y * second.re)];
        let radius = (0.5 * difference).hypot(shear);
        // Half of the gradient of the radius squared.
        let square_slope =
            [0, 1].map(|i| 0.25 * difference * difference_slope[i] + shear * shear_slope[i]);
        let factor = 0.5 - self.poisson_ratio();
        let value = criterion.of_parts(sum, radius, self.poisson_ratio());
        let slope = match criterion {
            Criterion::VonMises => [0, 1].map(|i| {
                (3.0 * square_slope[i] + factor * factor * sum * sum_slope[i])
                    / value.max(f64::MIN_POSITIVE)
            }),
            Criterion::Tresca => {
                let radius_slope = square_slope.map(|part| part / radius.max(f64::MIN_POSITIVE));
                let across = factor * sum.abs();
                if radius >= across {
                    radius_slope.map(|part| 2.0 * part)
                } else {
                    [0, 1].map(|i| radius_slope[i] + factor * sum.signum() * sum_slope[i])
                }
            }
        };
        (value, slope)
    }

    pub(super) fn equivalent(&self, criterion: Criterion, [x, y]: [f64; 2]) -> f64 {
        criterion.of(&self.stress0(x, y))
    }
}

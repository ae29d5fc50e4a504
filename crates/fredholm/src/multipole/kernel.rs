//! The kernels that panels serve: their values, their means over intervals, and their moments over a panel.

use std::f64::consts::{FRAC_PI_2, PI};

use super::on_panel::OnPanel;
use super::rings::Rings;
use super::rule::logarithm_moments;
use crate::Error;
use crate::complementarity::{mean_logarithm, mean_power};
use crate::special::{logarithms, powers, sines_of_half_turns};

/// Beyond this many half-lengths from the middle moments of a power are computed downwards, and the decimals in the logarithm of what that leaves out.
const FORWARD: f64 = 1.05;
const DIGITS: f64 = 37.0;
/// Gauss's rule of three nodes for means.
const GAUSS_NODE: f64 = 0.774_596_669_241_483_4;
const GAUSS_WEIGHTS: [f64; 2] = [5.0 / 18.0, 4.0 / 9.0];
/// Below this angle the series of `ln(y/sin y)` in squares leaves out less than rounding after these terms (theory).
const SMALL_ANGLE: f64 = 0.125;
const RATIO: [f64; 6] = [
    1.0 / 6.0,
    1.0 / 180.0,
    1.0 / 2835.0,
    1.0 / 37_800.0,
    1.0 / 467_775.0,
    691.0 / 3_831_077_250.0,
];
const LOGARITHM_OF_PI: f64 = 1.144_729_885_849_400_2;
/// Most moments.
const MOST: usize = super::rule::MOST;

/// A kernel `K(x - s)` on `[-1, 1]`, or that of rings on `[0, 1]`.
#[derive(Debug, Clone, PartialEq)]
pub enum PanelKernel {
    /// `ln 1/|x - s|`.
    Logarithm,
    /// `ln 1/(2 sin(pi |x - s|/2))`: the logarithm on a circle of which `[-1, 1]` is the whole turn.
    Sine,
    /// `|x - s|^-mu`.
    Power {
        /// `mu`, between 0 and 1.
        exponent: f64,
    },
    /// [Rings] about an axis.
    Ring(Rings),
}

impl PanelKernel {
    pub(super) fn check(&self) -> Result<(), Error> {
        match *self {
            Self::Power { exponent } if !(exponent > 0.0 && exponent < 1.0) => {
                Err(Error::InvalidParameter {
                    name: "exponent of a kernel",
                    value: exponent,
                    requirement: "between 0 and 1",
                })
            }
            _ => Ok(()),
        }
    }

    /// `K(d)` for a distance that is not zero; of rings about an axis what it begins with at their own places.
    #[must_use]
    pub fn value(&self, d: f64) -> f64 {
        match *self {
            Self::Ring(ref rings) if rings.exponent() > 0.0 => d.abs().powf(-rings.exponent()),
            Self::Logarithm | Self::Ring(_) => -d.abs().ln(),
            Self::Sine => -(2.0 * (FRAC_PI_2 * self.shortest(d)).sin().abs()).ln(),
            Self::Power { exponent } => d.abs().powf(-exponent),
        }
    }

    /// `dK/dx`, and zero at the place itself.
    pub(super) fn slope(&self, x: f64, s: f64) -> f64 {
        self.slope_across(x, s, self.shortest(x - s))
    }

    /// The same given the difference of both places.
    pub(super) fn slope_across(&self, x: f64, s: f64, d: f64) -> f64 {
        match *self {
            _ if d == 0.0 => 0.0,
            Self::Ring(ref rings) => rings.slope_across(x, s, d),
            Self::Logarithm => -1.0 / d,
            Self::Sine => -FRAC_PI_2 / (FRAC_PI_2 * d).tan(),
            Self::Power { exponent } => -exponent * d.abs().powf(-exponent) / d,
        }
    }

    /// How far apart two places are, and by what a value for that is to be multiplied.
    pub(super) fn apart(&self, x: f64, s: f64) -> [f64; 2] {
        match *self {
            Self::Ring(ref rings) => rings.apart(x, s, x - s),
            _ => [x - s, 1.0],
        }
    }

    /// Replaces [distances](Self::apart), none of them zero, by the kernel.
    pub(super) fn values(&self, distances: &mut [f64]) {
        match *self {
            Self::Ring(ref rings) => return rings.values(distances),
            Self::Logarithm => distances.iter_mut().for_each(|d| *d = d.abs()),
            Self::Sine => {
                sines_of_half_turns(distances);
                distances.iter_mut().for_each(|d| *d *= 2.0);
            }
            Self::Power { exponent } => {
                distances.iter_mut().for_each(|d| *d = d.abs());
                return powers(distances, -exponent);
            }
        }
        logarithms(distances);
        distances.iter_mut().for_each(|value| *value = -*value);
    }

    /// The kernel of rings, where places are distances from an axis.
    #[inline(always)]
    pub(super) fn rings(&self) -> Option<&Rings> {
        match self {
            Self::Ring(rings) => Some(rings),
            _ => None,
        }
    }

    /// `mu` of a power, 0 of logarithms.
    pub(super) fn exponent(&self) -> f64 {
        match *self {
            Self::Logarithm | Self::Sine => 0.0,
            Self::Power { exponent } => exponent,
            Self::Ring(ref rings) => rings.exponent(),
        }
    }

    /// Whether the ends of `[-1, 1]` are one place.
    pub(super) fn is_closed(&self) -> bool {
        *self == Self::Sine
    }

    /// A difference of two places by the shorter way.
    pub(super) fn shortest(&self, d: f64) -> f64 {
        if self.is_closed() { d - 2.0 * (0.5 * d).round() } else { d }
    }

    /// What is left of the kernel without the part that [`Self::moments`] has.
    pub(super) fn remainder(&self, d: f64) -> f64 {
        match *self {
            Self::Sine => {
                let angle = FRAC_PI_2 * self.shortest(d).abs();
                if angle < SMALL_ANGLE {
                    let square = angle * angle;
                    let sum = RATIO.iter().rev().fold(0.0, |sum, c| square * (c + sum));
                    return sum - LOGARITHM_OF_PI;
                }
                -(PI * angle.sin() / angle).ln()
            }
            _ => 0.0,
        }
    }

    /// The entry of a node near to a place: with what the [moments](Self::moments) make of it, what is added to the kernel on its panel, and its weight.
    #[inline(always)]
    pub(super) fn entry(&self, (x, node): (f64, f64), exact: f64, added: f64, weight: f64) -> f64 {
        match *self {
            Self::Ring(ref rings) => {
                let [singular, rest] = rings.parts(x, node);
                singular * (exact * node + added * weight) + rest * weight
            }
            _ => exact + (added + self.remainder(x - node)) * weight,
        }
    }

    /// `int_{-1}^{1} K(z - y) P_k(y) dy` at a place, without the remainder.
    pub(super) fn moments(&self, place: OnPanel, moments: &mut [f64]) {
        match *self {
            Self::Ring(ref rings) if rings.exponent() > 0.0 => {
                power_moments(rings.exponent(), place, moments);
            }
            Self::Logarithm | Self::Sine | Self::Ring(_) => logarithm_moments(place, moments),
            Self::Power { exponent } => power_moments(exponent, place, moments),
        }
    }

    /// Factor of the moments on a panel of this half-length, and what is added to the kernel there.
    pub(super) fn scale(&self, half: f64) -> [f64; 2] {
        match *self {
            Self::Ring(ref rings) if rings.exponent() > 0.0 => {
                [half.powf(1.0 - rings.exponent()), 0.0]
            }
            Self::Logarithm | Self::Sine | Self::Ring(_) => [half, -half.ln()],
            Self::Power { exponent } => [half.powf(1.0 - exponent), 0.0],
        }
    }

    /// The mean over two intervals, the first the same or left of the second.
    pub(super) fn mean(&self, left: [f64; 2], right: [f64; 2]) -> f64 {
        match *self {
            Self::Logarithm => mean_logarithm(left, right),
            Self::Sine => {
                // Both logarithms taken out, the near one and the one through the seam; the rest by Gauss's rule, as a constant has to give nothing over the whole circle.
                let image = left.map(|end| end + 2.0);
                mean_logarithm(left, right) + mean_logarithm(right, image) - mean_ratio(left, right)
            }
            Self::Power { exponent } => mean_power(left, right, exponent),
            Self::Ring(ref rings) => rings.mean(left, right),
        }
    }
}

/// The mean of `ln [2 sin(pi d/2)/(d (2 - d))]` over two intervals.
fn mean_ratio(left: [f64; 2], right: [f64; 2]) -> f64 {
    let logarithm = |d: f64| {
        if d == 0.0 {
            return FRAC_PI_2.ln();
        }
        (2.0 * (FRAC_PI_2 * d).sin() / (d * (2.0 - d))).ln()
    };
    let nodes = |[from, to]: [f64; 2]| {
        [(-GAUSS_NODE, GAUSS_WEIGHTS[0]), (0.0, GAUSS_WEIGHTS[1]), (GAUSS_NODE, GAUSS_WEIGHTS[0])]
            .map(|(u, weight)| (0.5 * (from + to) + 0.5 * (to - from) * u, weight))
    };
    let mut sum = 0.0;
    for (x, one) in nodes(left) {
        for (s, other) in nodes(right) {
            sum += one * other * logarithm(s - x);
        }
    }
    sum
}

/// `M_k(z) = int_{-1}^{1} |z - y|^-mu P_k(y) dy`. From `(2k+1) P_k = P'_(k+1) - P'_(k-1)` by parts
///
/// `(k + 2 - mu) M_(k+1) = (2k+1) z M_k - (k - 1 + mu) M_(k-1)`, `k >= 1`,
///
/// upwards between the ends and downwards beyond them, where the moments are the solution that decays.
fn power_moments(exponent: f64, place: OnPanel, moments: &mut [f64]) {
    let count = moments.len();
    let (z, [outer, inner]) = (place.z, place.to_ends());
    let x = z.abs();
    let power = 1.0 - exponent;
    let [far, near] = [outer, inner].map(|d| d.abs().powf(power).copysign(d));
    let zeroth = (far + near) / power;
    let first = x * zeroth + (near * inner - far * outer) / (power + 1.0);
    let mut all = [0.0; MOST + 1];
    if x < FORWARD {
        (all[0], all[1]) = (zeroth, first);
        for k in 1..count.max(2) - 1 {
            let n = k as f64;
            all[k + 1] =
                ((2.0 * n + 1.0) * x * all[k] - (n - power) * all[k - 1]) / (n + 1.0 + power);
        }
    } else {
        let beyond = (0.5 * DIGITS / x.acosh()).ceil() as usize;
        let (mut after, mut here) = (0.0, f64::MIN_POSITIVE.sqrt());
        for k in (1..=count + beyond).rev() {
            if k < count {
                all[k] = here;
            }
            let n = k as f64;
            let before = ((2.0 * n + 1.0) * x * here - (n + 1.0 + power) * after) / (n - power);
            (after, here) = (here, before);
        }
        all[0] = here;
        let scale = zeroth / here;
        all.iter_mut().for_each(|moment| *moment *= scale);
    }
    moments.copy_from_slice(&all[..count]);
    if z < 0.0 {
        moments.iter_mut().skip(1).step_by(2).for_each(|moment| *moment = -*moment);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadrature::double_exponential;

    #[test]
    fn moments_of_powers_agree_with_quadrature() {
        for exponent in [0.05, 0.5, 0.9] {
            for z in [0.0, 0.3, -0.7, 0.999, 1.0, -1.0, 1.0001, 1.04, 1.06, -1.3, 2.0, -9.0] {
                let mut found = [0.0; 13];
                power_moments(exponent, OnPanel::at(z), &mut found);
                for (k, found) in found.iter().enumerate() {
                    let exact = by_quadrature(exponent, z, k);
                    let size = 2.0 / (1.0 - exponent);
                    let error = (found - exact).abs();
                    assert!(error < 2e-13 * size, "{exponent} {z} {k}: {found} {exact}");
                }
            }
        }
    }

    /// The moment from the place, or the nearer end, to both ends by the double exponential rule.
    fn by_quadrature(exponent: f64, z: f64, k: usize) -> f64 {
        let legendre = |y: f64| {
            let (mut before, mut here) = (0.0, 1.0);
            for k in 0..k {
                let k = k as f64;
                (before, here) = (here, ((2.0 * k + 1.0) * y * here - k * before) / (k + 1.0));
            }
            here
        };
        let cut = z.clamp(-1.0, 1.0);
        // u = d^(1-mu) of the distance d takes the singularity away.
        let power = 1.0 - exponent;
        let part = |to: f64| -> f64 {
            let [near, far] = [(z - cut).abs(), (z - to).abs()];
            let [from, end] = [near, far].map(|d| d.powf(power));
            let half = 0.5 * (end - from);
            double_exponential(120)
                .map(|node| {
                    let distance = (from + half * node.from_left).powf(1.0 / power);
                    let y = cut + (distance - near).copysign(to - cut);
                    half * node.weight / power * legendre(y)
                })
                .sum()
        };
        part(-1.0) + part(1.0)
    }

    #[test]
    fn remainders_and_means_make_up_the_kernel() {
        let kernel = PanelKernel::Sine;
        // On both sides of the angle where the series ends.
        for d in [1e-9, 0.02, 0.0795, -0.0797, 0.3, -0.9, 1.4] {
            let short = kernel.shortest(d).abs();
            let sum = kernel.remainder(d) - short.ln();
            assert!((sum - kernel.value(d)).abs() < 1e-14, "{d}: {sum}");
            let mut values = [d];
            kernel.values(&mut values);
            assert!((values[0] - kernel.value(d)).abs() < 1e-14, "{d}: {}", values[0]);
        }
        // Means of far intervals are values, and those of one piece are means of those of its halves.
        for kernel in
            [PanelKernel::Logarithm, PanelKernel::Sine, PanelKernel::Power { exponent: 0.4 }]
        {
            let far = kernel.mean([-0.4001, -0.4], [0.3, 0.3001]);
            assert!((far - kernel.value(0.7)).abs() < 2e-3, "{kernel:?}: {far}");
            let [whole, left, right] = [[0.1, 0.2], [0.1, 0.15], [0.15, 0.2]];
            let halves = 0.25
                * (kernel.mean(left, left)
                    + 2.0 * kernel.mean(left, right)
                    + kernel.mean(right, right));
            assert!((kernel.mean(whole, whole) / halves - 1.0).abs() < 1e-3, "{kernel:?}");
        }
    }
}

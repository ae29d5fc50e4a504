//! One polynomial that stands for the density in the disk about a window.

use crate::allowance::UNIT;
use crate::chebyshev::{self, evaluate, nodes};
use crate::density::{Density, Panel};
use crate::legendre::{self, ORDER};

/// Nodes of the polynomial that stands for the density in a disk.
const DENSITY_NODES: usize = 22;
/// Places at which a piece of the density is compared with the polynomial that stands for it.
const SAMPLES: usize = 36;
/// A polynomial is nowhere more than `1/cos(pi degree/(2 n))` of its largest value at `n` Chebyshev nodes; degree 21 and 36 nodes give 1.64.
const FACTOR: f64 = 1.65;

/// A polynomial in a disk about a window.
pub(crate) struct Fitted {
    /// Chebyshev coefficients on the diameter, and what each is off by.
    coefficients: Vec<f64>,
    rounding: f64,
    /// A bound of what it misses.
    pub(crate) missed: f64,
    /// The largest jump of the density between its panels, and its largest size.
    pub(crate) jump: f64,
    pub(crate) largest: f64,
}

impl Fitted {
    /// The sum of the sizes of its coefficients, each times a weight.
    pub(crate) fn sum(&self, weight: impl Fn(i32) -> f64) -> f64 {
        (self.coefficients.iter().zip(0..))
            .map(|(c, k)| (c.abs() + self.rounding) * weight(k))
            .sum()
    }
}

/// The polynomial that stands for the density in a disk.
pub(crate) fn fit(density: &Density, c: f64, disk: f64) -> Fitted {
    let all = &density.panels;
    let first = all.partition_point(|panel| panel.right <= c - disk);
    let last = all.partition_point(|panel| panel.left < c + disk);
    let panels = &all[first..last];
    let at = nodes(if panels.len() == 1 { ORDER } else { DENSITY_NODES });
    let values: Vec<f64> = at.places.iter().map(|t| density.evaluate(c + disk * t)).collect();
    let coefficients: Vec<f64> = at.coefficients(&values).collect();
    let largest = panels.iter().fold(0.0f64, |most, panel| most.max(panel.largest));
    let evaluated = panels.iter().fold(0.0f64, |most, panel| most.max(panel.evaluated));
    if panels.len() == 1 {
        // The panel's own polynomial: its coefficients are sums of as many products of computed values.
        let count = ORDER as f64;
        // The places of values are rounded, too; |T_k'| <= k^2.
        let slope: f64 =
            coefficients.iter().zip(0u32..).map(|(a, k)| f64::from(k * k) * a.abs()).sum();
        let rounding =
            UNIT * (2.0 * (count + 2.0) * largest + 2.0 * evaluated + slope * c.abs() / disk);
        return Fitted { coefficients, rounding, missed: 0.0, jump: 0.0, largest };
    }
    let missed =
        panels.iter().map(|panel| difference(panel, &coefficients, c, disk)).fold(0.0, f64::max);
    // Both are evaluated with rounding.
    let rounding = FACTOR * UNIT * (evaluated + chebyshev::evaluated(&coefficients));
    let jump = (panels.windows(2))
        .map(|pair| (pair[0].evaluate(pair[0].right) - pair[1].evaluate(pair[1].left)).abs())
        .fold(0.0, f64::max);
    Fitted { coefficients, rounding: 0.0, missed: FACTOR * missed + rounding, jump, largest }
}

/// The largest difference of a panel's polynomial from another one at samples of its part of a disk.
fn difference(panel: &Panel, coefficients: &[f64], c: f64, disk: f64) -> f64 {
    let (left, right) = (panel.left.max(c - disk), panel.right.min(c + disk));
    // Places are taken from the nearer ones of the panel's ends and the disk's middle: they keep their digits.
    let [from, to] = [left, right].map(|x| panel.own(x));
    let [start, end] = [left, right].map(|x| ((x - c) / disk).clamp(-1.0, 1.0));
    let mut most = 0.0f64;
    for t in &nodes(SAMPLES).places {
        let place = 0.5 * ((from + to) + (to - from) * t);
        let other = 0.5 * ((start + end) + (end - start) * t);
        let value = legendre::evaluate(&panel.coefficients, place);
        most = most.max((value - evaluate(coefficients, other)).abs());
    }
    most
}

//! One polynomial that stands for the density in the disk about a window.

use crate::allowance::UNIT;
use crate::chebyshev::{self, lebesgue, nodes};
use crate::density::Density;
use crate::legendre::{self, ORDER};
use crate::panel::Panel;
use crate::places::Places;
use crate::vectorised::vectorised;

/// Nodes of the polynomial that stands for the density in a disk.
const DENSITY_NODES: usize = 26;
/// Places at which a piece of the density is compared with the polynomial that stands for it.
const SAMPLES: usize = 48;
/// A polynomial is nowhere more than `1/cos(pi degree/(2 n))` of its largest value at `n` Chebyshev nodes; degree 25 and 48 nodes give 1.463.
const FACTOR: f64 = 1.47;
/// Places that are compared together.
const TOGETHER: usize = 16;

/// A place that is another one moved is off by nine units instead of four: of the roundings of a value in [`legendre::evaluated`], `2 k (k + 1)` for each degree, these make `4.5 k (k + 1)`.
const PLACED_TWICE: f64 = 1.5;

/// A polynomial in a disk about a window.
pub(crate) struct Fitted {
    /// Sizes of the Chebyshev coefficients on the diameter, with what rounding of their sums may add.
    sizes: Vec<f64>,
    /// What the values were off by from which the coefficients were found.
    off: f64,
    /// A bound of what it misses.
    pub(crate) missed: f64,
    /// The largest jump of the density between its panels, or what these cannot resolve of it; and its largest size.
    pub(crate) jump: f64,
    pub(crate) largest: f64,
}

impl Fitted {
    /// The number of its coefficients.
    pub(crate) fn len(&self) -> usize {
        self.sizes.len()
    }

    /// The sum of the sizes of its coefficients, each times a weight; `whole` is the weight of any polynomial of size one.
    ///
    /// Values that are off by `e` change a coefficient by `2 e` at most, and the polynomial by `e` times Lebesgue's constant.
    pub(crate) fn sum(&self, weight: impl Fn(usize) -> f64, whole: f64) -> f64 {
        let (mut own, mut weights) = (0.0, 0.0);
        for (k, size) in self.sizes.iter().enumerate() {
            let weight = weight(k);
            own += size * weight;
            weights += weight;
        }
        own + self.off * (2.0 * weights).min(lebesgue(self.sizes.len()) * whole)
    }
}

/// The polynomial that stands for the density in a disk; none where the disk is so short that rounding carries its places out of the panel that holds it.
pub(crate) fn fit(density: &Density, c: f64, disk: f64) -> Option<Fitted> {
    let all = &density.panels;
    let first = all.partition_point(|panel| panel.right <= c - disk);
    let last = all.partition_point(|panel| panel.left < c + disk);
    let panels = &all[first..last];
    let at = nodes(if panels.len() == 1 { ORDER } else { DENSITY_NODES });
    let mut values = match panels {
        [panel] => on_panel(panel, &at.places, c, disk)?,
        _ => {
            let offsets: Vec<f64> = at.places.iter().map(|t| disk * t).collect();
            density
                .values(&Places { from: c, offsets: &offsets })
                .into_iter()
                .map(|(q, _)| q)
                .collect()
        }
    };
    // Sums of cosines lose digits of what they sum: that is to be small.
    let mean = values[values.len() / 2];
    values.iter_mut().for_each(|value| *value -= mean);
    let swing = values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    let mut coefficients = at.coefficients(&values);
    coefficients[0] += mean;
    let largest = panels.iter().fold(0.0f64, |most, panel| most.max(panel.largest));
    let evaluated = panels.iter().fold(0.0f64, |most, panel| most.max(panel.evaluated));
    if let [_] = panels {
        // The panel's own polynomial: its coefficients are sums of as many products of computed values.
        let count = ORDER as f64;
        let summed = UNIT * 2.0 * (count + 2.0) * swing;
        let mut sizes: Vec<f64> = coefficients.iter().map(|a| a.abs() + summed).collect();
        sizes[0] += 2.0 * UNIT * (largest + swing);
        let off = UNIT * (PLACED_TWICE * evaluated + swing);
        return Some(Fitted { sizes, off, missed: 0.0, jump: 0.0, largest });
    }
    let missed =
        panels.iter().map(|panel| difference(panel, &coefficients, c, disk)).fold(0.0, f64::max);
    // Both are evaluated with rounding.
    let rounding = FACTOR * UNIT * (evaluated + chebyshev::evaluated(&coefficients));
    let jump = (panels.windows(2))
        .map(|pair| (pair[0].evaluate(pair[0].right) - pair[1].evaluate(pair[1].left)).abs())
        .fold(0.0, f64::max);
    let noise = panels.iter().map(Panel::tail).fold(0.0, f64::max);
    let sizes = coefficients.iter().map(|a| a.abs()).collect();
    let jump = noise.max(jump);
    Some(Fitted { sizes, off: 0.0, missed: FACTOR * missed + rounding, jump, largest })
}

/// The polynomial of the panel that holds a disk at places of its diameter: these are those of its middle moved, since as numbers of the machine they would be rounded to the distance of the
/// disk from the origin.
fn on_panel(panel: &Panel, places: &[f64], c: f64, disk: f64) -> Option<Vec<f64>> {
    let (middle, scale) = (panel.own(c), disk / panel.half());
    let own: Vec<f64> = places.iter().map(|t| middle + scale * t).collect();
    let mut values = vec![0.0; own.len()];
    legendre::evaluate_all(&panel.coefficients, &own, &mut values);
    own.iter().all(|t| t.abs() <= 1.0).then_some(values)
}

/// The largest difference of a panel's polynomial from another one at samples of its part of a disk.
fn difference(panel: &Panel, coefficients: &[f64], c: f64, disk: f64) -> f64 {
    let (left, right) = (panel.left.max(c - disk), panel.right.min(c + disk));
    // Places are taken from the nearer ones of the panel's ends and the disk's middle: they keep their digits.
    let [from, to] = [left, right].map(|x| panel.own(x));
    let [start, end] = [left, right].map(|x| ((x - c) / disk).clamp(-1.0, 1.0));
    let at = &nodes(SAMPLES).places;
    vectorised(
        #[inline(always)]
        || {
            let mut most = 0.0f64;
            for places in at.chunks_exact(TOGETHER) {
                let (mut own, mut other) = ([0.0; TOGETHER], [0.0; TOGETHER]);
                for i in 0..TOGETHER {
                    own[i] = 0.5 * ((from + to) + (to - from) * places[i]);
                    other[i] = 0.5 * ((start + end) + (end - start) * places[i]);
                }
                let values = legendre::evaluate_at(&panel.coefficients, &own);
                let others = chebyshev::evaluate_at(coefficients, &other);
                for i in 0..TOGETHER {
                    most = most.max((values[i] - others[i]).abs());
                }
            }
            most
        },
    )
}

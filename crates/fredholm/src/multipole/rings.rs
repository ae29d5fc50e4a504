//! The kernel of rings about an axis, `2 K(k)/(x + s)` with `k^2 = 4 x s/(x + s)^2`.
//!
//! With `k' = |x - s|/(x + s)` and `q = k'^2` the complete elliptic integral is `K = a(q) ln(1/k') + b(q)`; between 0 and 1 polynomials for `a` and `b` together leave out 1.3e-18 of it. Both are
//! smooth where rings meet, so that moments of the logarithm serve panels beside the axis; the panel that begins at it has a rule of its own.

use super::rule::{MOST, PanelRule};
use crate::complementarity::mean_logarithm;
use crate::quadrature::double_exponential;
use crate::special::elliptic::{carlson_second_kind, complete_first_kind};
use crate::special::logarithms;

/// The coefficients of `a` and `b` (least squares of the relative deviation from the arithmetic-geometric mean, weighted until the largest was least).
const LOGARITHM: [f64; 11] = [
    1.0,
    0.249_999_999_999_678_12,
    0.140_624_999_225_650_94,
    0.097_656_029_841_169_79,
    0.074_752_732_590_148_39,
    0.060_205_314_664_788_116,
    0.047_604_041_847_266_534,
    0.030_488_317_873_783_12,
    0.011_490_555_509_442_701,
    0.001_732_353_968_450_293,
    0.000_054_589_272_727_262_352,
];
const PLAIN: [f64; 11] = [
    1.386_294_361_119_890_6,
    0.096_573_590_281_486_42,
    0.030_885_147_060_496_963,
    0.014_938_137_124_754_761,
    0.008_794_368_135_454_752,
    0.006_229_808_325_209_358,
    0.007_014_087_424_183_007,
    0.009_934_387_778_769_914,
    0.007_825_238_428_393_39,
    0.002_178_581_832_991_733_5,
    0.000_128_619_283_265_695_63,
];
/// Nodes of the rule on either side of a place, or of the middle of the panel that begins at the axis, up and down from its middle: twice as many change nothing but rounding (test).
const NODES: usize = 60;
/// Gauss's rules of three and of two nodes, no two of which are one place.
const THREE: [[f64; 2]; 3] = [
    [-0.774_596_669_241_483_4, 5.0 / 18.0],
    [0.0, 4.0 / 9.0],
    [0.774_596_669_241_483_4, 5.0 / 18.0],
];
const TWO: [[f64; 2]; 2] = [[-0.577_350_269_189_625_8, 0.5], [0.577_350_269_189_625_8, 0.5]];

#[inline(always)]
fn polynomial(coefficients: &[f64; 11], q: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| c + q * sum)
}

/// `k'` for a difference of the radii, and the factor of `K`.
#[inline(always)]
pub(super) fn apart(x: f64, s: f64, difference: f64) -> [f64; 2] {
    [difference.abs() / (x + s), 2.0 / (x + s)]
}

/// Replaces values of `k'` by `K`.
pub(super) fn values(distances: &mut [f64]) {
    let mut squares = [0.0; 64];
    for part in distances.chunks_mut(squares.len()) {
        part.iter().zip(&mut squares).for_each(|(d, q)| *q = d * d);
        logarithms(part);
        for (value, q) in part.iter_mut().zip(&squares) {
            *value = polynomial(&PLAIN, *q) - polynomial(&LOGARITHM, *q) * *value;
        }
    }
}

/// The kernel for radii with this difference.
pub(super) fn value(x: f64, s: f64, difference: f64) -> f64 {
    let [d, factor] = apart(x, s, difference);
    factor * (polynomial(&PLAIN, d * d) - polynomial(&LOGARITHM, d * d) * d.ln())
}

/// What goes with `ln(1/|x - s|)` in the kernel, and what is left.
#[inline(always)]
pub(super) fn split(x: f64, s: f64) -> [f64; 2] {
    let [d, factor] = apart(x, s, x - s);
    let logarithm = factor * polynomial(&LOGARITHM, d * d);
    [logarithm, factor * polynomial(&PLAIN, d * d) + logarithm * (x + s).ln()]
}

/// The slope in `x` for different radii: `(E/(s - x) - K/(x + s))/x`.
pub(super) fn slope(x: f64, s: f64) -> f64 {
    if x == 0.0 {
        return 0.0;
    }
    let [d, _] = apart(x, s, x - s);
    let first = complete_first_kind(d);
    // E = K - k^2 R_D(0, k'^2, 1)/3
    let second = first - (1.0 - d * d) * carlson_second_kind(0.0, d * d, 1.0) / 3.0;
    (second / (s - x) - first / (x + s)) / x
}

/// The mean over two intervals, the first the same or left of the second, about: the logarithm by its exact mean, and the rest by rules of three and of two nodes.
pub(super) fn mean(left: [f64; 2], right: [f64; 2]) -> f64 {
    let middle = |[from, to]: [f64; 2]| 0.5 * (from + to);
    let at = |[from, to]: [f64; 2], y: f64| middle([from, to]) + 0.5 * (to - from) * y;
    let (mut mass, mut sum, mut singular) = (0.0, 0.0, 0.0);
    for [one, weight] in THREE {
        for [other, own] in TWO {
            let (x, s) = (at(left, one), at(right, other));
            mass += weight * own * x * s;
            sum += weight * own * x * s * value(x, s, x - s);
            singular -= weight * own * (x - s).abs().ln();
        }
    }
    let [logarithm, _] = split(middle(left), middle(right));
    sum / mass + logarithm * (mean_logarithm(left, right) - singular)
}

impl PanelRule {
    /// The weights of `int_0^1 G(x, s) phi(s) s ds` for values of a polynomial at the nodes, from the place in `[0, 1]` or beside it.
    pub(super) fn weights_from_axis(&self, x: f64, weights: &mut [f64]) {
        let order = self.order();
        let mut moments = [0.0; MOST];
        let cut = x.min(1.0);
        // From the place, or from the end before it, to both ends.
        for to in [0.0, 1.0] {
            let length = to - cut;
            if length == 0.0 {
                continue;
            }
            for node in double_exponential(NODES) {
                let s = cut + 0.5 * length * node.from_left;
                let difference = (x - cut) - 0.5 * length * node.from_left;
                if difference == 0.0 || s <= 0.0 {
                    continue;
                }
                let mass = 0.5 * length.abs() * node.weight * s * value(x, s, difference);
                let y = 2.0 * s - 1.0;
                let (mut before, mut here) = (0.0, 1.0);
                for (k, moment) in moments[..order].iter_mut().enumerate() {
                    *moment += mass * here;
                    let k = k as f64;
                    (before, here) = (here, ((2.0 * k + 1.0) * y * here - k * before) / (k + 1.0));
                }
            }
        }
        self.from_moments(&moments[..order], weights);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_those_of_the_mean() {
        for k in 0..=400 {
            let d = 10f64.powf(-f64::from(k) / 25.0);
            let exact = complete_first_kind(d);
            let mut found = [d];
            values(&mut found);
            assert!((found[0] / exact - 1.0).abs() < 1e-15, "{d:e}: {} {exact}", found[0]);
            let (x, s) = (0.3 * (1.0 + d), 0.3 * (1.0 - d));
            let [logarithm, rest] = split(x, s);
            let sum = rest - logarithm * (x - s).abs().ln();
            if d > 1e-12 && d < 1.0 {
                let exact = 2.0 * complete_first_kind((x - s) / (x + s)) / (x + s);
                assert!((sum / exact - 1.0).abs() < 2e-15, "{d:e}: {sum} {exact}");
            }
        }
    }

    #[test]
    fn slopes_are_limits_of_differences() {
        for (x, s) in [(0.5, 0.3), (0.3, 0.5), (0.01, 0.9), (0.7, 0.001), (0.5, 0.5001)] {
            let step = 1e-3 * f64::abs(x - s);
            let at = |k: f64| value(x + k * step, s, x + k * step - s);
            let difference = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * step);
            let found = slope(x, s);
            assert!(
                (found - difference).abs() < 1e-8 * (1.0 / (x - s)).abs() / s,
                "{x} {s}: {found} {difference}"
            );
        }
    }

    #[test]
    fn uniform_pressure_on_the_panel_at_the_axis_has_the_second_elliptic_integral() {
        for order in [4, 10, 13] {
            let rule = PanelRule::new(order).unwrap();
            let mut weights = vec![0.0; order];
            for x in [0.0, 1e-9, 0.02, 0.3, 0.77, 0.999, 1.0, 1.001, 1.3, 1.7] {
                rule.weights_from_axis(x, &mut weights);
                let found: f64 = weights.iter().sum();
                let exact = uniform(x);
                assert!((found - exact).abs() < 4e-15, "{order} {x}: {found} {exact}");
            }
        }
    }
}

/// The potential of 1 on the unit disk: `2 E(x)` on it, and beside it `2 x (E(1/x) - (1 - 1/x^2) K(1/x))`.
#[cfg(test)]
pub(super) fn uniform(x: f64) -> f64 {
    let both = |k: f64| {
        let complementary = (1.0 - k * k).max(0.0).sqrt();
        if complementary == 0.0 {
            return [f64::INFINITY, 1.0];
        }
        let first = complete_first_kind(complementary);
        [first, first - k * k * carlson_second_kind(0.0, complementary.powi(2), 1.0) / 3.0]
    };
    if x <= 1.0 {
        return 2.0 * both(x)[1];
    }
    let [first, second] = both(1.0 / x);
    2.0 * x * (second - (1.0 - 1.0 / (x * x)) * first)
}

//! The kernel of rings about an axis, `2 K(k)/(x + s)` with `k^2 = 4 x s/(x + s)^2`.
//!
//! With `k' = |x - s|/(x + s)` and `q = k'^2` the complete elliptic integral is `K = a(q) ln(1/k') + b(q)`; between 0 and 1 polynomials for `a` and `b` together leave out 1.3e-18 of it. Both are
//! smooth where rings meet, so that moments of the logarithm serve panels beside the axis; the panel that begins at it has a rule of its own.

use std::sync::Arc;

use crate::Error;
use crate::complementarity::{mean_logarithm, mean_power};
use crate::kernel::Homogeneous;
use crate::kernel::WeberSonine;
use crate::special::logarithms;

/// `a` and `b` by their coefficients.
struct Split {
    logarithm: [f64; COUNT],
    plain: [f64; COUNT],
}

const COUNT: usize = 12;
/// The coefficients of `a` and `b` of both harmonics (least squares of the deviation, of the first relative to `K`, weighted until the largest was least).
const SPLITS: [Split; 2] = [
    Split {
        logarithm: [
            1.0,
            0.249_999_999_999_987_37,
            0.140_624_999_956_682_9,
            0.097_656_232_326_813_71,
            0.074_766_278_556_030_16,
            0.060_500_679_946_359_96,
            0.050_036_719_587_916_38,
            0.038_564_776_935_465_34,
            0.022_321_111_072_129_45,
            0.007_207_123_911_517_559_5,
            0.000_915_415_350_628_163_2,
            0.000_024_407_175_173_528_056,
        ],
        plain: [
            1.386_294_361_119_890_6,
            0.096_573_590_280_034_29,
            0.030_885_144_681_631_36,
            0.014_937_646_694_976_52,
            0.008_769_923_939_746_975,
            0.005_848_965_973_297_695,
            0.005_008_550_164_911_64,
            0.006_899_498_078_803_94,
            0.008_775_762_727_877_74,
            0.005_513_754_600_240_309,
            0.001_229_649_277_697_845,
            0.000_059_479_255_787_686_805,
        ],
    },
    Split {
        logarithm: [
            1.0,
            1.249_999_999_999_762_4,
            1.265_624_999_034_543_8,
            1.269_530_805_975_008_3,
            1.271_007_881_414_694_3,
            1.269_980_476_206_905_6,
            1.245_249_232_775_114_8,
            1.094_165_844_011_719,
            0.694_724_256_430_395_9,
            0.239_162_307_168_674_5,
            0.031_834_762_759_390_92,
            0.000_880_515_430_919_528_5,
        ],
        plain: [
            -0.613_705_638_880_109_4,
            -0.017_132_048_598_952_714,
            -0.003_283_695_816_166_713,
            -0.001_122_508_317_986_318_4,
            -0.000_407_315_169_097_963_93,
            0.002_583_752_751_952_208,
            0.030_528_826_411_996_16,
            0.135_109_362_462_320_5,
            0.246_666_835_877_396_96,
            0.176_520_246_540_865_07,
            0.042_110_949_854_709_14,
            0.002_131_232_883_073_059_4,
        ],
    },
];
/// Places that are taken at once.
const CHUNK: usize = 64;
/// Gauss's rules of three and of two nodes, no two of which are one place.
const THREE: [[f64; 2]; 3] = [
    [-0.774_596_669_241_483_4, 5.0 / 18.0],
    [0.0, 4.0 / 9.0],
    [0.774_596_669_241_483_4, 5.0 / 18.0],
];
const TWO: [[f64; 2]; 2] = [[-0.577_350_269_189_625_8, 0.5], [0.577_350_269_189_625_8, 0.5]];

/// Intervals whose middles are so many lengths apart have the mean of their middles: it is off by less than a hundredth (theory).
const APART: f64 = 4.0;
/// Step of differences for slopes, as a share of the distance: the fourth power of it is left, and rounding over it (theory).
const STEP: f64 = 1e-3;

#[inline(always)]
fn polynomial(coefficients: &[f64; COUNT], q: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| c + q * sum)
}

fn derivative(coefficients: &[f64; COUNT], q: f64) -> f64 {
    let terms = coefficients.iter().enumerate().skip(1).rev();
    terms.fold(0.0, |sum, (k, c)| k as f64 * c + q * sum)
}

/// Rings about an axis: `pi int_0^inf J_m(x t) J_m(s t) dt` for densities times `s ds` and `cos(m phi)`. Where they meet it is `ln(1/|x - s|)/s`; with the complete
/// elliptic integrals of `k^2 = 4 x s/(x + s)^2` it is `2 K/(x + s)` for `m = 0` and `2 ((2 - k^2) K - 2 E)/(k^2 (x + s))` for `m = 1`. On graded ground it is the kernel of [`WeberSonine`] times what makes it
/// `|x - s|^-mu/s` where they meet.
#[derive(Debug, Clone)]
pub struct Rings {
    /// `m`, 0 or 1.
    harmonic: usize,
    /// `mu`.
    exponent: f64,
    /// On graded ground.
    power: Option<Arc<Homogeneous>>,
}

impl PartialEq for Rings {
    fn eq(&self, other: &Self) -> bool {
        self.harmonic == other.harmonic && self.exponent == other.exponent
    }
}

impl Rings {
    /// From this exponent on the rule of the panel at the axis loses so many digits that collocation serves as well (survey of random traces and many-waved bases, `solve --no-audit`: of 27 traces from 1/2 to here panels solve 26,
    /// two of them to fewer digits than collocation; from here to 3/4 one base in a dozen is refused that was solved, and two know the pressure to 2e-4 and 4e-4 for 2e-5 and 7e-7).
    pub const SHARPEST: f64 = 2.0 / 3.0;

    /// Those of a kernel on a disk, of the order 0 or 1.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for other orders, and for an exponent below 0.
    pub fn of(kernel: &WeberSonine) -> Result<Self, Error> {
        let (order, exponent) = (kernel.order(), 2.0 * kernel.exponent());
        let refuse =
            |name, value, requirement| Err(Error::InvalidParameter { name, value, requirement });
        if order != 0.0 && order != 1.0 {
            return refuse("order of rings", order, "0 or 1");
        }
        if exponent < 0.0 {
            return refuse("exponent of rings", kernel.exponent(), "at least 0");
        }
        let power = (exponent > 0.0).then(|| Arc::new(Homogeneous::new(kernel)));
        Ok(Self { harmonic: usize::from(order == 1.0), exponent, power })
    }

    /// `mu`.
    pub(super) fn exponent(&self) -> f64 {
        self.exponent
    }

    #[inline(always)]
    fn split(&self) -> &'static Split {
        &SPLITS[self.harmonic.min(1)]
    }

    /// `k'` for a difference of the radii, and the factor of what it is the argument of.
    #[inline(always)]
    pub(super) fn apart(&self, x: f64, s: f64, difference: f64) -> [f64; 2] {
        let factor = match self.power {
            None => 2.0 / (x + s),
            Some(_) => (x + s).powf(-1.0 - self.exponent),
        };
        [difference.abs() / (x + s), factor]
    }

    /// Replaces values of `k'` by those of the function.
    pub(super) fn values(&self, distances: &mut [f64]) {
        if let Some(power) = &self.power {
            return power.values(distances);
        }
        let Split { logarithm, plain } = self.split();
        let mut squares = [0.0; CHUNK];
        for part in distances.chunks_mut(squares.len()) {
            part.iter().zip(&mut squares).for_each(|(d, q)| *q = d * d);
            logarithms(part);
            for (value, q) in part.iter_mut().zip(&squares) {
                *value = polynomial(plain, *q) - polynomial(logarithm, *q) * *value;
            }
        }
    }

    /// The kernel for radii with this difference.
    pub(super) fn value(&self, x: f64, s: f64, difference: f64) -> f64 {
        let [d, factor] = self.apart(x, s, difference);
        if let Some(power) = &self.power {
            return (factor * power.value(d)).min(f64::MAX);
        }
        let Split { logarithm, plain } = self.split();
        factor * (polynomial(plain, d * d) - polynomial(logarithm, d * d) * d.ln())
    }

    /// What goes with `ln(1/|x - s|)` or `|x - s|^-mu` in the kernel, and what is left.
    #[inline(always)]
    pub(super) fn parts(&self, x: f64, s: f64) -> [f64; 2] {
        if let Some(power) = &self.power {
            return self.parts_of_power(power, x, s);
        }
        let Split { logarithm, plain } = self.split();
        let [d, factor] = self.apart(x, s, x - s);
        let logarithm = factor * polynomial(logarithm, d * d);
        [logarithm, factor * polynomial(plain, d * d) + logarithm * (x + s).ln()]
    }

    /// Far apart all of it is left.
    fn parts_of_power(&self, power: &Homogeneous, x: f64, s: f64) -> [f64; 2] {
        let [d, factor] = self.apart(x, s, x - s);
        match power.parts(d) {
            Some([singular, rest]) => [singular / (x + s), factor * rest],
            None => [0.0, self.value(x, s, x - s)],
        }
    }

    /// The slope in `x` for different radii.
    #[must_use]
    pub fn slope(&self, x: f64, s: f64) -> f64 {
        self.slope_across(x, s, x - s)
    }

    /// The same given the difference of both radii.
    pub(super) fn slope_across(&self, x: f64, s: f64, difference: f64) -> f64 {
        if self.power.is_some() {
            let step = STEP * difference.abs().min(x);
            let at = |k: f64| self.value(x + k * step, s, difference + k * step);
            let differences = 8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0));
            return if step == 0.0 { 0.0 } else { differences / (12.0 * step) };
        }
        let Split { logarithm, plain } = self.split();
        let [d, factor] = self.apart(x, s, difference);
        let (q, sum) = (d * d, x + s);
        // dq/dx = 4 s (x - s)/(x + s)^3, of which the pole of the logarithm leaves a part.
        let smooth = derivative(plain, q) - derivative(logarithm, q) * d.ln();
        let by_square = smooth * 4.0 * s * difference / sum.powi(3);
        let by_pole = 2.0 * s * polynomial(logarithm, q) / (difference * sum);
        factor * (by_square - by_pole) - self.value(x, s, difference) / sum
    }

    /// The mean over two intervals, the first the same or left of the second, about: the logarithm by its exact mean, and the rest by rules of three and of two nodes.
    pub(super) fn mean(&self, left: [f64; 2], right: [f64; 2]) -> f64 {
        let middle = |[from, to]: [f64; 2]| 0.5 * (from + to);
        let (x, s) = (middle(left), middle(right));
        let longest = (left[1] - left[0]).max(right[1] - right[0]);
        if s - x > APART * longest {
            return self.value(x, s, x - s);
        }
        let at = |[from, to]: [f64; 2], y: f64| middle([from, to]) + 0.5 * (to - from) * y;
        let (mut mass, mut sum, mut singular) = (0.0, 0.0, 0.0);
        let beside = |d: f64| if self.exponent > 0.0 { d.powf(-self.exponent) } else { -d.ln() };
        for [one, weight] in THREE {
            for [other, own] in TWO {
                let (x, s) = (at(left, one), at(right, other));
                mass += weight * own * x * s;
                sum += weight * own * x * s * self.value(x, s, x - s);
                singular += weight * own * beside((x - s).abs());
            }
        }
        let [logarithm, _] = self.parts(middle(left), middle(right));
        let exact = match self.exponent {
            0.0 => mean_logarithm(left, right),
            exponent => mean_power(left, right, exponent),
        };
        sum / mass + logarithm * (exact - singular)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::special::elliptic::{carlson_second_kind, complete_first_kind};

    pub(in crate::multipole) fn rings(harmonic: usize, exponent: f64) -> Rings {
        Rings::of(&WeberSonine::new(1.0, harmonic as f64, 0.5 * exponent).unwrap()).unwrap()
    }

    fn both() -> [Rings; 2] {
        [rings(0, 0.0), rings(1, 0.0)]
    }

    /// `K` and `E` by `k'`.
    fn integrals(complementary: f64) -> [f64; 2] {
        let square = complementary * complementary;
        let first = complete_first_kind(complementary);
        [first, first - (1.0 - square) * carlson_second_kind(0.0, square, 1.0) / 3.0]
    }

    /// The kernel by its definition.
    pub(in crate::multipole) fn defined(harmonic: usize, x: f64, s: f64, difference: f64) -> f64 {
        let (d, factor) = (difference.abs() / (x + s), 2.0 / (x + s));
        let [first, second] = integrals(d);
        let square = 1.0 - d * d;
        if harmonic == 1 && square == 0.0 {
            return 0.0;
        }
        factor
            * if harmonic == 0 { first } else { ((2.0 - square) * first - 2.0 * second) / square }
    }

    /// The potential of 1 on the unit disk: `2 E(x)` on it, and beside it `2 x (E(1/x) - (1 - 1/x^2) K(1/x))`.
    pub(in crate::multipole) fn uniform(x: f64) -> f64 {
        let both = |k: f64| match 1.0 - k * k {
            left if left > 0.0 => integrals(left.sqrt()),
            _ => [0.0, 1.0],
        };
        if x <= 1.0 {
            return 2.0 * both(x)[1];
        }
        let [first, second] = both(1.0 / x);
        2.0 * x * (second - (1.0 - 1.0 / (x * x)) * first)
    }

    #[test]
    fn values_are_those_of_the_integrals() {
        for k in 1..=400 {
            let d = 10f64.powf(-f64::from(k) / 25.0);
            let (x, s) = (0.3 * (1.0 + d), 0.3 * (1.0 - d));
            for rings in both() {
                let exact = defined(rings.harmonic, x, s, 0.6 * d);
                // The definition of the second cancels where rings are far apart.
                let allowed = if rings.harmonic == 0 { 1e-15 } else { 4e-15 } * exact.max(1.0);
                let mut found = [d];
                rings.values(&mut found);
                let found = found[0] * 2.0 / (x + s);
                assert!((found - exact).abs() < allowed, "{rings:?} {d:e}: {found} {exact}");
                let [logarithm, rest] = rings.parts(x, s);
                let sum = rest - logarithm * (x - s).abs().ln();
                let exact = defined(rings.harmonic, x, s, x - s);
                assert!(d < 1e-12 || (sum - exact).abs() < 3.0 * allowed, "{d:e}: {sum} {exact}");
            }
        }
    }

    #[test]
    fn slopes_are_limits_of_differences() {
        for (x, s) in [(0.5, 0.3), (0.3, 0.5), (0.01, 0.9), (0.7, 0.001), (0.5, 0.5001)] {
            for rings in both() {
                let step = 1e-3 * f64::abs(x - s);
                let at = |k: f64| defined(rings.harmonic, x + k * step, s, x + k * step - s);
                let difference =
                    (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * step);
                let found = rings.slope(x, s);
                let size = 1.0 / ((x - s).abs() * (x + s));
                assert!((found - difference).abs() < 1e-8 * size, "{x} {s}: {found} {difference}");
            }
        }
        assert!(both()[0].slope(0.0, 0.4).abs() < 1e-13);
    }
}

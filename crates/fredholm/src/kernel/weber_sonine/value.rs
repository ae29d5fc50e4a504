//! The kernel of Weber and Sonine by tables of one variable.

use super::coefficients::{Coefficients, NEAR_TERMS};
use super::cutoff::Cutoff;
use super::dyadic::{Dyadic, polynomial};
use super::factor;
use crate::kernel::{Pair, Split};

/// Largest `delta` of the series about the diagonal, and largest `mu delta`: there their two parts begin to cancel.
const NEAR: f64 = 0.5;
const NEAR_OF_ORDER: f64 = 1.2;

type Near = [[f64; 4]; NEAR_TERMS / 4];

/// The kernel is homogeneous, `W = (x s)^(-1/2-gamma) g(|ln(x/s)|)`: next to the diagonal by its series, elsewhere by tables.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tables {
    pub(super) coefficients: Coefficients,
    /// Largest `delta^2/4` of the series.
    pub(super) near_limit: f64,
    /// `F_1` by powers of `delta^2/4`.
    pub(super) near: Near,
    /// `(F_1 - F_2)/q` likewise.
    pub(super) difference: Near,
    /// `kappa e^(q l)`.
    pub(super) near_strength: f64,
    pub(super) far_strength: f64,
    /// The hypergeometric function of `s^2/x^2` by `1 - s^2/x^2`.
    pub(super) far: Dyadic,
    /// `e^((1/2-mu) r) F_1` by `r` over the reach of the cutoff.
    pub(super) factor: Dyadic,
    pub(super) cutoff: Cutoff,
    /// `ln a`.
    pub(super) radius: f64,
}

/// Two different points.
struct Points {
    /// The larger one.
    larger: f64,
    /// Its logarithm.
    logarithm: f64,
    /// The smaller one as a share of it.
    share: f64,
    /// `|ln(x/s)|`.
    ratio: f64,
}

impl Points {
    fn new(larger: f64, smaller: f64) -> Self {
        // Deep in the corner the difference of their logarithms would not hold the ratio.
        let share = smaller / larger;
        Self { larger, logarithm: larger.ln(), share, ratio: -share.ln() }
    }
}

impl Tables {
    pub(super) fn new(radius: f64, order: f64, exponent: f64) -> Self {
        let coefficients = Coefficients::new(order, exponent);
        let delta = NEAR.min(NEAR_OF_ORDER / order);
        let terms = coefficients.near();
        let rows = |part: usize| -> Near {
            std::array::from_fn(|row| std::array::from_fn(|lane| terms[4 * row + lane][part]))
        };
        let rest_of_square = -(-4.0 * (0.5 * delta).asinh()).exp_m1();
        let far_pieces = 1 + (-rest_of_square.log2()) as usize;
        let cutoff = Cutoff::new(order, exponent);
        let nearest = 2.0 * (0.5 * delta).asinh();
        Self {
            near_limit: 0.25 * delta * delta,
            near: rows(0),
            difference: rows(1),
            near_strength: coefficients.strength * (2.0 * exponent * coefficients.shift).exp(),
            far_strength: coefficients.far_strength(),
            far: Dyadic::new(far_pieces, |rest| coefficients.far(rest)),
            factor: factor::table(&coefficients, cutoff.reach(), nearest),
            cutoff,
            radius: radius.ln(),
            coefficients,
        }
    }

    /// `W` and its factor at two different points of `(0, radius)`; NaN only for points that are NaN or negative.
    pub(super) fn pair(&self, x: f64, s: f64, distance: f64) -> Pair {
        let (larger, smaller) = if x > s { (x, s) } else { (s, x) };
        if smaller == 0.0 {
            return Pair { value: self.centre_value(larger), factor: 0.0 };
        }
        let points = Points::new(larger, smaller);
        let apart = distance / larger;
        let quarter = 0.25 * apart * (distance / smaller);
        let value = if quarter <= self.near_limit {
            self.near_value(quarter, distance, &points)
        } else {
            self.far_value(apart * (1.0 + points.share), &points)
        };
        Pair { value: value.min(f64::MAX), factor: self.factor(quarter, &points) }
    }

    /// The same with the factor at all points that are not too far apart for its table.
    pub(super) fn uncut(&self, x: f64, s: f64, distance: f64) -> Pair {
        let (larger, smaller) = if x > s { (x, s) } else { (s, x) };
        let value = self.value(x, s, distance);
        if smaller == 0.0 {
            return Pair { value, factor: 0.0 };
        }
        let quarter = 0.25 * (distance / larger) * (distance / smaller);
        let factor = self.whole_factor(quarter, &Points::new(larger, smaller), 1.0);
        Pair { value, factor }
    }

    /// `W` alone, the same to the last bit for less.
    pub(super) fn value(&self, x: f64, s: f64, distance: f64) -> f64 {
        let (larger, smaller) = if x > s { (x, s) } else { (s, x) };
        if smaller == 0.0 {
            return self.centre_value(larger);
        }
        let apart = distance / larger;
        let quarter = 0.25 * apart * (distance / smaller);
        let value = if quarter <= self.near_limit {
            self.near_value(quarter, distance, &Points::new(larger, smaller))
        } else {
            let share = smaller / larger;
            let rest_of_square = apart * (1.0 + share);
            if self.coefficients.order == 0.0 && self.coefficients.exponent == 0.0 {
                // No powers, and so no logarithms.
                self.far_strength * self.far.evaluate(rest_of_square) / larger
            } else {
                self.far_value(rest_of_square, &Points::new(larger, smaller))
            }
        };
        value.min(f64::MAX)
    }

    fn centre_value(&self, x: f64) -> f64 {
        if self.coefficients.order == 0.0 { self.at_centre(x) } else { 0.0 }
    }

    /// `W(x, 0) = C x^(-1-2 gamma)` for the order 0.
    fn at_centre(&self, x: f64) -> f64 {
        let power = -1.0 - 2.0 * self.coefficients.exponent;
        (self.far_strength * x.powf(power)).min(f64::MAX)
    }

    fn near_value(&self, quarter: f64, distance: f64, points: &Points) -> f64 {
        let gamma = self.coefficients.exponent;
        let middle = points.logarithm - 0.5 * points.ratio;
        let logarithm = distance.ln() - middle + self.coefficients.shift;
        let (sigma, power) = if gamma == 0.0 {
            (-logarithm, 1.0)
        } else {
            let q = 2.0 * gamma;
            ((-q * logarithm).exp_m1() / q, (-q * middle).exp())
        };
        let sum = polynomial(&self.near, quarter) * sigma + polynomial(&self.difference, quarter);
        self.near_strength * power * sum / (points.larger * points.share.sqrt())
    }

    fn far_value(&self, rest_of_square: f64, points: &Points) -> f64 {
        let Coefficients { order, exponent, .. } = self.coefficients;
        let power = -2.0 * exponent * points.logarithm - order * points.ratio;
        let scale = if power == 0.0 { 1.0 } else { power.exp() };
        self.far_strength * self.far.evaluate(rest_of_square) * scale / points.larger
    }

    /// `A = kappa F_1 / sqrt(x s)` with the cutoff.
    fn factor(&self, quarter: f64, points: &Points) -> f64 {
        let depth = self.radius - points.logarithm + 0.5 * points.ratio;
        let cutoff = self.cutoff.value(points.ratio, depth);
        if cutoff == 0.0 { 0.0 } else { self.whole_factor(quarter, points, cutoff) }
    }

    /// Times a share of it.
    fn whole_factor(&self, quarter: f64, points: &Points, share: f64) -> f64 {
        let order = self.coefficients.order;
        let function = if quarter <= self.near_limit {
            polynomial(&self.near, quarter) / points.share.sqrt()
        } else {
            let growth = if order == 0.0 { 1.0 } else { (order * points.ratio).exp() };
            self.factor.evaluate(points.ratio / self.cutoff.reach()) * growth
        };
        let factor = self.coefficients.strength * share * function / points.larger;
        factor.clamp(-f64::MAX, f64::MAX)
    }

    /// The split at `x = s`: `A = kappa/x`, `B = (kappa/x) [1 - (e^l/x)^q]/q`, which is `-A sigma(x e^-l)`.
    pub(super) fn on_diagonal(&self, x: f64) -> Split {
        let factor = self.coefficients.strength / x;
        let exponent = 2.0 * self.coefficients.exponent;
        let logarithm = self.coefficients.shift - x.ln();
        let rest = if exponent == 0.0 {
            -factor * logarithm
        } else {
            -factor * (exponent * logarithm).exp_m1() / exponent
        };
        Split { factor: factor.min(f64::MAX), rest: rest.clamp(-f64::MAX, f64::MAX) }
    }

    /// `W(x, x)`: infinite for `gamma >= 0`.
    pub(super) fn at(&self, x: f64) -> f64 {
        let gamma = self.coefficients.exponent;
        if gamma >= 0.0 || x == 0.0 {
            return f64::INFINITY;
        }
        self.near_strength / (-2.0 * gamma) * x.powf(-1.0 - 2.0 * gamma)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_value_alone_is_that_of_the_pair() {
        for (order, exponent) in [(0.0, 0.0), (1.0, 0.0), (0.0, 0.2), (2.5, -0.3)] {
            let tables = Tables::new(1.0, order, exponent);
            let places = [0.0, 1e-200, 1e-9, 0.3, 0.3 + 1e-12, 0.31, 0.6, 1.0, 1.7];
            for (i, x) in places.into_iter().enumerate() {
                for s in places.into_iter().skip(i + 1) {
                    let (both, alone) = (tables.pair(x, s, s - x), tables.value(s, x, s - x));
                    assert_eq!(both.value.to_bits(), alone.to_bits(), "{order} {exponent} {x} {s}");
                }
            }
        }
    }
}

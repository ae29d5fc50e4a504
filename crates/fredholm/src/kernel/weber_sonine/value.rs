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
    coefficients: Coefficients,
    /// Largest `delta^2/4` of the series.
    near_limit: f64,
    /// `F_1` by powers of `delta^2/4`.
    near: Near,
    /// `(F_1 - F_2)/q` likewise.
    difference: Near,
    /// `kappa e^(q l)`.
    near_strength: f64,
    far_strength: f64,
    /// The hypergeometric function of `s^2/x^2` by `1 - s^2/x^2`.
    far: Dyadic,
    /// `e^((1/2-mu) r) F_1` by `r` over the reach of the cutoff.
    factor: Dyadic,
    cutoff: Cutoff,
    /// `ln a`.
    radius: f64,
}

/// Two points by their logarithms.
struct Logarithms {
    /// `ln(x s)`.
    product: f64,
    /// `|ln(x/s)|`.
    ratio: f64,
    /// `ln max(x, s)`.
    larger: f64,
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
            let value = if self.coefficients.order == 0.0 { self.at_centre(larger) } else { 0.0 };
            return Pair { value, factor: 0.0 };
        }
        // Deep in the corner the difference of their logarithms would not hold the ratio.
        let quotient = smaller / larger;
        let (of_larger, ratio) = (larger.ln(), -quotient.ln());
        let logarithms = Logarithms { product: 2.0 * of_larger - ratio, ratio, larger: of_larger };
        let share = distance / larger;
        let quarter = 0.25 * share * (distance / smaller);
        let value = if quarter <= self.near_limit {
            self.near_value(quarter, distance, &logarithms)
        } else {
            self.far_value(share * (1.0 + quotient), &logarithms)
        };
        let depth = self.radius - 0.5 * logarithms.product;
        Pair { value: value.min(f64::MAX), factor: self.factor(quarter, &logarithms, depth) }
    }

    /// `W(x, 0) = C x^(-1-2 gamma)` for the order 0.
    fn at_centre(&self, x: f64) -> f64 {
        let power = -1.0 - 2.0 * self.coefficients.exponent;
        (self.far_strength * x.powf(power)).min(f64::MAX)
    }

    fn near_value(&self, quarter: f64, distance: f64, logarithms: &Logarithms) -> f64 {
        let gamma = self.coefficients.exponent;
        let logarithm = distance.ln() - 0.5 * logarithms.product + self.coefficients.shift;
        let sigma = if gamma == 0.0 {
            -logarithm
        } else {
            (-2.0 * gamma * logarithm).exp_m1() / (2.0 * gamma)
        };
        let sum = polynomial(&self.near, quarter) * sigma + polynomial(&self.difference, quarter);
        self.near_strength * (-(0.5 + gamma) * logarithms.product).exp() * sum
    }

    fn far_value(&self, rest_of_square: f64, logarithms: &Logarithms) -> f64 {
        let Coefficients { order, exponent, .. } = self.coefficients;
        let power = -(1.0 + 2.0 * exponent) * logarithms.larger - order * logarithms.ratio;
        self.far_strength * power.exp() * self.far.evaluate(rest_of_square)
    }

    /// `A = kappa F_1 / sqrt(x s)` with the cutoff.
    fn factor(&self, quarter: f64, logarithms: &Logarithms, depth: f64) -> f64 {
        let cutoff = self.cutoff.value(logarithms.ratio, depth);
        if cutoff == 0.0 {
            return 0.0;
        }
        let Logarithms { product, ratio, .. } = *logarithms;
        let (function, growth) = if quarter <= self.near_limit {
            (polynomial(&self.near, quarter), 0.0)
        } else {
            let share = ratio / self.cutoff.reach();
            (self.factor.evaluate(share), (self.coefficients.order - 0.5) * ratio)
        };
        let scale = (growth - 0.5 * product).exp();
        (self.coefficients.strength * cutoff * function * scale).clamp(-f64::MAX, f64::MAX)
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

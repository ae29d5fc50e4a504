//! Chebyshev series summed in twice the precision, at several places together.

use crate::allowance::UNIT;
use crate::sum::{two_product, two_sum};

/// Places that advance together.
pub(crate) const LANES: usize = 8;

/// Numbers as sums of two.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Doubles {
    pub(crate) high: [f64; LANES],
    pub(crate) low: [f64; LANES],
}

impl Doubles {
    pub(crate) const ZERO: Self = Self { high: [0.0; LANES], low: [0.0; LANES] };
}

/// `sum c_k T_k(t)` for coefficients that are sums of two numbers each, by Clenshaw's scheme.
///
/// All sums and products are off by some squared units of the sizes of their terms, which [`NEGLIGIBLE`] counts.
#[inline(always)]
pub(crate) fn chebyshev(coefficients: &[[f64; 2]], t: &Doubles) -> Doubles {
    let (mut next, mut after) = (Doubles::ZERO, Doubles::ZERO);
    let Some((first, rest)) = coefficients.split_first() else { return next };
    for c in rest.iter().rev() {
        (next, after) = (step(*c, t, 2.0, &next, &after), next);
    }
    step(*first, t, 1.0, &next, &after)
}

/// What [`chebyshev`] is off by, relative to the sum of the sizes of at most 64 coefficients: a step by less than `32 u^2` of what it adds, three numbers of which none exceeds 64 times that sum.
pub(crate) const NEGLIGIBLE: f64 = 64.0 * 32.0 * 256.0 * UNIT * UNIT;

/// `c + factor t next - after` for a factor of 1 or 2.
#[inline(always)]
fn step(c: [f64; 2], t: &Doubles, factor: f64, next: &Doubles, after: &Doubles) -> Doubles {
    let mut found = Doubles::ZERO;
    for i in 0..LANES {
        let (high, low) = (factor * t.high[i], factor * t.low[i]);
        let (product, mut lost) = two_product(high, next.high[i]);
        lost += high * next.low[i] + low * next.high[i];
        let (rest, lost_here) = two_sum(c[0], -after.high[i]);
        let (sum, lost_there) = two_sum(product, rest);
        let small = lost + lost_here + lost_there + (c[1] - after.low[i]);
        found.high[i] = sum + small;
        found.low[i] = small - (found.high[i] - sum);
    }
    found
}

/// `(x - c) inverse`, without rounding but for some squared units.
#[inline(always)]
pub(crate) fn placed(x: &[f64; LANES], c: f64, inverse: f64) -> Doubles {
    let mut found = Doubles::ZERO;
    for (i, x) in x.iter().enumerate() {
        let (difference, lost) = two_sum(*x, -c);
        let (product, error) = two_product(difference, inverse);
        found.high[i] = product;
        found.low[i] = error + lost * inverse;
    }
    found
}

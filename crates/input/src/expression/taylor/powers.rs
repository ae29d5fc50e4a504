//! Taylor coefficients of powers with a constant exponent.

use super::super::enclose::Enclosure;
use super::super::function::Binary;
use super::super::interval::Interval;
use super::super::value::Value;
use super::series::Series;

/// Largest exponent that is multiplied out.
const MOST_FACTORS: f64 = 1e6;

/// The values of `u^exponent`.
fn power_of(u: Interval, exponent: f64) -> Interval {
    let exponent = Enclosure::constant(exponent);
    Enclosure::binary(Binary::Power, Enclosure::defined(u), exponent).interval
}

impl Series {
    /// `u^p` with values in `first`.
    pub(super) fn power(&self, p: f64, first: Interval, order: usize) -> Self {
        let base = self.get(0);
        let is_whole = p.fract() == 0.0 && (0.0..=MOST_FACTORS).contains(&p);
        if is_whole && self.stored() == 2 && self.is_polynomial() {
            return self.power_of_line(p, first, order);
        }
        // A polynomial remains one if its degree is looked at in full.
        let degree = p * self.stored().saturating_sub(1) as f64;
        if is_whole && self.is_polynomial() && degree <= order as f64 {
            return self.multiplied_out(p as u32, order).with_first(first);
        }
        if !base.contains(0.0) {
            return self.power_recurrence(p, 1.0, first, order);
        }
        if is_whole {
            return self.multiplied_out(p as u32, order).with_first(first);
        }
        if p < 0.0 {
            return Self::cut(vec![first]);
        }
        self.power_at_root(p, first, order)
    }

    /// `u^(p/q)` with `0 < p < q`: at a root of `u` the slope is unbounded.
    pub(super) fn root(&self, p: f64, q: f64, first: Interval, order: usize) -> Self {
        if self.get(0).contains(0.0) {
            return Self::cut(vec![first]);
        }
        self.power_recurrence(p, q, first, order)
    }

    /// From `u g' = (p/q) u' g`: `k u_0 g_k = sum_(j=1)^k (j p/q - k + j) u_j g_(k-j)`.
    fn power_recurrence(&self, p: f64, q: f64, first: Interval, order: usize) -> Self {
        let base = self.get(0);
        Self::build(first, self.known(order), |g, k| {
            let mut sum = super::sum::Sum::default();
            for j in 1..=k.min(self.stored().saturating_sub(1)) {
                let (grows, falls) = (j as f64 * p, (k - j) as f64 * q);
                sum.add_near(grows - falls, grows.abs() + falls, self.get(j), g[k - j]);
            }
            sum.over(k as f64 * q).over(base).0
        })
    }

    /// `(u_0 + u_1 s)^p` for a whole exponent: `g_k = binomial(p, k) u_1^k u_0^(p-k)`, for which `u_0` may be anything.
    fn power_of_line(&self, p: f64, first: Interval, order: usize) -> Self {
        let count = (p as usize).min(order) + 1;
        let (base, slope) = (self.get(0), self.get(1));
        let mut factor = Interval::ONE;
        let mut terms = vec![first];
        for k in 1..count {
            let j = k as f64;
            let mut next = super::sum::Sum::default();
            next.add(p - j + 1.0, factor, slope);
            factor = next.over(j);
            terms.push(factor.times(power_of(base, p - j)).0);
        }
        if p as usize <= order { Self::polynomial(terms) } else { Self::cut(terms) }
    }

    fn multiplied_out(&self, exponent: u32, order: usize) -> Self {
        let mut product = Self::constant(Interval::ONE);
        for bit in (0..u32::BITS - exponent.leading_zeros()).rev() {
            product = product.square(order);
            if exponent >> bit & 1 == 1 {
                product = product.times(self, order);
            }
        }
        product
    }

    /// `u^p` where `u` may be zero, `p` between two whole numbers: from `g' = p u^(p-1) u'` as many coefficients as are bounded.
    fn power_at_root(&self, p: f64, first: Interval, order: usize) -> Self {
        if p < 1.0 || order == 0 {
            return Self::cut(vec![first]);
        }
        let below = self.power_at_root(p - 1.0, power_of(self.get(0), p - 1.0), order - 1);
        let factor = Interval::ends(p, p);
        Self::build(first, self.known(order).min(below.stored() + 1), |_, k| {
            self.chain(1.0, below.terms(), k).times(factor).0
        })
    }
}

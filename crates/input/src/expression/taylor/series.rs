//! Taylor coefficients as intervals: sums, products, quotients and what is defined by `g' = u' h`.

use super::super::interval::Interval;
use super::super::intervals;
use super::sum::Sum;

/// The enclosed coefficients of a function over an interval, from order 0 on; all are bounded.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    terms: Vec<Interval>,
    /// Whether the coefficients beyond are zero; if not, nothing is known of them.
    is_polynomial: bool,
}

impl Series {
    pub(super) fn unknown() -> Self {
        Self { terms: Vec::new(), is_polynomial: false }
    }

    /// The coefficients beyond these are zero.
    pub fn polynomial(terms: Vec<Interval>) -> Self {
        Self::limited(terms, true)
    }

    /// Nothing is known beyond these.
    pub fn cut(terms: Vec<Interval>) -> Self {
        Self::limited(terms, false)
    }

    fn limited(mut terms: Vec<Interval>, is_polynomial: bool) -> Self {
        let bounded = terms.iter().take_while(|term| term.is_bounded()).count();
        let is_polynomial = is_polynomial && bounded == terms.len() && bounded > 0;
        terms.truncate(bounded);
        Self { terms, is_polynomial }
    }

    pub(super) fn constant(value: Interval) -> Self {
        Self::polynomial(vec![value])
    }

    /// The coefficients after a first one, each from those before it, as long as they are bounded.
    pub(super) fn build(
        first: Interval,
        known: usize,
        next: impl Fn(&[Interval], usize) -> Interval,
    ) -> Self {
        let mut terms = vec![first];
        while terms.len() < known && terms.last().is_some_and(|term| term.is_bounded()) {
            let term = next(&terms, terms.len());
            terms.push(term);
        }
        Self::cut(terms)
    }

    /// The coefficient of order `k`; the whole line where nothing is known of it.
    pub fn get(&self, k: usize) -> Interval {
        let beyond = if self.is_polynomial { Interval::ZERO } else { Interval::WHOLE };
        self.terms.get(k).copied().unwrap_or(beyond)
    }

    /// Coefficients that are stored.
    pub(super) fn stored(&self) -> usize {
        self.terms.len()
    }

    pub(super) fn is_polynomial(&self) -> bool {
        self.is_polynomial
    }

    pub(super) fn is_constant(&self) -> bool {
        self.is_polynomial && self.terms.len() == 1
    }

    /// How many coefficients up to an order are bounded.
    pub(super) fn known(&self, order: usize) -> usize {
        if self.is_polynomial { order + 1 } else { self.terms.len().min(order + 1) }
    }

    /// The same with another enclosure of the values.
    pub(super) fn with_first(mut self, first: Interval) -> Self {
        if let Some(term) = self.terms.first_mut() {
            *term = first;
        }
        Self::limited(self.terms, self.is_polynomial)
    }

    fn map(&self, change: impl Fn(Interval) -> Interval) -> Self {
        Self::limited(self.terms.iter().map(|&term| change(term)).collect(), self.is_polynomial)
    }

    pub(super) fn negated(&self) -> Self {
        self.map(Interval::negated)
    }

    pub(super) fn times_constant(&self, factor: Interval) -> Self {
        Self::limited(intervals::products(&self.terms, factor), self.is_polynomial)
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        let (short, long) =
            if self.stored() < other.stored() { (self, other) } else { (other, self) };
        let is_polynomial = self.is_polynomial && other.is_polynomial;
        let mut terms = intervals::sums(&short.terms, &long.terms[..short.stored()]);
        if short.is_polynomial {
            terms.extend_from_slice(&long.terms[short.stored()..]);
        }
        Self::limited(terms, is_polynomial)
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// The orders of a product up to one, and whether there are none beyond.
    fn product_length(&self, other: &Self, order: usize) -> (usize, bool) {
        let known = self.known(order).min(other.known(order));
        let length = (self.stored() + other.stored()).saturating_sub(1);
        let is_polynomial = self.is_polynomial && other.is_polynomial && length <= order + 1;
        (
            if self.is_polynomial && other.is_polynomial { known.min(length) } else { known },
            is_polynomial,
        )
    }

    pub(super) fn times(&self, other: &Self, order: usize) -> Self {
        if self.is_constant() {
            return other.times_constant(self.get(0));
        }
        if other.is_constant() {
            return self.times_constant(other.get(0));
        }
        let (count, is_polynomial) = self.product_length(other, order);
        let term = |k: usize| {
            let mut sum = Sum::default();
            for j in (k + 1).saturating_sub(other.stored())..=k.min(self.stored().saturating_sub(1))
            {
                sum.add(1.0, self.get(j), other.get(k - j));
            }
            sum.total()
        };
        Self::limited((0..count).map(term).collect(), is_polynomial)
    }

    pub(super) fn square(&self, order: usize) -> Self {
        let (count, is_polynomial) = self.product_length(self, order);
        Self::limited((0..count).map(|k| self.square_term(k)).collect(), is_polynomial)
    }

    pub(super) fn square_term(&self, k: usize) -> Interval {
        let mut sum = Sum::default();
        for j in (k + 1).saturating_sub(self.stored())..k.div_ceil(2) {
            sum.add(2.0, self.get(j), self.get(k - j));
        }
        if k.is_multiple_of(2) {
            sum.add_one(1.0, self.get(k / 2).square());
        }
        sum.total()
    }

    /// The quotient whose values are enclosed by `first`.
    pub(super) fn over(&self, other: &Self, first: Interval, order: usize) -> Self {
        let divisor = other.get(0);
        if other.is_constant() {
            return self.map(|term| term.over(divisor).0).with_first(first);
        }
        Self::build(first, self.known(order).min(other.known(order)), |g, k| {
            let mut sum = Sum::default();
            sum.add_one(1.0, self.get(k));
            for j in 1..=k.min(other.stored().saturating_sub(1)) {
                sum.add(-1.0, other.get(j), g[k - j]);
            }
            sum.total().over(divisor).0
        })
    }

    /// `g_k` of `g' = u' h`: `(1/k) sum_(j=1)^k j u_j h_(k-j)`.
    pub(super) fn chain(&self, sign: f64, h: &[Interval], k: usize) -> Interval {
        let mut sum = Sum::default();
        for j in 1..=k.min(self.stored().saturating_sub(1)) {
            sum.add(sign * j as f64, self.get(j), h[k - j]);
        }
        sum.over(k as f64)
    }

    /// `g` of `g' = u'/w` with values in `first`.
    pub(super) fn integral_over(&self, w: &Self, first: Interval, order: usize) -> Self {
        let divisor = w.get(0);
        // The coefficient `k` needs those of `w` below `k` only.
        let known = self.known(order).min(w.known(order) + 1).min(order + 1);
        Self::build(first, known, |g, k| {
            let mut sum = Sum::default();
            sum.add_one(k as f64, self.get(k));
            for i in 1..k.min(w.stored()) {
                sum.add(-((k - i) as f64), w.get(i), g[k - i]);
            }
            sum.over(k as f64).over(divisor).0
        })
    }

    pub(super) fn terms(&self) -> &[Interval] {
        &self.terms
    }
}

//! Intervals side by side: sums, products, quotients and waves of most formulae on whole vectors.
//!
//! Each is that of [`Interval`] by itself to the last bit. What is rare there (an end that is infinite, a product of two intervals about zero, a quotient by one) goes one by one.

use super::interval::{Interval, product_by_sign, quotient_by_sign, summed_up};
use super::periodic::{Crest, wave_between};
use super::waves::{cosines, sines};

/// Intervals of a list that are taken at once.
const LANES: usize = 8;

/// Intervals by their ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Intervals<const COUNT: usize> {
    lower: [f64; COUNT],
    upper: [f64; COUNT],
}

/// Results, and whether each may be undefined.
type Known<const COUNT: usize> = (Intervals<COUNT>, [bool; COUNT]);

impl<const COUNT: usize> Intervals<COUNT> {
    #[inline(always)]
    pub(super) fn of(intervals: &[Interval; COUNT]) -> Self {
        Self::ends(|k| [intervals[k].lower(), intervals[k].upper()])
    }

    #[inline(always)]
    pub(super) fn same(interval: Interval) -> Self {
        Self { lower: [interval.lower(); COUNT], upper: [interval.upper(); COUNT] }
    }

    #[inline(always)]
    pub(super) fn one(&self, k: usize) -> Interval {
        Interval::ends(self.lower[k], self.upper[k])
    }

    #[inline(always)]
    fn pair(&self, k: usize) -> [f64; 2] {
        [self.lower[k], self.upper[k]]
    }

    #[inline(always)]
    pub(super) fn ones(&self) -> [Interval; COUNT] {
        std::array::from_fn(|k| self.one(k))
    }

    #[inline(always)]
    pub(super) fn negated(self) -> Self {
        Self::ends(|k| [-self.upper[k], -self.lower[k]])
    }

    #[inline(always)]
    pub(super) fn plus(self, other: Self) -> Known<COUNT> {
        let sum = Self::ends(
            #[inline(always)]
            |k| {
                let lower = -summed_up(-self.lower[k], -other.lower[k]);
                [lower, summed_up(self.upper[k], other.upper[k])]
            },
        );
        self.clear_or_alone(other, (sum, true), Interval::plus)
    }

    #[inline(always)]
    pub(super) fn times(self, other: Self) -> Known<COUNT> {
        let is_clear = (0..COUNT)
            .fold(true, |all, k| all & (has_one_sign(self.pair(k)) | has_one_sign(other.pair(k))));
        let product = Self::ends(
            #[inline(always)]
            |k| product_by_sign(self.pair(k), other.pair(k)),
        );
        self.clear_or_alone(other, (product, is_clear), Interval::times)
    }

    #[inline(always)]
    pub(super) fn over(self, other: Self) -> Known<COUNT> {
        let is_clear =
            (0..COUNT).fold(true, |all, k| all & ((other.lower[k] > 0.0) | (other.upper[k] < 0.0)));
        let quotient = Self::ends(
            #[inline(always)]
            |k| quotient_by_sign(self.pair(k), other.pair(k)),
        );
        self.clear_or_alone(other, (quotient, is_clear), Interval::over)
    }

    /// What was found by the ends, if that is clear and all is finite, else each pair by itself.
    #[inline(always)]
    fn clear_or_alone(
        self,
        other: Self,
        (found, is_clear): (Self, bool),
        alone: fn(Interval, Interval) -> (Interval, bool),
    ) -> Known<COUNT> {
        if is_clear & self.are_bounded() & other.are_bounded() & found.are_bounded() {
            (found, [false; COUNT])
        } else {
            self.pair_by_pair(&other, alone)
        }
    }

    #[inline(always)]
    pub(super) fn sine(self) -> Known<COUNT> {
        self.wave(sines(self.lower), sines(self.upper), Crest::OF_SINE)
    }

    #[inline(always)]
    pub(super) fn cosine(self) -> Known<COUNT> {
        self.wave(cosines(self.lower), cosines(self.upper), Crest::OF_COSINE)
    }

    /// A wave with these values at the ends.
    #[inline(always)]
    fn wave(self, left: [f64; COUNT], right: [f64; COUNT], crest: Crest) -> Known<COUNT> {
        if self.are_bounded() {
            let waves = Self::ends(
                #[inline(always)]
                |k| wave_between(self.pair(k), [left[k], right[k]], crest),
            );
            (waves, [false; COUNT])
        } else {
            let one = |k: usize| crest.wave(self.one(k));
            Self::known(std::array::from_fn(one))
        }
    }

    /// By a loop, which is compiled for the vectors of its surroundings: closures of `array::map` may not be.
    #[inline(always)]
    fn ends(of: impl Fn(usize) -> [f64; 2]) -> Self {
        let mut found = Self { lower: [0.0; COUNT], upper: [0.0; COUNT] };
        for k in 0..COUNT {
            [found.lower[k], found.upper[k]] = of(k);
        }
        found
    }

    /// Whether all ends are finite.
    #[inline(always)]
    fn are_bounded(&self) -> bool {
        (0..COUNT).fold(true, |all, k| {
            all & (self.lower[k].abs() <= f64::MAX) & (self.upper[k].abs() <= f64::MAX)
        })
    }

    #[cold]
    #[inline(never)]
    fn pair_by_pair(
        &self,
        other: &Self,
        of: fn(Interval, Interval) -> (Interval, bool),
    ) -> Known<COUNT> {
        Self::known(std::array::from_fn(|k| of(self.one(k), other.one(k))))
    }

    fn known(ones: [(Interval, bool); COUNT]) -> Known<COUNT> {
        (Self::of(&ones.map(|(interval, _)| interval)), ones.map(|(_, undefined)| undefined))
    }
}

/// Each interval times the same factor.
pub(super) fn products(terms: &[Interval], factor: Interval) -> Vec<Interval> {
    pulp::Arch::new().dispatch(Products { terms, factor })
}

/// Sums of as many intervals, pair by pair.
pub(super) fn sums(terms: &[Interval], others: &[Interval]) -> Vec<Interval> {
    pulp::Arch::new().dispatch(Sums { terms, others })
}

struct Products<'a> {
    terms: &'a [Interval],
    factor: Interval,
}

struct Sums<'a> {
    terms: &'a [Interval],
    others: &'a [Interval],
}

impl pulp::NullaryFnOnce for Products<'_> {
    type Output = Vec<Interval>;

    #[inline(always)]
    fn call(self) -> Self::Output {
        let factor = Intervals::same(self.factor);
        let mut found = Vec::with_capacity(self.terms.len());
        for terms in self.terms.chunks(LANES) {
            let product = Intervals::filled(terms).times(factor).0;
            found.extend_from_slice(&product.ones()[..terms.len()]);
        }
        found
    }
}

impl pulp::NullaryFnOnce for Sums<'_> {
    type Output = Vec<Interval>;

    #[inline(always)]
    fn call(self) -> Self::Output {
        let mut found = Vec::with_capacity(self.terms.len());
        for (terms, others) in self.terms.chunks(LANES).zip(self.others.chunks(LANES)) {
            let sum = Intervals::filled(terms).plus(Intervals::filled(others)).0;
            found.extend_from_slice(&sum.ones()[..terms.len()]);
        }
        found
    }
}

impl Intervals<LANES> {
    /// At most as many intervals, and zero beyond.
    #[inline(always)]
    fn filled(terms: &[Interval]) -> Self {
        let mut found = Self { lower: [0.0; LANES], upper: [0.0; LANES] };
        for (k, term) in terms.iter().take(LANES).enumerate() {
            (found.lower[k], found.upper[k]) = (term.lower(), term.upper());
        }
        found
    }
}

/// Whether an interval has no numbers on one side of zero.
#[inline(always)]
fn has_one_sign([lower, upper]: [f64; 2]) -> bool {
    (lower >= 0.0) | (upper <= 0.0)
}

//! What the terms of a solution of the first kind leave out.

use std::ops::Range;

use super::checks;
use crate::kernel::SpectralRelation;

/// Places per term, and most of them: a sum is largest within an eighth of a half-wave of its last term from one of them, where it has fallen by less than 2 %.
const PLACES_PER_TERM: usize = 8;
const MOST_PLACES: usize = 1 << 14;
/// Fewest terms from which a rate is told: two, in the shortest block of them.
const LEAST: usize = 16;
/// By how much the ratio of two sums may be off for those 2 %.
const RATIO: f64 = 0.02;
/// Safety on what is extrapolated: aliasing spoils the last terms by as much as is left out.
const SAFETY: f64 = 2.0;
/// A sum that is not this many times as large as rounding makes it is rounding: the largest of as many sums of random signs as there are places is some four times the mean one.
const NOISY: f64 = 8.0;

/// What lies beyond the first `kept` terms `c_n / lambda_n phi_n`.
///
/// Behind a bend with a power the terms fall by a power of `n`, and the blocks of terms from one doubling of `n` to the next by a ratio `r`, which may be near 1. The difference of two
/// resolutions is one block, what is left out all later ones: `r/(1 - r)` times as much. And a block is seen in full at the bend alone, a narrow place that must be looked for.
pub(super) struct Remainder<'r> {
    pub(super) relation: &'r dyn SpectralRelation,
    /// `c_n / lambda_n`, as far as known.
    pub(super) density: &'r [f64],
    /// Number of terms of the solution.
    pub(super) kept: usize,
    /// Whether the others are below rounding of the right-hand side.
    pub(super) is_whole: bool,
    /// What rounding may make of a coefficient of the right-hand side.
    pub(super) noise: f64,
}

impl Remainder<'_> {
    /// The largest value of what is left out, over the weight.
    pub(super) fn solution(&self) -> f64 {
        let size = |block: Range<usize>| self.largest(block);
        self.beyond(&size)
    }

    /// Its integral, as if no terms cancelled.
    pub(super) fn integral(&self) -> f64 {
        let size = |block: Range<usize>| {
            block.map(|n| (self.density[n] * self.relation.mass(n)).abs()).sum()
        };
        self.beyond(&size)
    }

    fn beyond(&self, size: &dyn Fn(Range<usize>) -> f64) -> f64 {
        let known = self.density.len();
        let omitted = |end: usize| if self.kept < end { size(self.kept..end) } else { 0.0 };
        let whole = if self.is_whole { omitted(known) } else { 0.0 };
        // Aliasing may spoil the upper half of what is known.
        let top = known / 2;
        let mut end = top;
        while end >= LEAST && self.is_noise(end / 2..end) {
            end /= 2;
        }
        if end < LEAST {
            return SAFETY * whole.max(omitted(top));
        }
        let [block, before, first] = [1, 2, 4].map(|part| size(end / (2 * part)..end / part));
        if block == 0.0 {
            return SAFETY * whole.max(omitted(top));
        }
        let [rate, former] = [block / before, before / first];
        let seen = rate.max((block / first).sqrt()) * (1.0 + RATIO);
        // A rate that still grows, as behind a bend beside an end, is taken to grow by as much again, up to half the way to one.
        let rate = seen + (rate - former).max(0.0).min(0.5 * (1.0 - seen).max(0.0));
        // Terms that do not fall where they are seen may yet be known until they are rounding.
        let later = match rate < 1.0 {
            true => block * rate / (1.0 - rate),
            false if self.is_whole => 0.0,
            false => f64::INFINITY,
        };
        SAFETY * whole.max(omitted(end) + later)
    }

    /// Whether rounding makes as much of a block.
    fn is_noise(&self, block: Range<usize>) -> bool {
        let square = |n: usize| self.relation.eigenvalue(n).powi(-2);
        let rounding = self.noise * block.clone().map(square).sum::<f64>().sqrt();
        self.largest(block) <= NOISY * rounding
    }

    /// The largest sum of a block, at places as close as it needs.
    fn largest(&self, block: Range<usize>) -> f64 {
        let mut terms = self.density[..block.end].to_vec();
        terms[..block.start].fill(0.0);
        if let Some(largest) = self.relation.largest_sum(&terms) {
            return largest;
        }
        let sum = self.relation.combination(&terms);
        let places = (PLACES_PER_TERM * block.end).min(MOST_PLACES);
        checks(self.relation.extent(), places).map(|x| sum(x).abs()).fold(0.0, f64::max)
    }
}

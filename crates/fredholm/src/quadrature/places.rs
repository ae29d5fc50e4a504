//! Places to look at a function that can only be asked for values.
//!
//! A function is known where it was asked, and nowhere else: whoever knows it at nodes alone has to look between them, at places that no grid has. A feature that is
//! narrower than the gaps between these places too may still be overlooked; only who has a formula can exclude it.

use std::sync::LazyLock;

use crate::kernel::Kernel;
use crate::linear::vector::largest;
use crate::{Error, Interval};

/// How many places there are from end to end, evenly spread: a feature is seen that covers a 2000th of the interval.
const EVEN: usize = 4093;
/// How many there are crowded at the ends as cosines.
const CROWDED: usize = 2039;
/// Steps of both sequences: irrational, so that they keep step with no grid, and not of one field, so that they do not with each other.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
const SILVER: f64 = std::f64::consts::SQRT_2 - 1.0;
/// Differences below this share of the largest value are rounding.
pub(crate) const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Of a misfit, so many places at most count in a potential.
const DOMINANT: usize = 600;
/// A misfit below this share of the largest does not count while there are larger ones.
const SHARE: f64 = 1e-3;

/// The places on `(-1, 1)`, from left to right: sorting them takes longer than most equations.
static UNIT_PLACES: LazyLock<Vec<f64>> = LazyLock::new(|| {
    let even = (1..=EVEN).map(|i| 2.0 * (i as f64 * GOLDEN).fract() - 1.0);
    let crowded =
        (1..=CROWDED).map(|i| -(std::f64::consts::PI * (i as f64 * SILVER).fract()).cos());
    let mut places: Vec<f64> = even.chain(crowded).collect();
    places.sort_by(f64::total_cmp);
    places
});

/// The places, from left to right.
pub(crate) fn places(interval: Interval) -> Vec<f64> {
    let (left, right) = (interval.left(), interval.right());
    let (centre, half) = (interval.centre(), interval.half_length());
    let mut places: Vec<f64> = UNIT_PLACES.iter().map(|xi| centre + half * xi).collect();
    // Rounding may carry the outermost to the ends.
    places.truncate(places.partition_point(|x| *x < right));
    places.drain(..places.partition_point(|x| *x <= left));
    places
}

/// Places in every part between neighbouring cuts.
const IN_PART: usize = 33;

/// The places, and those in every part of the interval between neighbouring cuts.
pub(crate) fn places_in_parts(interval: Interval, cuts: &[f64]) -> Vec<f64> {
    let mut places = places(interval);
    if cuts.is_empty() {
        return places;
    }
    let ends = with_ends(interval, cuts);
    for (left, right) in ends.iter().zip(ends.iter().skip(1)) {
        let (centre, half) = (left.midpoint(*right), 0.5 * (right - left));
        let inside = (1..=IN_PART)
            .map(|i| centre - half * (std::f64::consts::PI * (i as f64 * SILVER).fract()).cos())
            .filter(|x| left < x && x < right);
        places.extend(inside);
    }
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

/// The cuts inside an interval between its ends, from left to right.
pub(crate) fn with_ends(interval: Interval, cuts: &[f64]) -> Vec<f64> {
    let (left, right) = (interval.left(), interval.right());
    let mut all: Vec<f64> = cuts.iter().copied().filter(|x| left < *x && *x < right).collect();
    all.extend([left, right]);
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// A function at those places.
pub(crate) struct Sampled {
    pub(crate) interval: Interval,
    /// Between these the function is known to be nearly a polynomial.
    pub(crate) cuts: Vec<f64>,
    pub(crate) places: Vec<f64>,
    pub(crate) values: Vec<f64>,
    /// The largest value.
    pub(crate) largest: f64,
}

impl Sampled {
    /// # Errors
    /// [`Error::NotFinite`] where the function is not finite.
    pub(crate) fn new(
        interval: Interval,
        f: &(impl Fn(f64) -> f64 + ?Sized),
        cuts: &[f64],
    ) -> Result<Self, Error> {
        let places = places_in_parts(interval, cuts);
        let values: Vec<f64> = places.iter().map(|x| f(*x)).collect();
        let largest = largest(&values);
        if !largest.is_finite() {
            let culprit = values.iter().position(|value| !value.is_finite()).unwrap_or(0);
            let (at, value) = (places[culprit], values[culprit]);
            return Err(Error::NotFinite { what: "right-hand side", at, value });
        }
        Ok(Self { interval, cuts: cuts.to_vec(), places, values, largest })
    }

    /// The same function at other places.
    pub(crate) fn moved(&self, mut pairs: Vec<(f64, f64)>) -> Self {
        pairs.sort_by(|one, two| one.0.total_cmp(&two.0));
        pairs.dedup_by_key(|(place, _)| *place);
        let (places, values) = pairs.into_iter().unzip();
        Self { cuts: self.cuts.clone(), places, values, ..*self }
    }

    /// Length of what is nearer to a place than to others.
    pub(crate) fn cell(&self, index: usize) -> f64 {
        let at = |i: usize| self.places[i];
        let left =
            if index == 0 { self.interval.left() } else { at(index - 1).midpoint(at(index)) };
        let right = match self.places.get(index + 1) {
            Some(next) => at(index).midpoint(*next),
            None => self.interval.right(),
        };
        right - left
    }

    /// The largest `|K delta|` at the extremes of a density and at some more places.
    pub(crate) fn potential(
        &self,
        kernel: &dyn Kernel,
        density: &[(usize, f64)],
        more: &[f64],
    ) -> f64 {
        let extremes = [1.0, -1.0].map(|sign: f64| {
            density.iter().max_by(|one, two| (sign * one.1).total_cmp(&(sign * two.1)))
        });
        let tops = extremes.into_iter().flatten().map(|(index, _)| self.places[*index]);
        let at = |x: f64| {
            let term = |(index, value): &(usize, f64)| {
                let (s, cell) = (self.places[*index], self.cell(*index));
                let distance = (x - s).abs();
                let k = if distance < cell {
                    // The mean of a singular function over its cell is met at about a quarter of it.
                    let near = 0.25 * cell;
                    kernel.split(s, s, 0.0).value(kernel.singularity(), near)
                } else {
                    kernel.pair(x, s, distance).value
                };
                k * value * cell * kernel.measure(s)
            };
            density.iter().map(term).sum::<f64>().abs()
        };
        tops.chain(more.iter().copied()).map(at).fold(0.0, f64::max)
    }

    /// `int u delta dm`.
    pub(crate) fn integral(
        &self,
        kernel: &dyn Kernel,
        density: &[(usize, f64)],
        u: &dyn Fn(f64) -> f64,
    ) -> f64 {
        let term = |(index, value): &(usize, f64)| {
            let s = self.places[*index];
            u(s) * kernel.measure(s) * value * self.cell(*index)
        };
        density.iter().map(term).sum()
    }
}

/// The differences that matter, with their indices; none where all are rounding of a function with this largest value. Of too many every other, or third, with twice the weight, or three times.
pub(crate) fn dominant(differences: &[f64], largest: f64) -> Option<Vec<(usize, f64)>> {
    let most = differences.iter().fold(0.0f64, |most, d| most.max(d.abs()));
    if most <= ROUNDING * largest {
        return None;
    }
    let chosen: Vec<(usize, f64)> = (differences.iter().copied().enumerate())
        .filter(|(_, difference)| difference.abs() > SHARE * most)
        .collect();
    let stride = chosen.len().div_ceil(DOMINANT).max(1);
    Some(chosen.into_iter().step_by(stride).map(|(i, d)| (i, d * stride as f64)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_leave_no_wide_gap() {
        let sampled = Sampled::new(Interval::unit(), &|x| x, &[]).unwrap();
        let cells: Vec<f64> = (0..sampled.places.len()).map(|i| sampled.cell(i)).collect();
        let widest = cells.iter().fold(0.0f64, |most, cell| most.max(*cell));
        assert!(widest < 1e-3, "{widest}");
        let length: f64 = cells.iter().sum();
        assert!((length - 2.0).abs() < 1e-12);
    }
}

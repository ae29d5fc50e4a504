//! Where a pressure is largest, and where it is negative.

use crate::line_search::{crossing, top};
use crate::rounding::OF_A_VALUE;

/// Most sign changes that are sought: of more the samples are dense enough for a straight line (survey).
const MOST_REFINED: usize = 32;
/// Most samples beside which a maximum is sought, the highest first: the more only where crests are alike to what samples tell.
const MOST_CRESTS: usize = 128;
/// A pressure below this, relative to the largest, counts as zero (survey).
pub(crate) const NEGLIGIBLE: f64 = 1e-12;

/// A value and its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extreme {
    pub(crate) place: f64,
    pub(crate) value: f64,
}

/// A function sampled on `[-1, 1]`, from left to right.
pub(crate) struct Sampled<F> {
    f: F,
    points: Vec<f64>,
    values: Vec<f64>,
}

impl<F: Fn(f64) -> f64> Sampled<F> {
    /// `f` with its values at increasing points from -1 to 1; extremes and sign changes are refined between neighbours.
    pub(crate) fn new(f: F, points: Vec<f64>, values: Vec<f64>) -> Self {
        Self { f, points, values }
    }

    /// The largest value and its place; of equal ones the leftmost, but the middle of the base before places found by search that only rounding sets apart from it.
    pub(crate) fn maximum(&self) -> Extreme {
        let found = self.candidates().into_iter().map(|(_, found)| found);
        let found = found.reduce(|best, other| {
            if other.value > best.value + NEGLIGIBLE * best.value.abs() { other } else { best }
        });
        let found = found.unwrap_or(Extreme { place: 0.0, value: f64::NAN });
        let middle = (self.f)(0.0);
        // Beside a maximum of a curvature like its height values tell places apart to the root of what they are known to.
        if found.place.abs() < NEGLIGIBLE.sqrt()
            && middle + NEGLIGIBLE * middle.abs() >= found.value
        {
            Extreme { place: 0.0, value: middle.max(found.value) }
        } else {
            found
        }
    }

    /// The samples beside which the function may be largest, with the largest values there: that with the largest value, and those from which it may rise above all that were found before, the highest first; in
    /// the end from left to right.
    fn candidates(&self) -> Vec<(usize, Extreme)> {
        let (values, mut best) = (&self.values, 0);
        for (i, value) in values.iter().enumerate() {
            if *value > values[best] + NEGLIGIBLE * values[best].abs() {
                best = i;
            }
        }
        let mut found = vec![(best, self.refined(best))];
        let mut highest = found[0].1.value;
        for i in self.tops(values[best]) {
            if i != best && self.reached(i) > highest {
                let other = self.refined(i);
                highest = highest.max(other.value);
                found.push((i, other));
            }
        }
        found.sort_unstable_by_key(|(i, _)| *i);
        found
    }

    /// The values before and after a sample.
    fn neighbours(&self, i: usize) -> [f64; 2] {
        let last = self.values.len().saturating_sub(1);
        [i.saturating_sub(1), (i + 1).min(last)].map(|j| self.values[j])
    }

    /// A sample with a share of the second difference about it: with an eighth of it the most that a parabola through three samples rises to.
    fn raised(&self, i: usize, share: f64) -> f64 {
        let [before, after] = self.neighbours(i);
        self.values[i] + share * (2.0 * self.values[i] - before - after)
    }

    /// What the function may rise to beside a sample: others than parabolas may by more, and four times as much is looked at.
    fn reached(&self, i: usize) -> f64 {
        self.raised(i, 0.5)
    }

    /// The samples beside which the function may rise above a value, the highest first as parabolas tell: where samples are few they rise more, and would come before higher ones where these are many.
    fn tops(&self, value: f64) -> Vec<usize> {
        let is_top =
            |i: &usize| self.neighbours(*i).iter().all(|beside| self.values[*i] >= *beside);
        let tops = (0..self.values.len()).filter(is_top);
        let mut tops: Vec<usize> = tops.filter(|i| self.reached(*i) > value).collect();
        crate::order::sort_by_number(&mut tops, |one| -self.raised(*one, 0.125));
        tops.truncate(MOST_CRESTS);
        tops
    }

    /// Where else than about a place it rises above a value.
    pub(crate) fn elsewhere(&self, place: f64, value: f64) -> Vec<f64> {
        let tops = self.tops(value).into_iter();
        let others = tops.filter(|i| !self.about(*i).contains(&place)).map(|i| self.refined(i));
        others.filter(|top| top.value > value).map(|top| top.place).collect()
    }

    /// The neighbours of a sample.
    fn about(&self, i: usize) -> std::ops::RangeInclusive<f64> {
        self.points[i.saturating_sub(1)]..=self.points[(i + 1).min(self.points.len() - 1)]
    }

    /// The largest value between the neighbours of a sample.
    fn refined(&self, i: usize) -> Extreme {
        let sampled = Extreme { place: self.points[i], value: self.values[i] };
        let about = self.about(i);
        let (place, value) = top(&self.f, *about.start(), *about.end());
        // A value that is larger by rounding alone says nothing of the place.
        let noticeable = OF_A_VALUE * sampled.value.abs();
        if value > sampled.value + noticeable { Extreme { place, value } } else { sampled }
    }

    /// The intervals on which the function is negative beyond rounding.
    pub(crate) fn negative(&self) -> Vec<[f64; 2]> {
        let largest = self.values.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
        let threshold = -NEGLIGIBLE * largest;
        let changes = self
            .values
            .windows(2)
            .filter(|pair| (pair[0] < threshold) != (pair[1] < threshold))
            .count();
        let are_many = changes > MOST_REFINED;
        let mut intervals = Vec::new();
        let mut open = None;
        for i in 0..self.points.len() {
            let negative = self.values[i] < threshold;
            match (negative, open) {
                (true, None) => {
                    let previous = i.checked_sub(1);
                    open = Some(
                        previous
                            .map_or(self.points[i], |before| self.crossing([before, i], are_many)),
                    );
                }
                (false, Some(start)) => {
                    intervals.push([start, self.crossing([i, i - 1], are_many)]);
                    open = None;
                }
                _ => {}
            }
        }
        intervals.extend(open.map(|start| [start, 1.0]));
        intervals
    }

    /// The zero between a sample where the function is not negative beyond rounding and one where it is; by a straight line where there are many.
    fn crossing(&self, [one, other]: [usize; 2], are_many: bool) -> f64 {
        let at = |i: usize| (self.points[i], self.values[i]);
        let ((left, outer), (right, inner)) = (at(one), at(other));
        if outer < 0.0 {
            return left;
        }
        if are_many {
            return right - inner * (right - left) / (inner - outer);
        }
        crossing(&self.f, at(one), at(other), 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sampled<F: Fn(f64) -> f64>(f: F) -> Sampled<F> {
        let mut points = fredholm::basis::chebyshev::points(1024);
        points.reverse();
        let values = points.iter().map(|&x| f(x)).collect();
        Sampled::new(f, points, values)
    }

    #[test]
    fn finds_inner_and_edge_maxima() {
        let inner = sampled(|x: f64| 2.0 - (x - 0.3).powi(2)).maximum();
        assert!((inner.place - 0.3).abs() < 1e-7 && (inner.value - 2.0).abs() < 1e-15);
        assert_eq!(sampled(|x: f64| x).maximum(), Extreme { place: 1.0, value: 1.0 });
        assert_eq!(sampled(|x: f64| x * x).maximum().place, -1.0);
        assert_eq!(sampled(|_| 0.5).maximum().value, 0.5);
        assert_eq!(sampled(|x: f64| (x - 1e-10).cos()).maximum().place, 0.0);
    }

    /// Many crests that are nearly alike, the highest where samples are dense: where they are few parabolas rise by more.
    #[test]
    fn finds_the_highest_of_many_crests() {
        for crests in [30.0, 36.0, 45.0, 70.0] {
            let wave = |x: f64| {
                1.0 + 1e-3 * (std::f64::consts::PI * crests * x).cos() - 1e-5 * (x - 0.93).powi(2)
            };
            let mut points = fredholm::basis::chebyshev::points(360);
            points.reverse();
            let values = points.iter().map(|&x| wave(x)).collect();
            let found = Sampled::new(wave, points, values).maximum();
            let most =
                (0..=40_000).map(|i| wave(f64::from(i) / 20_000.0 - 1.0)).fold(0.0, f64::max);
            assert!(found.value >= most - 1e-12, "{crests}: {found:?} {most}");
        }
    }

    /// A crest between the last two samples, where both ends of a wave have the same value; and two crests of which the lower has the higher sample.
    #[test]
    fn finds_the_higher_of_maxima_that_samples_cannot_tell_apart() {
        let wave = |x: f64| (std::f64::consts::PI * (x - 0.999_9)).cos();
        let points: Vec<f64> = (0..=100).map(|i| f64::from(i - 50) / 50.0).collect();
        let values = points.iter().map(|x| wave(*x)).collect();
        let crest = Sampled::new(wave, points, values).maximum();
        assert!((crest.place - 0.999_9).abs() < 1e-7 && crest.value == 1.0, "{crest:?}");
        let crests = |x: f64| (1.0 - (x + 0.5).powi(2)).max(1.0 + 1e-6 - 4.0 * (x - 0.501).powi(2));
        let points = vec![-1.0, -0.5, 0.0, 0.5, 0.505, 1.0];
        let values = points.iter().map(|x| crests(*x)).collect();
        let crest = Sampled::new(crests, points, values).maximum();
        assert!((crest.place - 0.501).abs() < 1e-7, "{crest:?}");
    }

    #[test]
    fn finds_where_a_function_is_negative() {
        let ends = sampled(|x: f64| 0.25 - x * x).negative();
        assert_eq!(ends.len(), 2);
        assert!(ends[0][0] == -1.0 && (ends[0][1] + 0.5).abs() < 1e-14);
        assert!((ends[1][0] - 0.5).abs() < 1e-14 && ends[1][1] == 1.0);
        assert!(sampled(|x: f64| x * x).negative().is_empty());
        assert_eq!(sampled(|_| -1.0).negative(), [[-1.0, 1.0]]);
    }
}

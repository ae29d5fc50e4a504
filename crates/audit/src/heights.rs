//! What interpolation of the profile misses on windows.

use crate::chebyshev::lebesgue;
use crate::places::middle;
use crate::profile::Profile;

/// Orders of derivatives of the profile that are asked for together: high ones are dear.
const ORDERS: [usize; 3] = [15, 23, 40];

/// Between intervals on which derivatives are bounded are so many halvings, at most: what does not serve on the larger one may on the smaller.
const HALVINGS: usize = 3;

/// An interval, with bounds of the derivatives of the profile once they were asked for.
type Interval = ([f64; 2], Option<Vec<f64>>);

/// The intervals that were halved until the window at hand: bounds on them serve for it and for those to come.
#[derive(Debug, Default)]
pub(crate) struct Known {
    intervals: Vec<Interval>,
    /// What it took to ask for these bounds, in looks.
    looks: u64,
}

/// What is known of the profile on a window.
pub(crate) struct Heights<'a> {
    profile: &'a dyn Profile,
    window: [f64; 2],
    intervals: &'a mut [Interval],
    looks: &'a mut u64,
}

impl Known {
    /// What is known on a window, which lies in those before it or to the right of them.
    pub(crate) fn on<'a>(&'a mut self, profile: &'a dyn Profile, window: [f64; 2]) -> Heights<'a> {
        let [left, right] = window;
        while self.intervals.last().is_some_and(|([from, to], _)| left < *from || *to < right) {
            self.intervals.pop();
        }
        if self.intervals.last().is_none_or(|(last, _)| *last != window) {
            self.intervals.push((window, None));
        }
        Heights { profile, window, intervals: &mut self.intervals, looks: &mut self.looks }
    }

    /// What it took to ask for bounds since this was asked for last, in looks.
    pub(crate) fn take_looks(&mut self) -> u64 {
        std::mem::take(&mut self.looks)
    }
}

impl Heights<'_> {
    /// What interpolation at so many Chebyshev nodes misses; not looked into further where it is at most `wanted`.
    pub(crate) fn missed(&mut self, count: usize, wanted: f64) -> f64 {
        let (_, r) = middle(self.window);
        let own = self.intervals.len() - 1;
        let mut next = self.intervals.iter().rposition(|(_, bounds)| bounds.is_some());
        let mut known = next.map_or(f64::INFINITY, |index| self.missed_on(index, r, count));
        let order = ORDERS.into_iter().find(|order| *order >= count).unwrap_or(count);
        while known > wanted && next != Some(own) {
            let index = next.map_or(0, |index| (index + HALVINGS).min(own));
            self.ask(index, order, next);
            known = self.missed_on(index, r, count);
            next = Some(index);
        }
        let is_short = |bounds: &Vec<f64>| bounds.len() <= count;
        if known > wanted && self.intervals[own].1.as_ref().is_some_and(is_short) {
            self.ask(own, order, Some(own));
            known = self.missed_on(own, r, count);
        }
        known
    }

    /// Asks for bounds on an interval; those of a larger one hold on it as well.
    fn ask(&mut self, index: usize, order: usize, before: Option<usize>) {
        let interval = self.intervals[index].0;
        *self.looks += self.profile.looks(interval);
        let mut bounds = self.profile.taylor_bounds(interval, order);
        if let Some(larger) = before.and_then(|before| self.intervals[before].1.as_ref()) {
            bounds.extend(larger.iter().skip(bounds.len()));
            for (bound, other) in bounds.iter_mut().zip(larger) {
                *bound = bound.min(*other);
            }
        }
        self.intervals[index].1 = Some(bounds);
    }

    fn missed_on(&self, index: usize, r: f64, count: usize) -> f64 {
        self.intervals[index].1.as_ref().map_or(f64::INFINITY, |bounds| missed(bounds, r, count))
    }
}

/// At `n` Chebyshev nodes `f^(n)/n! 2 (r/2)^n`; or what fewer miss, times one more than Lebesgue's constant.
fn missed(bounds: &[f64], r: f64, count: usize) -> f64 {
    let (mut power, mut fewer) = (0.5 * r * r, f64::INFINITY);
    for n in 2..count {
        fewer = fewer.min(share(bounds, n, power));
        power *= 0.5 * r;
    }
    share(bounds, count, power).min((1.0 + lebesgue(count)) * fewer)
}

fn share(bounds: &[f64], n: usize, power: f64) -> f64 {
    let bound = bounds.get(n).copied().unwrap_or(f64::INFINITY);
    // No product of zero and infinity.
    if bound == 0.0 { 0.0 } else { power * bound }
}

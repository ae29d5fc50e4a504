//! What interpolation of the profile misses on windows.

use crate::chebyshev::lebesgue;
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
}

/// What is known of the profile on a window.
pub(crate) struct Heights<'a> {
    profile: &'a dyn Profile,
    window: [f64; 2],
    intervals: &'a mut [Interval],
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
        Heights { profile, window, intervals: &mut self.intervals }
    }
}

impl Heights<'_> {
    /// What interpolation at so many Chebyshev nodes misses; not looked into further where it is at most `wanted`.
    pub(crate) fn missed(&mut self, count: usize, wanted: f64) -> f64 {
        let r = 0.5 * (self.window[1] - self.window[0]);
        let on = |bounds: &Vec<f64>| missed(bounds, r, count);
        let known = self.intervals.iter().filter_map(|(_, bounds)| bounds.as_ref().map(on));
        let mut known = known.fold(f64::INFINITY, f64::min);
        let own = self.intervals.len() - 1;
        let mut next = self.intervals.iter().rposition(|(_, bounds)| bounds.is_some());
        while known > wanted && next != Some(own) {
            let index = next.map_or(0, |index| (index + HALVINGS).min(own));
            let order = ORDERS.into_iter().find(|order| *order >= count).unwrap_or(count);
            let bounds = self.profile.taylor_bounds(self.intervals[index].0, order);
            known = known.min(on(&bounds));
            self.intervals[index].1 = Some(bounds);
            next = Some(index);
        }
        if known > wanted
            && self.intervals[own].1.as_ref().is_some_and(|bounds| bounds.len() <= count)
        {
            let order = ORDERS.into_iter().find(|order| *order >= count).unwrap_or(count);
            let bounds = self.profile.taylor_bounds(self.window, order);
            known = known.min(on(&bounds));
            self.intervals[own].1 = Some(bounds);
        }
        known
    }
}

/// At `n` Chebyshev nodes `f^(n)/n! 2 (r/2)^n`; or what fewer miss, times one more than Lebesgue's constant.
fn missed(bounds: &[f64], r: f64, count: usize) -> f64 {
    let missed = |n: usize| {
        let bound = bounds.get(n).copied().unwrap_or(f64::INFINITY);
        // No product of zero and infinity.
        if bound == 0.0 { 0.0 } else { 2.0 * (0.5 * r).powi(n as i32) * bound }
    };
    let fewer = (2..count).map(missed).fold(f64::INFINITY, f64::min);
    missed(count).min((1.0 + lebesgue(count)) * fewer)
}

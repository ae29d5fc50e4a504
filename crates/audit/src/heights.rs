//! What interpolation of the profile misses on windows.

use crate::Profile;
use crate::chebyshev::lebesgue;

/// Orders of derivatives of the profile that are asked for together: high ones are dear.
const ORDERS: [usize; 3] = [15, 23, 40];

/// Bounds of the derivatives of the profile on intervals that contain the window at hand: windows are looked at from left to right and from the large to the small, so that those of a window
/// serve for its parts.
#[derive(Debug, Default)]
pub(crate) struct Known {
    intervals: Vec<([f64; 2], Vec<f64>)>,
}

/// What is known of the profile on a window.
pub(crate) struct Heights<'a> {
    profile: &'a dyn Profile,
    window: [f64; 2],
    known: &'a mut Known,
}

impl Known {
    /// What is known on a window, which lies in those before it or to the right of them.
    pub(crate) fn on<'a>(&'a mut self, profile: &'a dyn Profile, window: [f64; 2]) -> Heights<'a> {
        let [left, right] = window;
        while self.intervals.last().is_some_and(|([from, to], _)| left < *from || *to < right) {
            self.intervals.pop();
        }
        Heights { profile, window, known: self }
    }
}

impl Heights<'_> {
    /// What interpolation at so many Chebyshev nodes misses; not looked into further where it is at most `wanted`.
    pub(crate) fn missed(&mut self, count: usize, wanted: f64) -> f64 {
        let r = 0.5 * (self.window[1] - self.window[0]);
        let on = |bounds: &[f64]| missed(bounds, r, count);
        let known = (self.known.intervals.iter())
            .map(|(_, bounds)| on(bounds))
            .fold(f64::INFINITY, f64::min);
        if known <= wanted {
            return known;
        }
        let own = self.known.intervals.last().filter(|(interval, _)| *interval == self.window);
        if own.is_some_and(|(_, bounds)| bounds.len() > count) {
            return known;
        }
        let order = ORDERS.into_iter().find(|order| *order >= count).unwrap_or(count);
        let bounds = self.profile.taylor_bounds(self.window, order);
        let found = on(&bounds);
        if own.is_some() {
            self.known.intervals.pop();
        }
        self.known.intervals.push((self.window, bounds));
        found.min(known)
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

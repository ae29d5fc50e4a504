//! How far the free ends of zones are off.

use crate::bound::Audit;
use crate::panel::Panel;
use crate::residual::Bounded;
use crate::sample::range_on;

impl Audit<'_> {
    /// A bound of how far free ends are off: inside of it the resampled pressure exceeds what it is off by, beyond it the residual what it may be.
    pub(crate) fn ends(&self, gaps: &[Bounded], pressure: f64, margin: f64) -> Option<f64> {
        let is_end = |x: f64| self.problem.pieces.iter().flatten().any(|end| *end == x);
        let mut worst: Option<f64> = None;
        // Windows that may be in contact have to touch a free end.
        let mut open: Vec<(f64, f64, bool)> = gaps
            .iter()
            .filter(|window| window.least <= margin)
            .map(|window| (window.left, window.right, false))
            .collect();
        for zone in self.answer.zones {
            for (side, at) in zone.iter().copied().enumerate().filter(|(_, at)| !is_end(*at)) {
                let inside = self.inside(*zone, side, pressure)?;
                let mut outside = at;
                let mut is_growing = true;
                while is_growing {
                    is_growing = false;
                    for (left, right, used) in open.iter_mut().filter(|window| !window.2) {
                        let touches = if side == 1 { *left == outside } else { *right == outside };
                        if touches {
                            outside = if side == 1 { *right } else { *left };
                            *used = true;
                            is_growing = true;
                        }
                    }
                }
                worst = Some(worst.unwrap_or(0.0).max(inside).max((outside - at).abs()));
            }
        }
        if open.iter().any(|window| !window.2) { None } else { worst }
    }

    /// The distance from an end of a zone from which on the pressure exceeds what it may be off by, as far as the middle; none where it does not.
    fn inside(&self, zone: [f64; 2], side: usize, pressure: f64) -> Option<f64> {
        let half = 0.5 * (zone[1] - zone[0]);
        let mut known: Option<f64> = None;
        // From the middle outwards, each step half as far from the end.
        let mut far = half;
        for _ in 0..60 {
            let near = 0.5 * far;
            let interval = if side == 0 {
                [zone[0] + near, zone[0] + far]
            } else {
                [zone[1] - far, zone[1] - near]
            };
            if interval[0] >= interval[1] || self.least_on(interval) <= pressure {
                break;
            }
            known = Some(near);
            far = near;
        }
        known
    }

    /// A lower bound of the resampled pressure on an interval.
    fn least_on(&self, [left, right]: [f64; 2]) -> f64 {
        let first = self.density.panels.partition_point(|panel| panel.right <= left);
        let parts = self.density.panels[first..].iter().take_while(|panel| panel.left < right);
        parts
            .map(|panel| least(panel, panel.left.max(left), panel.right.min(right), 6))
            .fold(f64::INFINITY, f64::min)
    }
}

/// A lower bound of a polynomial, by halves where it is poor.
fn least(panel: &Panel, left: f64, right: f64, depth: usize) -> f64 {
    let [low, _] = range_on(panel, left, right);
    let middle = 0.5 * (left + right);
    if low > 0.0 || depth == 0 || middle <= left || middle >= right {
        return low;
    }
    least(panel, left, middle, depth - 1).min(least(panel, middle, right, depth - 1))
}

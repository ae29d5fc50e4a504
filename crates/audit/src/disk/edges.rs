//! How far free edges are off.

use super::Audit;
use crate::sampled::Seen;

/// Places at which the pressure is looked at from one distance of an edge to half of it.
const LOOKED: usize = 9;
/// Halvings of the distance from an edge.
const HALVINGS: usize = 60;

impl Audit<'_> {
    /// How far free edges are off: inside of it the pressure exceeds what it is off by, beyond it the residual what it may be; none where a gap elsewhere may close, or no edge is
    /// free.
    pub(super) fn ends(&self, gaps: &[Seen], pressure: f64, margin: f64) -> Option<f64> {
        let mut open: Vec<(&Seen, bool)> =
            gaps.iter().filter(|gap| gap.least <= margin).map(|gap| (gap, false)).collect();
        let mut worst: Option<f64> = None;
        for [left, right] in self.zones.iter().copied() {
            let edges = [(left, right, 1.0), (right, left, -1.0)];
            for (edge, other, inwards) in
                edges.into_iter().filter(|(at, ..)| *at > 0.0 && *at < 1.0)
            {
                let inside = self.inside(edge, inwards, (edge - other).abs(), pressure)?;
                let mut outside = edge;
                loop {
                    let touching = open.iter_mut().find(|(gap, used)| {
                        !used
                            && if inwards < 0.0 {
                                gap.left == outside
                            } else {
                                gap.right == outside
                            }
                    });
                    let Some((gap, used)) = touching else { break };
                    *used = true;
                    outside = if inwards < 0.0 { gap.right } else { gap.left };
                }
                worst = Some(worst.unwrap_or(0.0).max(inside).max((outside - edge).abs()));
            }
        }
        if open.iter().any(|(_, used)| !used) { None } else { worst }
    }

    /// The distance from an edge from which on the pressure exceeds what it may be off by, as far as the middle of the zone.
    fn inside(&self, edge: f64, inwards: f64, width: f64, pressure: f64) -> Option<f64> {
        let mut far = 0.5 * width;
        let mut known = None;
        for _ in 0..HALVINGS {
            let near = 0.5 * far;
            let places = (0..LOOKED).map(|i| near + (far - near) * i as f64 / (LOOKED - 1) as f64);
            let least = places
                .map(|d| self.level.density.evaluate(edge + inwards * d))
                .fold(f64::INFINITY, f64::min);
            if least <= pressure {
                break;
            }
            known = Some(near);
            far = near;
        }
        known
    }
}

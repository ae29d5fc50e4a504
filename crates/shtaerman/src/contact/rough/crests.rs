//! Where a pressure is largest between nodes that lie farther apart than the ups and downs of the base.

use super::nodes::Field;
use super::solved::Solved;
use crate::line_search::Point;

/// So many of the highest crests are looked at.
const HIGHEST: usize = 128;

impl<F: Field> Solved<F> {
    /// Samples of the base between whose neighbours no more than one node lies and the pressure is largest, with these, as far as tells what the body gives, which is smooth: cubics through the nodes. None where there is but one.
    pub(super) fn crests(&self, samples: &[Point]) -> Vec<f64> {
        let nodes = &*self.nodes;
        let known = nodes.places.iter().zip(&nodes.heights).zip(&self.given);
        let known: Vec<Point> = known.map(|((xi, height), v)| (*xi, height + v)).collect();
        let mut next = 0;
        let pressed = |(xi, height): &Point| {
            next += known[next..].iter().take_while(|(at, _)| at < xi).count();
            let about = &known[next.saturating_sub(2)..known.len().min(next + 2)];
            let inside = nodes.zone(*xi).map(|_| polynomial(about, *xi) - height);
            (inside.unwrap_or(f64::NEG_INFINITY), next)
        };
        let pressed: Vec<(f64, usize)> = samples.iter().map(pressed).collect();
        let is_crest = |three: &[(f64, usize)]| {
            three[0].0 < three[1].0 && three[1].0 >= three[2].0 && three[2].1 - three[0].1 <= 1
        };
        let threes = pressed.windows(3).enumerate().filter(|(_, three)| is_crest(three));
        let mut crests: Vec<usize> = threes.map(|(first, _)| first).collect();
        if crests.len() < 2 {
            return Vec::new();
        }
        // By the parabolas through the three: few samples a wave may all lie far below its crest.
        let top = |first: &usize| {
            let [before, here, after] = [0, 1, 2].map(|k| pressed[first + k].0.max(0.0));
            here + 0.125 * (2.0 * here - before - after)
        };
        crate::order::sort_by_number(&mut crests, |first| -top(first));
        crests.truncate(HIGHEST);
        crests.iter().flat_map(|first| *first..first + 3).map(|i| samples[i].0).collect()
    }
}

/// The polynomial through some points, by Lagrange's formula.
fn polynomial(points: &[Point], x: f64) -> f64 {
    let share = |(i, (at, value)): (usize, &Point)| {
        let others = points.iter().enumerate().filter(|(j, _)| *j != i);
        value * others.map(|(_, (other, _))| (x - other) / (at - other)).product::<f64>()
    };
    points.iter().enumerate().map(share).sum()
}

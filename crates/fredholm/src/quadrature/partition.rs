//! Panels on which polynomials of low degree resolve a function, and the places where such panels are narrow.

use super::gauss_legendre;
use super::places::{Sampled, with_ends};

/// Nodes of a panel.
const NODES: usize = 16;
/// Most panels that are tried: a function that needs more is noise.
const MOST_PANELS: usize = 1024;
/// Panels shorter than so many units in the last place of their ends, or this share of the interval, are not cut: there is a jump.
const SHORTEST: f64 = 4.0 * f64::EPSILON;
/// A panel that is shorter than this share of its distance to the nearest end or breakpoint belongs to a narrow feature: maps that crowd nodes at the ends of panels
/// have wider gaps there.
const NARROW: f64 = 0.05;
/// Narrow panels over a larger share of the interval are no feature: the function is rough there, which takes more nodes everywhere.
const BROAD: f64 = 0.2;
/// Most features.
const FEATURES: usize = 24;
/// A feature of this share of the interval has no sides.
const POINT: f64 = 1e-9;
/// Panels up to so many times the finest belong to a feature that has sides.
const ALIKE: f64 = 2.0;
/// Breakpoints are at least this share of the interval apart.
const APART: f64 = 1e-11;
/// Panels below this share of the interval count as smooth.
const SMOOTH: f64 = 1e-9;
/// Finest and coarsest resolution, relative to the largest value.
const RESOLUTIONS: [f64; 2] = [1e-13, 1e-3];
/// Roundings of a place that a value may show: of the place itself, of the nodes with the norm of their interpolation, and of what a formula makes of it.
const NUMBERS: f64 = 8.0;
/// Places of every panel at which it is looked at, beside those of the sample: shares of its length from its left end.
const OWN: [f64; 6] = [0.0137, 0.1713, 0.3829, 0.5774, 0.8147, 0.9931];

/// Where the breakpoints of a feature go.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Joints {
    /// In its middle: right for whatever fades slowly on both sides.
    Middle,
    /// At both of its sides: right for whatever has ended there.
    Sides,
}

impl Sampled {
    /// Places at which a function has narrow features, so that panels should begin there: kinks and jumps, crests, steep steps. None of those that are known, and none where the
    /// function is rough over longer stretches. `tolerance` is relative to the largest value.
    pub(crate) fn joints(
        &self,
        f: &dyn Fn(f64) -> f64,
        known: &[f64],
        tolerance: f64,
    ) -> [Vec<f64>; 2] {
        let Some(mut panels) = self.partition(f, known, tolerance) else {
            return Default::default();
        };
        panels.sort_by(|one, two| one.0.total_cmp(&two.0));
        let length = self.interval.right() - self.interval.left();
        let boundaries = self.boundaries(known);
        let narrow = panels.iter().filter(|panel| is_narrow(**panel, &boundaries));
        if narrow.map(|(left, right)| right - left).sum::<f64>() > BROAD * length {
            return Default::default();
        }
        [Joints::Middle, Joints::Sides].map(|kind| self.of_kind(kind, &panels, boundaries.clone()))
    }

    fn of_kind(&self, kind: Joints, panels: &[(f64, f64)], mut boundaries: Vec<f64>) -> Vec<f64> {
        let length = self.interval.right() - self.interval.left();
        let mut joints = Vec::new();
        for _ in 0..FEATURES {
            let narrow = (0..panels.len()).filter(|i| is_narrow(panels[*i], &boundaries));
            let size = |i: &usize| panels[*i].1 - panels[*i].0;
            let Some(finest) = narrow.min_by(|i, j| size(i).total_cmp(&size(j))) else {
                return joints;
            };
            let (left, right) = panels[finest];
            let middle = left.midpoint(right);
            let ends_at_once = size(&finest) > POINT * length;
            let new = if kind == Joints::Sides && ends_at_once {
                let alike = |i: &usize| size(i) <= ALIKE * size(&finest);
                let first = (0..finest).rev().take_while(alike).last().unwrap_or(finest);
                let last = (finest + 1..panels.len()).take_while(alike).last().unwrap_or(finest);
                vec![panels[first].0, panels[last].1]
            } else {
                vec![middle]
            };
            let apart = |x: &f64| boundaries.iter().all(|end| (x - end).abs() > APART * length);
            let new: Vec<f64> = new.into_iter().filter(apart).collect();
            // Where nothing is left to cut, the feature counts as cut.
            boundaries.push(if new.is_empty() { middle } else { new[0] });
            boundaries.extend(new.iter().skip(1));
            joints.extend(new);
        }
        Vec::new()
    }

    /// Whether polynomials resolve the function on a panel to rounding, as far as its values show; also where the panel is too short to be cut.
    pub(crate) fn is_smooth(&self, f: &dyn Fn(f64) -> f64, panel: (f64, f64)) -> bool {
        let (left, right) = panel;
        let length = self.interval.right() - self.interval.left();
        let Some(nodes) = Nodes::new() else { return true };
        let allowed = self.largest * RESOLUTIONS[0];
        right - left <= SMOOTH * length || self.is_resolved(f, &nodes, panel, allowed)
    }

    fn boundaries(&self, known: &[f64]) -> Vec<f64> {
        let mut boundaries = vec![self.interval.left(), self.interval.right()];
        boundaries.extend(known);
        boundaries.sort_by(f64::total_cmp);
        boundaries
    }

    /// Panels between the known places and the cuts, halved until polynomials resolve the function on each; none if those are too many.
    pub(crate) fn partition(
        &self,
        f: &dyn Fn(f64) -> f64,
        known: &[f64],
        tolerance: f64,
    ) -> Option<Vec<(f64, f64)>> {
        let all: Vec<f64> = known.iter().chain(&self.cuts).copied().collect();
        let boundaries = with_ends(self.interval, &all);
        let ends = boundaries.iter().zip(boundaries.iter().skip(1));
        let mut open: Vec<(f64, f64)> = ends.map(|(left, right)| (*left, *right)).collect();
        let length = self.interval.right() - self.interval.left();
        let shortest = |(left, right): (f64, f64)| {
            SHORTEST * left.abs().max(right.abs()).max(f64::EPSILON * length)
        };
        let allowed = self.largest * (0.1 * tolerance).clamp(RESOLUTIONS[0], RESOLUTIONS[1]);
        let nodes = Nodes::new()?;
        let mut panels = Vec::new();
        let mut tried = 0;
        while let Some((left, right)) = open.pop() {
            tried += 1;
            if tried > MOST_PANELS + 2 * boundaries.len() {
                return None;
            }
            if right - left <= shortest((left, right))
                || self.is_resolved(f, &nodes, (left, right), allowed)
            {
                panels.push((left, right));
            } else {
                let middle = left.midpoint(right);
                open.extend([(left, middle), (middle, right)]);
            }
        }
        Some(panels)
    }

    fn is_resolved(
        &self,
        f: &dyn Fn(f64) -> f64,
        nodes: &Nodes,
        (left, right): (f64, f64),
        allowed: f64,
    ) -> bool {
        let (centre, half) = (left.midpoint(right), 0.5 * (right - left));
        let values: Vec<f64> = nodes.places.iter().map(|t| f(centre + half * t)).collect();
        let own = || OWN.iter().map(|share| left + share * (right - left));
        let first = self.places.partition_point(|x| *x <= left);
        let last = self.places.partition_point(|x| *x < right);
        let agrees = |allowed: f64| {
            let agrees = |x: f64, value: f64| {
                (nodes.interpolate(&values, (x - centre) / half) - value).abs() <= allowed
            };
            own().all(|x| agrees(x, f(x)))
                && (first..last).all(|i| agrees(self.places[i], self.values[i]))
        };
        if agrees(allowed) {
            return true;
        }
        // Where the function is steep it is known no better than it changes from number to number.
        let change = own().map(|x| (f(x.next_up()) - f(x)).abs()).fold(0.0, f64::max);
        let known = NUMBERS * change;
        known > allowed && agrees(known)
    }
}

fn is_narrow((left, right): (f64, f64), boundaries: &[f64]) -> bool {
    let middle = left.midpoint(right);
    let distances = boundaries.iter().map(|end| (middle - end).abs());
    right - left < NARROW * distances.fold(f64::INFINITY, f64::min)
}

/// Nodes of Gauss and Legendre with the weights of barycentric interpolation.
struct Nodes {
    places: Vec<f64>,
    weights: Vec<f64>,
}

impl Nodes {
    fn new() -> Option<Self> {
        let rule = gauss_legendre(NODES).ok()?;
        // (H. Wang and S. Xiang, Math. Comp. 81 (2012) 861.)
        let weight = |(k, (t, w)): (usize, (&f64, &f64))| {
            let size = ((1.0 - t * t) * w).sqrt();
            if k % 2 == 0 { size } else { -size }
        };
        let weights = rule.nodes.iter().zip(&rule.weights).enumerate().map(weight).collect();
        Some(Self { places: rule.nodes, weights })
    }

    fn interpolate(&self, values: &[f64], t: f64) -> f64 {
        let (mut top, mut bottom) = (0.0, 0.0);
        for ((place, weight), value) in self.places.iter().zip(&self.weights).zip(values) {
            if t == *place {
                return *value;
            }
            let share = weight / (t - place);
            top += share * value;
            bottom += share;
        }
        top / bottom
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Interval;

    fn joints(f: &dyn Fn(f64) -> f64) -> Vec<f64> {
        let [mut joints, sides] =
            Sampled::new(Interval::unit(), f, &[]).unwrap().joints(f, &[], 1e-12);
        assert_eq!(joints.is_empty(), sides.is_empty());
        joints.sort_by(f64::total_cmp);
        joints
    }

    #[test]
    fn narrow_features_are_found() {
        for (centre, width) in [(-0.6686, 0.000997), (0.0, 0.001), (0.3, 2e-4), (0.99, 1e-4)] {
            let found = joints(&|x| 1.0 + 0.3 * (-((x - centre) / width).powi(2)).exp());
            assert!(!found.is_empty(), "{centre}");
            assert!(found.iter().any(|x| (x - centre).abs() < 6.0 * width), "{centre}: {found:?}");
        }
        let kink = joints(&|x| (x - 0.3).abs());
        assert!(kink.len() == 1 && (kink[0] - 0.3).abs() < 1e-11, "{kink:?}");
        let jump = joints(&|x| if x > 0.7 { 1.0 } else { 0.0 });
        assert!(jump.len() == 1 && (jump[0] - 0.7).abs() < 1e-11, "{jump:?}");
    }

    #[test]
    fn smooth_and_rough_functions_have_none() {
        let functions: [&dyn Fn(f64) -> f64; 6] = [
            &f64::exp,
            &|_| 0.0,
            &|x| (400.0 * x).cos(),
            // A root at an end is no feature: nodes crowd there anyway.
            &|x| (1.0 - x).sqrt(),
            &|x| (1e9 + x * x) - 1e9,
            &|x| 1.0 / (1.0 + 25.0 * x * x),
        ];
        for f in functions {
            assert!(joints(f).is_empty());
        }
    }
}

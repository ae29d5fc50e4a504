//! Panels on which polynomials of low degree resolve a function, and the places where such panels are narrow.

use std::ops::Range;
use std::sync::LazyLock;

use super::gauss_legendre;
use super::places::{ROUNDING, Sampled, with_ends};
use crate::linear::{dot, vectorised};

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

/// Values compared at once, and after how many of these it is asked whether one has failed.
const LANES: usize = 32;
const GROUPS: usize = 4;

/// A panel of a partition.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Panel {
    pub(crate) left: f64,
    pub(crate) right: f64,
    /// Whether all values on it are those of a polynomial to rounding, not only to what was asked for.
    is_polynomial: bool,
}

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
    /// function is rough over longer stretches. `panels` are those of its partition.
    pub(crate) fn joints(&self, panels: &[Panel], known: &[f64]) -> [Vec<f64>; 2] {
        let panels: Vec<(f64, f64)> =
            panels.iter().map(|panel| (panel.left, panel.right)).collect();
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
        let Some(nodes) = &*RULE else { return true };
        let allowed = self.largest * RESOLUTIONS[0];
        right - left <= SMOOTH * length || self.resolved(f, nodes, panel, allowed).is_some()
    }

    fn boundaries(&self, known: &[f64]) -> Vec<f64> {
        let mut boundaries = vec![self.interval.left(), self.interval.right()];
        boundaries.extend(known);
        boundaries.sort_by(f64::total_cmp);
        boundaries
    }

    /// Panels between the known places and the cuts, from left to right, halved until polynomials resolve the function on each; none if those are too many. `tolerance` is relative to the
    /// largest value.
    pub(crate) fn partition(
        &self,
        f: &dyn Fn(f64) -> f64,
        known: &[f64],
        tolerance: f64,
    ) -> Option<Vec<Panel>> {
        let all: Vec<f64> = known.iter().chain(&self.cuts).copied().collect();
        let boundaries = with_ends(self.interval, &all);
        let ends = boundaries.iter().zip(boundaries.iter().skip(1));
        let mut open: Vec<(f64, f64)> = ends.map(|(left, right)| (*left, *right)).collect();
        let length = self.interval.right() - self.interval.left();
        let shortest = |(left, right): (f64, f64)| {
            SHORTEST * left.abs().max(right.abs()).max(f64::EPSILON * length)
        };
        let allowed = self.largest * (0.1 * tolerance).clamp(RESOLUTIONS[0], RESOLUTIONS[1]);
        let nodes = RULE.as_ref()?;
        let mut panels = Vec::new();
        let mut tried = 0;
        while let Some((left, right)) = open.pop() {
            tried += 1;
            if tried > MOST_PANELS + 2 * boundaries.len() {
                return None;
            }
            let found = if right - left <= shortest((left, right)) {
                Some(false)
            } else {
                self.resolved(f, nodes, (left, right), allowed)
            };
            if let Some(is_polynomial) = found {
                panels.push(Panel { left, right, is_polynomial });
            } else {
                let middle = left.midpoint(right);
                open.extend([(left, middle), (middle, right)]);
            }
        }
        panels.sort_by(|one, two| one.left.total_cmp(&two.left));
        Some(panels)
    }

    /// The same function at as few places as tell what it is like between the nodes of a mesh: at the nodes of panels on which all its values are those of polynomials to rounding, at all places
    /// elsewhere.
    pub(crate) fn thinned(&self, f: &dyn Fn(f64) -> f64, panels: &[Panel]) -> Self {
        let Some(nodes) = &*RULE else { return self.moved(self.pairs(0..self.places.len())) };
        let mut open = panels.to_vec();
        let mut pairs = Vec::new();
        while let Some(Panel { left, right, is_polynomial }) = open.pop() {
            let (centre, half) = (left.midpoint(right), 0.5 * (right - left));
            let inside = self.inside(left, right);
            if is_polynomial {
                let places = nodes.places.iter().map(|t| centre + half * t);
                pairs.extend(places.map(|x| (x, f(x))));
            } else if inside.len() <= 2 * NODES {
                pairs.extend(self.pairs(inside));
            } else {
                let rounding = ROUNDING * self.largest;
                open.extend([(left, centre), (centre, right)].map(|(left, right)| {
                    let is_polynomial =
                        self.deviation(f, nodes, (left, right), rounding) <= rounding;
                    Panel { left, right, is_polynomial }
                }));
            }
        }
        self.moved(pairs)
    }

    fn pairs(&self, indices: Range<usize>) -> Vec<(f64, f64)> {
        indices.map(|i| (self.places[i], self.values[i])).collect()
    }

    /// The places inside a panel.
    fn inside(&self, left: f64, right: f64) -> Range<usize> {
        let first = self.places.partition_point(|x| *x <= left);
        first..self.places.partition_point(|x| *x < right).max(first)
    }

    /// Whether a polynomial resolves the function on a panel to what is allowed; if so, whether to rounding.
    fn resolved(
        &self,
        f: &dyn Fn(f64) -> f64,
        nodes: &Nodes,
        panel: (f64, f64),
        allowed: f64,
    ) -> Option<bool> {
        let deviation = self.deviation(f, nodes, panel, allowed);
        if deviation <= allowed {
            return Some(deviation <= ROUNDING * self.largest);
        }
        // Where the function is steep it is known no better than it changes from number to number.
        let change = own(panel).map(|x| (f(x.next_up()) - f(x)).abs()).fold(0.0, f64::max);
        let known = NUMBERS * change;
        (known > allowed && self.deviation(f, nodes, panel, known) <= known).then_some(false)
    }

    /// How far the function is from a polynomial on a panel; where that is more than what is allowed, any larger number.
    fn deviation(
        &self,
        f: &dyn Fn(f64) -> f64,
        nodes: &Nodes,
        panel: (f64, f64),
        allowed: f64,
    ) -> f64 {
        let (left, right) = panel;
        let (centre, half) = (left.midpoint(right), 0.5 * (right - left));
        let values = nodes.places.each_ref().map(|t| f(centre + half * t));
        let polynomial = Polynomial::new((centre, half), nodes.series(&values), self.largest);
        let own = own(panel).map(|x| {
            let [value] = polynomial.evaluate([x]);
            let difference = (value - f(x)).abs();
            if difference.is_nan() { f64::INFINITY } else { difference }
        });
        let own = own.fold(0.0, f64::max);
        if own > allowed {
            return own;
        }
        let inside = self.inside(left, right);
        let (places, values) = (&self.places[inside.clone()], &self.values[inside]);
        own.max(vectorised(
            #[inline(always)]
            || polynomial.deviation(places, values, allowed),
        ))
    }
}

/// Places of a panel at which it is looked at, beside those of the sample.
fn own((left, right): (f64, f64)) -> impl Iterator<Item = f64> {
    OWN.iter().map(move |share| left + share * (right - left))
}

fn is_narrow((left, right): (f64, f64), boundaries: &[f64]) -> bool {
    let middle = left.midpoint(right);
    let distances = boundaries.iter().map(|end| (middle - end).abs());
    right - left < NARROW * distances.fold(f64::INFINITY, f64::min)
}

static RULE: LazyLock<Option<Nodes>> = LazyLock::new(Nodes::new);

/// Nodes of Gauss and Legendre, with what makes the series in Legendre polynomials of the polynomial through values there.
struct Nodes {
    places: [f64; NODES],
    /// `(k + 1/2) w_i P_k(t_i)`, a row for each `k`: Gauss's rule is exact for the products.
    rows: [[f64; NODES]; NODES],
}

impl Nodes {
    fn new() -> Option<Self> {
        let rule = gauss_legendre(NODES).ok()?;
        let places: [f64; NODES] = rule.nodes.try_into().ok()?;
        let mut rows = [[0.0; NODES]; NODES];
        for (i, (t, weight)) in places.iter().zip(&rule.weights).enumerate() {
            let (mut before, mut current) = (0.0, 1.0);
            for (k, row) in rows.iter_mut().enumerate() {
                let k = k as f64;
                row[i] = (k + 0.5) * weight * current;
                (before, current) =
                    (current, ((2.0 * k + 1.0) * t * current - k * before) / (k + 1.0));
            }
        }
        Some(Self { places, rows })
    }

    fn series(&self, values: &[f64; NODES]) -> [f64; NODES] {
        self.rows.each_ref().map(|row| dot(row, values))
    }
}

/// `(2k + 1)/(k + 1)` and `(k + 1)/(k + 2)`: divisions take longer than all the rest.
const RECURRENCE: [[f64; 2]; NODES] = {
    let mut recurrence = [[0.0; 2]; NODES];
    let mut k = 0;
    while k < NODES {
        let n = k as f64;
        recurrence[k] = [(2.0 * n + 1.0) / (n + 1.0), (n + 1.0) / (n + 2.0)];
        k += 1;
    }
    recurrence
};

/// `sum_k a_k P_k(t)`, `t = (x - centre) scale`.
struct Polynomial {
    centre: f64,
    scale: f64,
    series: [f64; NODES],
    /// Terms that count.
    count: usize,
}

impl Polynomial {
    /// From `a_k`; the last of them are left out where they are the rounding of values up to a largest one, `(k + 1/2) eps`.
    fn new((centre, half): (f64, f64), series: [f64; NODES], largest: f64) -> Self {
        let counts = |k: &usize| {
            let rounding = (*k as f64 + 0.5) * f64::EPSILON * largest;
            series[*k].is_nan() || series[*k].abs() > rounding
        };
        let last = (1..NODES).rev().find(counts).unwrap_or(0);
        Self { centre, scale: 1.0 / half, series, count: last + 1 }
    }

    /// By Clenshaw's recurrence.
    #[inline(always)]
    fn evaluate<const N: usize>(&self, x: [f64; N]) -> [f64; N] {
        let t = x.map(|x| (x - self.centre) * self.scale);
        let last = self.count - 1;
        let (mut next, mut current) = ([0.0; N], [self.series[last]; N]);
        for k in (0..last).rev() {
            let [up, down] = RECURRENCE[k];
            for lane in 0..N {
                let sum = (self.series[k] + up * t[lane] * current[lane]) - down * next[lane];
                (next[lane], current[lane]) = (current[lane], sum);
            }
        }
        current
    }

    /// The largest difference from values at places, or one that is more than what is allowed; infinite for NaN.
    #[inline(always)]
    fn deviation(&self, places: &[f64], values: &[f64], allowed: f64) -> f64 {
        let (places, rest) = places.as_chunks::<LANES>();
        let (values, values_of_rest) = values.as_chunks::<LANES>();
        let mut most = 0.0;
        for (places, values) in places.chunks(GROUPS).zip(values.chunks(GROUPS)) {
            let mut lanes = [most; LANES];
            for (places, values) in places.iter().zip(values) {
                let found = self.evaluate(*places);
                for lane in 0..LANES {
                    let difference = (found[lane] - values[lane]).abs();
                    let difference = if difference.is_nan() { f64::INFINITY } else { difference };
                    lanes[lane] = if difference > lanes[lane] { difference } else { lanes[lane] };
                }
            }
            most = largest_of_lanes(lanes);
            if most > allowed {
                return most;
            }
        }
        for (x, value) in rest.iter().zip(values_of_rest) {
            let difference = (self.evaluate([*x])[0] - value).abs();
            most = most.max(if difference.is_nan() { f64::INFINITY } else { difference });
        }
        most
    }
}

/// By halves: one after the other they would wait for each other.
#[inline(always)]
fn largest_of_lanes(mut lanes: [f64; LANES]) -> f64 {
    let mut half = LANES / 2;
    while half > 0 {
        for lane in 0..half {
            let other = lanes[lane + half];
            lanes[lane] = if other > lanes[lane] { other } else { lanes[lane] };
        }
        half /= 2;
    }
    lanes[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Interval;

    fn joints(f: &dyn Fn(f64) -> f64) -> Vec<f64> {
        let sampled = Sampled::new(Interval::unit(), f, &[]).unwrap();
        let panels = sampled.partition(f, &[], 1e-12).unwrap_or_default();
        let [mut joints, sides] = sampled.joints(&panels, &[]);
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

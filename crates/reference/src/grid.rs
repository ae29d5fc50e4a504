//! Panels that shrink towards the ends of zones and the breaks of the base.

use crate::kernel::Kernel;
use crate::panel::{Chart, Panel, Place, QUADRATURE, visit};
use crate::rule::{self, Rule};

/// Panels of a zone are halved at most so often to resolve the base.
const MOST_HALVINGS: usize = 60;
/// Panels that are shorter, relative to where they are, are not halved for the base: it would be its rounding that is resolved.
const SHORT: f64 = 1e-9;
/// Neighbours differ in length by no more than that.
const UNLIKE: f64 = 2.5;
/// Beyond so many panels a base is left as it is: there are too many unknowns anyway.
const MOST_PANELS: usize = 2000;
/// Places of a panel, between the nodes, at which the base is compared with the polynomial through them.
const COMPARED: [f64; 5] = [-0.93, -0.41, 0.087, 0.56, 0.871];

/// A place where the base bends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Break {
    /// Its `x`.
    pub at: f64,
    /// Whether the height or the slope jumps there, or less than that is known; else panels end there and do not shrink: a knot of a spline, or the surroundings of a narrow feature.
    pub is_sharp: bool,
}

/// How fine panels are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Fineness {
    /// Nodes of a panel.
    pub(crate) nodes: usize,
    /// The shortest panel, relative to the zone over `1 + theta`.
    pub(crate) shortest: f64,
    /// The base is resolved to that share of its heights.
    pub(crate) resolved: f64,
}

/// What the places of joints of panels are off by: some units of the machine on `[-1, 1]`.
const JOINED: f64 = 4.0 * f64::EPSILON;
/// The shortest panel: on power kernels shorter ones would be as many as 1/(1 - mu) asks for.
const NEAREST: f64 = 1e-26;

/// Panels with their nodes.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub(crate) panels: Vec<Panel>,
    pub(crate) rule: Rule,
    /// Of integrals with the kernel.
    quadrature: Rule,
    /// Legendre polynomials at the nodes of the quadrature, one degree after the other.
    legendre: Vec<[f64; QUADRATURE]>,
}

impl Grid {
    pub(crate) fn new(panels: Vec<Panel>, nodes: usize) -> Self {
        let quadrature = Rule::new(QUADRATURE);
        let mut places = [0.0; QUADRATURE];
        places.copy_from_slice(&quadrature.nodes);
        let mut legendre = vec![];
        degrees(&places, nodes, |_, values| legendre.push(*values));
        Self { panels, rule: Rule::new(nodes), quadrature, legendre }
    }

    /// By how much the panels beside a place are off: by what two are apart or overlap where they meet without an anchor in common, by what is too near to be resolved at the ends of zones, and by nothing
    /// elsewhere.
    pub(crate) fn unresolved(&self, x: f64) -> f64 {
        let is_at = |place: Place| (place.x() - x).abs() <= JOINED;
        let of_pair = |pair: &[Panel]| {
            let [one, two] = [pair[0], pair[1]];
            match [one.at(1.0), two.at(-1.0)].map(is_at) {
                [true, true] if one.anchor != two.anchor => JOINED,
                [true, true] | [false, false] => 0.0,
                _ => NEAREST,
            }
        };
        let outermost = [
            self.panels.first().map(|panel| panel.at(-1.0)),
            self.panels.last().map(|panel| panel.at(1.0)),
        ];
        let at_end = if outermost.into_iter().flatten().any(is_at) { NEAREST } else { 0.0 };
        self.panels.windows(2).map(of_pair).fold(at_end, f64::max)
    }

    pub(crate) fn len(&self) -> usize {
        self.panels.len() * self.rule.nodes.len()
    }

    /// The nodes with their weights, in the order of the unknowns.
    pub(crate) fn nodes(&self) -> Vec<(Place, f64)> {
        let of_panel = |panel: &Panel| {
            let panel = *panel;
            (self.rule.nodes.iter().zip(&self.rule.weights))
                .map(move |(t, weight)| (panel.at(*t), panel.half() * weight))
        };
        self.panels.iter().flat_map(of_panel).collect()
    }

    /// Weights of the values at the nodes in the potential at a target: from the integrals of the kernel with the Legendre polynomials of each panel.
    pub(crate) fn row(&self, kernel: &Kernel<'_>, target: Place) -> Vec<f64> {
        let n = self.rule.nodes.len();
        let mut row = vec![0.0; self.len()];
        let mut integrals = vec![0.0; n];
        for (panel, entries) in self.panels.iter().zip(row.chunks_mut(n)) {
            integrals.fill(0.0);
            visit(kernel, panel, target, &self.quadrature, &mut |part| {
                let mut add = |k: usize, values: &[f64; QUADRATURE]| {
                    integrals[k] += dot(&part.weights, values);
                };
                if part.is_whole {
                    self.legendre.iter().enumerate().for_each(|(k, values)| add(k, values));
                } else {
                    degrees(&part.places, n, add);
                }
            });
            self.rule.collect(&integrals, entries);
        }
        row
    }
}

/// Hands over the Legendre polynomials below a degree at places.
fn degrees(
    places: &[f64; QUADRATURE],
    degree: usize,
    mut take: impl FnMut(usize, &[f64; QUADRATURE]),
) {
    let (mut before, mut values) = ([0.0; QUADRATURE], [1.0; QUADRATURE]);
    for k in 0..degree {
        take(k, &values);
        let [rise, fall] = rule::recurrence(k);
        for ((x, before), value) in places.iter().zip(&mut before).zip(&mut values) {
            (*before, *value) = (*value, rise * x * *value - fall * *before);
        }
    }
}

/// Sums of every fourth product, then of those: as fast as the machine adds, and in one order.
fn dot(one: &[f64; QUADRATURE], two: &[f64; QUADRATURE]) -> f64 {
    let mut sums = [0.0; 4];
    for (one, two) in one.chunks_exact(4).zip(two.chunks_exact(4)) {
        for ((sum, a), b) in sums.iter_mut().zip(one).zip(two) {
            *sum += a * b;
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}

/// Cuts panels to resolve a base.
pub(crate) struct Cutter<'a> {
    rule: Rule,
    base: &'a dyn Fn(f64) -> f64,
    allowed: f64,
    pub(crate) found: Vec<Panel>,
}

impl<'a> Cutter<'a> {
    /// Resolves the base on zones to a share of its heights there.
    pub(crate) fn new(
        zones: &[[f64; 2]],
        base: &'a dyn Fn(f64) -> f64,
        fineness: Fineness,
    ) -> Self {
        let places = |[l, r]: &[f64; 2]| {
            let (l, r) = (*l, *r);
            (0..=64).map(move |i| l + (r - l) * f64::from(i) / 64.0)
        };
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for x in zones.iter().flat_map(places) {
            least = least.min(base(x));
            most = most.max(base(x));
        }
        // Heights below their own rounding are noise.
        let rounding = 1e-14 * most.abs().max(least.abs());
        let allowed = (fineness.resolved * (most - least)).max(rounding);
        Self { rule: Rule::new(fineness.nodes), base, allowed, found: vec![] }
    }

    /// Panels between cuts of a chart, rising, each with the size of the panel beside it; none where panels need not shrink towards it.
    pub(crate) fn cut(&mut self, chart: Chart, cuts: &[(f64, Option<f64>)]) {
        let start = self.found.len();
        for pair in cuts.windows(2) {
            let [(from, first), (to, last)] = [pair[0], pair[1]];
            let half = 0.5 * (to - from);
            if first.is_none() && last.is_none() {
                self.resolve(Panel { chart, anchor: from, from: 0.0, to: 2.0 * half });
                continue;
            }
            let levels = |least: Option<f64>| {
                least.map_or(0, |least| (half / least).log2().clamp(1.0, 400.0) as usize)
            };
            for (lower, upper) in halvings(half, levels(first)) {
                self.resolve(Panel { chart, anchor: from, from: lower, to: upper });
            }
            for (lower, upper) in halvings(half, levels(last)).into_iter().rev() {
                self.resolve(Panel { chart, anchor: to, from: -upper, to: -lower });
            }
        }
        let own = self.found.split_off(start);
        self.found.extend(balanced(own));
    }

    /// Halves a panel until the polynomial through the nodes is the base, to what is allowed.
    fn resolve(&mut self, whole: Panel) {
        let n = self.rule.nodes.len();
        let mut cardinals = vec![0.0; n];
        let mut waiting = vec![(whole, 0)];
        while let Some((panel, depth)) = waiting.pop() {
            let at = |t: f64| (self.base)(panel.at(t).x());
            let heights: Vec<f64> = self.rule.nodes.iter().map(|t| at(*t)).collect();
            let last = &self.rule.expand(&heights)[n - 2..];
            let tail = last.iter().fold(0.0f64, |most, c| most.max(c.abs()));
            let missed = COMPARED.iter().fold(tail, |most, t| {
                self.rule.cardinals(*t, &mut cardinals);
                let between: f64 = heights.iter().zip(&cardinals).map(|(h, c)| h * c).sum();
                most.max((between - at(*t)).abs())
            });
            let is_short = panel.half() < SHORT * (1e-3 + panel.anchor.abs());
            let is_enough = missed <= self.allowed || depth == MOST_HALVINGS || is_short;
            if is_enough || self.found.len() > MOST_PANELS {
                self.found.push(panel);
                continue;
            }
            let middle = 0.5 * (panel.from + panel.to);
            waiting.push((Panel { from: middle, ..panel }, depth + 1));
            waiting.push((Panel { to: middle, ..panel }, depth + 1));
        }
    }
}

/// Halves panels beside far shorter ones: what bends there bends the potential as far as it is wide.
fn balanced(mut panels: Vec<Panel>) -> Vec<Panel> {
    loop {
        let is_long = |i: usize, j: usize| panels[i].half() > UNLIKE * panels[j].half();
        let long: Vec<bool> = (0..panels.len())
            .map(|i| i > 0 && is_long(i, i - 1) || i + 1 < panels.len() && is_long(i, i + 1))
            .collect();
        if !long.contains(&true) || panels.len() > MOST_PANELS {
            return panels;
        }
        let halves = |(panel, is_long): (Panel, bool)| {
            let middle = 0.5 * (panel.from + panel.to);
            let (first, second) = (Panel { to: middle, ..panel }, Panel { from: middle, ..panel });
            if is_long { vec![first, second] } else { vec![panel] }
        };
        panels = panels.into_iter().zip(long).flat_map(halves).collect();
    }
}

/// Panels of the zones of a rough layer, from left to right.
pub(crate) fn panels(
    kernel: &Kernel<'_>,
    theta: f64,
    zones: &[[f64; 2]],
    breaks: &[Break],
    base: &dyn Fn(f64) -> f64,
    fineness: Fineness,
) -> Vec<Panel> {
    let mut cutter = Cutter::new(zones, base, fineness);
    for &[left, right] in zones {
        let least = (right - left) * fineness.shortest / (1.0 + theta);
        let least = least.powf(1.0 / (1.0 - kernel.exponent())).max(NEAREST);
        // The axis of a disk is no end, unless the base has its tip there.
        let is_smooth_axis = matches!(kernel, Kernel::Disk { .. })
            && left == 0.0
            && !breaks.iter().any(|cut| cut.at == 0.0 && cut.is_sharp);
        let mut cuts = vec![(left, (!is_smooth_axis).then_some(least))];
        let inside = breaks.iter().filter(|cut| left < cut.at && cut.at < right);
        cuts.extend(inside.map(|cut| (cut.at, cut.is_sharp.then_some(least))));
        cuts.push((right, Some(least)));
        cutter.cut(Chart::Line, &cuts);
    }
    cutter.found
}

/// Intervals from 0 to `half` that halve towards 0, the smallest first.
fn halvings(half: f64, levels: usize) -> Vec<(f64, f64)> {
    let at = |k: usize| half * 0.5f64.powi(k as i32);
    let mut found = vec![(0.0, at(levels))];
    found.extend((0..levels).rev().map(|k| (at(k + 1), at(k))));
    found
}

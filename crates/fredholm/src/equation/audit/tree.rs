//! A solution resampled on graded panels, and its potential.

use super::leaf::{FAR, NODES, Rule};
use crate::kernel::Kernel;
use crate::quadrature::places::Sampled;
use crate::{Error, Interval};

/// Most panels.
const MOST_PANELS: usize = 3000;
/// What the panels at the ends may leave of the mean square, relative to the largest value.
const END: f64 = 1e-17;
/// Shortest panels at ends and at breakpoints, as shares of the interval.
const SHORTEST: f64 = 1e-14;
const SHORTEST_INSIDE: f64 = 1e-7;
/// The same at the axis of a disk, where solutions are smooth.
const SHORTEST_AXIS: f64 = 1e-5;
/// Values of the kernel beside the diagonal are resolved to this share of their size.
const RESOLVED: f64 = 1e-13;
/// Values of the kernel far from the diagonal are interpolated to this share of their size.
const SMOOTH: f64 = 1e-12;
/// Places of a branch, as shares of its half, at which that is tried: it may be singular beyond either end, on the circle or at the image of a point.
const TRIED: [f64; 2] = [-0.97, 0.97];
/// Panels below this share of the interval are not cut for the sake of the solution: near the ends it may be rough.
const LEAST: f64 = 1e-4;
/// A solution is resolved to this share of the largest value of the right-hand side.
const RESAMPLED: f64 = 1e-14;
/// Places of a panel, as shares of its half, at which that is tried.
const OWN: [f64; 4] = [-0.93, -0.41, 0.287, 0.96];
/// Shares of the interval at which the kernel is looked at.
const LOOKED: [f64; 3] = [0.31, 0.62, 0.83];

/// A panel: the solution at its nodes.
pub(super) struct Leaf {
    left: f64,
    right: f64,
    values: Vec<f64>,
}

/// An interval with what stands for its part of the solution from afar.
struct Branch {
    left: f64,
    right: f64,
    places: [f64; NODES],
    /// `int g dm = sum masses[j] g(places[j])` for smooth `g`, the solution in the masses.
    masses: [f64; NODES],
    content: Content,
}

enum Content {
    Leaf(usize),
    Halves(usize, usize),
}

/// The panels and the intervals they make, the whole last.
pub(super) struct Tree<'k> {
    kernel: &'k dyn Kernel,
    rule: Rule,
    leaves: Vec<Leaf>,
    branches: Vec<Branch>,
    /// Over longer intervals the kernel is not smooth even far from the diagonal.
    scale: f64,
}

impl Leaf {
    pub(super) fn length(&self) -> f64 {
        self.right - self.left
    }

    /// The place at a share of half the panel from its middle.
    pub(super) fn at(&self, share: f64) -> f64 {
        self.left.midpoint(self.right) + 0.5 * self.length() * share
    }

    fn own(&self, x: f64) -> f64 {
        (x - self.left.midpoint(self.right)) / (0.5 * self.length())
    }
}

/// How panels are made.
struct Maker<'m> {
    sampled: &'m Sampled,
    f: &'m dyn Fn(f64) -> f64,
    /// Singular places with the shortest panel at each.
    singular: Vec<(f64, f64)>,
    inner: Vec<f64>,
    scale: f64,
    solution: &'m dyn Fn(f64) -> f64,
}

impl Maker<'_> {
    /// Whether polynomials resolve the solution: beside a narrow feature of the right-hand side it bends where that does not.
    fn resolves(&self, rule: &Rule, (left, right): (f64, f64)) -> bool {
        if right - left <= LEAST * (self.sampled.interval.right() - self.sampled.interval.left()) {
            return true;
        }
        let (centre, half) = (left.midpoint(right), 0.5 * (right - left));
        let at = |t: f64| (self.solution)(centre + half * t);
        let values: Vec<f64> = rule.nodes.iter().map(|t| at(*t)).collect();
        let largest = values.iter().fold(self.sampled.largest, |most, value| most.max(value.abs()));
        OWN.iter().all(|t| (rule.interpolate(&values, *t) - at(*t)).abs() <= RESAMPLED * largest)
    }

    /// Where an interval is cut; nowhere where it is a panel.
    fn cut(&self, rule: &Rule, left: f64, right: f64) -> Option<f64> {
        let middle = left.midpoint(right);
        let apart = |x: &f64| (x - middle).abs();
        let inside = self.inner.iter().copied().filter(|x| left < *x && *x < right);
        if let Some(place) = inside.min_by(|one, two| apart(one).total_cmp(&apart(two))) {
            return Some(place);
        }
        let length = right - left;
        let is_long = |(place, shortest): &(f64, f64)| {
            length > (left - place).max(place - right).max(*shortest)
        };
        let is_panel = length <= self.scale
            && !self.singular.iter().any(is_long)
            && self.sampled.is_smooth(self.f, (left, right))
            && self.resolves(rule, (left, right));
        (!is_panel && left < middle && middle < right).then_some(middle)
    }
}

impl<'k> Tree<'k> {
    pub(super) fn new(
        kernel: &'k dyn Kernel,
        sampled: &Sampled,
        f: &dyn Fn(f64) -> f64,
        breakpoints: &[f64],
        solution: &dyn Fn(f64) -> f64,
    ) -> Result<Self, Error> {
        let interval = kernel.interval();
        let length = interval.right() - interval.left();
        let rule = Rule::new(kernel.singularity())?;
        let scale = scale(kernel, &rule);
        // d^beta misses about eps^(beta + 1/2) of the mean square on a last panel of length eps.
        let end = END.powf(1.0 / (kernel.end_exponent() + 0.5)).clamp(SHORTEST, 1e-6) * length;
        let is_axis = kernel.measure(interval.left()) == 0.0;
        let at_left = if is_axis { SHORTEST_AXIS * length } else { end };
        let mut singular = vec![(interval.left(), at_left), (interval.right(), end)];
        singular.extend(breakpoints.iter().map(|x| (*x, SHORTEST_INSIDE * length)));
        let maker = Maker { sampled, f, singular, inner: breakpoints.to_vec(), scale, solution };
        let mut tree = Self { kernel, rule, leaves: Vec::new(), branches: Vec::new(), scale };
        tree.grow(&maker, interval.left(), interval.right())?;
        Ok(tree)
    }

    /// The interval as a branch, after everything that it is made of; its index.
    fn grow(&mut self, maker: &Maker<'_>, left: f64, right: f64) -> Result<usize, Error> {
        let (centre, half) = (left.midpoint(right), 0.5 * (right - left));
        let mut places = [0.0; NODES];
        places.iter_mut().zip(&self.rule.nodes).for_each(|(x, t)| *x = centre + half * t);
        let mut masses = [0.0; NODES];
        let content = match maker.cut(&self.rule, left, right) {
            Some(middle) => {
                let one = self.grow(maker, left, middle)?;
                let two = self.grow(maker, middle, right)?;
                for branch in [one, two].map(|index| &self.branches[index]) {
                    for (place, mass) in branch.places.iter().zip(&branch.masses) {
                        let shares = self.rule.shares((place - centre) / half);
                        masses.iter_mut().zip(shares).for_each(|(sum, share)| *sum += share * mass);
                    }
                }
                Content::Halves(one, two)
            }
            None => {
                if self.leaves.len() >= MOST_PANELS {
                    return Err(Error::InvalidParameter {
                        name: "number of panels",
                        value: self.leaves.len() as f64,
                        requirement: "at most 3000: kernel or right-hand side has features too fine for this interval",
                    });
                }
                let values: Vec<f64> = places.iter().map(|x| (maker.solution)(*x)).collect();
                if let Some(j) = values.iter().position(|value| !value.is_finite()) {
                    return Err(Error::NotFinite {
                        what: "solution",
                        at: places[j],
                        value: values[j],
                    });
                }
                for j in 0..NODES {
                    masses[j] =
                        half * self.rule.weights[j] * self.kernel.measure(places[j]) * values[j];
                }
                self.leaves.push(Leaf { left, right, values });
                Content::Leaf(self.leaves.len() - 1)
            }
        };
        self.branches.push(Branch { left, right, places, masses, content });
        Ok(self.branches.len() - 1)
    }

    pub(super) fn interval(&self) -> Interval {
        self.kernel.interval()
    }

    pub(super) fn measure(&self, x: f64) -> f64 {
        self.kernel.measure(x)
    }

    pub(super) fn leaves(&self) -> usize {
        self.leaves.len()
    }

    /// From left to right.
    pub(super) fn panels(&self) -> impl DoubleEndedIterator<Item = &Leaf> {
        self.leaves.iter()
    }

    /// The resampled solution at a place of a panel.
    pub(super) fn evaluate(&self, leaf: &Leaf, x: f64) -> f64 {
        self.rule.interpolate(&leaf.values, leaf.own(x))
    }

    /// `int u q dm`.
    pub(super) fn integral(&self, u: &dyn Fn(f64) -> f64) -> f64 {
        self.sum(&|branch, j| branch.masses[j] * u(branch.places[j]))
    }

    /// `int u^2 dm`.
    pub(super) fn square_of(&self, u: &dyn Fn(f64) -> f64) -> f64 {
        self.sum(&|branch, j| {
            let weight = 0.5 * (branch.right - branch.left) * self.rule.weights[j];
            let x = branch.places[j];
            weight * self.kernel.measure(x) * u(x) * u(x)
        })
    }

    fn sum(&self, term: &dyn Fn(&Branch, usize) -> f64) -> f64 {
        let leaves = self.branches.iter().filter(|b| matches!(b.content, Content::Leaf(_)));
        leaves.map(|branch| (0..NODES).map(|j| term(branch, j)).sum::<f64>()).sum()
    }

    /// `(K q)(x)`.
    pub(super) fn potential(&self, x: f64) -> f64 {
        let mut open = vec![self.branches.len() - 1];
        let mut sum = 0.0;
        while let Some(index) = open.pop() {
            let branch = &self.branches[index];
            let length = branch.right - branch.left;
            let is_far = (branch.left - x).max(x - branch.right) >= FAR * length;
            if is_far && length <= self.scale {
                let is_leaf = matches!(branch.content, Content::Leaf(_));
                if let Some(afar) = self.potential_afar(branch, x, is_leaf) {
                    sum += afar;
                    continue;
                }
            }
            match branch.content {
                Content::Halves(one, two) => open.extend([one, two]),
                Content::Leaf(leaf) => {
                    let leaf = &self.leaves[leaf];
                    let density = |s: f64| self.kernel.measure(s) * self.evaluate(leaf, s);
                    sum += self.rule.near(self.kernel, x, (leaf.left, leaf.right), &density);
                }
            }
        }
        sum
    }

    /// The share of a branch in the potential, where the kernel is smooth over it.
    fn potential_afar(&self, branch: &Branch, x: f64, is_leaf: bool) -> Option<f64> {
        let value = |s: f64| self.kernel.pair(x, s, (x - s).abs()).value;
        let mut values = [0.0; NODES];
        values.iter_mut().zip(&branch.places).for_each(|(k, s)| *k = value(*s));
        if !is_leaf {
            let size = values.iter().fold(0.0f64, |most, k| most.max(k.abs()));
            let (centre, half) =
                (branch.left.midpoint(branch.right), 0.5 * (branch.right - branch.left));
            let is_smooth = |t: &f64| {
                let difference = self.rule.interpolate(&values, *t) - value(centre + half * t);
                difference.abs() <= SMOOTH * size
            };
            if !TRIED.iter().all(is_smooth) {
                return None;
            }
        }
        Some(values.iter().zip(&branch.masses).map(|(k, mass)| k * mass).sum())
    }
}

/// The longest interval, halved from the whole, over which both parts of the split are polynomials of degree 15 to rounding.
fn scale(kernel: &dyn Kernel, rule: &Rule) -> f64 {
    let interval = kernel.interval();
    let whole = interval.right() - interval.left();
    let mut length = whole;
    // A share of the interval that stays clear of its left end, where kernels of a disk have their axis.
    for _ in 0..40 {
        let resolved = LOOKED.iter().all(|share| {
            let x = interval.left() + share * whole;
            let end = (x + 0.25 * length).min(interval.right());
            let (centre, half) = (x.midpoint(end), 0.5 * (end - x));
            let parts = |t: f64| {
                let s = centre + half * t;
                let split = kernel.split(x, s, s - x);
                [split.factor, split.rest]
            };
            let values: Vec<[f64; 2]> = rule.nodes.iter().map(|t| parts(*t)).collect();
            let size = values.iter().flatten().fold(0.0f64, |most, v| most.max(v.abs()));
            [-0.96, -0.4, 0.137, 0.771, 0.987].into_iter().all(|t| {
                let shares = rule.shares(t);
                let exact = parts(t);
                (0..2).all(|part| {
                    let sum: f64 = shares.iter().zip(&values).map(|(s, v)| s * v[part]).sum();
                    (sum - exact[part]).abs() <= RESOLVED * size
                })
            })
        });
        if resolved {
            return if length == whole { whole } else { 0.25 * length };
        }
        length *= 0.5;
    }
    length
}

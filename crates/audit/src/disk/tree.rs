//! Panels of a disk that lie together, seen from afar by masses at Gauss nodes.

use crate::legendre::{ORDER, RULE, polynomials};
use crate::panel::Panel;

/// Places at least this many half-lengths from the middle of what lies together see it by its masses: kernels are polynomials of degree 23 in the distance from the axis there but for `5.8^-24`.
const FAR: f64 = 3.0;
/// And a single panel, whose masses are its density at nodes that integrate polynomials of degree 47: `3^-48` for what its density has, and less for what is small in it.
const FAR_FROM_PANEL: f64 = 5.0 / 3.0;

/// Panels that lie together.
pub(super) struct Cluster {
    left: f64,
    right: f64,
    /// `int q l_j s ds` with Lagrange's polynomials of the Gauss nodes.
    masses: [f64; ORDER],
    parts: Parts,
}

enum Parts {
    Panel(usize),
    Both([usize; 2]),
}

/// What a place sees.
pub(super) enum Seen<'a> {
    /// Masses on an interval.
    Far(&'a Cluster),
    /// A panel by its index.
    Near(usize),
}

/// All panels.
pub(super) struct Tree {
    clusters: Vec<Cluster>,
}

impl Tree {
    /// Of panels with their masses `q s ds` at the nodes.
    pub(super) fn new(panels: &[Panel], masses: &[[f64; ORDER]]) -> Self {
        let mut tree = Self { clusters: Vec::with_capacity(2 * panels.len()) };
        if !panels.is_empty() {
            tree.gather(panels, masses, [0, panels.len()]);
        }
        tree
    }

    /// The cluster of these panels, after those of its parts; its index.
    fn gather(
        &mut self,
        panels: &[Panel],
        masses: &[[f64; ORDER]],
        [first, last]: [usize; 2],
    ) -> usize {
        let (left, right) = (panels[first].left, panels[last - 1].right);
        let cluster = if last - first == 1 {
            Cluster { left, right, masses: masses[first], parts: Parts::Panel(first) }
        } else {
            let middle = usize::midpoint(first, last);
            let both = [[first, middle], [middle, last]].map(|s| self.gather(panels, masses, s));
            let mut sums = [0.0; ORDER];
            for child in both.map(|child| &self.clusters[child]) {
                child.add_sums([left, right], &mut sums);
            }
            let masses = RULE.spread(&sums);
            Cluster { left, right, masses, parts: Parts::Both(both) }
        };
        self.clusters.push(cluster);
        self.clusters.len() - 1
    }

    /// Calls `visit` with parts that together are all panels.
    pub(super) fn see(&self, r: f64, mut visit: impl FnMut(Seen<'_>)) {
        let mut stack = Vec::with_capacity(32);
        stack.extend(self.clusters.len().checked_sub(1));
        while let Some(index) = stack.pop() {
            let cluster = &self.clusters[index];
            let (from_left, to_right) = (r - cluster.left, cluster.right - r);
            let is_far =
                |times: f64| (from_left - to_right).abs() >= times * (cluster.right - cluster.left);
            match cluster.parts {
                Parts::Panel(_) if is_far(FAR_FROM_PANEL) => visit(Seen::Far(cluster)),
                Parts::Panel(panel) => visit(Seen::Near(panel)),
                Parts::Both(_) if is_far(FAR) => visit(Seen::Far(cluster)),
                Parts::Both(both) => stack.extend(both),
            }
        }
    }
}

impl Cluster {
    /// Adds its masses times `P_k` of a longer interval.
    fn add_sums(&self, [left, right]: [f64; 2], sums: &mut [f64; ORDER]) {
        let half = 0.5 * (self.right - self.left);
        for (mass, t) in self.masses.iter().zip(&RULE.nodes) {
            let from_left = (self.left - left) + half * (1.0 + t);
            let to_right = (right - self.right) + half * (1.0 - t);
            let own = (from_left - to_right) / (right - left);
            for (sum, p) in sums.iter_mut().zip(polynomials(own)) {
                *sum += mass * p;
            }
        }
    }

    /// Its nodes, their distances from a place beside it, which keep their digits, and its masses.
    pub(super) fn seen(&self, r: f64) -> ([f64; ORDER], [f64; ORDER], &[f64; ORDER]) {
        let half = 0.5 * (self.right - self.left);
        let middle = 0.5 * (self.left + self.right);
        let nodes = RULE.nodes.map(|t| middle + half * t);
        let distances = if r <= self.left {
            RULE.nodes.map(|t| (self.left - r) + half * (1.0 + t))
        } else {
            RULE.nodes.map(|t| (r - self.right) + half * (1.0 - t))
        };
        (nodes, distances, &self.masses)
    }
}

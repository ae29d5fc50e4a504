//! The nodes on an interval cut into panels, or on panels with gaps between them.

use std::ops::Range;
use std::sync::Arc;

use super::SincGrid;
use super::grid::AT_ONCE;
use crate::linear::vectorised;
use crate::{Error, Interval};

/// Most nodes of a mesh.
const MOST_NODES: usize = 8001;

/// A point of a mesh: where it is, in which panel, and how far from the ends of that panel.
///
/// Near an end the distances hold more digits than the position does. The position lies strictly inside the panel, so a
/// function with a jump at a breakpoint gives its one-sided value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// `x`.
    pub position: f64,
    /// Distance to the left end of the panel.
    pub from_left: f64,
    /// Distance to the right end of the panel.
    pub from_right: f64,
    /// Index of the panel, from left to right.
    pub panel: usize,
}

/// One grid on each of the panels: between consecutive boundaries, unless there is a gap.
#[derive(Debug, Clone)]
pub(super) struct Mesh {
    grid: Arc<SincGrid>,
    boundaries: Vec<f64>,
    /// For each panel the index of its left end in `boundaries`; its right end is the next one.
    left_ends: Vec<usize>,
    /// `x` of every node, and its distances to the ends of its panel.
    positions: Vec<f64>,
    from_left: Vec<f64>,
    from_right: Vec<f64>,
    weights: Vec<f64>,
}

impl Mesh {
    pub(super) fn new(
        grid: Arc<SincGrid>,
        interval: Interval,
        breaks: &[f64],
    ) -> Result<Self, Error> {
        let boundaries = boundaries(interval, breaks)?;
        let left_ends = (0..boundaries.len() - 1).collect();
        Self::on_boundaries(grid, boundaries, left_ends)
    }

    /// The grid on each of the panels, which may have gaps between them.
    pub(super) fn on_panels(
        grid: Arc<SincGrid>,
        interval: Interval,
        panels: &[(f64, f64)],
    ) -> Result<Self, Error> {
        let (boundaries, left_ends) = disjoint(interval, panels)?;
        Self::on_boundaries(grid, boundaries, left_ends)
    }

    fn on_boundaries(
        grid: Arc<SincGrid>,
        boundaries: Vec<f64>,
        left_ends: Vec<usize>,
    ) -> Result<Self, Error> {
        let panels = left_ends.len();
        if panels.saturating_mul(grid.count()) > MOST_NODES {
            return Err(Error::BeyondMethod {
                what: "number of nodes",
                value: panels as f64 * grid.count() as f64,
                limit: "at most 8001 over all panels: fewer kinks, steps and narrow features need fewer",
            });
        }
        Ok(Self::carried(grid, boundaries, left_ends))
    }

    /// Another grid on the same panels, however many nodes that makes: it is looked at, and nothing is solved on it.
    pub(super) fn with_grid(&self, grid: Arc<SincGrid>) -> Self {
        Self::carried(grid, self.boundaries.clone(), self.left_ends.clone())
    }

    fn carried(grid: Arc<SincGrid>, boundaries: Vec<f64>, left_ends: Vec<usize>) -> Self {
        let count = left_ends.len() * grid.count();
        let empty = || Vec::with_capacity(count);
        let mut mesh = Self {
            grid,
            boundaries,
            left_ends,
            positions: empty(),
            from_left: empty(),
            from_right: empty(),
            weights: empty(),
        };
        for &end in &mesh.left_ends {
            let (left, right) = (mesh.boundaries[end], mesh.boundaries[end + 1]);
            for node in mesh.grid.nodes().iter().map(|node| node.carried(left, right)) {
                mesh.positions.push(node.position);
                mesh.from_left.push(node.from_left);
                mesh.from_right.push(node.from_right);
                mesh.weights.push(mesh.grid.step() * node.derivative);
            }
        }
        mesh
    }

    pub(super) fn count(&self) -> usize {
        self.positions.len()
    }

    /// Nodes of one panel.
    pub(super) fn panel_count(&self) -> usize {
        self.grid.count()
    }

    pub(super) fn grid(&self) -> &SincGrid {
        &self.grid
    }

    pub(super) fn boundaries(&self) -> &[f64] {
        &self.boundaries
    }

    /// Number of panels.
    pub(super) fn panels(&self) -> usize {
        self.left_ends.len()
    }

    /// Index of the left end of a panel among the boundaries; its right end is the next one.
    pub(super) fn left_end(&self, panel: usize) -> usize {
        self.left_ends[panel]
    }

    /// `h dx/dt` of every node.
    pub(super) fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// `x` of every node, from left to right.
    pub(super) fn positions(&self) -> &[f64] {
        &self.positions
    }

    pub(super) fn place(&self, index: usize) -> Place {
        Place {
            position: self.positions[index],
            from_left: self.from_left[index],
            from_right: self.from_right[index],
            panel: self.panel(index),
        }
    }

    pub(super) fn places(&self) -> impl ExactSizeIterator<Item = Place> + '_ {
        (0..self.count()).map(|index| self.place(index))
    }

    /// The panel of a node.
    pub(super) fn panel(&self, index: usize) -> usize {
        index / self.panel_count()
    }

    /// The places midway between neighbouring nodes of a panel, those that numbers tell apart from both.
    pub(super) fn midway(&self) -> impl Iterator<Item = f64> + '_ {
        let panels = self.positions.chunks_exact(self.panel_count());
        let pairs = panels.flat_map(|nodes| nodes.iter().zip(&nodes[1..]));
        pairs.filter_map(|(&left, &right)| {
            let middle = left.midpoint(right);
            (left < middle && middle < right).then_some(middle)
        })
    }

    /// Whether reflection about the middle of the interval carries the mesh into itself.
    pub(super) fn is_symmetric(&self) -> bool {
        let count = self.boundaries.len();
        let twice_centre = self.boundaries[0] + self.boundaries[count - 1];
        let panels = self.panels();
        (0..count).all(|k| self.boundaries[k] + self.boundaries[count - 1 - k] == twice_centre)
            && (0..panels).all(|k| self.left_ends[k] + self.left_ends[panels - 1 - k] == count - 2)
    }

    /// Cuts a range of nodes at the breakpoints.
    pub(super) fn segments(
        &self,
        range: Range<usize>,
    ) -> impl Iterator<Item = Range<usize>> + use<> {
        let count = self.panel_count();
        (range.start / count..range.end.div_ceil(count))
            .map(move |panel| range.start.max(panel * count)..range.end.min((panel + 1) * count))
    }

    /// `|x_i - x_j|` for nodes `j` of one panel; across a breakpoint or a gap from the distances to it.
    pub(super) fn distances(&self, i: usize, segment: Range<usize>, distances: &mut [f64]) {
        let (own, other) = (self.panel(i), self.panel(segment.start));
        let (from_left, from_right) = (&self.from_left[segment.clone()], &self.from_right[segment]);
        let (left, right) = (self.from_left[i], self.from_right[i]);
        let ends = |panel: usize| {
            let end = self.left_ends[panel];
            (self.boundaries[end], self.boundaries[end + 1])
        };
        vectorised(
            #[inline(always)]
            || {
                if own == other {
                    between(left, right, from_left, from_right, distances);
                } else if own > other {
                    let beyond = (ends(own).0 - ends(other).1, left);
                    for (distance, s) in distances.iter_mut().zip(from_right) {
                        *distance = s + beyond.0 + beyond.1;
                    }
                } else {
                    let beyond = (ends(other).0 - ends(own).1, right);
                    for (distance, s) in distances.iter_mut().zip(from_left) {
                        *distance = s + beyond.0 + beyond.1;
                    }
                }
            },
        );
    }

    /// For the nodes of a range the smaller distance of it and of node `i` from their nearer ends over their distance from each other: how much of the relative rounding of the one the
    /// other has. 0 for a node and itself and across a breakpoint.
    pub(super) fn cancellations(&self, i: usize, range: Range<usize>, found: &mut [f64]) {
        found[..range.len()].fill(0.0);
        let own = self.panel(i) * self.panel_count();
        let inside = range.start.max(own)..range.end.min(own + self.panel_count());
        if inside.is_empty() {
            return;
        }
        let found = &mut found[inside.start - range.start..inside.end - range.start];
        let (from_left, from_right) = (&self.from_left[inside.clone()], &self.from_right[inside]);
        let (left, right) = (self.from_left[i], self.from_right[i]);
        let nearer = if left < right { left } else { right };
        vectorised(
            #[inline(always)]
            || {
                between(left, right, from_left, from_right, found);
                for ((found, left), right) in found.iter_mut().zip(from_left).zip(from_right) {
                    let other = if left < right { left } else { right };
                    let smaller = if nearer < *other { nearer } else { *other };
                    *found = if *found == 0.0 { 0.0 } else { smaller / *found };
                }
            },
        );
    }

    /// Distance of a node to a boundary.
    pub(super) fn distance_to_boundary(&self, boundary: usize, j: usize) -> f64 {
        let end = self.left_ends[self.panel(j)];
        if boundary <= end {
            self.boundaries[end] - self.boundaries[boundary] + self.from_left[j]
        } else {
            self.boundaries[boundary] - self.boundaries[end + 1] + self.from_right[j]
        }
    }

    /// The place of a point of the closed panels; points outside go to the nearer end, NaN stays.
    pub(super) fn locate(&self, x: f64) -> Place {
        let last = self.panels() - 1;
        let right_end = |panel: usize| self.boundaries[self.left_ends[panel] + 1];
        let mut panel = self.left_ends[..last].partition_point(|&end| self.boundaries[end + 1] < x);
        // In a gap the nearer of the two ends counts.
        if panel > 0 && x - right_end(panel - 1) < self.boundaries[self.left_ends[panel]] - x {
            panel -= 1;
        }
        let (left, right) = (self.boundaries[self.left_ends[panel]], right_end(panel));
        let position = if x.is_nan() { x } else { x.clamp(left, right) };
        Place { position, from_left: position - left, from_right: right - position, panel }
    }

    /// The places of up to so many points; after the last of them it is repeated.
    pub(super) fn locate_all(&self, points: &[f64]) -> [Place; AT_ONCE] {
        let mut last = self.place(0);
        let mut points = points.iter();
        std::array::from_fn(|_| {
            if let Some(x) = points.next() {
                last = self.locate(*x);
            }
            last
        })
    }
}

/// The distances of points of one panel from another, each given by its distances to the ends: from those to the end that is nearer to both.
#[inline(always)]
fn between(left: f64, right: f64, from_left: &[f64], from_right: &[f64], distances: &mut [f64]) {
    for ((distance, l), r) in distances.iter_mut().zip(from_left).zip(from_right) {
        let is_left = left + l < right + r;
        let difference = if is_left { left - l } else { right - r };
        *distance = difference.abs();
    }
}

/// The ends of the panels from left to right, those that two panels share once, and where each panel begins among them.
fn disjoint(interval: Interval, panels: &[(f64, f64)]) -> Result<(Vec<f64>, Vec<usize>), Error> {
    let refused = |value: f64, requirement: &'static str| Error::InvalidParameter {
        name: "panel",
        value,
        requirement,
    };
    if panels.is_empty() {
        return Err(Error::WrongLength { what: "list of panels", found: 0, expected: 1 });
    }
    let (mut boundaries, mut left_ends) = (Vec::<f64>::new(), Vec::new());
    for &(left, right) in panels {
        if !(interval.contains(left) && interval.contains(right)) {
            let outside = if interval.contains(left) { right } else { left };
            return Err(refused(outside, "inside the interval of the kernel"));
        }
        // Panels shorter than rounding of their ends have no inside.
        if right - left <= 8.0 * f64::EPSILON * left.abs().max(right.abs()) {
            return Err(refused(right, "ended right of where it began, beyond rounding"));
        }
        match boundaries.last() {
            Some(&previous) if left < previous => {
                return Err(refused(left, "begun where the one before it ends, or right of that"));
            }
            Some(&previous) if left == previous => {}
            _ => boundaries.push(left),
        }
        left_ends.push(boundaries.len() - 1);
        boundaries.push(right);
    }
    Ok((boundaries, left_ends))
}

/// The ends of the panels between breakpoints.
pub(super) fn boundaries(interval: Interval, breaks: &[f64]) -> Result<Vec<f64>, Error> {
    if !interval.is_finite() {
        return Err(Error::InvalidParameter {
            name: "right end",
            value: interval.right(),
            requirement: "finite: collocation needs a finite section of the half-line",
        });
    }
    let mut inner = breaks.to_vec();
    inner.sort_by(f64::total_cmp);
    inner.dedup();
    // Panels shorter than rounding of their ends have no inside.
    let shortest = 1e-12 * interval.half_length();
    let mut boundaries = vec![interval.left()];
    for point in inner {
        let previous = boundaries[boundaries.len() - 1];
        let inside = point - previous > shortest && interval.right() - point > shortest;
        if !inside {
            return Err(Error::InvalidParameter {
                name: "breakpoint",
                value: point,
                requirement: "inside the interval, apart from its ends and from the others",
            });
        }
        boundaries.push(point);
    }
    boundaries.push(interval.right());
    Ok(boundaries)
}

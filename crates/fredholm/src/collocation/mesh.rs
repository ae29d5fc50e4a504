//! The nodes on an interval cut into panels.

use std::ops::Range;
use std::sync::Arc;

use super::SincGrid;
use super::map::Node;
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

/// One grid on each of the panels between consecutive boundaries.
#[derive(Debug, Clone)]
pub(super) struct Mesh {
    grid: Arc<SincGrid>,
    boundaries: Vec<f64>,
    nodes: Vec<(usize, Node)>,
    weights: Vec<f64>,
}

impl Mesh {
    pub(super) fn new(
        grid: Arc<SincGrid>,
        interval: Interval,
        breaks: &[f64],
    ) -> Result<Self, Error> {
        let boundaries = boundaries(interval, breaks)?;
        let panels = boundaries.len() - 1;
        if panels.saturating_mul(grid.count()) > MOST_NODES {
            return Err(Error::InvalidParameter {
                name: "number of nodes",
                value: panels as f64 * grid.count() as f64,
                requirement: "at most 8001 over all panels",
            });
        }
        let nodes: Vec<(usize, Node)> = boundaries
            .windows(2)
            .enumerate()
            .flat_map(|(panel, ends)| {
                grid.nodes().iter().map(move |node| (panel, node.carried(ends[0], ends[1])))
            })
            .collect();
        let weights = nodes.iter().map(|(_, node)| grid.step() * node.derivative).collect();
        Ok(Self { grid, boundaries, nodes, weights })
    }

    pub(super) fn count(&self) -> usize {
        self.nodes.len()
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

    /// `h dx/dt` of every node.
    pub(super) fn weights(&self) -> &[f64] {
        &self.weights
    }

    pub(super) fn node(&self, index: usize) -> &Node {
        &self.nodes[index].1
    }

    pub(super) fn places(&self) -> impl ExactSizeIterator<Item = Place> + '_ {
        self.nodes.iter().map(|&(panel, node)| Place {
            position: node.position,
            from_left: node.from_left,
            from_right: node.from_right,
            panel,
        })
    }

    /// Whether reflection about the middle of the interval carries the mesh into itself.
    pub(super) fn is_symmetric(&self) -> bool {
        let count = self.boundaries.len();
        let twice_centre = self.boundaries[0] + self.boundaries[count - 1];
        (0..count).all(|k| self.boundaries[k] + self.boundaries[count - 1 - k] == twice_centre)
    }

    /// Whether two nodes lie in one panel.
    pub(super) fn same_panel(&self, i: usize, j: usize) -> bool {
        self.nodes[i].0 == self.nodes[j].0
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

    /// `|x_i - x_j|` for nodes `j` of one panel that lie left of `x_i`; across a breakpoint from the distances to it.
    pub(super) fn distances(&self, i: usize, segment: Range<usize>, distances: &mut [f64]) {
        let (panel, x) = &self.nodes[i];
        let nodes = &self.nodes[segment];
        let Some((left_panel, _)) = nodes.first() else { return };
        if left_panel == panel {
            for (distance, (_, s)) in distances.iter_mut().zip(nodes) {
                *distance = x.distance(s);
            }
        } else {
            let gap = self.boundaries[*panel] - self.boundaries[left_panel + 1];
            for (distance, (_, s)) in distances.iter_mut().zip(nodes) {
                *distance = s.from_right + gap + x.from_left;
            }
        }
    }

    /// Distance of a node to a boundary.
    pub(super) fn distance_to_boundary(&self, boundary: usize, j: usize) -> f64 {
        let (panel, node) = &self.nodes[j];
        if boundary <= *panel {
            self.boundaries[*panel] - self.boundaries[boundary] + node.from_left
        } else {
            self.boundaries[boundary] - self.boundaries[*panel + 1] + node.from_right
        }
    }

    /// The place of a point of the closed interval; points outside go to the nearer end, NaN stays.
    pub(super) fn locate(&self, x: f64) -> Place {
        let last = self.boundaries.len() - 2;
        let panel = self.boundaries[1..=last].partition_point(|&boundary| boundary < x);
        let (left, right) = (self.boundaries[panel], self.boundaries[panel + 1]);
        let position = if x.is_nan() { x } else { x.clamp(left, right) };
        Place { position, from_left: position - left, from_right: right - position, panel }
    }
}

fn boundaries(interval: Interval, breaks: &[f64]) -> Result<Vec<f64>, Error> {
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

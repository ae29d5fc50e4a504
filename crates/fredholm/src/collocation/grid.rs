//! Nodes of the double-exponential map on the unit interval, shared by all operators that use them.

use std::f64::consts::{LN_2, PI};

use crate::kernel::Kernel;
use crate::quadrature::map::Node;
use crate::{Error, Interval};

/// Fewest and most nodes on either side of the middle.
const HALF_COUNTS: std::ops::RangeInclusive<usize> = 4..=4000;
/// End of the range of `t` for the logarithm: what lies beyond, `d ln d` with `d = 1e-20`, leaves 14 digits of the
/// end values up to `lambda = 1e5`.
const RANGE: f64 = 3.4;
/// Up to here the distances to the ends do not underflow.
const LARGEST_RANGE: f64 = 6.0;
/// What the tails beyond the range may leave out of the solution of a power kernel.
const TAIL: f64 = 1e-18;

/// The nodes `t_j = j h`, `|t_j| <= T`, and their images under `tanh(pi/2 sinh t)`.
///
/// A grid depends on neither kernel nor interval: build it once, share it by reference counting among operators.
#[derive(Debug, Clone, PartialEq)]
pub struct SincGrid {
    half_count: usize,
    step: f64,
    nodes: Vec<Node>,
}

impl SincGrid {
    /// The grid with `2 half_count + 1` nodes and the range `T` that suits a kernel.
    ///
    /// # Errors
    /// As [`SincGrid::with_range`].
    pub fn new(kernel: &(impl Kernel + ?Sized), half_count: usize) -> Result<Self, Error> {
        Self::with_range(half_count, suitable_range(kernel.end_exponent()))
    }

    /// The grid with `2 half_count + 1` nodes on `[-T, T]`, `T` being `range`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `4 <= half_count <= 4000` and `1 <= range <= 6` (beyond 6 distances to the
    /// ends underflow).
    pub fn with_range(half_count: usize, range: f64) -> Result<Self, Error> {
        if !HALF_COUNTS.contains(&half_count) {
            return Err(Error::InvalidParameter {
                name: "half_count",
                value: half_count as f64,
                requirement: "between 4 and 4000",
            });
        }
        if !(1.0..=LARGEST_RANGE).contains(&range) {
            return Err(Error::InvalidParameter {
                name: "range",
                value: range,
                requirement: "between 1 and 6",
            });
        }
        let step = range / half_count as f64;
        let unit = Interval::unit();
        let right: Vec<Node> = (0..=half_count).map(|j| Node::at(unit, j as f64 * step)).collect();
        let nodes = right.iter().skip(1).rev().map(Node::mirrored).chain(right.iter().copied());
        Ok(Self { half_count, step, nodes: nodes.collect() })
    }

    /// Nodes on either side of the middle.
    #[must_use]
    pub fn half_count(&self) -> usize {
        self.half_count
    }

    /// Number of nodes, `2 half_count + 1`.
    #[must_use]
    pub fn count(&self) -> usize {
        self.nodes.len()
    }

    /// `h`.
    #[must_use]
    pub fn step(&self) -> f64 {
        self.step
    }

    /// The images on `[-1, 1]`, from left to right.
    pub(super) fn nodes(&self) -> &[Node] {
        &self.nodes
    }
}

/// The range of `t` beyond which a solution differs from its end values by rounding only.
///
/// A point is `2 exp(-pi sinh T)` of the half-length from its end; solutions behave as `d ln d` for the logarithm and as
/// `d^beta` for `beta < 1`. For `beta < 0.05` the range is cut where distances underflow, and accuracy is lost.
fn suitable_range(end_exponent: f64) -> f64 {
    if end_exponent >= 1.0 {
        return RANGE;
    }
    let decades = -TAIL.ln() / end_exponent;
    ((LN_2 + decades) / PI).asinh().clamp(RANGE, LARGEST_RANGE)
}

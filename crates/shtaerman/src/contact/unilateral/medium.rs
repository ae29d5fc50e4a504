//! The body under the punch: its displacement under a pressure, without dimensions.
//!
//! `u(xi) = theta0 k int K(xi, eta) p0(eta) dm(eta)` with the factor `k` and the measure `dm`:
//!
//! - plane, one punch or a pair: `K = ln 1/|xi - eta|`, `k = 1`, `dm = deta`;
//! - a row with the period `L`: `K = ln 1/(2 sin(pi |xi - eta|/L))`, `k = 1`, `dm = deta`;
//! - a disk, pressures without angle: `K = int_0^inf J_0(xi t) J_0(eta t) dt`, `k = pi`, `dm = eta deta`;
//! - one punch or a pair on a half-plane with `E ~ y^mu`: `K = |xi - eta|^-mu`, `k = 1`, `dm = deta`;
//! - a disk on such a half-space: `K = int_0^inf t^mu J_0(xi t) J_0(eta t) dt`, `k = pi`, `dm = eta deta`.
//!
//! But for the row and the gauge of the plane they are homogeneous, `K(b y, b t) dm(b t) = b^(1-mu) K(y, t) dm(t)`.
//!
//! Equations are solved in local coordinates `xi = c + b y`, in which the plane and the disk are always of one size.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use fredholm::Interval;
use fredholm::SincOperator;
use fredholm::collocation::SincGrid;
use fredholm::kernel::{Kernel, Logarithm, LogarithmSine, Power, WeberSonine};

use super::shared::{disk_harmonic, disk_operator, line_operator};
use crate::{Error, Geometry, Problem};

/// Step of the difference quotient of a kernel, as a share of the distance: it serves Newton steps, not answers.
const DIFFERENCE: f64 = 1e-4;

/// The kernel of the displacement.
#[derive(Debug, Clone)]
pub(super) enum Medium {
    /// One punch or a pair on a half-plane.
    Line,
    /// A row of punches on a half-plane; the period in half-widths.
    Row { period: f64, kernel: LogarithmSine },
    /// Rings of pressure on a half-space, graded or not.
    Disk { kernel: WeberSonine },
    /// One punch or a pair on a graded half-plane.
    Graded { kernel: Power },
}

/// Local coordinates `xi = centre + half y`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Hull {
    pub(super) centre: f64,
    pub(super) half: f64,
}

impl Medium {
    pub(super) fn new(problem: &Problem) -> Result<Self, Error> {
        let frame = problem.frame();
        let exponent = frame.grading().map_or(0.0, |grading| grading.exponent());
        Ok(match frame.geometry().scaled(frame.half_width()) {
            Geometry::Plane | Geometry::Pair { .. } if exponent > 0.0 => {
                Self::Graded { kernel: Power::new(Interval::unit(), exponent)? }
            }
            Geometry::Plane | Geometry::Pair { .. } => Self::Line,
            Geometry::Periodic { period } => {
                // Panels leave a gap, however narrow: the kernel of the whole circle has the same values.
                let kernel = LogarithmSine::new(PI.next_down())?;
                Self::Row { period, kernel }
            }
            Geometry::Circular => Self::Disk { kernel: disk_harmonic(0, exponent)? },
        })
    }

    pub(super) fn is_disk(&self) -> bool {
        matches!(self, Self::Disk { .. })
    }

    /// `mu` of `E ~ y^mu`.
    pub(super) fn exponent(&self) -> f64 {
        match self {
            Self::Line | Self::Row { .. } => 0.0,
            Self::Disk { kernel } => 2.0 * kernel.exponent(),
            Self::Graded { kernel } => kernel.exponent(),
        }
    }

    /// Whether panels need a gap between their last and their first end, and a base without gaps has none.
    pub(super) fn is_closed(&self) -> bool {
        matches!(self, Self::Row { period, .. } if *period <= 2.0)
    }

    /// `k`.
    pub(super) fn strength(&self) -> f64 {
        if self.is_disk() { PI } else { 1.0 }
    }

    /// The local coordinates for zones between these ends; `origin` is the middle of the base.
    pub(super) fn hull(&self, left: f64, right: f64, origin: f64) -> Hull {
        match self {
            Self::Line | Self::Graded { .. } => {
                Hull { centre: 0.5 * (left + right), half: 0.5 * (right - left) }
            }
            Self::Row { period, .. } => Hull { centre: origin, half: period / TAU },
            Self::Disk { .. } => Hull { centre: 0.0, half: right },
        }
    }

    /// Ends of the local interval that zones reach from end to end; none for a row.
    pub(super) fn local_ends(&self) -> Option<[f64; 2]> {
        match self {
            Self::Line | Self::Graded { .. } => Some([-1.0, 1.0]),
            Self::Row { .. } => None,
            Self::Disk { .. } => Some([0.0, 1.0]),
        }
    }

    /// What local coordinates do to an integral: `int K(xi, eta) p dm(eta) = scale int K(y, t) p dm(t) - gauge int p dm(eta)`.
    pub(super) fn scale(&self, hull: &Hull) -> f64 {
        hull.half.powf(1.0 - self.exponent())
    }

    /// What local coordinates take from the logarithm, see [`Self::scale`].
    pub(super) fn gauge(&self, hull: &Hull) -> f64 {
        if matches!(self, Self::Line) { hull.half.ln() } else { 0.0 }
    }

    /// `dm(eta)` over `dm(t)`.
    pub(super) fn measure(&self, hull: &Hull) -> f64 {
        if self.is_disk() { hull.half * hull.half } else { hull.half }
    }

    /// `dP0` over `p0 dm`: the circumference of a ring over its radius.
    pub(super) fn area(&self) -> f64 {
        if self.is_disk() { TAU } else { 1.0 }
    }

    pub(super) fn grid(&self, half_count: usize) -> Result<Arc<SincGrid>, Error> {
        Ok(Arc::new(match self {
            Self::Line => SincGrid::new(&Logarithm::unit(), half_count)?,
            Self::Row { kernel, .. } => SincGrid::new(kernel, half_count)?,
            Self::Disk { kernel } => SincGrid::new(kernel, half_count)?,
            Self::Graded { kernel } => SincGrid::new(kernel, half_count)?,
        }))
    }

    /// The operator on the whole local interval of a disk or of a punch on a half-plane, kept among problems; none for others.
    pub(super) fn known_operator(
        &self,
        half_count: usize,
    ) -> Option<Result<Arc<SincOperator>, Error>> {
        match self {
            Self::Line => Some(line_operator(half_count)),
            Self::Disk { .. } => Some(disk_operator(0, self.exponent(), half_count)),
            Self::Row { .. } | Self::Graded { .. } => None,
        }
    }

    /// The operator on panels in local coordinates.
    pub(super) fn operator(
        &self,
        grid: &Arc<SincGrid>,
        panels: &[(f64, f64)],
    ) -> Result<SincOperator, Error> {
        let grid = Arc::clone(grid);
        Ok(match self {
            Self::Line => SincOperator::on_panels(&Logarithm::unit(), grid, panels)?,
            Self::Row { kernel, .. } => SincOperator::on_panels(kernel, grid, panels)?,
            Self::Disk { kernel } => SincOperator::on_panels(kernel, grid, panels)?,
            Self::Graded { kernel } => SincOperator::on_panels(kernel, grid, panels)?,
        })
    }

    /// `K(y, t)` in local coordinates for different points.
    pub(super) fn value(&self, y: f64, t: f64) -> f64 {
        let distance = (y - t).abs().max(f64::MIN_POSITIVE);
        match self {
            Self::Line => -distance.ln(),
            Self::Row { kernel, .. } => kernel.pair(y, t, distance).value,
            Self::Disk { kernel } if y != t => kernel.value(y, t),
            Self::Disk { kernel } => kernel.pair(y, t, distance).value,
            Self::Graded { kernel } => kernel.pair(y, t, distance).value,
        }
    }

    /// `(xi - eta) dK/dxi` for different points; of a homogeneous body finite where they meet.
    pub(super) fn reduced_slope(&self, xi: f64, eta: f64) -> f64 {
        let difference = xi - eta;
        match self {
            Self::Line => -1.0,
            Self::Row { period, .. } => {
                let angle = PI * difference / period;
                if angle == 0.0 { -1.0 } else { -angle / angle.tan() }
            }
            Self::Disk { kernel } => {
                let step = DIFFERENCE * difference.abs();
                if xi + step == xi || xi <= step {
                    return -kernel.split(xi, xi, 0.0).factor;
                }
                let at = |xi: f64| kernel.value(xi, eta);
                difference * (at(xi + step) - at(xi - step)) / (2.0 * step)
            }
            Self::Graded { kernel } => -kernel.exponent() * self.value(xi, eta),
        }
    }

    /// The Galerkin matrix for cells of `xi`, scaled by the roots of their masses; and those masses.
    pub(super) fn cells(&self, cells: &[[f64; 2]]) -> (Vec<f64>, Vec<f64>) {
        let count = cells.len();
        let centre = |i: usize| 0.5 * (cells[i][0] + cells[i][1]);
        let width = |i: usize| cells[i][1] - cells[i][0];
        let masses: Vec<f64> = (0..count)
            .map(|i| if self.is_disk() { centre(i) * width(i) } else { width(i) })
            .collect();
        let mut matrix = vec![0.0; count * count];
        for i in 0..count {
            for j in 0..=i {
                let entry = self.mean(cells[j], cells[i]) * (masses[i] * masses[j]).sqrt();
                matrix[i * count + j] = entry;
                matrix[j * count + i] = entry;
            }
        }
        (matrix, masses)
    }

    /// The mean of `K` over two cells, the first the same or left of the second.
    fn mean(&self, left: [f64; 2], right: [f64; 2]) -> f64 {
        let middle = |cell: [f64; 2]| 0.5 * (cell[0] + cell[1]);
        let (s, x) = (middle(left), middle(right));
        let distance = x - s;
        match self {
            Self::Line => mean_logarithm(left, right),
            Self::Row { period, .. } => {
                // Of K with both logarithms taken out, the near one and the one through the gap to the image of the left cell.
                let ratio = if distance == 0.0 {
                    TAU / (period * period)
                } else {
                    2.0 * (PI * distance / period).sin() / (distance * (period - distance))
                };
                let image = left.map(|end| end + period);
                mean_logarithm(left, right) + mean_logarithm(right, image) - ratio.ln()
            }
            Self::Disk { kernel } => {
                let split = kernel.split(x, s, distance);
                let exponent = self.exponent();
                // sigma = (d^-mu - 1)/mu
                let singular = if exponent > 0.0 {
                    (mean_power(left, right, exponent) - 1.0) / exponent
                } else {
                    mean_logarithm(left, right)
                };
                split.factor * singular + split.rest
            }
            Self::Graded { kernel } => mean_power(left, right, kernel.exponent()),
        }
    }
}

/// Beyond this many widths of the larger cell the midpoints of two cells stand for them.
const FAR: f64 = 12.0;

/// The mean of `|x - s|^-mu` over `x` in one cell and `s` in another that is the same or lies left of it.
pub(in crate::contact) fn mean_power(left: [f64; 2], right: [f64; 2], exponent: f64) -> f64 {
    let (h, k) = (left[1] - left[0], right[1] - right[0]);
    let divisor = (1.0 - exponent) * (2.0 - exponent);
    if left == right {
        return 2.0 * h.powf(-exponent) / divisor;
    }
    let gap = (right[0] - left[1]).max(0.0);
    let distance = gap + 0.5 * (h + k);
    if distance > FAR * h.max(k) {
        return distance.powf(-exponent);
    }
    // Second difference of G(d) = d^(2-mu)/((1-mu)(2-mu)), G'' = d^-mu
    let g = |d: f64| d.powf(2.0 - exponent);
    (g(gap + h + k) - g(gap + h) - g(gap + k) + g(gap)) / (divisor * h * k)
}

/// The mean of `ln 1/|x - s|` over `x` in one cell and `s` in another that is the same or lies left of it.
fn mean_logarithm(left: [f64; 2], right: [f64; 2]) -> f64 {
    let (h, k) = (left[1] - left[0], right[1] - right[0]);
    if left == right {
        return 1.5 - h.ln();
    }
    // From the gap between the cells, which is exact for neighbours.
    let gap = (right[0] - left[1]).max(0.0);
    let distance = gap + 0.5 * (h + k);
    if distance > FAR * h.max(k) {
        return -distance.ln();
    }
    // Second difference of G(d) = d^2/2 ln d - 3 d^2/4, G'' = ln d
    let g = |d: f64| if d > 0.0 { d * d * (0.5 * (d / distance).ln() - 0.75) } else { 0.0 };
    let sum = g(gap + h + k) - g(gap + h) - g(gap + k) + g(gap);
    -(sum / (h * k) + distance.ln())
}

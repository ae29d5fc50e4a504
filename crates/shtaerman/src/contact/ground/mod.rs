//! The ground under the punch: its displacement under a pressure, without dimensions. One file for each ground.
//!
//! `u(xi) = theta0 k int K(xi, eta) p0(eta) dm(eta)` with the factor `k` and the measure `dm`:
//!
//! - a [line](mod@line), one punch or a pair: `K = ln 1/|xi - eta|`, `k = 1`, `dm = deta`;
//! - a [row] with the period `L`: `K = ln 1/(2 sin(pi |xi - eta|/L))`, `k = 1`, `dm = deta`;
//! - a [disk], pressures without angle: `K = int_0^inf J_0(xi t) J_0(eta t) dt`, `k = pi`, `dm = eta deta`;
//! - [graded] ground, one punch or a pair on a half-plane with `E ~ y^mu`: `K = |xi - eta|^-mu`, `k = 1`, `dm = deta`;
//! - [layered] ground, a layer on a rigid base or a coated half-plane, and a layer under a [disk](layered_disk): kernels of their transfer functions;
//! - a disk on such a half-space: `K = int_0^inf t^mu J_0(xi t) J_0(eta t) dt`, `k = pi`, `dm = eta deta`.
//!
//! But for the row, layers and the gauge of the plane these are homogeneous, `K(b y, b t) dm(b t) = b^(1-mu) K(y, t) dm(t)`.
//!
//! Equations are solved in local coordinates `xi = c + b y`, in which the plane and the disk are always of one size.

mod disk;
mod graded;
mod layered;
mod layered_disk;
mod line;
pub(in crate::contact) mod of_problem;
mod row;
mod shared;

pub(crate) use shared::layered_plane;

use std::fmt::Debug;
use std::sync::Arc;

use fredholm::SincOperator;
use fredholm::collocation::SincGrid;
use fredholm::complementarity::galerkin;
use fredholm::kernel::Kernel;
use fredholm::multipole::PanelKernel;

use crate::{Error, deadline::work};

/// A kernel as an answer keeps it.
pub(in crate::contact) trait KeptKernel: Kernel + Debug + Send + Sync {}

impl<K: Kernel + Debug + Send + Sync> KeptKernel for K {}

/// The same, shared.
pub(in crate::contact) type SharedKernel = Arc<dyn KeptKernel>;

/// From this exponent on the kernel `|d|^-mu` is not square integrable (theory): the norm of a row is infinite.
pub(in crate::contact) const SHARP: f64 = 0.5;
/// Step of a difference quotient of fourth order, as a share of the length over which a function changes: so it is good to `1e-12` (theory).
pub(in crate::contact) const STEP: f64 = 1e-3;
/// Tables of kernels are good to this (`cargo test -p fredholm --test all transfer::`). At half or twice stated errors grow up to 2 times (survey).
const KERNEL: f64 = 1e-13;
/// Nodes on either side of the middle of a panel that is as long as a layer is thick, and the most to begin with: answers to rounding were seen on twice as many, and fewer show tension where
/// there is none. At half or twice stated errors grow up to 9.8 times (survey).
const NODES_A_THICKNESS: f64 = 4.0;
const MOST_TO_BEGIN_WITH: f64 = 600.0;

/// Nodes on either side of the middle of a panel of this length to begin with, on a layer of this thickness.
fn half_count_of_layer(length: f64, thickness: f64) -> f64 {
    (NODES_A_THICKNESS * length / thickness).min(MOST_TO_BEGIN_WITH)
}

fn middle([left, right]: [f64; 2]) -> f64 {
    0.5 * (left + right)
}

/// The means of a kernel over a cell and those left of it from the means of its singular function; its other parts are taken in the middles.
fn smooth_means(
    kernel: &dyn Kernel,
    (lefts, right): (&[[f64; 2]], [f64; 2]),
    singular: Vec<f64>,
) -> Vec<f64> {
    let x = middle(right);
    let splits = lefts.iter().map(|left| kernel.split(x, middle(*left), x - middle(*left)));
    splits.zip(singular).map(|(split, singular)| split.factor * singular + split.rest).collect()
}

/// Local coordinates `xi = centre + half y`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::contact) struct Hull {
    pub(in crate::contact) centre: f64,
    pub(in crate::contact) half: f64,
}

/// What a ground is to a contact: its kernel, and what depends on the kind of kernel.
///
/// What has a default is right for one punch or a pair on a plane ground whose local coordinates are `xi` itself, or a homogeneous kernel's.
pub(in crate::contact) trait Ground: Debug + Send + Sync {
    /// `K` in local coordinates.
    fn kernel(&self) -> &dyn Kernel;

    /// The local coordinates for zones between these ends; `origin` is the middle of the base.
    fn hull(&self, left: f64, right: f64, _origin: f64) -> Hull {
        Hull { centre: 0.5 * (left + right), half: 0.5 * (right - left) }
    }

    /// `(xi - eta) dK/dxi` for different points; of a homogeneous plane kernel finite where they meet.
    fn reduced_slope(&self, xi: f64, eta: f64) -> f64;

    /// The means of `K` over one cell of `xi` and each of others that are the same or lie left of it.
    fn means(&self, lefts: &[[f64; 2]], right: [f64; 2]) -> Vec<f64>;

    /// Whether zones are rings about an axis, `r` in place of `xi`.
    fn is_disk(&self) -> bool {
        false
    }

    /// What the kernel for two places takes, as work.
    fn entry(&self) -> f64 {
        match (self.is_disk(), self.exponent() > 0.0) {
            (false, _) => work::ENTRY,
            (true, false) => work::RING,
            (true, true) => work::RING_OF_POWER,
        }
    }

    /// `mu` of `E ~ y^mu`, and of the singularity of a plane kernel.
    fn exponent(&self) -> f64 {
        0.0
    }

    /// Whether panels need a gap between their last and their first end, and a base without gaps has none.
    fn is_closed(&self) -> bool {
        false
    }

    /// `k`.
    fn strength(&self) -> f64 {
        1.0
    }

    /// Ends of the local interval that zones reach from end to end; none where local coordinates do not follow the zones.
    fn local_ends(&self) -> Option<[f64; 2]> {
        None
    }

    /// What local coordinates do to an integral: `int K(xi, eta) p dm(eta) = scale int K(y, t) p dm(t) - gauge int p dm(eta)`.
    fn scale(&self, hull: &Hull) -> f64 {
        hull.half.powf(1.0 - self.exponent())
    }

    /// What local coordinates take from the logarithm, see [`Self::scale`].
    fn gauge(&self, _hull: &Hull) -> f64 {
        0.0
    }

    /// `dm(eta)` over `dm(t)`.
    fn measure(&self, hull: &Hull) -> f64 {
        hull.half
    }

    /// `dP0` over `p0 dm`: the circumference of a ring over its radius.
    fn area(&self) -> f64 {
        1.0
    }

    /// The operator on the whole local interval in one panel, if it is kept among problems.
    fn known_operator(&self, _half_count: usize) -> Option<Result<Arc<SincOperator>, Error>> {
        None
    }

    /// The kernel of fast products on panels, and half the length of the interval of its own coordinate about the middle of the base; none where there is no such kernel.
    fn panel_kernel(&self) -> Option<(PanelKernel, f64)> {
        None
    }

    /// What that kernel is to be multiplied by to be `K`.
    fn panel_share(&self) -> f64 {
        1.0
    }

    /// The kernel of fast products for pressures `p(r) cos(phi)` on a disk, to be multiplied by the same.
    fn turned_panel_kernel(&self) -> Result<Option<PanelKernel>, Error> {
        Ok(None)
    }

    /// The kernel of pressures `p(r) cos(phi)` on a disk.
    fn turned_kernel(&self) -> Result<Option<SharedKernel>, Error> {
        Ok(None)
    }

    /// Its operator on the whole radius, if it is kept among problems.
    fn known_turned_operator(
        &self,
        _half_count: usize,
    ) -> Option<Result<Arc<SincOperator>, Error>> {
        None
    }

    /// `K(y, t)` in local coordinates for different points.
    fn value(&self, y: f64, t: f64) -> f64 {
        let distance = (y - t).abs().max(f64::MIN_POSITIVE);
        self.kernel().pair(y, t, distance).value
    }

    /// [`value`](Self::value) for one point and many.
    fn values(&self, y: f64, places: &[f64], values: &mut [f64]) {
        let distance = |t: &f64| (y - t).abs().max(f64::MIN_POSITIVE);
        let distances: Vec<f64> = places.iter().map(distance).collect();
        self.kernel().values(y, places, &distances, values, &mut vec![0.0; places.len()]);
    }

    /// `dK/dxi` for different points.
    fn slope(&self, xi: f64, eta: f64) -> f64 {
        let difference = xi - eta;
        if difference == 0.0 { 0.0 } else { self.reduced_slope(xi, eta) / difference }
    }

    /// What values of the kernel may be off by, beside their rounding.
    fn kernel_error(&self) -> f64 {
        0.0
    }

    /// Nodes on either side of the middle of a panel of this length that show what the kernel itself has of lengths; 0 where it has none.
    fn first_half_count(&self, _length: f64) -> f64 {
        0.0
    }

    fn grid(&self, half_count: usize) -> Result<Arc<SincGrid>, Error> {
        Ok(Arc::new(SincGrid::crowded(self.kernel(), half_count)?))
    }

    /// The operator on panels in local coordinates.
    fn operator(&self, grid: &Arc<SincGrid>, panels: &[(f64, f64)]) -> Result<SincOperator, Error> {
        Ok(SincOperator::on_panels(self.kernel(), Arc::clone(grid), panels)?)
    }

    /// The Galerkin matrix for cells of `xi`, scaled by the roots of their masses; and those masses.
    fn cells(&self, cells: &[[f64; 2]]) -> (Vec<f64>, Vec<f64>) {
        let mass = |cell: &[f64; 2]| {
            let width = cell[1] - cell[0];
            if self.is_disk() { middle(*cell) * width } else { width }
        };
        let masses: Vec<f64> = cells.iter().map(mass).collect();
        (galerkin(&masses, |i| self.means(&cells[..=i], cells[i])), masses)
    }
}

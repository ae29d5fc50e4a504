//! What depends on a kernel alone, kept from one problem to the next: operators of one punch on a half-plane in local coordinates; of a disk the tables of the kernel
//! and its operators on the whole radius.
//!
//! The kernel is homogeneous, so contacts of all radii have the same operators; they take longer than all the rest of a solution. What is kept is a function of
//! its key, so answers do not depend on what was solved before, nor on what other threads solve.

use std::sync::{Arc, Mutex};

use fredholm::SincOperator;
use fredholm::collocation::SincGrid;
use fredholm::kernel::{Logarithm, TransferDisk, TransferPlane, WeberSonine};

use crate::latest::{always, cached};
use crate::{Error, Layering};

/// Most nodes of an operator that is kept: half a megabyte each; parity halves those of the logarithm.
const MOST_NODES: usize = 257;

/// Order and exponent of grading, the latter by its bits.
type KernelKey = (usize, u64);
/// That and the nodes on either side of the middle.
type OperatorKey = (KernelKey, usize);
/// Order and layer.
type LayeredKey = (usize, Layering);

static KNOWN_PLANES: Mutex<Vec<(Layering, Arc<TransferPlane>)>> = Mutex::new(Vec::new());
static KNOWN_DISKS: Mutex<Vec<(LayeredKey, Arc<TransferDisk>)>> = Mutex::new(Vec::new());
static KNOWN_KERNELS: Mutex<Vec<(KernelKey, WeberSonine)>> = Mutex::new(Vec::new());
static KNOWN_LINES: Mutex<Vec<(usize, Arc<SincOperator>)>> = Mutex::new(Vec::new());
static KNOWN_OPERATORS: Mutex<Vec<(OperatorKey, Arc<SincOperator>)>> = Mutex::new(Vec::new());

/// The kernel of pressures `p(r)` (0) or `p(r) cos(phi)` (1) on the unit disk, on a body with this exponent of grading.
///
/// # Errors
/// [`Error::Equation`] for an exponent that is not below 1.
pub(super) fn disk_harmonic(order: usize, exponent: f64) -> Result<WeberSonine, Error> {
    let order = order.min(1);
    cached(&KNOWN_KERNELS, (order, exponent.to_bits()), always, || {
        Ok(WeberSonine::new(1.0, order as f64, 0.5 * exponent)?)
    })
}

/// The operator of that kernel on `(0, 1)` in one panel, on the nodes that suit the order 0.
///
/// # Errors
/// [`Error::Equation`] for a number of nodes that is out of range or does not fit into memory.
pub(super) fn disk_operator(
    order: usize,
    exponent: f64,
    half_count: usize,
) -> Result<Arc<SincOperator>, Error> {
    let order = order.min(1);
    let key = ((order, exponent.to_bits()), half_count);
    cached(
        &KNOWN_OPERATORS,
        key,
        |operator| operator.count() <= MOST_NODES,
        || {
            let grid = Arc::new(SincGrid::crowded(&disk_harmonic(0, exponent)?, half_count)?);
            let kernel = disk_harmonic(order, exponent)?;
            Ok(Arc::new(SincOperator::on_panels(&kernel, grid, &[(0.0, 1.0)])?))
        },
    )
}

/// The operator of the logarithm on `(-1, 1)` in one panel.
///
/// # Errors
/// As [`disk_operator`].
pub(super) fn line_operator(half_count: usize) -> Result<Arc<SincOperator>, Error> {
    cached(
        &KNOWN_LINES,
        half_count,
        |_| half_count <= MOST_NODES,
        || {
            let kernel = Logarithm::unit();
            let grid = Arc::new(SincGrid::crowded(&kernel, half_count)?);
            Ok(Arc::new(SincOperator::on_panels(&kernel, grid, &[(-1.0, 1.0)])?))
        },
    )
}

/// The kernel of layered ground, its thickness in half-widths.
///
/// # Errors
/// [`Error::Equation`] for a transfer function that is not finite.
pub(crate) fn layered_plane(layering: &Layering) -> Result<Arc<TransferPlane>, Error> {
    cached(&KNOWN_PLANES, layering.clone(), always, || {
        let owned = layering.clone();
        let transfer = move |u| owned.transfer(u);
        Ok(Arc::new(match layering.remainder().cloned() {
            Some(remainder) => TransferPlane::with_remainder(move |d| remainder.at(d))?,
            None => TransferPlane::new(layering.thickness(), layering.far_share(), transfer)?,
        }))
    })
}

/// The same of pressures `p(r)` (0) or `p(r) cos(phi)` (1) on the unit disk.
///
/// # Errors
/// As [`layered_plane`].
pub(super) fn layered_disk(order: usize, layering: &Layering) -> Result<Arc<TransferDisk>, Error> {
    cached(&KNOWN_DISKS, (order, layering.clone()), always, || {
        let owned = layering.clone();
        let transfer = move |u| owned.transfer(u);
        Ok(Arc::new(TransferDisk::new(order, layering.thickness(), transfer)?))
    })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use fredholm::collocation::Place;

    use super::*;

    #[test]
    fn operators_are_those_of_their_order_however_often() {
        // Hertz's pressure sqrt(1 - s^2), from the first two of the spectral relation: pi (2 - x^2)/8, and times s pi x (4 - 3 x^2)/32
        let potentials: [fn(f64) -> f64; 2] =
            [|x| PI * (2.0 - x * x) / 8.0, |x| PI * x * (4.0 - 3.0 * x * x) / 32.0];
        for (order, exact) in [0, 1, 0, 1].map(|order| (order, potentials[order])) {
            let operator = disk_operator(order, 0.0, 60).unwrap();
            let pressure = |place: Place| {
                let root = (place.from_right * (1.0 + place.position)).sqrt();
                place.position.powi(order as i32) * root
            };
            let pressures = operator.sample_places(pressure).unwrap();
            let found = operator.apply(&pressures).unwrap();
            for (x, u) in operator.positions().zip(found).filter(|(x, _)| (0.01..0.99).contains(x))
            {
                assert!((u - exact(x)).abs() < 1e-12, "{order} {x}: {u} {}", exact(x));
            }
        }
    }
}

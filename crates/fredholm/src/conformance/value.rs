//! Value, split and symmetry of a kernel.

use super::Report;
use crate::kernel::{Kernel, Singularity};
use crate::{Error, Interval};

/// Distances from the diagonal, as shares of the distance to the nearer end, at which split and value meet.
const DISTANCES: [f64; 4] = [1e-3, 1e-5, 1e-8, 1e-11];
/// Distances from the ends, as shares of the length.
const CORNERS: [f64; 4] = [1e-3, 1e-7, 1e-12, 1e-16];

/// Checks that the kernel is finite off the diagonal, symmetric, as even as it says, has a positive measure, and that `A sigma(d) + B` with the split of the diagonal is what the value
/// tends to.
///
/// # Errors
/// [`Error::InvalidParameter`] where the extent of the kernel is not finite.
pub fn check_kernel(kernel: &dyn Kernel) -> Result<Report, Error> {
    let extent = kernel.extent();
    if !extent.is_finite() {
        return Err(Error::InvalidParameter {
            name: "right end of the extent",
            value: extent.right(),
            requirement: "finite",
        });
    }
    let points = points(extent);
    let mut report = Report::default();
    report.add("values off the diagonal that are not finite", not_finite(kernel, &points), 0.0);
    report.add("symmetry", asymmetry(kernel, &points), 1e-13);
    if kernel.is_even() {
        report.add("evenness", unevenness(kernel, &points), 1e-13);
    }
    report.add(
        "densities of the measure that are not positive",
        bad_densities(kernel, &points),
        0.0,
    );
    report.add("split at the diagonal", split_error(kernel, &points), 1e-9);
    report.add("values far from the middle that are not finite", corners(kernel), 0.0);
    Ok(report)
}

fn points(extent: Interval) -> Vec<f64> {
    let (left, length) = (extent.left(), 2.0 * extent.half_length());
    [0.003, 0.11, 0.29, 0.5, 0.62, 0.87, 0.995].iter().map(|share| left + share * length).collect()
}

fn pairs(points: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    points.iter().flat_map(move |&x| points.iter().filter(move |s| **s != x).map(move |&s| (x, s)))
}

fn not_finite(kernel: &dyn Kernel, points: &[f64]) -> f64 {
    pairs(points).filter(|&(x, s)| !kernel.value(x, s).is_finite()).count() as f64
}

fn asymmetry(kernel: &dyn Kernel, points: &[f64]) -> f64 {
    pairs(points).map(|(x, s)| relative(kernel.value(x, s), kernel.value(s, x))).fold(0.0, f64::max)
}

fn unevenness(kernel: &dyn Kernel, points: &[f64]) -> f64 {
    let twice = 2.0 * kernel.interval().centre();
    pairs(points)
        .map(|(x, s)| relative(kernel.value(x, s), kernel.value(twice - x, twice - s)))
        .fold(0.0, f64::max)
}

/// Difference relative to the larger of one and the value: kernels with a logarithm have zeros.
fn relative(one: f64, other: f64) -> f64 {
    (one - other).abs() / one.abs().max(other.abs()).max(1.0)
}

fn bad_densities(kernel: &dyn Kernel, points: &[f64]) -> f64 {
    let is_bad = |x: &&f64| {
        let density = kernel.measure(**x);
        !(density > 0.0 && density.is_finite())
    };
    points.iter().filter(is_bad).count() as f64
}

/// `|K(x, x + d) - A(x, x) sigma(d) - B(x, x)|` over `|A sigma| + |B|` and the size of `K` farther off, less what the change of `A` and `B` over `d` explains.
fn split_error(kernel: &dyn Kernel, points: &[f64]) -> f64 {
    let singularity = kernel.singularity();
    let mut worst = 0.0f64;
    for &x in points {
        let at = kernel.split(x, x, 0.0);
        let room = (x - kernel.interval().left()).min(kernel.extent().right() - x);
        // A smooth kernel may vanish on the diagonal: its size is that over the room.
        let across = kernel.pair(x, x + 0.5 * room, 0.5 * room).value.abs();
        for share in DISTANCES {
            let s = x + share * room;
            let distance = s - x;
            let singular = match singularity {
                Singularity::None => 0.0,
                _ => at.factor * singularity.value(distance),
            };
            let size = singular.abs() + at.rest.abs() + across;
            let found = kernel.pair(x, s, distance).value;
            // The smooth parts change by about d ln d times their own size over the room.
            let explained = 40.0 * share * (1.0 - share.ln());
            worst = worst.max(((found - singular - at.rest).abs() / size - explained).max(0.0));
        }
    }
    worst
}

/// Pairs of points deep in the corners, where collocation has its outermost nodes.
fn corners(kernel: &dyn Kernel) -> f64 {
    let extent = kernel.extent();
    let length = 2.0 * extent.half_length();
    let mut bad = 0.0;
    for share in CORNERS {
        let (near, nearer) = (share * length, 0.25 * share * length);
        for (x, s) in [
            (extent.left() + near, extent.left() + nearer),
            (extent.right() - near, extent.right() - nearer),
        ] {
            let pair = kernel.pair(x, s, near - nearer);
            let across =
                kernel.pair(extent.left() + near, extent.right() - near, length - 2.0 * near);
            let finite = [pair.value, pair.factor, across.value, across.factor];
            bad += finite.iter().filter(|value| !value.is_finite()).count() as f64;
        }
        let end = kernel.pair(extent.left(), extent.right() - near, length - near);
        bad += f64::from(u8::from(!end.value.is_finite()));
    }
    bad
}

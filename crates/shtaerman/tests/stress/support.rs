//! Closed forms of the potential, in plain complex arithmetic.

use std::f64::consts::PI;

use shtaerman::{Stress, StressField};

/// `re + i im`.
pub(crate) type Complex = (f64, f64);

pub(crate) fn multiply(a: Complex, b: Complex) -> Complex {
    (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0)
}

pub(crate) fn divide(a: Complex, b: Complex) -> Complex {
    let size = b.0 * b.0 + b.1 * b.1;
    let product = multiply(a, (b.0, -b.1));
    (product.0 / size, product.1 / size)
}

/// The root with an argument half that of `a`, the latter from 0 to pi.
pub(crate) fn root(a: Complex) -> Complex {
    let (size, angle) = (a.0.hypot(a.1).sqrt(), 0.5 * a.1.atan2(a.0));
    (size * angle.cos(), size * angle.sin())
}

/// Stress from `F` and `F'`.
pub(crate) fn from_potential(value: Complex, first: Complex, y: f64, ratio: f64) -> Stress {
    let (sum, difference) = (2.0 / PI * value.1, 2.0 * y / PI * first.0);
    Stress {
        sigma_x: 0.5 * (sum + difference),
        sigma_y: 0.5 * (sum - difference),
        sigma_z: ratio * sum,
        tau_xy: -y / PI * first.1,
    }
}

/// `sqrt(z^2 - 1)` in the upper half-plane, about `z` far away.
pub(crate) fn root_of_ends(x: f64, y: f64) -> Complex {
    multiply(root((x - 1.0, y)), root((x + 1.0, y)))
}

/// `p = sqrt(1 - s^2)`: `F = pi (z - sqrt(z^2 - 1))`.
pub(crate) fn hertz(x: f64, y: f64, ratio: f64) -> Stress {
    let root = root_of_ends(x, y);
    let quotient = divide((x, y), root);
    from_potential(
        (PI * (x - root.0), PI * (y - root.1)),
        (PI * (1.0 - quotient.0), -PI * quotient.1),
        y,
        ratio,
    )
}

/// `p = 1/(pi sqrt(1 - s^2))`: `F = 1/sqrt(z^2 - 1)`.
pub(crate) fn flat_punch(x: f64, y: f64, ratio: f64) -> Stress {
    let inverse = divide((1.0, 0.0), root_of_ends(x, y));
    let cube = multiply(inverse, multiply(inverse, inverse));
    let first = multiply((-x, -y), cube);
    from_potential(inverse, first, y, ratio)
}

/// `p = 1` on `(-1, 1)`: `F = ln((z + 1)/(z - 1))`.
pub(crate) fn strip(x: f64, y: f64, ratio: f64) -> Stress {
    let value =
        (((x + 1.0).hypot(y) / (x - 1.0).hypot(y)).ln(), y.atan2(x + 1.0) - y.atan2(x - 1.0));
    let ends = multiply((x - 1.0, y), (x + 1.0, y));
    from_potential(value, divide((-2.0, 0.0), ends), y, ratio)
}

/// Depths from the farthest to next to nothing, and places from the middle of a panel to far beside.
pub(crate) const DEPTHS: [f64; 10] = [30.0, 3.0, 1.0, 0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9];

pub(crate) fn places() -> impl Iterator<Item = f64> {
    let between = (0..60).map(|i| 1.0 - 2.0 * (0.618_033_988_749_894_9 * f64::from(i)).fract());
    let near = [1e-1, 1e-2, 1e-3, 1e-6, 1e-9, 1e-12, 0.0];
    let ends = near.into_iter().flat_map(|d| [1.0 - d, 1.0 + d, -1.0 - d, -1.0 + d]);
    between.chain(ends).chain([-20.0, -3.0, 1.5, 8.0])
}

/// Largest difference of the components over `floor` and the size of the stress.
pub(crate) fn difference(one: &Stress, two: &Stress, floor: f64) -> f64 {
    let parts = |s: &Stress| [s.sigma_x, s.sigma_y, s.sigma_z, s.tau_xy];
    let (a, b) = (parts(one), parts(two));
    let size = a.iter().fold(floor, |most, part| most.max(part.abs()));
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size
}

/// The worst difference over all places and depths.
pub(crate) fn worst(field: &StressField, exact: impl Fn(f64, f64) -> Stress) -> (f64, f64, f64) {
    let mut worst = (0.0, 0.0, 0.0);
    for depth in DEPTHS {
        for x in places() {
            let error = difference(&exact(x, depth), &field.stress(x, depth).unwrap(), 1.0);
            if error > worst.0 || error.is_nan() {
                worst = (error, x, depth);
            }
        }
    }
    worst
}

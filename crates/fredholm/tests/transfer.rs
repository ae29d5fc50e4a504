//! Kernels of a transfer function against image charges, which have closed forms, and against quadrature elsewhere.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::PI;

use fredholm::conformance::check_kernel;
use fredholm::kernel::{Kernel, TransferDisk, TransferPlane, WeberSonine};

/// The last two are from places beyond the interval.
const DISTANCES: [f64; 10] = [1e-9, 1e-4, 0.01, 0.1, 0.37, 0.9, 1.5, 2.0, 3.7, 90.0];

/// `M = 1 + c exp(-2u)`: an image of the strength `c` at the depth `2h`, `K = (1 + c) ln(1/d) - (c/2) ln(1 + 4 h^2/d^2)`.
#[test]
fn plane_images() {
    for thickness in [0.005, 0.03, 0.4, 3.0, 500.0] {
        for c in [-1.0, -0.6, 0.5, 40.0] {
            let transfer = move |u: f64| 1.0 + c - c * -(-2.0 * u).exp_m1();
            let kernel = TransferPlane::new(thickness, 1.0 + c, transfer).unwrap();
            let report = check_kernel(&kernel).unwrap();
            assert!(report.passes(), "{thickness} {c}\n{report}");
            let exact =
                |d: f64| -(1.0 + c) * d.ln() - 0.5 * c * (2.0 * thickness / d).powi(2).ln_1p();
            // Roundings of c, and of the logarithms of small and large numbers.
            let allowed = |d: f64| 4e-14 * (1.0 + c.abs()) * (1.0 + d.ln().abs());
            // Many at once: in order, against it, and near and far in turn.
            for step in [1, 299, 77] {
                let distances: Vec<f64> =
                    (1..=300).map(|i| f64::from(i * step % 300 + 1).powi(3) * 1e-7).collect();
                let (mut values, mut factors) = (vec![0.0; 300], vec![0.0; 300]);
                kernel.pairs(0.0, &distances, &distances, &mut values, &mut factors);
                for (d, found) in distances.iter().zip(values) {
                    let off = (found - exact(*d)).abs();
                    assert!(off < allowed(*d), "{thickness} {c} {d}: {found} {}", exact(*d));
                }
                assert!(factors.iter().all(|factor| *factor == -1.0));
            }
            for d in DISTANCES {
                let (found, exact) = (kernel.pair(0.0, d, d).value, exact(d));
                assert!((found - exact).abs() < allowed(d), "{thickness} {c} {d}: {found} {exact}");
                // d dK/dd
                let slope = -(1.0 + c) + c / (1.0 + (0.5 * d / thickness).powi(2));
                let found = kernel.reduced_slope(d);
                assert!(
                    (found - slope).abs() < 1e-10 * (1.0 + c.abs()),
                    "{thickness} {c} {d}: {found} {slope}"
                );
            }
            let constant = -c * (2.0 * thickness).ln() - thickness.ln();
            let found = kernel.gauge_constant();
            assert!(
                (found - constant).abs() < 1e-13 * (1.0 + c.abs()) * 20.0,
                "{found} {constant}"
            );
        }
    }
}

/// The mean of `cos(mu phi)/sqrt(R^2 + 4 h^2)` over the angle, `mu = 0` by the arithmetic-geometric mean.
fn image(order: usize, h: f64, x: f64, s: f64) -> f64 {
    if order == 0 {
        let far = (x + s).hypot(2.0 * h);
        let near = (x - s).hypot(2.0 * h);
        let (mut a, mut g) = (far, near);
        for _ in 0..40 {
            (a, g) = (0.5 * (a + g), (a * g).sqrt());
        }
        return 1.0 / a;
    }
    let count = 20_000;
    let at = |j: usize| {
        let angle = PI * (j as f64 + 0.5) / count as f64;
        angle.cos() / (x * x + s * s - 2.0 * x * s * angle.cos() + 4.0 * h * h).sqrt()
    };
    (0..count).map(at).sum::<f64>() / count as f64
}

/// The same on a disk, `W = W_1 + c times the mean of 1/sqrt(R^2 + 4 h^2)`.
#[test]
fn images_of_rings() {
    for thickness in [0.05, 0.3, 2.0, 300.0] {
        for order in [0, 1] {
            for c in [-1.0, 0.7] {
                let transfer = move |u: f64| 1.0 + c * (-2.0 * u).exp();
                let kernel = TransferDisk::new(order, thickness, transfer).unwrap();
                let report = check_kernel(&kernel).unwrap();
                assert!(report.passes(), "{thickness} {order} {c}\n{report}");
                let whole = WeberSonine::new(1.0, order as f64, 0.0).unwrap();
                for (x, s) in [
                    (0.0, 0.3),
                    (0.2, 0.21),
                    (0.5, 0.9),
                    (0.99, 1.0),
                    (1e-8, 1.0),
                    (3.0, 0.7),
                    (70.0, 0.7),
                ] {
                    let exact = whole.value(x, s) + c * image(order, thickness, x, s);
                    let found = kernel.value(x, s);
                    let allowed = 1e-13 * (1.0 + whole.value(x, s).abs() + 1.0 / thickness);
                    assert!(
                        (found - exact).abs() < allowed,
                        "{thickness} {order} {c} {x} {s}: {found} {exact}"
                    );
                }
            }
        }
    }
    assert!((image(0, 1e-9, 0.0, 0.5) - 2.0).abs() < 1e-12);
}

#[test]
fn refuses_what_has_no_tables() {
    for thickness in [0.0, -1.0, 1e-4, f64::NAN, f64::INFINITY] {
        assert!(TransferPlane::new(thickness, 0.0, f64::tanh).is_err());
        assert!(TransferDisk::new(0, thickness, f64::tanh).is_err());
    }
    assert!(TransferPlane::new(1.0, -1.0, f64::tanh).is_err());
    assert!(TransferPlane::new(1.0, 0.0, |_| f64::NAN).is_err());
    assert!(TransferDisk::new(2, 1.0, f64::tanh).is_err());
}

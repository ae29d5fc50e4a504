//! What holds for every pressure: equilibrium, balance, symmetry, the point load far away.

use std::f64::consts::PI;

use shtaerman::{Stress, StressField};

use crate::stress::support::difference;

/// Two zones, one with a kink, one with an infinite corner.
fn field() -> StressField {
    let panels = [[-2.0, -1.0], [-1.0, -0.4], [0.3, 1.0]];
    StressField::from_pressure(&panels, None, 0.25, |panel, left, right| match panel {
        0 => 1.0 - 0.6 * right,
        1 => 1.0 - left / 0.6,
        _ => (left / right).sqrt() * (1.0 + left).exp(),
    })
    .unwrap()
}

/// Central difference of the sixth order.
fn slope(f: impl Fn(f64) -> f64, step: f64) -> f64 {
    [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)]
        .into_iter()
        .map(|(k, weight)| weight * (f(k * step) - f(-k * step)))
        .sum::<f64>()
        / (60.0 * step)
}

#[test]
fn stresses_are_in_equilibrium_and_compatible() {
    let field = field();
    let at = |x: f64, y: f64| field.stress(x, y).unwrap();
    for (x, y) in [(0.1, 0.5), (-1.0, 0.2), (0.9, 0.3), (3.0, 1.0), (-0.7, 0.05), (0.98, 0.02)] {
        let step = 5e-3 * y;
        let along = |part: fn(&Stress) -> f64| slope(|d| part(&at(x + d, y)), step);
        let down = |part: fn(&Stress) -> f64| slope(|d| part(&at(x, y + d)), step);
        let scale = at(x, y).max_shear() / y;
        let sums =
            [along(|s| s.sigma_x) + down(|s| s.tau_xy), along(|s| s.tau_xy) + down(|s| s.sigma_y)];
        assert!(sums.iter().all(|sum| sum.abs() < 1e-9 * scale), "{x} {y}: {sums:?}, {scale}");
        // The sum is harmonic: its mean over a circle is its value in the centre.
        let circle = (0..64).map(|i| 2.0 * PI * f64::from(i) / 64.0).map(|angle| {
            let stress = at(x + 0.3 * y * angle.cos(), y + 0.3 * y * angle.sin());
            stress.sigma_x + stress.sigma_y
        });
        let centre = at(x, y);
        let mean = circle.sum::<f64>() / 64.0;
        assert!((mean / (centre.sigma_x + centre.sigma_y) - 1.0).abs() < 1e-12);
    }
}

/// Every level carries the force: `int sigma_y dx = -P`, `int tau dx = 0`.
#[test]
fn every_level_carries_the_force() {
    let field = field();
    for depth in [1e-2f64, 0.1, 2.0] {
        let step = depth.min(0.1) / 25.0;
        let range = (30.0 / step) as i64;
        let mut sums = [0.0; 2];
        for i in -range..=range {
            let u: f64 = i as f64 * step;
            let (x, weight) = (3.0 * (u / 3.0).sinh(), (u / 3.0).cosh() * step);
            if x.abs() > 1e4 {
                continue;
            }
            let stress = field.stress(x, depth).unwrap();
            sums[0] -= weight * stress.sigma_y;
            sums[1] += weight * stress.tau_xy;
        }
        assert!((sums[0] / field.force() - 1.0).abs() < 1e-9, "{depth}: {sums:?}");
        assert!(sums[1].abs() < 1e-8 * field.force(), "no friction: {sums:?}");
    }
}

#[test]
fn far_away_the_stress_is_flamants() {
    let field = field();
    let force = field.force();
    for (x, y) in [(3e5, 1e5), (-2e6, 7e6), (0.0, 1e6)] {
        let size = x * x + y * y;
        let radial = -2.0 * force * y / (PI * size * size);
        let exact = Stress {
            sigma_x: radial * x * x,
            sigma_y: radial * y * y,
            sigma_z: 0.25 * radial * size,
            tau_xy: radial * x * y,
        };
        assert!(difference(&exact, &field.stress(x, y).unwrap(), 0.0) < 1e-5);
    }
}

#[test]
fn there_is_no_place_too_far() {
    let field = field();
    for far in [1e90, 1e110, 1e160, 1e300, f64::MAX] {
        for (x, y) in [(far, 1.0), (-far, 0.0), (1.0, far), (far, far)] {
            let stress = field.stress(x, y).unwrap();
            for part in [stress.sigma_x, stress.sigma_y, stress.sigma_z, stress.tau_xy] {
                assert!(part.abs() < 1e-85, "{x:e} {y:e}: {stress:?}");
            }
        }
    }
}

#[test]
fn mirrored_pressures_have_mirrored_stresses() {
    let field = field();
    let panels = [[-1.0, -0.3], [0.4, 1.0], [1.0, 2.0]];
    let mirrored =
        StressField::from_pressure(&panels, None, 0.25, |panel, left, right| match panel {
            0 => (right / left).sqrt() * (1.0 + right).exp(),
            1 => 1.0 - right / 0.6,
            _ => 1.0 - 0.6 * left,
        })
        .unwrap();
    for (x, y) in [(0.5, 1e-4), (0.3, 0.2), (-1.0, 1e-3), (-0.4, 0.5)] {
        let (one, two) = (field.stress(x, y).unwrap(), mirrored.stress(-x, y).unwrap());
        let turned = Stress { tau_xy: -two.tau_xy, ..two };
        assert!(difference(&one, &turned, 1.0) < 1e-12, "{x} {y}");
    }
}

/// By mpmath with 40 digits: `p = sqrt(1 - s^2) e^s + (1 + s)/4`, a root at one end and a jump at the other.
#[test]
fn an_unsymmetric_pressure_agrees_with_high_precision() {
    let pressure =
        |_: usize, left: f64, right: f64| (left * right).sqrt() * (left - 1.0).exp() + 0.25 * left;
    let field = StressField::from_pressure(&[[-1.0, 1.0]], None, 0.0, pressure).unwrap();
    for ([x, y], [sigma_x, sigma_y, tau_xy]) in REFERENCES {
        let exact = Stress { sigma_x, sigma_y, sigma_z: 0.0, tau_xy };
        let error = difference(&exact, &field.stress(x, y).unwrap(), 1.0);
        assert!(error < 2e-12, "{x} {y}: {error:e}");
    }
}

#[expect(clippy::excessive_precision, reason = "as mpmath prints them")]
const REFERENCES: [([f64; 2], [f64; 3]); 7] = [
    ([0.3, 0.001], [-1.609_246_193_271_752_7, -1.612_682_672_986_520_6, 0.001_109_782_515_758_25]),
    (
        [-0.9, 1e-6],
        [-0.202_220_114_220_146_59, -0.202_219_606_030_372_34, 1.266_679_656_350_885_7e-6],
    ),
    (
        [0.999, 0.001],
        [-0.437_286_525_617_740_11, -0.568_111_264_370_091_29, -0.126_368_739_117_750_21],
    ),
    (
        [1.0001, 1e-6],
        [-0.003_556_009_559_020_25, -1.108_921_798_301_804e-7, -1.687_375_220_360_543_7e-5],
    ),
    ([1.0, 1e-6], [-0.254_065_185_503_561_71, -0.251_359_059_637_834_76, -0.160_513_953_917_173_5]),
    ([0.1, 0.5], [-0.504_740_367_601_623_63, -1.269_701_671_296_679_5, 0.198_023_353_122_040_9]),
    (
        [5.0, 2.0],
        [-0.093_979_882_885_379_06, -0.017_654_664_027_149_174, -0.040_557_798_701_309_234],
    ),
];

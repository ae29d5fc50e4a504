//! The largest equivalent stresses and their places.

use std::f64::consts::PI;

use shtaerman::{Criterion, StressField};

fn hertz(ratio: f64) -> StressField {
    let pressure = |_: usize, left: f64, right: f64| (left * right).sqrt();
    StressField::from_pressure(&[[-1.0, 1.0]], None, ratio, pressure).unwrap()
}

/// 20 digits by mpmath from the closed form on the axis.
#[test]
fn hertz_has_the_known_maxima() {
    for (criterion, value, depth) in [
        (Criterion::Tresca, 2.0 * SHEAR[1], SHEAR[0]),
        (Criterion::VonMises, VON_MISES[1], VON_MISES[0]),
    ] {
        let peak = hertz(0.3).peak(criterion);
        assert!((peak.value / value - 1.0).abs() < 1e-13, "{peak:?}");
        assert!((peak.depth / depth - 1.0).abs() < 1e-10, "{peak:?}");
        assert!(peak.x.abs() < 1e-10 && !peak.is_corner);
    }
}

/// A material that hardly feels hydrostatic pressure out of the plane yields on the surface: `nu = 0`, `sigma_vm = p` there.
#[test]
fn the_maximum_may_lie_on_the_surface() {
    let peak = hertz(0.0).peak(Criterion::VonMises);
    assert_eq!((peak.depth, peak.is_corner), (0.0, false));
    assert!((peak.value - 1.0).abs() < 1e-13 && peak.x.abs() < 1e-7, "{peak:?}");
}

/// Under the strip the radius of Mohr's circle is `p/pi` on the whole half-circle through its ends.
#[test]
fn a_uniform_strip_has_a_circle_of_maxima() {
    let field = StressField::from_pressure(&[[-1.0, 1.0]], None, 0.4, |_, _, _| 1.0).unwrap();
    let peak = field.peak(Criterion::Tresca);
    assert!((peak.value - 2.0 / PI).abs() < 1e-13, "{peak:?}");
    assert!((peak.x.hypot(peak.depth) - 1.0).abs() < 1e-6);
}

/// A pressure that falls away from its edge has the worst stress at the edge itself, as a limit.
#[test]
fn a_corner_with_bounded_pressure_yields_at_the_edge() {
    let pressure = |_: usize, _: f64, right: f64| (-5.0 * right).exp();
    let field = StressField::from_pressure(&[[-1.0, 1.0]], None, 0.3, pressure).unwrap();
    let peak = field.peak(Criterion::Tresca);
    assert!(peak.is_corner && (peak.x, peak.depth) == (1.0, 0.0), "{peak:?}");
    // max(2 sin(phi), sin(phi) + 2 (1/2 - nu) 2 phi/2 ...) p/pi is attained close to the corner.
    let near = (1..180)
        .map(|i| PI * f64::from(i) / 180.0)
        .map(|angle| field.stress(1.0 + 1e-8 * angle.cos(), 1e-8 * angle.sin()).unwrap().tresca())
        .fold(0.0, f64::max);
    assert!((near / peak.value - 1.0).abs() < 1e-4, "{near} {peak:?}");
}

#[test]
fn an_infinite_corner_has_an_infinite_stress() {
    let pressure = |_: usize, left: f64, right: f64| (left * right).sqrt().recip();
    let field = StressField::from_pressure(&[[-1.0, 1.0]], None, 0.3, pressure).unwrap();
    let peak = field.peak(Criterion::VonMises);
    assert!(peak.is_corner && peak.value.is_infinite() && peak.x == -1.0);
}

/// Nothing on a fine grid exceeds the maximum, and it is a stress of the field: zones of different widths and pressures.
#[test]
fn no_point_exceeds_the_maximum() {
    for (widths, loads) in
        [([0.3, 0.3], [1.0, 1.0]), ([0.02, 1.0], [3.0, 1.0]), ([0.5, 0.01], [1.0, 0.2])]
    {
        let panels = [[-widths[0], 0.0], [0.05, 0.05 + widths[1]]];
        let pressure = |panel: usize, left: f64, right: f64| {
            loads[panel] * (left * right).sqrt() / widths[panel]
                * (1.0 + 0.3 * left / widths[panel])
        };
        let field = StressField::from_pressure(&panels, None, 0.3, pressure).unwrap();
        for criterion in [Criterion::VonMises, Criterion::Tresca] {
            let peak = field.peak(criterion);
            let there = criterion.of(&field.stress(peak.x, peak.depth).unwrap());
            assert!((there / peak.value - 1.0).abs() < 1e-12);
            for i in 0..120 {
                for j in 0..40 {
                    let x = -0.6 + 1.8 * f64::from(i) / 119.0;
                    let y = 1e-4 * 2e4f64.powf(f64::from(j) / 39.0);
                    let value = criterion.of(&field.stress(x, y).unwrap());
                    assert!(value <= peak.value * (1.0 + 1e-12), "{x} {y}: {value} {peak:?}");
                }
            }
        }
    }
}

/// A periodic row: the maximum repeats, and it is that of one punch when the punches are far apart.
#[test]
fn a_row_far_apart_has_the_maximum_of_one() {
    let pressure = |_: usize, left: f64, right: f64| (left * right).sqrt();
    let field = StressField::from_pressure(&[[-1.0, 1.0]], Some(1e5), 0.3, pressure).unwrap();
    let peak = field.peak(Criterion::Tresca);
    assert!((peak.value / (2.0 * SHEAR[1]) - 1.0).abs() < 1e-8, "{peak:?}");
    assert!((peak.depth / SHEAR[0] - 1.0).abs() < 1e-8);
}

/// Depth and value, from `F = pi (z - sqrt(z^2 - 1))` on the axis.
const SHEAR: [f64; 2] = [0.786_151_377_757_423_3, 0.300_283_106_000_777_6];
const VON_MISES: [f64; 2] = [0.704_291_684_588_101, 0.557_516_216_566_063_7];

/// Crests of a fine wave on a long contact: on the surface the stress is `(1 - 2 nu) p` by von Mises, and below each crest there may be a maximum of the shear.
#[test]
fn the_highest_of_many_crests_is_found() {
    let ratio = 0.05;
    for (waves, phase) in [(20.0, 0.4), (33.0, -1.1), (47.0, 2.2), (61.0, 0.9), (88.0, -2.6)] {
        let lean = 0.002 * phase;
        let pressure = |_: usize, left: f64, right: f64| {
            let x = if left < right { left - 1.0 } else { 1.0 - right };
            (left * right).sqrt() * (1.0 + lean * x) * (1.0 + 0.2 * (waves * x + phase).cos())
        };
        let field = StressField::from_pressure(&[[-1.0, 1.0]], None, ratio, pressure).unwrap();
        let places = (1..20_000).map(|i| f64::from(i) / 10_000.0);
        let highest = places.map(|left| pressure(0, left, 2.0 - left)).fold(0.0, f64::max);
        let peak = field.peak(Criterion::VonMises);
        let least = (1.0 - 2.0 * ratio) * highest;
        assert!(peak.value >= least - 2.0 * field.error(), "{waves}: {peak:?} {least}");
        let shear = field.peak(Criterion::Tresca);
        for i in 0..400 {
            let x = f64::from(i) / 200.0 - 0.9975;
            for depth in [0.3, 0.6, 1.0, 1.6, 2.5, 20.0].map(|depth| depth / waves) {
                let stress = field.stress(x, depth).unwrap();
                let found = [stress.von_mises(), stress.tresca()];
                let allowed = [peak.value, shear.value].map(|value| value * (1.0 + 1e-12));
                assert!(found[0] <= allowed[0] && found[1] <= allowed[1], "{waves} {x} {depth}");
            }
        }
    }
}

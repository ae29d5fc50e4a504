//! Waves of several harmonics: by their series where slopes are known, and by panels and cells where they are not.

use std::f64::consts::PI;

use crate::support::{With, level, punch};
use shtaerman::{Load, Rotational, SmoothContact, Vertical};

/// Amplitudes and phases of the harmonics.
type Wave = Vec<(f64, f64)>;

fn waves() -> Vec<Wave> {
    vec![
        vec![(1.0, 0.3)],
        vec![(1.0, -2.0), (0.2, 0.7)],
        // Two zones at small forces, one at larger ones.
        vec![(0.3, 1.0), (1.0, 0.4), (0.1, 0.0)],
        vec![(1.0, 0.0), (0.0, 0.0), (0.3, 2.0), (0.0, 0.0), (0.05, 1.1)],
    ]
}

fn height(wave: &Wave, x: f64) -> f64 {
    let terms = wave.iter().zip(1..);
    terms.map(|((h, phase), k)| h * (PI * f64::from(k) * x + phase).cos()).sum()
}

fn slope(wave: &Wave, x: f64) -> f64 {
    let terms = wave.iter().zip(1..);
    terms
        .map(|((h, phase), k)| {
            let k = PI * f64::from(k);
            -h * k * (k * x + phase).sin()
        })
        .sum()
}

/// With slopes, and without.
fn both(wave: &Wave, load: Load) -> [SmoothContact; 2] {
    let [one, two] = [wave.clone(), wave.clone()];
    let plain = punch(0.8, move |x| height(&one, x), load).period(2.0);
    let wave = wave.clone();
    let known = punch(0.8, move |x| height(&two, x), load).slope(move |x| slope(&wave, x));
    [known.period(2.0).solved(), plain.solved()]
}

fn compare(what: &str, [series, panels]: &[SmoothContact; 2]) {
    let (zones, others) = (series.zones(), panels.zones());
    assert_eq!(zones.len(), others.len(), "{what}");
    for (zone, other) in zones.iter().zip(&others) {
        for (end, exact) in zone.ends.iter().zip(other.ends) {
            assert!((end - exact).abs() < 1e-9, "{what}: {zone:?} {other:?}");
        }
    }
    let places: Vec<f64> = (0..400).map(|i| f64::from(i) / 199.7 - 1.0).collect();
    let many = series.pressures0(&places);
    let largest = panels.largest_inside0();
    for (xi, p) in places.iter().zip(&many) {
        // Next to an end the pressure falls as a root, which makes more of an error of the end.
        let beside = others.iter().flat_map(|zone| zone.ends).any(|end| {
            let distance = xi - end;
            (distance - 2.0 * (0.5 * distance).round()).abs() < 1e-4
        });
        let error = (p - panels.pressure0(*xi)).abs();
        assert!(beside || error < 1e-8 * largest, "{what} {xi}: {error:e}");
        let single = series.pressure0(*xi);
        assert!((p - single).abs() <= 1e-14 * largest, "{what} {xi}: {p} {single}");
    }
    let error = (series.settlement0() - panels.settlement0()).abs();
    assert!(error < 1e-10, "{what}: settlement {error:e}");
    let error = (series.moment0() - panels.moment0()).abs();
    assert!(error < 1e-8 * series.force0(), "{what}: moment {error:e}");
    let left = series.complementarity();
    assert!(left.tension < 1e-9 && left.penetration < 1e-9, "{what}: {left:?}");
}

#[test]
fn a_series_agrees_with_panels() {
    for (number, wave) in waves().iter().enumerate() {
        for force in [0.01, 0.3, 1.5, 3.0, 20.0] {
            compare(&format!("wave {number} at {force}"), &both(wave, level(force)));
        }
    }
}

#[test]
fn a_series_agrees_with_panels_at_a_settlement() {
    for (number, wave) in waves().iter().enumerate() {
        for settlement in [-0.6, -0.2] {
            let tilt = Rotational::Tilt(0.0);
            let load = Load::new(Vertical::Settlement(settlement), tilt).unwrap();
            let both = both(wave, load);
            let forces = [both[0].force0(), both[1].force0()];
            let what = format!("wave {number} at the settlement {settlement}");
            assert!((forces[0] / forces[1] - 1.0).abs() < 1e-8, "{what}: {forces:?}");
            assert!(forces[0] > 0.0, "{what}");
        }
    }
}

#[test]
fn a_bump_that_samples_of_the_slope_miss_is_seen() {
    // A bump towards the body, between the samples of the slope and on one of the heights: it makes a zone of its own.
    let bump = |x: f64| (-((x - 0.25) / 0.002).powi(2)).exp();
    let height = move |x: f64| -(PI * x).cos() - 1.5 * bump(x);
    let slope =
        move |x: f64| PI * (PI * x).sin() + 1.5 * 2.0 * (x - 0.25) / 0.002f64.powi(2) * bump(x);
    let contact = punch(1.0, height, level(1e-3)).slope(slope).period(2.0).solved();
    assert!(contact.is_contact(0.25) && !contact.is_contact(-0.25));
    assert!(contact.complementarity().penetration < 1e-9);
}

//! Waves of several harmonics: by their series where slopes are known, and by panels and cells where they are not.

use std::f64::consts::PI;

use crate::smooth::support::{Solved, holds, level, punch};
use shtaerman::{Error, Load, Rotational, Vertical};

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

fn formula(wave: &Wave) -> String {
    let terms = wave.iter().zip(1..);
    let terms = terms.map(|((h, phase), k)| format!("{h}*cos({k}*pi*x + ({phase}))"));
    terms.collect::<Vec<_>>().join(" + ")
}

/// By a formula, whose slopes are known, and by a closure.
fn both(wave: &Wave, load: Load) -> [Solved; 2] {
    let [one, two] = [wave.clone(), wave.clone()];
    let plain = punch(0.8, move |x| height(&one, x), load).period(2.0);
    let known = punch(0.8, move |x| height(&two, x), load).formula(&formula(wave));
    [known.period(2.0).solved(), plain.solved()]
}

fn compare(what: &str, [series, panels]: &[Solved; 2]) {
    let (zones, others) = (series.zones(), panels.zones());
    assert_eq!(zones.len(), others.len(), "{what}");
    for (zone, other) in zones.iter().zip(&others) {
        for (end, exact) in zone.ends.iter().zip(other.ends) {
            assert!((end - exact).abs() < 1e-9, "{what}: {zone:?} {other:?}");
        }
    }
    let places: Vec<f64> = (0..400).map(|i| f64::from(i) / 199.7 - 1.0).collect();
    let many = series.contact.pressures(&places).unwrap();
    let largest = places.iter().map(|xi| panels.pressure(*xi).abs()).fold(0.0, f64::max);
    for (xi, p) in places.iter().zip(&many) {
        // Next to an end the pressure falls as a root, which makes more of an error of the end.
        let beside = others.iter().flat_map(|zone| zone.ends).any(|end| {
            let distance = xi - end;
            (distance - 2.0 * (0.5 * distance).round()).abs() < 1e-4
        });
        let error = (p - panels.pressure(*xi)).abs();
        assert!(beside || error < 1e-8 * largest, "{what} {xi}: {error:e}");
        let single = series.pressure(*xi);
        assert!((p - single).abs() <= 1e-14 * largest, "{what} {xi}: {p} {single}");
    }
    let error = (series.settlement() - panels.settlement()).abs();
    assert!(error < 1e-10, "{what}: settlement {error:e}");
    let error = (series.moment() - panels.moment()).abs();
    assert!(error < 1e-8 * series.force(), "{what}: moment {error:e}");
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
            let forces = [both[0].force(), both[1].force()];
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
    let text = "-cos(pi*x) - 1.5*exp(-((x - 0.25)/0.002)^2)";
    let contact = punch(1.0, height, level(1e-3)).formula(text).period(2.0).solved();
    assert!(contact.gap(0.25) == 0.0 && contact.gap(-0.25) > 0.0);
    assert!(contact.complementarity().penetration < 1e-9);
}

/// `x^2` repeated with the period 2: hollow at the seam, where full contact would take an infinite tension. With the weight `sin psi/sqrt(sin^2 B - sin^2 psi)`, `psi = pi x/2`,
/// of a single zone (of one cosine it gives Westergaard's) the force is `8/(pi^2 theta0) ln(1/cos B)`.
#[test]
fn a_hollow_kink_at_the_seam_opens_at_every_force() {
    for (force, tolerance) in [(0.01, 1e-13), (1.0, 1e-12), (4.0, 1e-11), (5.5, 1e-9)] {
        let contact = punch(1.0, |x| x * x, level(force)).formula("x^2").period(2.0).solved();
        let exact = 2.0 / PI * (-PI * PI * force / 8.0).exp().acos();
        let [zone] = contact.zones().try_into().unwrap();
        for (end, side) in zone.ends.into_iter().zip([-1.0, 1.0]) {
            assert!((side * end - exact).abs() < tolerance, "{force}: {end} {exact}");
            assert!((side * end - exact).abs() <= contact.zones_error() + 1e-15, "{force}: {end}");
        }
        assert!(contact.pressure(1.0) == 0.0 && contact.pressure(-1.0) == 0.0);
        if force < 2.0 {
            holds(&contact, 1e-9, &format!("{force}"));
        }
    }
}

#[test]
fn a_gap_that_no_modes_resolve_is_refused() {
    let wave = punch(1.0, |x| x * x, level(12.0)).formula("x^2").period(2.0);
    assert!(matches!(wave.refused(), Error::ZonesTooClose { .. }));
    // A gap of e^-123 periods is narrower than rounding.
    let wave = punch(1.0, |x| x * x, level(100.0)).formula("x^2").period(2.0);
    let contact = wave.solved();
    assert_eq!([-1.0, 1.0].map(|xi| contact.pressure(xi)), [0.0; 2]);
    assert!(contact.pressure(0.999_999) > 0.0 && contact.complementarity().tension == 0.0);
    // Bilateral contact pulls there.
    let wave = punch(1.0, |x| x * x, level(12.0)).formula("x^2").period(2.0).bilateral();
    let contact = wave.solved();
    assert_eq!([-1.0, 1.0].map(|xi| contact.pressure(xi)), [f64::NEG_INFINITY; 2]);
}

/// Westergaard's `sin^2(pi b/2) = P0/(2 h/theta0)`, a little short of full contact, with the crest anywhere.
#[test]
fn narrow_gaps_of_turned_cosines() {
    for crest in [0.0, 0.2, 0.06, 0.246, -0.9] {
        for (short, tolerance) in [(1e-3, 1e-9), (1e-5, 1e-7), (1e-6, 1e-5)] {
            let load = level(2.0 * (1.0 - short));
            let height = move |x: f64| -(PI * (x - crest)).cos();
            let text = format!("-cos(pi*(x - ({crest})))");
            let contact = punch(1.0, height, load).formula(&text).period(2.0).solved();
            let half = 1.0 - 2.0 / PI * f64::sqrt(short).asin();
            let [zone] = contact.zones().try_into().unwrap();
            let found = 0.5 * (zone.ends[1] - zone.ends[0]);
            let what = format!("{crest} {short}: {found} {half}");
            assert!((found - half).abs() < tolerance, "{what}");
            assert!((found - half).abs() <= contact.zones_error(), "{what}");
            let middle = 0.5 * (zone.ends[1] + zone.ends[0]) - crest;
            let middle = middle - 2.0 * (0.5 * middle).round();
            assert!(middle.abs() <= contact.zones_error(), "{what}: middle {middle:e}");
        }
    }
}

/// Full contact of `A |sin(pi (x - s)/2)|`, kinks and all: `f_k = -4 A/(pi (4 k^2 - 1))`, `p_k = -(E*/2) k pi f_k`, and the moment is the sum of their moments.
#[test]
fn the_moment_of_a_wave_with_a_kink() {
    for (height, place) in [(0.1, 0.3), (0.02, -0.77)] {
        let toml = format!(
            "[foundation]\nyoung_modulus = 1\npoisson_ratio = 0\nroughness = 0\n[punch]\ngeometry = \"periodic\"\nperiod = 2\nprofile = \"{height}*abs(sin(pi/2*(x-({place}))))\"\n[load]\nforce = 2\ntilt = 0\n"
        );
        let contact = shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap();
        let sum: f64 = (1..4_000_000)
            .rev()
            .map(|k| {
                let sign = if k % 2 == 1 { -1.0 } else { 1.0 };
                let k = f64::from(k);
                sign * (k * PI * place).sin() / (4.0 * k * k - 1.0)
            })
            .sum();
        let exact = -4.0 * height / PI * sum;
        let bare = contact.dimensionless();
        let stated = bare.error().unwrap().moment;
        let off = (bare.moment() - exact).abs();
        println!("{exact} off by {off:e}, stated {stated:e}");
        // The sum is off by some of its next term.
        assert!(off <= stated + 1e-12 * height, "{off:e}");
        assert!(stated < 1e-11, "{stated:e}");
    }
}

#[test]
fn gaps_beside_a_narrow_crest_of_a_pressed_wave_are_found() {
    // Equally spaced places lie farther apart than the crest is wide.
    let (at, width) = (0.4, 0.0011);
    let crest = move |x: f64| (-((0.5 * PI * (x - at)).sin() / width).powi(2)).exp();
    let height = move |x: f64| 0.5 * (PI * x).cos() - 0.05 * crest(x);
    let text = format!("0.5*cos(pi*x) - 0.05*exp(-(sin(0.5*pi*(x - {at}))/{width})^2)");
    let problem = punch(0.8, height, level(6.0)).formula(&text).period(2.0);
    let contact = problem.solved();
    let opens = (1..40).any(|i| contact.gap(at + 0.1 * width * f64::from(i)) > 0.0);
    assert!(opens, "{at}: {:?}", contact.zones());
    let left = contact.complementarity();
    assert!(left.tension < 1e-9 && left.penetration < 1e-9, "{left:?}");
}

//! Rows of punches and waves: closed forms.

use std::f64::consts::PI;

use crate::smooth::support::{balanced, close, holds, level, punch};
use shtaerman::{Error, Load, Rotational, Vertical};

#[test]
fn a_row_of_flat_punches() {
    // Koiter: p = (P/L) cos psi/sqrt(s^2 - sin^2 psi), psi = pi x/L, s = sin(pi a/L); the surface is at -theta P ln s
    for period in [2.02, 2.5, 4.0, 100.0f64] {
        let (theta0, force) = (0.9, 1.2);
        let contact = punch(theta0, |_| 0.0, level(force)).period(period).solved();
        let s = (PI / period).sin();
        let exact = -theta0 * force * s.ln();
        let error = (contact.settlement() - exact).abs();
        assert!(error < 1e-11 * (1.0 + exact.abs()), "{period}: {} {exact}", contact.settlement());
        for x in [-0.9f64, 0.0, 0.4, 0.99] {
            let psi = PI * x / period;
            // s^2 - sin^2 psi without cancellation
            let root = ((PI * (1.0 - x) / period).sin() * (PI * (1.0 + x) / period).sin()).sqrt();
            let exact = force / period * psi.cos() / root;
            close(contact.pressure(x), exact, 1e-10, &format!("{period} {x}"));
        }
        holds(&contact, 1e-10, &format!("{period}"));
    }
}

#[test]
fn a_row_under_moments() {
    for period in [2.1, 3.0, 9.0] {
        let base = |x: f64| 0.2 * x * x;
        let contact = punch(1.0, base, balanced(1.0, 0.2)).period(period).solved();
        holds(&contact, 1e-10, &format!("{period}"));
        let lifted = punch(1.0, |_| 0.0, balanced(1.0, 0.75)).period(period).solved();
        assert!(lifted.zones()[0].is_free()[0]);
        holds(&lifted, 1e-10, &format!("lifted, {period}"));
    }
}

/// `f = -h cos(pi (x - at))`, contact at the crests, wherever the seam is.
fn wave(mean: f64, at: f64) -> crate::smooth::support::Solved {
    let h = 0.3;
    punch(1.0, move |x| -h * (PI * (x - at)).cos(), level(2.0 * mean))
        .formula(&format!("-{h}*cos(pi*(x - ({at})))"))
        .period(2.0)
        .solved()
}

/// The pressure of full contact `p* = pi E* h/L`, `L = 2`, `E* = 2/pi`.
const LIMIT: f64 = 0.3;

#[test]
fn westergaard() {
    for share in [0.01, 0.3, 0.7, 0.95f64] {
        for at in [0.0, 0.25, 0.9, -1.0] {
            let contact = wave(share * LIMIT, at);
            let s = share.sqrt();
            let a = 2.0 / PI * s.asin();
            let zones = contact.zones();
            assert_eq!(zones.len(), 1);
            let [left, right] = zones[0].ends;
            let what = format!("{share} at {at}: {left} {right}");
            close(right - left, 2.0 * a, 1e-11, &what);
            for y in [-0.9, 0.0, 0.5, 0.99] {
                let psi = 0.5 * PI * a * y;
                let mean = share * LIMIT;
                let inside = (s - psi.sin()) * (s + psi.sin());
                let exact = 2.0 * mean * psi.cos() * inside.sqrt() / (s * s);
                close(contact.pressure(at + a * y), exact, 1e-10, &what);
            }
            assert!(contact.gap(at + 1.0) > 0.0);
        }
    }
}

/// The gap is shorter than the distance of any samples.
#[test]
fn a_wave_just_short_of_full_contact() {
    let at = 0.0f64;
    let missing = 1e-6f64;
    let contact = wave((1.0 - missing) * LIMIT, at);
    // cos(pi a/L) = sqrt(1 - P0/P*)
    let gap = 2.0 - 4.0 / PI * missing.sqrt().acos();
    let [left, right] = contact.zones()[0].ends;
    // Its width to 1e-10 of the half-width.
    assert!((2.0 - (right - left) - gap).abs() < 1e-10, "{at}: {left} {right} {gap}");
    assert!(contact.complementarity().tension < 1e-9);
    assert!(contact.gap(at + 1.0) > 0.0);
    // A gap that is too short is said to be, or as good as none.
    let narrow =
        punch(1.0, move |x| -LIMIT * (PI * (x - at)).cos(), level(2.0 * LIMIT * (1.0 - 1e-9)))
            .formula(&format!("-{LIMIT}*cos(pi*x)"))
            .period(2.0);
    assert!(matches!(narrow.refused(), Error::ZonesTooClose { gap, .. } if gap < 1e-3));
    let full = wave((1.0 - 1e-11) * LIMIT, at);
    assert!(full.complementarity().tension < 1e-10);
    close(full.pressure(at), 2.0 * LIMIT, 1e-10, &format!("{at}"));
}

#[test]
fn the_moment_of_a_wave_is_that_of_its_own_period() {
    // The crest at 0.9 reaches over the seam: what lies beyond counts from -1.
    let contact = wave(0.3 * LIMIT, 0.9);
    let a = 2.0 / PI * 0.3f64.sqrt().asin();
    assert!(0.9 + a > 1.0);
    // By the trapezoidal rule in the angle of the zone.
    let count = 20_000;
    let moment: f64 = (0..count)
        .map(|i| {
            let angle = PI * (f64::from(i) + 0.5) / f64::from(count);
            let x = 0.9 + a * angle.cos();
            let own = if x > 1.0 { x - 2.0 } else { x };
            own * contact.pressure(x) * a * angle.sin() * PI / f64::from(count)
        })
        .sum();
    assert!((moment - contact.moment()).abs() < 1e-4, "{moment} {}", contact.moment());
}

#[test]
fn full_contact_of_a_wave() {
    // p = pbar + p* cos(pi x), moment 0 about the crest
    let mean = 1.4 * LIMIT;
    let contact = wave(mean, 0.0);
    for x in [-1.0f64, -0.3, 0.0, 0.77, 1.0, 2.3] {
        let exact = mean + LIMIT * (PI * x).cos();
        close(contact.pressure(x), exact, 1e-12, &format!("{x}"));
    }
    assert!(contact.settlement().abs() < 1e-14 && contact.moment().abs() < 1e-14);
    // About a quarter: int x cos(pi (x - 1/4)) = sin(pi/4) int x sin(pi x) = sqrt(1/2) 2/pi
    let turned = wave(mean, 0.25);
    close(turned.moment(), LIMIT * 0.5f64.sqrt() * 2.0 / PI, 1e-12, "moment");
    // Bilateral contact is full below the limit, too.
    let h = LIMIT;
    let problem = punch(1.0, move |x| -h * (PI * x).cos(), level(LIMIT)).period(2.0).bilateral();
    close(problem.solved().pressure(1.0), -0.5 * LIMIT, 1e-12, "tension");
    assert!(!problem.solved().contact.tension().is_empty());
}

#[test]
fn a_kinked_wave() {
    // f = |x| on -1 .. 1: p = P/2 + (1/theta0) (4/pi^2) sum over odd k of k cos(k pi x)/k^2 .. = P/2 + (2/pi^2) ln cot(pi |x|/2)
    let load = level(10.0);
    let problem = punch(1.0, f64::abs, load).period(2.0).breaks(&[0.0]).bilateral();
    let contact = problem.solved();
    for x in [0.01f64, 0.2, -0.6, 0.97] {
        let exact = 5.0 - 2.0 / (PI * PI) * (0.5 * PI * x.abs()).tan().ln();
        close(contact.pressure(x), exact, 1e-12, &format!("{x}"));
    }
    close(contact.settlement(), 0.5, 1e-13, "mean height");
}

#[test]
fn a_wave_by_its_settlement() {
    let first = wave(0.4 * LIMIT, 0.0);
    let load = Load::new(Vertical::Settlement(first.settlement()), Rotational::Tilt(0.0)).unwrap();
    let again = punch(1.0, |x| -LIMIT * (PI * x).cos(), load).period(2.0).solved();
    close(again.force(), 0.8 * LIMIT, 1e-10, "force");
}

#[test]
fn a_wave_of_two_heights() {
    let base = |x: f64| -0.3 * (2.0 * PI * x).cos() - 0.05 * (PI * (x - 0.2)).cos();
    let contact = punch(1.0, base, level(0.2)).period(2.0).solved();
    assert_eq!(contact.zones().len(), 2);
    holds(&contact, 1e-10, "two crests");
}

//! What neither the heights of a base show nor few places: ripples on a slope or a hollow, and features beside an edge.

use std::f64::consts::PI;

use crate::smooth::support::{Smooth, balanced, level, punch};

/// The least pressure over the mean, at many places of all zones.
fn least(contact: &crate::smooth::support::Solved) -> f64 {
    let pressures = contact.zones().into_iter().flat_map(|zone| {
        let [left, right] = zone.ends;
        let place = move |i: i32| left + (right - left) * (f64::from(i) + 0.37) / 4000.0;
        (0..4000).map(place)
    });
    let least = pressures.map(|x| contact.pressure(x)).fold(f64::INFINITY, f64::min);
    least / (0.5 * contact.force())
}

/// The force at which a base that is held in contact pulls nowhere any more: a force adds that of a flat one.
fn lift_off(base: &dyn Fn(f64) -> Smooth) -> f64 {
    let held = base(1.0).bilateral().solved();
    (1..8000).fold(f64::NEG_INFINITY, |most, i| {
        let x = f64::from(i) / 4000.0 - 1.0;
        let flat = 1.0 / (PI * (1.0 - x * x).sqrt());
        most.max(1.0 - held.pressure(x) / flat)
    })
}

/// The profile has one top and no valley: ripples are steep enough for the pressure alone.
#[test]
fn ripples_that_no_valley_shows_open_gaps() {
    let mut parted = 0;
    for (waves, phase) in [(97.0, 0.3), (211.3, 2.0), (389.1, 4.4)] {
        let size = 0.15 / (waves * waves);
        let base = |force: f64| {
            let height = move |x: f64| -0.1 * x * x + size * (waves * x + phase).cos();
            let formula = format!("-0.1*x^2 + {size}*cos({waves}*x + {phase})");
            punch(1.0, height, balanced(force, 0.0)).formula(&formula)
        };
        let limit = lift_off(&base);
        let whole = base(1.001 * limit).solved();
        assert_eq!(whole.zones().len(), 1, "{waves}");
        assert!(least(&whole) > 0.0, "{waves}: {:e}", least(&whole));
        for share in [3e-3, 3e-4, 1e-4] {
            let Ok(contact) = base((1.0 - share) * limit).solve() else { continue };
            assert!(contact.zones().len() > 1, "{waves} {share}");
            assert!(least(&contact) > -1e-9, "{waves} {share}: {:e}", least(&contact));
            parted += 1;
        }
    }
    assert!(parted >= 6, "{parted}");
}

/// A kink beside an edge takes from the corner there more than it has: the edge is free.
#[test]
fn corners_do_not_pull() {
    for (at, slope) in [(0.99997, 3.0), (0.999_994, 5.0), (0.9993, 1.0)] {
        let height = move |x: f64| slope * (x.abs() - at).max(0.0);
        let base = punch(1.0, height, balanced(1e-3, -1e-4));
        let base = base.formula(&format!("{slope}*max(0, abs(x) - {at})"));
        let contact = base.solved();
        for zone in contact.zones() {
            assert!(zone.intensity.iter().all(|k| *k >= 0.0), "{at}: {:?}", contact.zones());
        }
        assert!(least(&contact) >= 0.0, "{at}: {:e}", least(&contact));
    }
}

/// `max(0, |x| - c)^2/(2 R)`: `P R/E* = b^2/4 (2 t - sin 2 t)`, `cos t = c/b` (M. Ciavarella, D. A. Hills, G. Monno, Proc. Inst. Mech. Eng. C 212 (1998) 319).
#[test]
fn small_roundings_of_a_flat_base() {
    for (flat, turn) in [(0.9, 1e-2), (0.99, 1e-3), (0.9999, 3e-4), (0.99999, 1e-3)] {
        let end = flat / f64::cos(turn);
        let radius = 1e-3;
        let doubled = 2.0 * turn;
        // 2 t - sin 2 t
        let excess = doubled.powi(3) / 6.0
            * (1.0 - doubled * doubled / 20.0 * (1.0 - doubled * doubled / 42.0));
        let modulus = 2.0 / PI;
        let force = modulus / radius * end * end / 4.0 * excess;
        let height = move |x: f64| (x.abs() - flat).max(0.0).powi(2) / (2.0 * radius);
        let formula = format!("max(0, abs(x) - {flat})^2/{}", 2.0 * radius);
        let contact = punch(1.0, height, balanced(force, 0.0)).formula(&formula).solved();
        let [left, right] = contact.zones()[0].ends;
        let known = contact.zones_error();
        assert!(known < 1e-14, "{flat} {turn}: {known:e}");
        assert!((right - end).abs() <= known + 4e-16, "{flat} {turn}: {:e}", right - end);
        assert!((left + end).abs() <= known + 4e-16, "{flat} {turn}: {:e}", left + end);
        // In the middle it is that of a sharp punch but for squares of the turn.
        let sharp = force / (PI * end);
        let off = (contact.pressure(0.0) / sharp - 1.0).abs();
        assert!(off < turn * turn, "{flat} {turn}: {off:e}");
        assert!(least(&contact) >= 0.0, "{flat} {turn}: {:e}", least(&contact));
    }
}

/// Of two equal teeth each bears half the force, however little that is: the tip of the other is looked at.
#[test]
fn teeth_beside_a_contact_touch() {
    for (left, right) in [(-0.54, -0.225), (-0.31, 0.77), (0.1, 0.9)] {
        for force in [1e-3, 1e-5, 1e-8] {
            let height = move |x: f64| 0.01 * (x - left).abs().min((x - right).abs());
            let formula = format!("min(0.01*abs(x - ({left})), 0.01*abs(x - ({right})))");
            let contact = punch(1.0, height, level(force)).formula(&formula).solved();
            assert_eq!(contact.zones().len(), 2, "{left} {right} {force}");
            let arm = contact.moment() / force;
            assert!((arm - 0.5 * (left + right)).abs() < 1e-9, "{left} {right} {force}: {arm}");
        }
    }
}

//! The conditions of contact, checked by quadrature.

use crate::smooth::support::{balanced, holds, punch};
use shtaerman::{Load, Rotational, Vertical};

#[test]
fn one_zone() {
    for moment in [0.0, 0.3, -0.8] {
        holds(&punch(1.0, |x| 2.0 * x * x, balanced(1.0, moment)).solved(), 1e-11, "parabola");
        holds(&punch(1.0, |x| (2.0 * x).exp(), balanced(1.0, moment)).solved(), 1e-11, "exp");
        let kinked = punch(3.0, |x| 2.0 * (x - 0.2).abs(), balanced(1.0, moment)).breaks(&[0.2]);
        holds(&kinked.solved(), 1e-10, "kink");
        let bend = punch(1.0, |x| x.max(0.1).powi(2), balanced(1.0, moment)).breaks(&[0.1]);
        holds(&bend.solved(), 1e-10, "bend");
    }
}

#[test]
fn two_bumps() {
    let bump = |x: f64| 40.0 * ((x - 0.5).powi(2)).min((x + 0.5).powi(2));
    let contact = punch(1.0, bump, balanced(1.0, 0.05)).breaks(&[0.0]).solved();
    assert_eq!(contact.zones().len(), 2);
    holds(&contact, 1e-11, "bumps");
}

#[test]
fn many_zones() {
    for waves in [6.2f64, 12.0, 40.0] {
        let base = move |x: f64| 0.5 * (1.0 - (waves * x + 0.3).cos()) + 0.3 * x * x;
        let contact = punch(1.0, base, balanced(0.5, 0.05)).solved();
        assert!(contact.zones().len() as f64 > waves / 10.0);
        holds(&contact, 1e-10, &format!("{waves}"));
    }
}

#[test]
fn a_step_of_the_base_is_a_wall() {
    let step = |x: f64| if x > 0.25 { 9.0 } else { 0.0 };
    let contact = punch(1.0, step, balanced(1.0, -0.3)).breaks(&[0.25]).solved();
    let zone = contact.zones()[0];
    assert_eq!(zone.ends[1], 0.25);
    assert!(!zone.is_free()[1] && zone.intensity[1] > 0.1);
    holds(&contact, 1e-11, "step");
}

#[test]
fn the_stiffness_is_the_derivative() {
    let at = |delta: f64, alpha: f64| {
        let load = Load::new(Vertical::Settlement(delta), Rotational::Tilt(alpha)).unwrap();
        punch(1.0, |x| 3.0 * x * x + x.powi(3), load).solved()
    };
    let stiffness = at(0.8, 0.2).stiffness();
    let h = 1e-4;
    let force = (at(0.8 + h, 0.2).force() - at(0.8 - h, 0.2).force()) / (2.0 * h);
    let coupling = (at(0.8 + h, 0.2).moment() - at(0.8 - h, 0.2).moment()) / (2.0 * h);
    let turn = (at(0.8, 0.2 - h).moment() - at(0.8, 0.2 + h).moment()) / (2.0 * h);
    assert!((stiffness.force_settlement - force).abs() < 1e-6, "{stiffness:?} {force}");
    assert!((stiffness.coupling - coupling).abs() < 1e-6, "{stiffness:?} {coupling}");
    assert!((stiffness.moment_tilt - turn).abs() < 1e-6, "{stiffness:?} {turn}");
}

#[test]
fn reflection_reflects() {
    let right = punch(1.0, |x| x * x - x + (9.0 * x).sin(), balanced(1.0, 0.2)).solved();
    let left = punch(1.0, |x| x * x + x - (9.0 * x).sin(), balanced(1.0, -0.2)).solved();
    for (one, other) in right.zones().iter().zip(left.zones().iter().rev()) {
        assert!((one.ends[0] + other.ends[1]).abs() < 1e-11);
        assert!((one.ends[1] + other.ends[0]).abs() < 1e-11);
    }
    assert!((right.settlement() - left.settlement()).abs() < 1e-11);
}

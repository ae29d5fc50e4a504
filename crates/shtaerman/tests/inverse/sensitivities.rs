//! Sensitivities against the tangent stiffness, scaling laws and closed forms.

use crate::inverse::support::{bare, load, physical, unilateral};
use shtaerman::{Derivatives, Load, Problem, Rotational, Roughness, Solver, Vertical};

#[track_caller]
fn near(found: f64, exact: f64, scale: f64) {
    assert!((found - exact).abs() < 3e-8 * scale.abs(), "{found} for {exact}");
}

fn problems() -> Vec<Problem> {
    let start = physical(200e9, 1.2e-14, 5e-3, "x^2/(2*0.8)", load(8e5, 0.0));
    let eccentric = Load::new(Vertical::Force(8e5), Rotational::Eccentricity(6e-4)).unwrap();
    let power = Roughness::power(2e-10, 0.6).unwrap();
    let mut problems = vec![start.clone(), start.with_load(eccentric).unwrap()];
    let full = physical(200e9, 1.2e-14, 5e-3, "x^2/(2*80)", load(8e5, 0.0));
    problems.push(full);
    // Power laws join once their solver does.
    problems.extend(start.with_roughness(power).ok().filter(is_solved));
    problems
}

/// Whether the law of the layer is taken as it is.
fn is_solved(problem: &Problem) -> bool {
    let Ok(contact) = problem.solve() else { return false };
    let p = contact.pressure(0.0).unwrap();
    let layer = contact.base_depth(0.0) - contact.elastic_displacement(0.0);
    (layer / (2e-10 * p.powf(0.6)) - 1.0).abs() < 1e-6
}

/// `kappa B dq/dB - E dq/dE = P dq/dP - m q`, `m = 0` for displacements and 1 for pressures: from the homogeneity of the equations, which are those of
/// `(l B, l theta, l f)` for `l delta`, and of `(s^(1-kappa) B, theta, s f, s P)` for `s p, s delta`.
#[test]
fn the_scaling_laws_hold() {
    for problem in problems() {
        let contact = problem.solve().unwrap();
        let scaling = *problem.scaling().unwrap();
        let (coefficient, exponent) = match scaling.roughness() {
            Roughness::Linear { compliance } => (compliance, 1.0),
            Roughness::Power { coefficient, exponent } => (coefficient, exponent),
            other => unreachable!("{other:?}"),
        };
        let holds = |d: &Derivatives, value: f64, power: f64| {
            let layer = exponent * coefficient * d.roughness.unwrap();
            let elastic = -scaling.pressure() * d.young_modulus.unwrap();
            let load = contact.force() * d.force.unwrap();
            near(layer + elastic, load - power * value, layer.abs() + elastic.abs() + load.abs());
            assert!(d.error < 1e-6, "{}", d.error);
        };
        for found in [contact.sensitivities(), contact.difference_sensitivities()] {
            let found = found.unwrap();
            holds(&found.settlement.unwrap(), contact.settlement(), 0.0);
            holds(&found.peak_pressure.unwrap(), contact.peak_pressure(), 1.0);
            assert!(found.force.is_none());
        }
    }
}

#[test]
fn the_force_derivative_is_the_inverse_stiffness() {
    for problem in problems() {
        let contact = problem.solve().unwrap();
        let found = contact.sensitivities().unwrap();
        let [[k11, k12], [_, k22]] = contact.stiffness().matrix();
        let determinant = k11 * k22 - k12 * k12;
        let eccentricity = contact.moment() / contact.force();
        // dP, e dP = S (ddelta, -dalpha)
        let settlement = (k22 - k12 * eccentricity) / determinant;
        let tilt = -(k11 * eccentricity - k12) / determinant;
        near(found.settlement.unwrap().force.unwrap(), settlement, settlement);
        near(found.tilt.unwrap().force.unwrap(), tilt, settlement / 5e-3);
    }
}

#[test]
fn the_roughness_derivative_is_the_dissipation() {
    // d delta/d chi at constant P, M is int p p_1 dx, p_1 = dp/dP: half the derivative of int p^2 by P.
    let problem = &problems()[0];
    let contact = problem.solve().unwrap();
    let squared = |force: f64| {
        let contact = problem.with_vertical(Vertical::Force(force)).unwrap().solve().unwrap();
        let [[left, right]] = contact.zones()[..] else { unreachable!() };
        let count = 4000;
        // Midpoints in the angle: p vanishes like a root at the edges.
        (0..count)
            .map(|i| {
                let angle = std::f64::consts::PI * (f64::from(i) + 0.5) / f64::from(count);
                let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
                let p = contact.pressure(middle + half * angle.cos()).unwrap();
                p * p * half * angle.sin() * std::f64::consts::PI / f64::from(count)
            })
            .sum::<f64>()
    };
    let step = 1e-3 * contact.force();
    let exact = 0.5 * (squared(8e5 + step) - squared(8e5 - step)) / (2.0 * step);
    let found = contact.sensitivities().unwrap().settlement.unwrap().roughness.unwrap();
    assert!((found / exact - 1.0).abs() < 1e-5, "{found} {exact}");
}

#[test]
fn a_layer_alone_has_closed_derivatives() {
    // f0 = c xi^2 at theta0 = 0: delta0 = c w^2, P = 4/3 c w^3, so d delta0/dP = 1/(2w), width 2w: dw/dP = 1/(4 c w^2).
    let c: f64 = 50.0;
    let problem = unilateral(0.0, "50*xi^2", load(1.0, 0.0));
    let found = problem.solve().unwrap().sensitivities().unwrap();
    let w = (0.75 / c).cbrt();
    near(found.settlement.unwrap().force.unwrap(), 0.5 / w, 0.5 / w);
    near(found.peak_pressure.unwrap().force.unwrap(), 0.5 / w, 0.5 / w);
    near(found.contact_width.force.unwrap(), 0.5 / (c * w * w), 0.5 / (c * w * w));
    assert_eq!(found.settlement.unwrap().theta0, None);
}

#[test]
fn bilateral_contact_and_a_prescribed_settlement() {
    // Linear in the load; dF/d delta is the stiffness, also where nothing is prescribed but zero.
    for settlement in [2.0, 0.0] {
        let load = Load::new(Vertical::Settlement(settlement), Rotational::Tilt(0.3)).unwrap();
        let problem = bare(2.0, "xi^2 - xi/2", load, Solver::bilateral());
        let contact = problem.solve().unwrap();
        let found = contact.sensitivities().unwrap();
        let stiffness = contact.stiffness().force_settlement;
        near(found.force.unwrap().settlement.unwrap(), stiffness, stiffness);
        assert!(found.settlement.is_none() && found.tilt.is_none() && found.held == "tilt");
        assert!(found.force.unwrap().theta0.unwrap().is_finite());
        near(found.contact_width.settlement.unwrap(), 0.0, 1.0);
    }
}

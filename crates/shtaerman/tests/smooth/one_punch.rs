//! One punch: closed forms.

use std::f64::consts::{LN_2, PI};

use crate::smooth::support::{balanced, close, holds, punch};
use shtaerman::{Load, Rotational, Vertical};

#[test]
fn flat_punch() {
    // p = (P + 2 M x)/(pi sqrt(1 - x^2)), delta = theta0 P ln 2, alpha = -2 theta0 M, K = (P +- 2M)/sqrt(pi)
    let (theta0, force, moment) = (3.0, 0.7, 0.3);
    for is_unilateral in [true, false] {
        let mut problem = punch(theta0, |_| 0.0, balanced(force, moment));
        problem.is_unilateral = is_unilateral;
        let contact = problem.solved();
        close(contact.settlement(), theta0 * force * LN_2, 1e-14, "settlement");
        close(contact.tilt(), -2.0 * theta0 * moment, 1e-14, "tilt");
        let zone = contact.zones()[0];
        assert_eq!(zone.ends, [-1.0, 1.0]);
        assert_eq!(zone.is_free(), [false; 2]);
        close(zone.intensity[0], (force - 2.0 * moment) / PI.sqrt(), 1e-13, "K left");
        close(zone.intensity[1], (force + 2.0 * moment) / PI.sqrt(), 1e-14, "K right");
        for x in [-0.99f64, -0.3, 0.0, 0.5, 0.999] {
            let exact = (force + 2.0 * moment * x) / (PI * (1.0 - x * x).sqrt());
            close(contact.pressure(x), exact, 1e-13, "pressure");
        }
        assert_eq!(contact.pressure(1.0), f64::INFINITY);
        // Outside: ln(2/w) P + (M 2/w) sides, with x = (w + 1/w)/2
        for x in [1.0 + 1e-9, 1.3, -1.7, -20.0f64] {
            let w = x.abs() + (x * x - 1.0).sqrt();
            let exact = theta0 * (force * (2.0 / w).ln() + 2.0 * moment * x.signum() / w);
            close(contact.elastic_displacement(x), exact, 1e-13, "outside");
        }
        let stiffness = contact.stiffness();
        close(stiffness.force_settlement, 1.0 / (theta0 * LN_2), 1e-14, "c11");
        close(stiffness.moment_tilt, 0.5 / theta0, 1e-14, "c22");
        assert_eq!(stiffness.coupling, 0.0);
    }
}

#[test]
fn flat_punch_beyond_the_tilting_limit() {
    // b = 2 (1 - |M|/P), p = P/(pi b) sqrt((b + y)/(b - y)), y from the middle of the zone
    for (e, side) in [(0.55, 1.0), (0.9, -1.0), (0.9999, 1.0), (0.500001, -1.0)] {
        let contact = punch(2.0, |_| 0.0, balanced(1.5, 1.5 * e * side)).solved();
        let b = 2.0 * (1.0 - e);
        let zone = contact.zones()[0];
        let (wall, free) = if side > 0.0 { (1, 0) } else { (0, 1) };
        assert_eq!(zone.ends[wall], side);
        assert!(zone.is_free()[free] && !zone.is_free()[wall]);
        close(zone.ends[wall] * side - zone.ends[free] * side, 2.0 * b, 1e-11, "width");
        for y in [-0.9f64, -0.2, 0.4, 0.99] {
            let exact = 1.5 / (PI * b) * ((1.0 + y) / (1.0 - y)).sqrt();
            let found = contact.pressure(side * (1.0 - b + b * y));
            close(found, exact, 1e-10, &format!("{e} {y}"));
        }
        assert!(contact.gap(-side) > 0.0);
    }
}

#[test]
fn tension_of_a_bilateral_punch() {
    // p changes its sign at x = -P/(2M)
    let contact = punch(1.0, |_| 0.0, balanced(1.0, 0.8)).bilateral().solved();
    let tension = contact.contact.tension();
    assert_eq!(tension.len(), 1);
    assert!(tension[0][0] < -0.999 && (tension[0][1] + 0.625).abs() < 0.01, "{tension:?}");
}

#[test]
fn hertz() {
    // f = c x^2: 1/(2R) = c, a^2 = theta0 P/c, p0 = 2P/(pi a); E* = 2/(pi theta0)
    for (theta0, curvature, force) in [(1.0, 8.0, 1.0), (1e4, 3e8, 1.0), (0.02, 1.0, 7.0)] {
        let contact = punch(theta0, move |x| curvature * x * x, balanced(force, 0.0)).solved();
        let a = (theta0 * force / curvature).sqrt();
        let zone = contact.zones()[0];
        close(zone.ends[1], a, 1e-12, "width");
        close(-zone.ends[0], a, 1e-12, "width");
        assert_eq!(zone.intensity, [0.0; 2]);
        for y in [-0.95f64, 0.0, 0.3, 0.99] {
            let exact = 2.0 * force / (PI * a) * (1.0 - y * y).sqrt();
            close(contact.pressure(a * y), exact, 1e-11, "pressure");
        }
        // delta = theta0 P ln(2/a) + f_0, f_0 = c a^2/2
        let settlement = theta0 * force * ((2.0 / a).ln() + 0.5);
        close(contact.settlement(), settlement, 1e-12, "settlement");
        // Stiffness on the zone: 1/(theta0 ln(2/a))
        let c11 = 1.0 / (theta0 * (2.0 / a).ln());
        close(contact.stiffness().force_settlement, c11, 1e-12, "stiffness");
    }
}

#[test]
fn an_eccentric_parabola_rolls() {
    // f = c x^2 turned by alpha: the zone moves to the line of the force, alpha = -2 c e
    let (curvature, force, e) = (40.0, 1.0, 0.6);
    let contact = punch(1.0, move |x| curvature * x * x, balanced(force, force * e)).solved();
    let a = (force / curvature).sqrt();
    let [left, right] = contact.zones()[0].ends;
    close(right, e + a, 1e-11, "right");
    close(left, e - a, 1e-11, "left");
    close(contact.tilt(), -2.0 * curvature * e, 1e-11, "tilt");
    close(contact.pressure(e + 0.5 * a), 2.0 / (PI * a) * 0.75f64.sqrt(), 1e-10, "pressure");
}

#[test]
fn a_formula_keeps_digits_on_short_zones() {
    let (curvature, e) = (1e9, 0.6);
    let contact = punch(1.0, move |x| curvature * x * x, balanced(1.0, e))
        .formula(&format!("{curvature}*x^2"))
        .solved();
    let a = (1.0 / curvature).sqrt();
    let [left, right] = contact.zones()[0].ends;
    close(right - left, 2.0 * a, 1e-9, "width");
    close(contact.pressure(0.5 * (left + right)), 2.0 / (PI * a), 1e-9, "pressure");
}

#[test]
fn wedge() {
    // f = t |x|: P = a E* t, p = (E* t/pi) arccosh(a/|x|)
    let (theta0, slope) = (0.8, 2.0);
    let modulus = 2.0 / (PI * theta0);
    let a = 0.45;
    let load = balanced(a * modulus * slope, 0.0);
    let contact = punch(theta0, move |x| slope * x.abs(), load).breaks(&[0.0]).solved();
    let zone = contact.zones()[0];
    close(zone.ends[1], a, 1e-12, "width");
    close(zone.ends[0], -a, 1e-12, "width");
    for y in [1e-5f64, 0.001, 0.3, -0.7, 0.999] {
        let exact = modulus * slope / PI * (1.0 / y.abs()).acosh();
        close(contact.pressure(a * y), exact, 5e-11, &format!("pressure at {y}"));
    }
    assert!(contact.pressure(0.0) > 100.0 * contact.pressure(0.1));
}

#[test]
fn a_blunted_wedge() {
    // f = t max(|x| - c, 0), kinks at +-c: by p = (E*/2 pi) int f'' G with G(x, s) = ln |(a^2 - x s + sqrt(a^2 - x^2) sqrt(a^2 - s^2))/(a (x - s))|,
    // P = 2 (E* t/2) sqrt(a^2 - c^2): a slope change t at s carries (E* t/2) sqrt(a^2 - s^2)
    let (theta0, slope, c, a) = (1.0, 3.0, 0.2f64, 0.7f64);
    let modulus = 2.0 / (PI * theta0);
    let load = balanced(modulus * slope * (a * a - c * c).sqrt(), 0.0);
    let contact =
        punch(theta0, move |x| slope * (x.abs() - c).max(0.0), load).breaks(&[-c, c]).solved();
    close(contact.zones()[0].ends[1], a, 1e-11, "width");
    for x in [0.0f64, 0.15, 0.3, 0.69] {
        let green = |s: f64| {
            let roots = ((a * a - x * x) * (a * a - s * s)).sqrt();
            ((a * a - x * s + roots) / (a * (x - s))).abs().ln()
        };
        let exact = modulus * slope / (2.0 * PI) * (green(c) + green(-c));
        close(contact.pressure(x), exact, 2e-11, &format!("pressure at {x}"));
    }
}

#[test]
fn polynomial_base_in_full_contact() {
    // p = [P/pi + 2 M x/pi - (1/(pi theta0)) sum_{m >= 2} m f_m T_m]/sqrt(1 - x^2)
    let series = [0.4, -0.2, 0.05, 0.03, -0.01, 0.0, 0.004];
    let base = move |x: f64| {
        series.iter().enumerate().map(|(m, f)| f * (m as f64 * x.acos()).cos()).sum::<f64>()
    };
    let (theta0, force, moment) = (1.3, 1.0, 0.1);
    let contact = punch(theta0, base, balanced(force, moment)).solved();
    assert_eq!(contact.zones()[0].ends, [-1.0, 1.0]);
    let bent = |x: f64| -> f64 {
        let terms = series.iter().enumerate().skip(2);
        terms.map(|(m, f)| m as f64 * f * (m as f64 * x.acos()).cos()).sum()
    };
    for x in [-0.9f64, -0.1, 0.33, 0.98] {
        let density = (force + 2.0 * moment * x) / PI - bent(x) / (PI * theta0);
        close(contact.pressure(x), density / (1.0 - x * x).sqrt(), 1e-12, "pressure");
    }
    close(contact.settlement(), series[0] + theta0 * force * LN_2, 1e-13, "settlement");
    close(contact.tilt(), -2.0 * theta0 * moment - series[1], 1e-12, "tilt");
    for (side, x) in [(0, -1.0), (1, 1.0)] {
        let density = (force + 2.0 * moment * x) / PI - bent(x) / (PI * theta0);
        close(contact.zones()[0].intensity[side], PI.sqrt() * density, 1e-12, "K");
    }
}

#[test]
fn what_is_prescribed_does_not_matter() {
    let base = |x: f64| 3.0 * x.powi(4) + (5.0 * x).cos() - 0.3 * x;
    let (force, moment) = (0.4, 0.05);
    let first = punch(2.0, base, balanced(force, moment)).solved();
    let (delta, alpha) = (first.settlement(), first.tilt());
    for (vertical, rotational) in [
        (Vertical::Settlement(delta), Rotational::Tilt(alpha)),
        (Vertical::Settlement(delta), Rotational::Moment(moment)),
        (Vertical::Force(force), Rotational::Tilt(alpha)),
        (Vertical::Force(force), Rotational::Eccentricity(moment / force)),
        (Vertical::Settlement(delta), Rotational::Eccentricity(moment / force)),
    ] {
        let contact = punch(2.0, base, Load::new(vertical, rotational).unwrap()).solved();
        let what = format!("{vertical:?} {rotational:?}");
        close(contact.force(), force, 1e-10, &what);
        close(contact.moment(), moment, 1e-9, &what);
        close(contact.settlement(), delta, 1e-11, &what);
        close(contact.tilt(), alpha, 1e-10, &what);
        close(contact.pressure(0.6), first.pressure(0.6), 1e-10, &what);
    }
}

#[test]
fn the_scale_of_stiffness_does_not_matter() {
    // theta0 -> k theta0, f -> k f: the same pressure
    let base = |x: f64| 2.0 * x * x + 0.3 * (7.0 * x).sin();
    let one = punch(1.0, base, balanced(1.0, -0.1)).solved();
    let two = punch(1e7, move |x| 1e7 * base(x), balanced(1.0, -0.1)).solved();
    assert_eq!(one.zones().len(), two.zones().len());
    for x in [-0.5, 0.0, 0.3] {
        close(two.pressure(x), one.pressure(x), 1e-11, "pressure");
    }
    close(two.settlement(), 1e7 * one.settlement(), 1e-12, "settlement");
}

#[test]
fn an_end_about_a_kink_is_found() {
    // The base is flat up to a kink and rises beyond: the density at the free end has two slopes there, and the ends that steps of either lead to lie on the other's side.
    for kink in [0.42, 0.6401] {
        for force in [0.7, 1.1] {
            for arm in [-0.61, -0.57, -0.5] {
                let rising = move |x: f64| 0.97 * (x - kink).max(0.0);
                let contact = punch(1.0, rising, balanced(force, arm * force))
                    .formula(&format!("0.97*max(x - {kink}, 0)"))
                    .breaks(&[kink])
                    .solved();
                holds(&contact, 1e-9, &format!("{kink} {force} {arm}"));
            }
        }
    }
}

//! Wedges whose kink is not, or hardly, off the middle of the zone.

use std::f64::consts::PI;

use fredholm::quadrature::double_exponential;
use shtaerman::{Rotational, Vertical};

use crate::smooth_graded::support::{Case, EXPONENTS, beta_integral, close, cosine, potential};

const STEEPNESS: f64 = 1.0 / 3.0;
const PROFILE: &str = "abs(x)/3";
const SHARES: [f64; 5] = [-0.9, -0.3, 0.01, 0.5, 0.96];

/// `int_|y|^1 (x^2 - y^2)^-beta dx`, the shape of the pressure of a wedge on `|y| <= 1`.
fn symmetric(mu: f64, y: f64) -> f64 {
    let (beta, y) = (0.5 * (1.0 - mu), y.abs());
    // x = y + u^(1/(1-beta)) takes the power away
    let power = 1.0 / (1.0 - beta);
    let end = (1.0 - y).powf(1.0 / power);
    double_exponential(300)
        .map(|node| {
            let distance = (0.5 * end * node.from_left).powf(power);
            0.5 * end * node.weight * power * (distance + 2.0 * y).powf(-beta)
        })
        .sum()
}

/// Eccentricities up to where squares are felt.
fn eccentricities() -> impl Iterator<Item = f64> {
    let small = (-15..=-6).flat_map(|power| [1.0, -3.0].map(|e| e * 10f64.powi(power)));
    std::iter::once(0.0).chain(small)
}

#[test]
fn hardly_eccentric_wedges_are_turned_flat_punches_besides() {
    // p changes by a pressure that displaces the zone by a turn, which is that of a flat punch, singular as the ends move.
    for mu in EXPONENTS {
        let case = Case::plane(mu);
        let force = 0.01;
        let level = case.solve(PROFILE, Vertical::Force(force), Rotational::Eccentricity(0.0));
        let b = level.zones()[0][1];
        assert!(b < 1.0);
        let factor = 1.0 / beta_integral(0.5 * (mu - 1.0));
        // of a flat punch on |x| <= b
        let unit = case.line() * PI * factor / cosine(mu) * b.powf(-mu);
        for e in eccentricities() {
            let contact = case.solve(PROFILE, Vertical::Force(force), Rotational::Eccentricity(e));
            let what = format!("{mu} {e:e}");
            let squares = 100.0 * (e / b).powi(2);
            let turn = -unit * mu * (2.0 + mu) / (b * b) * force * e;
            let scale = STEEPNESS;
            let error = (contact.tilt() - turn).abs() / scale;
            assert!(error < 1e-14 + squares, "tilt, {what}: {error:e}");
            // The ends move by the ratio of the flat pressure there and the slope of p.
            let [left, right] = contact.zones()[0];
            let shift = e * (2.0 + mu) / (1.0 + mu);
            assert!((left + b - shift).abs() < (1e-14 + squares) * b, "left, {what}: {left}");
            assert!((right - b - shift).abs() < (1e-14 + squares) * b, "right, {what}: {right}");
            close(contact.settlement(), level.settlement(), 1e-13 + squares, &what);
            for y in SHARES {
                let weight = (1.0 - y * y).powf(0.5 * (mu - 1.0)) * factor / b;
                let moved = weight * (2.0 + mu) * force * e / b * y;
                let exact = level.pressure(y * b).unwrap() + moved;
                close(contact.pressure(y * b).unwrap(), exact, 1e-12 + 100.0 * squares, &what);
            }
            let left = contact.complementarity().unwrap();
            assert!(left.tension < 1e-12 && left.penetration < 1e-12, "{what} {left:?}");
            assert!(
                contact.relative_error() < 1e-10,
                "{what} {:?}",
                contact.dimensionless().error()
            );
        }
    }
}

#[test]
fn level_wedges_are_known() {
    for mu in EXPONENTS {
        let case = Case::plane(mu);
        let contact = case.press(PROFILE, 0.01);
        let b = contact.zones()[0][1];
        // The same shape as by the integral, scaled by the force.
        let all = |f: &dyn Fn(f64) -> f64| -> f64 {
            double_exponential(300).map(|node| 0.5 * node.weight * f(0.5 * node.from_left)).sum()
        };
        let sum = 2.0 * b * all(&|y| symmetric(mu, y));
        for y in SHARES {
            let exact = 0.01 * symmetric(mu, y) / sum;
            let found = contact.pressure(y * b).unwrap();
            let stated = contact.dimensionless().error().unwrap().pressure;
            let stated = stated * contact.problem().scaling().unwrap().pressure();
            assert!((found - exact).abs() < stated, "{mu} {y}: {found} {exact} {stated:e}");
            assert!(stated < 1e-10 * exact, "{mu} {y}: {stated:e} {exact}");
        }
    }
}

#[test]
fn kernels_of_hardly_eccentric_wedges_give_the_base() {
    for mu in [0.2, 0.5, 0.8] {
        let case = Case::plane(mu);
        for e in [1e-12, 1e-9, -1e-7, 4e-7, 1e-6] {
            let contact = case.solve(PROFILE, Vertical::Force(0.05), Rotational::Eccentricity(e));
            let [left, right] = contact.zones()[0];
            let size = contact.settlement();
            for share in [0.1, 0.45, 0.8] {
                let x = left + share * (right - left);
                let error = potential(&case, &contact, &[0.0], x) - contact.base_depth(x);
                assert!(error.abs() < 1e-10 * size, "{mu} {e:e} {x}: {error:e} of {size}");
            }
            for x in [-1.0, 1.1 * right, 1.0] {
                let error = potential(&case, &contact, &[0.0], x) - contact.elastic_displacement(x);
                assert!(error.abs() < 1e-10 * size, "{mu} {e:e} {x}: {error:e} of {size}");
            }
        }
    }
}

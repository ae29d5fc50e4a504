//! Circular punches.

use std::f64::consts::PI;

use libm::tgamma;
use shtaerman::{Rotational, Solver, Vertical};

use crate::smooth_graded::support::{Case, EXPONENTS, close, piece, rings};

const PLACES: [f64; 5] = [0.0, 1e-9, 0.3, 0.75, 0.999];

/// `e = 4^beta/(theta Gamma(1-beta)^2)` with `beta = (1-mu)/2`: `2e c^(1+mu)/(1+mu)` is the stiffness of a flat disk.
fn modulus(case: &Case) -> f64 {
    let beta = 0.5 * (1.0 - case.mu);
    4f64.powf(beta) / (case.rings() * tgamma(1.0 - beta).powi(2))
}

#[test]
fn flat_disks_under_force_and_moment() {
    for mu in EXPONENTS {
        for a in [1.0f64, 0.03] {
            let case = Case { half_width: a, ..Case::disk(mu) };
            let (force, moment) = (2.0, 0.2 * a);
            let contact = case.solve("0", Vertical::Force(force), Rotational::Moment(moment));
            let (beta, e) = (0.5 * (1.0 - mu), modulus(&case));
            let stiffness = 2.0 * e * a.powf(1.0 + mu) / (1.0 + mu);
            close(contact.settlement(), force / stiffness, 1e-13, "settlement");
            let turning = 4.0 * e * a.powf(3.0 + mu) / ((1.0 + mu).powi(2) * (3.0 + mu));
            close(contact.tilt(), -moment / turning, 1e-13, "tilt");
            for y in PLACES {
                let weight = (1.0 - y * y).powf(-beta) / (2.0 * PI * a * a);
                for x in [y, -y] {
                    let exact = weight * (1.0 + mu) * (force + (3.0 + mu) * moment / a * x);
                    close(contact.pressure(x * a).unwrap(), exact, 1e-12, &format!("{mu} {x}"));
                }
            }
            let scale = (2.0 * PI).sqrt() * (0.5 * a).powf(beta) * (1.0 + mu) / (2.0 * PI * a * a);
            let [left, right] = contact.corner_intensity().unwrap()[0];
            close(left, scale * (force - (3.0 + mu) * moment / a), 1e-12, "left corner");
            close(right, scale * (force + (3.0 + mu) * moment / a), 1e-12, "right corner");
        }
    }
}

#[test]
fn paraboloids_and_cones() {
    for mu in EXPONENTS {
        for c in [0.5f64, 1e-4] {
            let case = Case::disk(mu);
            let (beta, e) = (0.5 * (1.0 - mu), modulus(&case));
            // f = r^2/(2R): g = c^2/(R (1+mu)), P = 4 e c^(3+mu)/(R (1+mu)^2 (3+mu))
            let force = 4.0 * e * c.powf(3.0 + mu) / (3.0 * (1.0 + mu).powi(2) * (3.0 + mu));
            let contact = case.press("x^2/(2*3)", force);
            close(contact.zones()[0][1], c, 1e-13, "radius");
            close(contact.settlement(), c * c / (3.0 * (1.0 + mu)), 1e-12, "settlement");
            let unit = 2.0 * e / (PI * 3.0 * (1.0 + mu).powi(2)) * c.powf(1.0 + mu);
            for y in PLACES {
                let exact = unit * (1.0 - y * y).powf(1.0 - beta);
                close(contact.pressure(y * c).unwrap(), exact, 1e-10, &format!("{mu} {y}"));
            }
            // f = r t: g = B c t, P = 2 e B t c^(2+mu)/((1+mu) (2+mu)), B = sqrt(pi) Gamma((1+mu)/2)/(2 Gamma(1+mu/2))
            let total = 0.5 * PI.sqrt() * tgamma(0.5 + 0.5 * mu) / tgamma(1.0 + 0.5 * mu);
            let force = 2.0 * e * total * 0.2 * c.powf(2.0 + mu) / ((1.0 + mu) * (2.0 + mu));
            let contact = case.press("0.2*abs(x)", force);
            close(contact.zones()[0][1], c, 1e-13, "radius of the cone");
            close(contact.settlement(), 0.2 * total * c, 1e-12, "settlement of the cone");
            for y in [0.1, 0.5, 0.9] {
                // int_y^1 (t^2 - y^2)^-beta dt
                let integral = piece(&|t, _| (t + y).powf(-beta), [y, 1.0], y, beta);
                let exact = e / PI * total * 0.2 * c.powf(mu) * integral;
                close(contact.pressure(y * c).unwrap(), exact, 1e-10, &format!("cone {mu} {y}"));
            }
            // At the apex int t^-2beta dt = 1/mu
            let exact = e / PI * total * 0.2 * c.powf(mu) / mu;
            close(contact.pressure(0.0).unwrap(), exact, 1e-10, "apex");
        }
    }
}

#[test]
fn pressures_displace_as_the_kernel_says() {
    for (mu, profile, kinks, force) in [
        (0.3, "x^2/2", &[][..], 0.05),
        (0.5, "x^4", &[], 0.05),
        (0.4, "0.3*max(abs(x) - 0.2, 0)", &[0.2], 0.05),
        (0.7, "x^2/2 + 0.2*abs(x)", &[], 0.1),
        (0.6, "0.1*x^2", &[], 4.0),
    ] {
        let case = Case::disk(mu);
        let contact = case.press(profile, force);
        let edge = contact.zones()[0][1];
        let size = contact.settlement();
        for y in [0.05, 0.3, 0.6, 0.97] {
            let x = y * edge;
            let error = rings(&case, &contact, kinks, x) - contact.base_depth(x);
            assert!(error.abs() < 1e-10 * size, "{mu} {profile} {x}: {error:e} of {size}");
        }
        for x in [1.01 * edge, 0.5 * (1.0 + edge), 1.0] {
            let found = contact.elastic_displacement(x);
            let error = rings(&case, &contact, kinks, x) - found;
            assert!(x <= edge || error.abs() < 1e-10 * size, "{profile} {x}: {error:e} {found}");
        }
        assert!(
            contact.relative_error() < 1e-10,
            "{profile} {:?}",
            contact.dimensionless().error()
        );
    }
}

#[test]
fn a_disk_in_bilateral_contact_keeps_its_corner() {
    let case = Case { solver: Solver::bilateral(), ..Case::disk(0.8) };
    let contact = case.press("x^2", 0.5);
    assert_eq!(contact.zones(), [[-1.0, 1.0]]);
    for x in [0.1, 0.5, 0.9] {
        let error = rings(&case, &contact, &[], x) - contact.base_depth(x);
        assert!(error.abs() < 1e-10, "{x}: {error:e}");
    }
}

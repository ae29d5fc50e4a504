//! Circular punches.

use std::f64::consts::PI;

use shtaerman::{Error, Geometry, Rotational, Solver, Vertical};

use crate::geometries::support::{
    assert_near, assert_stiffness, attempt, pressed, solve, solve_bilateral,
};

const DISK: Geometry = Geometry::Circular;

#[test]
fn the_flat_punch_agrees_with_another_method() {
    // p + int W p s ds = 1: p(0) by two Nystrom methods
    let load = (Vertical::Settlement(1.0), Rotational::Moment(0.0));
    let contact = solve((DISK, 1.0 / PI, 1.0), "0", load);
    assert_near(contact.dimensionless().pressure(0.0).unwrap(), 0.479_479_198_852_840, 1e-13);
    assert_eq!(contact.dimensionless().zones(), [[-1.0, 1.0]]);
}

#[test]
fn a_layer_alone_is_statics() {
    let contact = solve((DISK, 0.0, 1.0), "50*xi^2", pressed(0.5));
    // P = pi delta^2/(2 c)
    let settlement = (2.0 * 50.0 * 0.5 / PI).sqrt();
    assert_near(contact.dimensionless().settlement(), settlement, 1e-12);
    let [left, right] = contact.dimensionless().zones()[0];
    assert_near(right, (settlement / 50.0).sqrt(), 1e-13);
    assert!(left == -right);
    assert_near(contact.dimensionless().pressure(-0.1).unwrap(), settlement - 0.5, 1e-12);
    // A ring: P = 2 pi int (delta - c (r - 1/2)^2) r dr = (4 pi/3) (1/2) delta sqrt(delta/c)
    let ring = solve((DISK, 0.0, 1.0), "100*(abs(xi) - 0.5)^2", pressed(0.5));
    let settlement = (0.5 * 3.0 / (4.0 * PI) * 10.0f64).powf(2.0 / 3.0);
    assert_near(ring.dimensionless().settlement(), settlement, 1e-12);
    let half = (settlement / 100.0).sqrt();
    for (found, exact) in ring.dimensionless().zones().concat().iter().zip([
        -0.5 - half,
        -0.5 + half,
        0.5 - half,
        0.5 + half,
    ]) {
        assert_near(*found, exact, 1e-13);
    }
    assert!(ring.dimensionless().pressure(0.0).unwrap() == 0.0);
    assert_near(ring.dimensionless().gap(0.0).unwrap(), 25.0 - settlement, 1e-12);
}

#[test]
fn the_smooth_limit_is_boussinesqs() {
    // p = P/(2 pi sqrt(1 - r^2)), delta0 = pi theta0 P0/4, M0 = (8/(3 pi theta0)) alpha0
    for theta in [1e3, 1e5, 1e7] {
        let contact = solve((DISK, theta, 1.0), "0", pressed(1.0));
        assert_near(contact.dimensionless().settlement() / (0.25 * PI * theta), 1.0, 10.0 / theta);
        let exact = 1.0 / (2.0 * PI * (1.0f64 - 0.36).sqrt());
        assert_near(contact.dimensionless().pressure(0.6).unwrap() / exact, 1.0, 10.0 / theta);
        let turning = contact.dimensionless().stiffness().moment_tilt;
        assert_near(turning * theta, 8.0 / (3.0 * PI), 30.0 / theta);
        let tilted =
            solve((DISK, theta, 1.0), "0", (Vertical::Force(1.0), Rotational::Eccentricity(0.1)));
        assert_near(tilted.dimensionless().tilt() * turning, -0.1, 1e-12);
        // p = (P + 3 M x/a^2)/(2 pi a sqrt(a^2 - r^2))
        assert_near(
            tilted.dimensionless().pressure(0.6).unwrap() / exact,
            1.0 + 0.3 * 0.6,
            20.0 / theta,
        );
        assert_near(
            tilted.dimensionless().pressure(-0.6).unwrap() / exact,
            1.0 - 0.3 * 0.6,
            20.0 / theta,
        );
    }
}

#[test]
fn the_smooth_sphere_is_hertzs() {
    // f = c r^2, E* = 2/(pi theta): a^3 = 3 pi theta P/(16 c), p = (3 P/(2 pi a^2)) sqrt(1 - r^2/a^2), delta = 2 c a^2
    let mut before = [f64::INFINITY; 3];
    for theta in [1e2, 1e4, 1e6] {
        let profile = format!("{theta}*xi^2");
        let contact = solve((DISK, theta, 1.0), &profile, pressed(0.2));
        let radius = (3.0 * PI * 0.2 / 16.0f64).cbrt();
        let errors = [
            contact.dimensionless().zones()[0][1] / radius - 1.0,
            contact.dimensionless().pressure(0.0).unwrap() / (0.3 / (PI * radius * radius)) - 1.0,
            contact.dimensionless().settlement() / (2.0 * theta * radius * radius) - 1.0,
        ];
        // Of the order of chi, and ln chi times that at the edge.
        for (error, before) in errors.iter().zip(before) {
            assert!(error.abs() < 0.03 * before && error.abs() < 30.0 / theta, "{errors:?}");
        }
        before = errors.map(f64::abs);
    }
}

#[test]
fn a_moment_lifts_beyond_the_known_limit() {
    // P a/4 on the layer alone, P a/3 on the body alone
    for (theta, limit, tolerance) in [(0.0, 0.25, 1e-12), (1e7, 1.0 / 3.0, 1e-4)] {
        let with = |moment: f64| {
            let load = (Vertical::Force(1.0), Rotational::Moment(moment));
            attempt((DISK, theta, 1.0), "0", load, Solver::default())
        };
        let Err(Error::LiftsOff { limit: found, value, .. }) = with(0.4) else {
            panic!("{theta}");
        };
        assert!(value == 0.4);
        assert_near(found, limit, tolerance);
        assert!(with(found * (1.0 - 1e-6)).is_ok() && with(-found * (1.0 + 1e-6)).is_err());
    }
    // Where the base does not touch as a whole there is no such moment.
    let load = (Vertical::Force(0.1), Rotational::Tilt(1e-3));
    let refused = attempt((DISK, 1.0, 1.0), "50*xi^2", load, Solver::default());
    assert!(matches!(refused, Err(Error::LiftsOff { limit: 0.0, field: "tilt", .. })));
    // Full contact may pull.
    let load = (Vertical::Settlement(1.0), Rotational::Tilt(2.0));
    let contact = solve_bilateral((DISK, 0.0, 1.0), "0", load);
    assert_near(contact.dimensionless().pressure(0.8).unwrap(), 1.0 - 1.6, 1e-14);
    assert_near(contact.dimensionless().pressure(-0.8).unwrap(), 1.0 + 1.6, 1e-14);
    assert_near(contact.dimensionless().moment(), -2.0 * PI / 4.0, 1e-13);
}

#[test]
fn displacements_and_pressures_satisfy_the_equation() {
    let contact =
        solve((DISK, 3.0, 1.0), "0.2*xi^2", (Vertical::Force(1.0), Rotational::Moment(0.1)));
    for xi in [-0.9, -0.2, 0.3, 1.0] {
        let depth = contact.dimensionless().settlement()
            - contact.dimensionless().tilt() * xi
            - 0.2 * xi * xi;
        assert_near(
            contact.dimensionless().pressure(xi).unwrap()
                + contact.dimensionless().elastic_displacement(xi),
            depth,
            1e-13,
        );
    }
    // Far away a force and a couple: theta0 (pi/2) [P/(pi r) + M x/(2 pi ...)], the even part alone of order 1/r.
    let r = 200.0;
    let even = 0.5
        * (contact.dimensionless().elastic_displacement(r)
            + contact.dimensionless().elastic_displacement(-r));
    assert_near(even * r / (3.0 * 0.5), 1.0, 1e-4);
    let odd = 0.5
        * (contact.dimensionless().elastic_displacement(r)
            - contact.dimensionless().elastic_displacement(-r));
    assert_near(odd * r * r / (3.0 * 0.5 * 0.1), 1.0, 1e-4);
}

#[test]
fn several_rings_answer_their_stiffness() {
    let body = (DISK, 3.0, 1.0);
    let profile = "10*(1 - cos(12*xi))";
    let contact = solve(body, profile, pressed(1.5));
    assert!(contact.dimensionless().zones().len() == 5, "{:?}", contact.dimensionless().zones());
    assert!(contact.complementarity().unwrap().tension < 1e-10);
    assert!(contact.complementarity().unwrap().penetration < 1e-10);
    assert_stiffness(body, profile, &contact, 1e-5);
    let settlement =
        (Vertical::Settlement(contact.dimensionless().settlement()), Rotational::Tilt(0.0));
    assert_near(solve(body, profile, settlement).dimensionless().force(), 1.5, 1e-11);
}

#[test]
fn bases_that_are_no_bodies_of_revolution_are_refused() {
    for profile in ["xi", "xi^2 + 0.01*xi^3", "abs(xi - 0.1)"] {
        let error =
            attempt((DISK, 1.0, 1.0), profile, pressed(1.0), Solver::default()).unwrap_err();
        assert!(error.to_string().contains("even in x"), "{error}");
    }
}

#[test]
fn one_half_may_not_hide_what_the_other_lacks() {
    let profile = "xi^2 + 1e-2*exp(-((xi - 0.37003)/1e-6)^2)";
    for theta0 in [1.0, 30.0] {
        let refused = attempt((DISK, theta0, 1.0), profile, pressed(1.0), Solver::default());
        assert!(refused.unwrap_err().to_string().contains("even in x"));
    }
    let codes = |profile: &str| {
        let contact = solve((DISK, 1.0, 1.0), profile, pressed(1.0));
        contact.warnings().iter().map(|warning| warning.code).collect::<Vec<_>>()
    };
    assert_eq!(codes("0.1*((xi - 1)^2 + (xi + 1)^2)"), []);
    assert_eq!(codes("where(xi < 0, -xi, xi)^1.5"), []);
    // Even, though its form does not show it; and not even, by less than is found.
    for profile in ["xi*(xi + 1) - xi", "xi^2 + 1e-5*exp(-((xi - 0.37003)/1e-8)^2)"] {
        assert_eq!(codes(profile), [shtaerman::WarningCode::EvennessNotProved], "{profile}");
    }
}

/// `W(r, s) = 1/agm(r + s, |r - s|)`.
fn kernel(r: f64, s: f64, between: f64) -> f64 {
    let (mut one, mut two) = (r + s, between);
    for _ in 0..40 {
        (one, two) = (0.5 * (one + two), (one * two).sqrt());
    }
    1.0 / one
}

/// `int f ds` with singular ends, of the distances from both ends, by the double-exponential rule.
fn integral([left, right]: [f64; 2], f: impl Fn(f64, f64, f64) -> f64) -> f64 {
    let step = 1.0 / 16.0;
    (-56..=56)
        .map(|i| {
            let t = step * f64::from(i);
            let s = 0.5 * PI * t.sinh();
            let share = |s: f64| s.exp() / (2.0 * s.cosh()) * (right - left);
            let (from, to) = (share(s), share(-s));
            let at = if from < to { left + from } else { right - to };
            let weight = 0.25 * PI * t.cosh() / s.cosh().powi(2) * (right - left) * step;
            weight * f(at, from, to)
        })
        .sum()
}

#[test]
fn many_rings_carry_what_they_displace() {
    // The equation itself, by another quadrature and another kernel.
    let (theta, force) = (50.0, 1.0);
    let profile = "20*cos(24*pi*xi) + 8*xi^2";
    let contact = solve((DISK, theta, 1.0), profile, pressed(force));
    let rings: Vec<[f64; 2]> =
        contact.dimensionless().zones().into_iter().filter(|zone| zone[0] > 0.0).collect();
    assert!(rings.len() >= 8, "{rings:?}");
    let displacement = |r: f64| -> f64 {
        let of = |[left, right]: [f64; 2]| {
            let pressed = |s: f64, between: f64| {
                contact.dimensionless().pressure(s).unwrap() * s * kernel(r, s, between)
            };
            if left < r && r < right {
                integral([left, r], |s, _, to| pressed(s, to))
                    + integral([r, right], |s, from, _| pressed(s, from))
            } else {
                integral([left, right], |s, _, _| pressed(s, (r - s).abs()))
            }
        };
        PI * theta * rings.iter().map(|ring| of(*ring)).sum::<f64>()
    };
    let height = |r: f64| 20.0 * (24.0 * PI * r).cos() + 8.0 * r * r;
    let carried = |ring: &[f64; 2]| {
        integral(*ring, |s, _, _| 2.0 * PI * s * contact.dimensionless().pressure(s).unwrap())
    };
    assert_near(rings.iter().map(carried).sum::<f64>(), force, 1e-11);
    for [left, right] in &rings {
        for share in [0.1, 0.5, 0.8] {
            let r = left + share * (right - left);
            let gap = contact.dimensionless().pressure(r).unwrap() + displacement(r)
                - contact.dimensionless().settlement()
                + height(r);
            assert_near(gap, 0.0, 1e-9 * contact.dimensionless().settlement());
        }
        for beside in [left - 1e-3, right + 1e-3] {
            if beside < 1.0 {
                assert!(
                    displacement(beside) - contact.dimensionless().settlement() + height(beside)
                        > 0.0
                );
            }
        }
    }
}

#[test]
fn hundreds_of_rings() {
    for crests in [120, 240] {
        let profile = format!("cos(2*pi*{crests}*xi)");
        let contact = solve((DISK, 5.0, 1.0), &profile, pressed(0.1));
        let bare = contact.dimensionless();
        // Of each crest a ring, on both sides of the axis.
        assert_eq!(bare.zones().len(), 2 * crests);
        assert!(contact.relative_error() < 1e-10, "{crests}: {:e}", contact.relative_error());
        let force: f64 = bare.zones()[crests..].iter().map(|ends| ring_force(&bare, *ends)).sum();
        assert!((force - 0.1).abs() < 1e-9, "{crests}: {force}");
    }
}

/// `2 pi int p r dr` over a ring, by the double exponential rule.
fn ring_force(contact: &shtaerman::Contact, [left, right]: [f64; 2]) -> f64 {
    let half = 0.5 * (right - left);
    let rule = fredholm::quadrature::double_exponential(20);
    rule.map(|node| {
        let r = left + half * node.from_left;
        2.0 * PI * half * node.weight * r * contact.pressure(r).unwrap()
    })
    .sum()
}

/// Under the axis a root of the distance is steeper than any number beside it shows: the pressure there is the limit, and the largest.
#[test]
fn roots_of_the_distance_have_their_peak_on_the_axis() {
    for exponent in [0.1, 0.6, 0.9] {
        let toml = format!(
            "[foundation]\npoisson_ratio = 0.3\nyoung_modulus = 1e9\nroughness = 1e-9\n[punch]\ngeometry = \"circular\"\nradius = 1.0\nprofile = \"1e-5*abs(xi)^{exponent}\"\n[load]\nforce = 1e4\nmoment = 0\n"
        );
        let contact = shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap();
        let stated = contact.error().unwrap().pressure;
        let [axis, beside] = [0.0, 1e-300].map(|r| contact.pressure(r).unwrap());
        assert!((axis - beside).abs() <= stated, "{exponent}: {axis:e} {beside:e} {stated:e}");
        assert!(
            (contact.peak_pressure() - axis).abs() <= stated && contact.peak_pressure_at() == 0.0
        );
    }
}

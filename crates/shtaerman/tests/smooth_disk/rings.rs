//! Annuli, and disks with rings about them.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::support::{A, MODULUS, pressed, solve, sunk};
use shtaerman::Contact;

/// `int_l^r f(s, s - l, r - s) ds` with singular ends, by the double-exponential rule.
fn integral(left: f64, right: f64, f: impl Fn(f64, f64, f64) -> f64) -> f64 {
    let step = 1.0 / 32.0;
    (-128..=128)
        .map(|i| {
            let t = step * f64::from(i);
            let s = FRAC_PI_2 * t.sinh();
            let share = |s: f64| s.exp() / (2.0 * s.cosh());
            let [from, to] = [share(s), share(-s)].map(|share| share * (right - left));
            let at = if from < to { left + from } else { right - to };
            let weight = 0.5 * FRAC_PI_2 * t.cosh() / s.cosh().powi(2) * (right - left) * step;
            if weight < 1e-300 { 0.0 } else { weight * f(at, from, to) }
        })
        .sum()
}

/// `K(2 sqrt(r s)/(r + s))/(r + s)` by the arithmetic-geometric mean.
fn kernel(r: f64, s: f64, between: f64) -> f64 {
    let (mut one, mut two) = (r + s, between);
    for _ in 0..40 {
        (one, two) = (0.5 * (one + two), (one * two).sqrt());
    }
    FRAC_PI_2 / one
}

/// Zones on one side of the axis, those of a disk from it.
fn zones(contact: &Contact) -> Vec<[f64; 2]> {
    let edges = contact.edges().into_iter();
    edges.filter(|zone| zone[1] > 0.0).map(|zone| zone.map(|x| x.max(0.0))).collect()
}

/// The displacement that the pressure makes: `u(r) = (4/(pi E*)) int p s K ds/(r + s)`, and the force that it has.
fn displacement(contact: &Contact, r: f64) -> f64 {
    let p = |s: f64| contact.pressure(s).unwrap();
    let of = |[left, right]: [f64; 2]| {
        if r <= left || right <= r {
            let between = |from: f64, to: f64| if r <= left { left - r + from } else { r - right + to };
            return integral(left, right, |s, from, to| p(s) * s * kernel(r, s, between(from, to)));
        }
        integral(left, r, |s, _, to| p(s) * s * kernel(r, s, to))
            + integral(r, right, |s, from, _| p(s) * s * kernel(r, s, from))
    };
    4.0 / (PI * MODULUS) * zones(contact).into_iter().map(of).sum::<f64>()
}

fn force(contact: &Contact) -> f64 {
    let of = |[left, right]: [f64; 2]| {
        integral(left, right, |s, _, _| 2.0 * PI * s * contact.pressure(s).unwrap())
    };
    zones(contact).into_iter().map(of).sum()
}

/// Bases with the numbers of their zones along a diameter.
const BASES: [(&str, f64, usize); 6] = [
    ("-x^2", 1e3, 2),
    ("0.1*(abs(x) - 0.003)^2", 10.0, 2),
    ("1e-6*(1 - cos(5000*x))", 200.0, 9),
    ("1e-6*cos(5000*x)", 100.0, 8),
    ("1e-6*cos(2000*x) + 0.2*x^2", 100.0, 2),
    ("1e-6*(1 - cos(2500*x)) + 1e2*x^4", 500.0, 3),
];

#[test]
fn pressures_make_the_surface_follow_the_base() {
    for (profile, load, count) in BASES {
        let contact = solve(profile, pressed(load));
        eprintln!("{profile}: {:?} {:?} {:e}", contact.edges0(), contact.complementarity(), contact.relative_error());
        assert_eq!(contact.edges0().len(), count, "{profile}: {:?}", contact.edges0());
        let height = |x: f64| contact.problem().profile().height(x / A, A);
        for [left, right] in zones(&contact) {
            for share in [0.02, 0.3, 0.77, 0.98] {
                let r = left + share * (right - left);
                let found = displacement(&contact, r);
                let exact = contact.settlement() - height(r);
                let size = contact.settlement().abs() + height(r).abs();
                eprintln!("   {r:e} {:e}", (found - exact) / size);
                assert!((found - exact).abs() < 1e-10 * size, "{profile} {r}: {found:e} {exact:e}");
            }
        }
        for r in [1e-4 * A, 0.45 * A, 0.9999 * A, 1.01 * A, 30.0 * A] {
            let error = displacement(&contact, r) / contact.elastic_displacement(r) - 1.0;
            eprintln!("   {r:e} {error:e}");
        }
        let error = force(&contact) / load - 1.0;
        assert!(error.abs() < 1e-10, "{profile}: {error:e}");
        let left = contact.complementarity().unwrap();
        assert!(left.tension < 1e-9 && left.penetration < 1e-9, "{profile}: {left:?}");
    }
}

#[test]
fn flat_annuli() {
    for b in [0.01, 0.1, 0.5, 0.9] {
        let profile = format!("where(abs(x) < {}, 1e-3, 0)", b * A);
        let contact = solve(&profile, sunk(1e-6));
        eprintln!("{b} {:e} {:?} {:e}", contact.force() / (2.0 * MODULUS * A * 1e-6), contact.stiffness(), contact.relative_error());
    }
}

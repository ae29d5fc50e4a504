//! Annuli, and disks with rings about them.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use crate::support::{A, MODULUS, close, honest, pressed, problem, solve, sunk};
use shtaerman::{Contact, Load, Profile, Rotational, SmoothDisk, Solver, Vertical};

/// Distance from a corner, as share of the zone, below which the pressure is its singularity.
const SINGULAR: f64 = 1e-7;

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

/// A zone on one side of the axis, that of a disk from it, with its corner intensities.
struct Side {
    ends: [f64; 2],
    intensity: [f64; 2],
}

fn sides(contact: &Contact) -> Vec<Side> {
    let edges = contact.edges().into_iter().zip(contact.corner_intensity().unwrap());
    edges
        .filter(|(zone, _)| zone[1] > 0.0)
        .map(|(zone, intensity)| Side {
            ends: zone.map(|x| x.max(0.0)),
            intensity: [if zone[0] > 0.0 { intensity[0] } else { 0.0 }, intensity[1]],
        })
        .collect()
}

impl Side {
    /// The pressure at a place by its distances from the ends.
    fn pressure(&self, contact: &Contact, s: f64, from: f64, to: f64) -> f64 {
        let near = SINGULAR * (self.ends[1] - self.ends[0]);
        let [inner, outer] = self.intensity;
        if inner != 0.0 && from < near {
            return inner / (2.0 * PI * from).sqrt();
        }
        if outer != 0.0 && to < near {
            return outer / (2.0 * PI * to).sqrt();
        }
        contact.pressure(s).unwrap()
    }

    /// `int p(s) f(s, |r - s|) ds`.
    fn integral(&self, contact: &Contact, r: f64, f: impl Fn(f64, f64) -> f64) -> f64 {
        let [left, right] = self.ends;
        let p = |s: f64, from: f64, to: f64| self.pressure(contact, s, from, to);
        if r <= left || right <= r {
            let beside =
                |from: f64, to: f64| if r <= left { left - r + from } else { r - right + to };
            return integral(left, right, |s, from, to| p(s, from, to) * f(s, beside(from, to)));
        }
        integral(left, r, |s, from, to| p(s, from, right - s) * f(s, to))
            + integral(r, right, |s, from, to| p(s, s - left, to) * f(s, from))
    }
}

/// The displacement that the pressure makes: `u(r) = (4/(pi E*)) int p s K ds/(r + s)`.
fn displacement(contact: &Contact, r: f64) -> f64 {
    let of = |side: Side| side.integral(contact, r, |s, between| s * kernel(r, s, between));
    4.0 / (PI * MODULUS) * sides(contact).into_iter().map(of).sum::<f64>()
}

/// `2 pi int p r dr`.
fn force(contact: &Contact) -> f64 {
    sides(contact).into_iter().map(|s| 2.0 * PI * s.integral(contact, 2.0 * A, |r, _| r)).sum()
}

fn height(contact: &Contact, x: f64) -> f64 {
    contact.problem().profile().height(x / A, A)
}

/// Bases with forces, and the numbers of their zones along a diameter.
const BASES: [(&str, f64, usize); 9] = [
    ("-x^2", 3e4, 2),
    ("0.1*(abs(x) - 0.003)^2", 10.0, 2),
    ("1e-6*(1 - cos(5000*x))", 200.0, 9),
    ("1e-6*cos(5000*x)", 100.0, 8),
    ("1e-6*cos(2000*x) + 0.2*x^2", 100.0, 2),
    ("1e-6*(1 - cos(2500*x)) + 1e2*x^4", 500.0, 3),
    ("where(abs(x) < 0.002, 1e-4, 0)", 1e3, 2),
    ("where(abs(x) < 0.003, 0, 1e-7)", 1e4, 3),
    ("where(abs(x) < 0.002, 5e-7, where(abs(x) < 0.003, 1e-4, 0))", 1e4, 3),
];

#[test]
fn pressures_make_the_surface_follow_the_base() {
    for (profile, load, count) in BASES {
        let contact = solve(profile, pressed(load));
        eprintln!(
            "{profile}: {:?} {:?} {:e} {:?}",
            contact.edges0(),
            contact.complementarity(),
            contact.relative_error(),
            contact.method()
        );
        if contact.edges0().len() != count {
            eprintln!("COUNT");
        }
        for side in sides(&contact) {
            let [left, right] = side.ends;
            for share in [0.02, 0.3, 0.77, 0.98] {
                let r = left + share * (right - left);
                let error =
                    displacement(&contact, r) - (contact.settlement() - height(&contact, r));
                let size = contact.settlement().abs() + height(&contact, r).abs();
                eprintln!("   {r:e} {:e}", error / size);
            }
        }
        for r in [1e-4 * A, 0.45 * A, 0.9999 * A, 1.01 * A, 30.0 * A] {
            let error = displacement(&contact, r) / contact.elastic_displacement(r) - 1.0;
            eprintln!("   beside {r:e} {error:e}");
        }
        eprintln!("  force {:e}", force(&contact) / load - 1.0);
    }
}

#[test]
fn flat_annuli() {
    for b in [0.01, 0.1, 0.5, 0.9] {
        let profile = format!("where(abs(x) < {}, 1e-3, 0)", b * A);
        let contact = solve(&profile, sunk(1e-6));
        eprintln!(
            "{b} {:e} {:e} {:e}",
            contact.force() / (2.0 * MODULUS * A * 1e-6),
            contact.stiffness().moment_tilt / (MODULUS * A.powi(3)),
            contact.relative_error()
        );
    }
}

#[test]
fn thin_layers_tend_to_it() {
    for (profile, load, _) in &BASES[1..6] {
        let smooth = solve(profile, pressed(*load));
        let [left, right] = smooth.edges0()[smooth.edges0().len() - 1];
        let x = A * (0.4 * left + 0.6 * right);
        for theta0 in [1e2, 1e3, 1e4] {
            let chi = 2.0 * A / (PI * MODULUS * theta0);
            let base = Profile::expression(profile).unwrap();
            let rough = problem(base, chi, pressed(*load), Solver::default()).solve().unwrap();
            let [.., zone] = rough.edges0()[..] else { panic!() };
            eprintln!(
                "{profile} {theta0} {:?}",
                [
                    rough.settlement() / smooth.settlement() - 1.0,
                    zone[0] / left - 1.0,
                    zone[1] / right - 1.0,
                    rough.pressure(x).unwrap() / smooth.pressure(x).unwrap() - 1.0,
                    rough.stiffness().force_settlement / smooth.stiffness().force_settlement - 1.0,
                    rough.stiffness().moment_tilt / smooth.stiffness().moment_tilt - 1.0,
                ]
            );
        }
    }
}

#[test]
fn a_narrow_ring_is_a_line_of_hertz() {
    for load in [1e-6, 1e-4, 1e-2] {
        let contact = solve("0.1*(abs(x) - 0.003)^2", pressed(load));
        let line = load / (2.0 * PI * 3e-3);
        let half = (4.0 * line * 5.0 / (PI * MODULUS)).sqrt();
        let [_, [inner, outer]] = contact.edges()[..] else { panic!() };
        eprintln!(
            "{half:e} {:e} {:e} {:e}",
            (outer - inner) / (2.0 * half) - 1.0,
            contact.peak_pressure().0 / (2.0 * line / (PI * half)) - 1.0,
            contact.relative_error()
        );
    }
}

#[test]
fn one_disk_is_that_of_galins_transforms() {
    for (load, breaks) in [(0.3, vec![]), (3.0, vec![]), (0.5, vec![0.4])] {
        let bend = if breaks.is_empty() { 0.0 } else { 0.2 };
        let disk = SmoothDisk {
            theta0: 1.0,
            load: Load::new(Vertical::Force(load), Rotational::Moment(0.0)).unwrap(),
            height: Arc::new(move |r: f64| r * r + bend * (r - 0.4).max(0.0)),
            slope: Arc::new(move |r: f64| 2.0 * r + if r > 0.4 { bend } else { 0.0 }),
            breaks,
            tolerance: 0.0,
            is_unilateral: true,
        };
        let (one, two) = (disk.solve().unwrap(), disk.solve_rings().unwrap());
        eprintln!(
            "{} {} {:e}",
            one.radius(),
            two.zones()[0].ends[1],
            one.settlement0() - two.settlement0()
        );
        for xi in [0.0, 0.1, -0.3, 0.399, 0.9 * one.radius()] {
            eprintln!("   {:e}", one.pressure0(xi) - two.pressure0(xi));
        }
    }
}

#[test]
fn stiffness_is_the_slope_of_the_force() {
    for (profile, load, _) in BASES {
        let contact = solve(profile, pressed(load));
        let step = 1e-5 * contact.stiffness().force_settlement.recip() * load;
        let force = |by: f64| solve(profile, sunk(contact.settlement() + by)).force();
        let slope = (force(step) - force(-step)) / (2.0 * step);
        eprintln!(
            "{profile} {:e} {:e}",
            contact.stiffness().force_settlement / slope - 1.0,
            force(0.0) / load - 1.0
        );
    }
}

#[test]
fn kinks_and_measured_bases() {
    for (profile, load) in [
        ("1e-3*abs(abs(x) - 0.003)", 50.0),
        ("2e-3*max(abs(abs(x) - 0.003) - 0.0004, 0)", 2e2),
        ("-1e-3*abs(x)", 1e3),
        ("1e-4*abs(sin(2000*x))", 1e3),
    ] {
        let contact = solve(profile, pressed(load));
        eprintln!(
            "{profile} {:?} {:?} {:e}",
            contact.edges0(),
            contact.complementarity(),
            contact.relative_error()
        );
        for side in sides(&contact) {
            let [left, right] = side.ends;
            for share in [0.02, 0.3, 0.77, 0.98] {
                let r = left + share * (right - left);
                let error =
                    displacement(&contact, r) - (contact.settlement() - height(&contact, r));
                let size = contact.settlement().abs() + height(&contact, r).abs();
                eprintln!("   {r:e} {:e}", error / size);
            }
        }
    }
    let _ = (close, honest);
}

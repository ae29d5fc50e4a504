//! Boussinesq, Hertz, Love's cone, powers, and full contact.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::smooth_disk::support::{
    A, MODULUS, close, honest, pressed, solve, solve_bilateral, sunk,
};
use shtaerman::{Contact, Vertical};

/// The errors stated for pressure, settlement or force, and edge, in SI units.
fn stated(contact: &Contact) -> [f64; 4] {
    let accuracy = contact.dimensionless().error().unwrap();
    let scaling = contact.problem().scaling().unwrap();
    [
        accuracy.pressure * scaling.pressure(),
        accuracy.settlement * scaling.displacement(),
        accuracy.force * scaling.force(),
        contact.dimensionless().error().and_then(|error| error.zones).unwrap_or(0.0) * A,
    ]
}

#[test]
fn boussinesqs_flat_punch() {
    // F = 2 a E* delta, p = F/(2 pi a sqrt(a^2 - r^2)), u = (2 delta/pi) asin(a/r) outside
    let force = 3e4;
    let delta = force / (2.0 * A * MODULUS);
    for contact in
        [solve("0", pressed(force)), solve("0", sunk(delta)), solve_bilateral("0", pressed(force))]
    {
        close(contact.settlement(), delta, 1e-14, "settlement");
        close(contact.force(), force, 1e-14, "force");
        assert_eq!(contact.zones(), [[-A, A]]);
        assert_eq!(contact.pressure_right(), f64::INFINITY);
        for r in [0.0f64, -1e-3, 3e-3, 4.999e-3] {
            let exact = force / (2.0 * PI * A * (A * A - r * r).sqrt());
            close(contact.pressure(r).unwrap(), exact, 1e-12, "pressure");
        }
        for r in [5.000001e-3, 6e-3, -0.05, 3.0f64] {
            let exact = 2.0 * delta / PI * (A / r.abs()).asin();
            close(contact.elastic_displacement(r), exact, 1e-12, "displacement");
        }
        close(contact.stiffness().force_settlement, 2.0 * MODULUS * A, 1e-14, "stiffness");
        close(contact.stiffness().moment_tilt, 4.0 / 3.0 * MODULUS * A.powi(3), 1e-14, "turning");
        close(contact.mean_pressure(), force / (PI * A * A), 1e-14, "mean");
    }
}

#[test]
fn hertzs_sphere() {
    // a^3 = 3 F R/(4 E*), p0 = 3 F/(2 pi a^2), delta = a^2/R;
    // outside u = [(2 a^2 - r^2) asin(a/r) + a sqrt(r^2 - a^2)]/(pi R)
    for (radius, force) in [(0.5, 1e3), (20.0, 7.0), (1e-1, 1e-6)] {
        let c = (3.0 * force * radius / (4.0 * MODULUS)).cbrt();
        let delta = c * c / radius;
        let peak = 3.0 * force / (2.0 * PI * c * c);
        let profile = format!("x^2/(2*{radius})");
        for (contact, by_force) in
            [(solve(&profile, pressed(force)), true), (solve(&profile, sunk(delta)), false)]
        {
            let [pressure, settlement, load, edge] = stated(&contact);
            let found = contact.zones()[0][1];
            close(found, c, 1e-13, "radius");
            honest(edge, found - c, c, 1e-12, "radius");
            close(contact.force(), force, 1e-12, "force");
            close(contact.settlement(), delta, 1e-12, "settlement");
            if by_force {
                honest(settlement, contact.settlement() - delta, delta, 1e-12, "settlement");
            } else {
                honest(load, contact.force() - force, force, 1e-12, "force");
            }
            for y in [0.0f64, 1e-9, 0.3, -0.7, 0.99, 0.99999] {
                let exact = peak * (1.0 - y * y).sqrt();
                let p = contact.pressure(c * y).unwrap();
                close(p, exact, 1e-10, &format!("pressure at {y}"));
                // Nearer to the edge the error grows.
                let error = (p - exact) * (1.0 - y * y).sqrt();
                honest(pressure, error, peak, 1e-11, "pressure");
            }
            close(contact.peak_pressure(), peak, 1e-12, "peak");
            for r in [1.0001 * c, 1.5 * c, 20.0 * c] {
                let exact = ((2.0 * c * c - r * r) * (c / r).asin() + c * (r * r - c * c).sqrt())
                    / (PI * radius);
                assert!((contact.elastic_displacement(r) - exact).abs() < 1e-12 * delta, "{r}");
            }
            close(contact.stiffness().force_settlement, 2.0 * MODULUS * c, 1e-12, "stiffness");
            assert!(contact.relative_error() < 1e-11, "{}", contact.relative_error());
        }
    }
}

#[test]
fn loves_cone() {
    // f = t r: F = (2/pi) E* delta^2/t, p = (E* t/2) arccosh(c/r), c = 2 delta/(pi t)
    for (slope, delta) in [(2e-3, 4e-6), (0.5, 1e-9), (1e-3, 1e-60)] {
        let contact = solve(&format!("{slope}*abs(x)"), sunk(delta));
        let c = 2.0 * delta / (PI * slope);
        close(contact.zones()[0][1], c, 1e-13, "radius");
        close(contact.force(), 2.0 / PI * MODULUS * delta * delta / slope, 1e-12, "force");
        for y in [1e-6f64, 0.01, 0.4, -0.9, 0.9999] {
            let exact = 0.5 * MODULUS * slope * (1.0 / y.abs()).acosh();
            close(contact.pressure(c * y).unwrap(), exact, 1e-10, &format!("pressure at {y}"));
        }
        assert_eq!(contact.pressure_middle(), f64::INFINITY);
    }
}

/// `k sqrt(pi) Gamma(k/2)/(2 Gamma((k+1)/2)) / 1`: `delta = factor c^k` for `f = r^k`.
fn factor(k: f64) -> f64 {
    let gamma = |x: f64| {
        // Stirling's series after shifting the argument by ten.
        let shift: f64 = (0..10).map(|i| (x + f64::from(i)).ln()).sum();
        let z = x + 10.0;
        let series = 1.0 / (12.0 * z) - 1.0 / (360.0 * z.powi(3)) + 1.0 / (1260.0 * z.powi(5))
            - 1.0 / (1680.0 * z.powi(7));
        ((z - 0.5) * z.ln() - z + 0.5 * (2.0 * PI).ln() + series - shift).exp()
    };
    0.5 * k * PI.sqrt() * gamma(0.5 * k) / gamma(0.5 * k + 0.5)
}

#[test]
fn powers_of_the_distance() {
    // f = b r^k: delta = b factor c^k, F = 2 E* k/(k + 1) delta c
    for k in [1.5, 2.0, 3.0, 4.0, 8.0] {
        let c = 0.6 * A;
        let b = 3e-6 / A.powf(k);
        let delta = b * factor(k) * c.powf(k);
        let force = 2.0 * MODULUS * k / (k + 1.0) * delta * c;
        let contact = solve(&format!("{b:e}*abs(x)^{k}"), pressed(force));
        close(contact.zones()[0][1], c, 1e-12, &format!("radius of {k}"));
        close(contact.settlement(), delta, 1e-11, &format!("settlement of {k}"));
        if k == 4.0 {
            // G' = (32/3) b x^3: p = (E*/pi)(32/3) b w (c^2 - (2/3) w^2), w^2 = c^2 - r^2
            for y in [0.0f64, 0.5, 0.99] {
                let w = c * (1.0 - y * y).sqrt();
                let exact = MODULUS / PI * 32.0 / 3.0 * b * w * (c * c - 2.0 / 3.0 * w * w);
                close(contact.pressure(c * y).unwrap(), exact, 1e-11, "pressure");
            }
        }
    }
}

/// `k` and [`factor`] of it (mpmath, 30 digits).
const POWERS: [(f64, f64); 9] = [
    (0.05, 1.034_238_511_318_322_2),
    (0.2, 1.132_308_697_521_575_4),
    (0.5, 1.311_028_777_146_06),
    (0.8, 1.471_637_592_162_352_3),
    (1.2, 1.664_701_151_090_433_4),
    (1.5, 1.797_210_352_103_388_3),
    (2.0, 2.0),
    (2.7, 2.255_005_588_094_481_4),
    (4.0, 8.0 / 3.0),
];

#[test]
fn blunt_and_sharp_powers_are_as_good_as_stated() {
    // As above; p(0) = (E*/pi) k delta/((k - 1) c) for k > 1, infinite below.
    for i in 0..2 {
        let [share, other] =
            [0.618_033_988_7, 0.754_877_666_2].map(|step| (step * f64::from(i + 1)).fract());
        for (k, factor) in POWERS {
            let c = A * (0.05 + 0.9 * share);
            let b = 10f64.powf(-7.0 + 2.0 * other) / A.powf(k);
            let delta = b * factor * c.powf(k);
            let force = 2.0 * MODULUS * k / (k + 1.0) * delta * c;
            let contact = solve(&format!("{b:e}*abs(x)^{k}"), pressed(force));
            let [pressure, settlement, _, edge] = stated(&contact);
            let middle = contact.pressure_middle();
            let exact = MODULUS / PI * k * delta / ((k - 1.0) * c);
            honest(settlement, contact.settlement() - delta, delta, 1e-11, &format!("{k}"));
            honest(edge, contact.zones()[0][1] - c, c, 1e-9, &format!("edge of {k}"));
            if k > 1.0 {
                honest(pressure, middle - exact, exact, 1e-10, &format!("middle of {k}"));
            } else {
                assert_eq!(middle, f64::INFINITY);
            }
        }
    }
}

#[test]
fn a_parabola_pressed_to_its_corner() {
    // d(x) = delta - x^2/R: F = 2 E* (delta a - a^3/(3R)), p = (E*/pi)[(delta - a^2/R)/w + 2 w/R]
    let radius = 2.0;
    let delta = 3.0 * A * A / radius;
    let force = 2.0 * MODULUS * (delta * A - A.powi(3) / (3.0 * radius));
    for contact in [solve("x^2/4", pressed(force)), solve("x^2/4", sunk(delta))] {
        close(contact.settlement(), delta, 1e-13, "settlement");
        close(contact.force(), force, 1e-13, "force");
        assert_eq!(contact.zones(), [[-A, A]]);
        for r in [0.0f64, 2e-3, -4.9e-3] {
            let w = (A * A - r * r).sqrt();
            let exact = MODULUS / PI * ((delta - A * A / radius) / w + 2.0 * w / radius);
            close(contact.pressure(r).unwrap(), exact, 1e-12, "pressure");
        }
        assert_eq!(contact.pressure_left(), f64::INFINITY);
    }
    // Held in contact by less than it needs, the edge pulls.
    let contact = solve_bilateral("x^2/4", pressed(1e-3 * force));
    assert_eq!(contact.pressure_left(), f64::NEG_INFINITY);
    assert!(!contact.tension().is_empty());
}

#[test]
fn a_rounded_edge() {
    // f = max(r - b, 0) t: G = t x acos(b/x), F = E* t c^2 (acos(b/c) + (b/c) sqrt(1 - b^2/c^2))
    let (b, slope, c) = (2e-3, 1e-3, 3.1e-3f64);
    let z = b / c;
    let force = MODULUS * slope * c * c * (z.acos() + z * (1.0 - z * z).sqrt());
    let contact = solve(&format!("{slope}*max(abs(x) - {b}, 0)"), pressed(force));
    close(contact.zones()[0][1], c, 1e-12, "radius");
    close(contact.settlement(), slope * c * z.acos(), 1e-12, "settlement");
    // p(0) = (E*/pi) int G'/x dx, G' = acos(b/x) + b/sqrt(x^2 - b^2)
    let sum = |f: &dyn Fn(f64) -> f64, to: f64| {
        let count = 20_000;
        (0..count).map(|i| f(to * (f64::from(i) + 0.5) / f64::from(count))).sum::<f64>() * to
            / f64::from(count)
    };
    // x = b/cos t: G' dx/x = (t + cot t) tan t dt
    let exact = MODULUS * slope / PI * sum(&|t| t * t.tan() + 1.0, z.acos());
    close(contact.pressure(0.0).unwrap(), exact, 1e-8, "middle");
    // At the kink the pressure is infinite, beside it large.
    assert!(contact.pressure(b * (1.0 + 1e-9)).unwrap() > 5.0 * contact.pressure(0.0).unwrap());
}

#[test]
fn a_stepped_punch_stands_on_its_step() {
    let contact = solve("where(abs(x) < 0.003, 0, 0.001)", pressed(1e4));
    let [left, right] = contact.zones()[0];
    close(right, 3e-3, 1e-12, "radius");
    assert!(left == -right);
    close(contact.settlement(), 1e4 / (2.0 * 3e-3 * MODULUS), 1e-12, "settlement");
    close(contact.pressure(1e-3).unwrap(), 1e4 / (2.0 * PI * 3e-3 * 8e-6f64.sqrt()), 1e-11, "p");
    assert!(contact.gap(4e-3).unwrap() > 0.9e-3);
}

#[test]
fn a_measured_sphere() {
    let places: Vec<f64> = (0..=400).map(|i| A * (f64::from(i) / 200.0 - 1.0)).collect();
    let heights = places.iter().map(|x| x * x).collect();
    let profile = shtaerman::Profile::from_points(places, heights).unwrap();
    let load = pressed(1e3);
    let contact =
        crate::smooth_disk::support::problem(profile, 0.0, load, shtaerman::Solver::default())
            .solve()
            .unwrap();
    let c = (3.0 * 1e3 * 0.5 / (4.0 * MODULUS)).cbrt();
    close(contact.zones()[0][1], c, 1e-9, "radius");
    close(contact.pressure(0.0).unwrap(), 1.5e3 / (PI * c * c), 1e-8, "peak");
}

#[test]
fn what_is_prescribed_does_not_matter() {
    let profile = "1e-6*(cosh(300*x) - 1) + 0.1*x^2";
    let first = solve(profile, pressed(500.0));
    let second = solve(profile, sunk(first.settlement()));
    close(second.force(), 500.0, 1e-12, "force");
    close(second.zones()[0][1], first.zones()[0][1], 1e-12, "radius");
    close(second.pressure(1e-4).unwrap(), first.pressure(1e-4).unwrap(), 1e-12, "pressure");
    assert!(matches!(second.problem().load().vertical(), Vertical::Settlement(_)));
    assert!(first.zones()[0][1] < A * FRAC_PI_2);
}

/// Under `H max(0, rho - 0.3)^1.1` the whole base has `p = (E* H/(pi a)) [d/sqrt(1 - rho^2) + F(rho)]`, with `F` by mpmath (`fredholm`, test `beside_a_bend_it_is_as_exact_as_stated`).
#[test]
fn a_ring_that_bends_as_a_power_has_its_pressure() {
    let height = 1e-6;
    let profile = format!("{height:e}*max(0, abs(x)/{A:e} - 0.3)^1.1");
    let contact = solve_bilateral(&profile, pressed(900.0));
    let unit = MODULUS * height / (PI * A);
    let at = |rho: f64| contact.pressure(rho * A).unwrap() / unit;
    let corner = (at(0.5) - 2.230_999_882_837_028_5) * 0.75f64.sqrt();
    let stated = contact.error().unwrap().pressure / unit;
    for (rho, exact) in [(0.2, 2.542_622_158_940_113), (0.3, 6.957_021_081_636_043)] {
        let off = (at(rho) - corner / ((1.0 - rho) * (1.0 + rho)).sqrt() - exact).abs();
        assert!(off <= 2.0 * stated + 1e-12 * exact, "{rho}: off {off:e}, stated {stated:e}");
    }
    assert!(stated < 1e-5, "{stated:e}");
}

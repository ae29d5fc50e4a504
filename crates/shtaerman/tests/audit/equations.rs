//! Bounds of equations against closed forms.
//!
//! `int_(-a)^a ln(1/|x - s|) sqrt(a^2 - s^2) ds = pi a^2/2 (ln(2/a) + 1/2) - pi/2 x^2`; and with the eigenvalues `nu_n = pi Gamma(n + mu)/(n! Gamma(mu) cos(pi mu/2))` of `|x - s|^-mu` on
//! Gegenbauer's polynomials of the order `q = mu/2` (G. Szegő, Orthogonal Polynomials, 1939) that of `(a^2 - s^2)^((1+mu)/2)` is `a^2 (nu_0 (1 - 1/(2 + 2 q)) - nu_2 (2 q (1 + q) x^2/a^2 - q)/(2 q (1 + q)))`.

use std::f64::consts::PI;

use shtaerman::ErrorKind;
use shtaerman::equation::{EquationFile, SolvedEquation};

/// A kernel with its parameters, `mu` (0 for logarithms), `a`, and the share of the interval that is given.
const KERNELS: [(&str, f64, f64, f64); 6] = [
    ("name = \"log\"", 0.0, 0.05, 1.0),
    ("name = \"log\"", 0.0, 1.9, 1.0),
    ("name = \"log\"", 0.0, 2.0, 1.0),
    ("name = \"log-square\"\nb = 0.0", 0.0, 1.3, 0.5),
    ("name = \"power\"\nmu = 0.35", 0.35, 0.4, 1.0),
    ("name = \"power\"\nmu = 0.2", 0.2, 3.0, 1.0),
];

/// `int K phi` as `c - b x^2`.
fn potential(mu: f64, a: f64) -> [f64; 2] {
    if mu == 0.0 {
        return [0.5 * PI * a * a * ((2.0 / a).ln() + 0.5), 0.5 * PI];
    }
    let q = 0.5 * mu;
    let first = PI / (PI * q).cos();
    let second = first * mu * (mu + 1.0) / 2.0;
    [a * a * (first * (1.0 - 0.5 / (1.0 + q)) + second * 0.5 / (1.0 + q)), second]
}

#[test]
fn bounds_hold() {
    for (kernel, mu, a, share) in KERNELS {
        let [level, bend] = potential(mu, a);
        for lambda in [0.3, 300.0] {
            for solver in ["", "method = \"spectral\"\nn = 30"] {
                let (power, c, b) = (0.5 * (1.0 + mu), lambda * level, lambda * bend);
                let text = format!(
                    "[equation]\nkind = \"second\"\nlambda = {lambda}\nrhs = \"{c} - {b}*x^2 + max({a}^2 - x^2, 0)^{power}\"\n[kernel]\n{kernel}\na = {a}\n[solver]\n{solver}"
                );
                let file = EquationFile::parse(&text, "e.toml").unwrap();
                let solved = file.equation().solve().and_then(SolvedEquation::audited).unwrap();
                let audit = solved.audit_report().unwrap().clone();
                assert_eq!(audit.kind, Some(ErrorKind::Bound), "{text}{audit:?}");
                let stated = solved.error();
                let largest = a.powf(1.0 + mu);
                // The truth has the rounding of the numbers in its right-hand side.
                let slack = 4.0 * f64::EPSILON * (largest + c.abs());
                let mut worst = 0.0f64;
                for k in 0..=400 {
                    let xi = (PI * f64::from(k) / 400.0).cos();
                    let x = if share < 1.0 { a * xi.abs() } else { a * xi };
                    let exact = (a * a - x * x).max(0.0).powf(power);
                    worst = worst.max((solved.evaluate(x).unwrap().unwrap() - exact).abs());
                }
                println!("{kernel} {a} {lambda} {solver:?}: {worst:e} {stated:?}");
                assert!(worst <= stated.solution + slack, "{text}: {worst:e} {stated:?}");
                // int (1 - y^2)^p dy = sqrt(pi) Gamma(p + 1)/Gamma(p + 3/2)
                let whole = PI.sqrt() * libm::tgamma(power + 1.0) / libm::tgamma(power + 1.5);
                let missed = (solved.integral().unwrap() - share * whole * a * largest).abs();
                assert!(missed <= stated.integral + slack * a, "{text}: {missed:e} {stated:?}");
                // Beside the ends the solution changes by the root of a rounding from one number to the next.
                let idle = 1e3 * worst + 1e-6 * (1.0 + lambda * a) * largest;
                assert!(stated.solution <= idle, "idle: {text}: {worst:e} {stated:?}");
            }
        }
    }
}

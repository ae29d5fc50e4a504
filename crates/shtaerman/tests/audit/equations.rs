//! Bounds of equations against closed forms.
//!
//! `int_(-a)^a ln(1/|x - s|) sqrt(a^2 - s^2) ds = pi a^2/2 (ln(2/a) + 1/2) - pi/2 x^2`; and with the eigenvalues `nu_n = pi Gamma(n + mu)/(n! Gamma(mu) cos(pi mu/2))` of `|x - s|^-mu` on
//! Gegenbauer's polynomials of the order `q = mu/2` (G. Szegő, Orthogonal Polynomials, 1939) that of `(a^2 - s^2)^((1+mu)/2)` is `a^2 (nu_0 (1 - 1/(2 + 2 q)) - nu_2 (2 q (1 + q) x^2/a^2 - q)/(2 q (1 + q)))`.

use std::f64::consts::PI;

use shtaerman::equation::{EquationFile, SolvedEquation};
use shtaerman::{Error, ErrorKind};

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

/// The method that suits, and degenerate kernels of a low degree.
const SOLVERS: [&str; 2] = ["", "method = \"spectral\"\nn = 30"];

#[test]
fn bounds_hold() {
    for (kernel, mu, a, share) in KERNELS {
        let [level, bend] = potential(mu, a);
        for (lambda, solvers) in [(0.3, &SOLVERS[..1]), (300.0, &SOLVERS[..])] {
            for solver in solvers {
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

/// A tent far narrower than the nodes of a degenerate kernel, without an audit. The operator is symmetric: the integral of its solution is that of 1 and, with the solution `phi_1` of the right-hand
/// side 1 and the measure `m`, `w m(c) phi_1(c)` to the square of its half-width `w`.
#[test]
fn tents_between_the_nodes_are_in_integrals() {
    let cases = [
        ("name = \"power\"\nmu = 0.3955\na = 0.4099", 0.03687, 0.30941, 4.73e-6, false),
        ("name = \"yukawa\"\nchi0 = 1.6e-6\nm = 0\na = 2.724", 8.006, 2.43862, 5.28e-5, true),
    ];
    for (kernel, lambda, centre, width, is_radial) in cases {
        let solve = |rhs: &str, method: &str| {
            let text = format!(
                "[equation]\nkind = \"second\"\nlambda = {lambda}\nrhs = \"{rhs}\"\n[kernel]\n{kernel}\n[solver]\nmethod = \"{method}\"\nn = 200\n"
            );
            let text = if method == "sinc" { text.replace("n = 200\n", "") } else { text };
            let file = EquationFile::parse(&text, "e.toml").unwrap();
            let solved = file.equation().solve().unwrap();
            let values = solved.evaluate(centre).unwrap().unwrap();
            (solved.integral().unwrap(), values, *solved.error())
        };
        let (whole, at_centre, _) = solve("1", "sinc");
        let measure = if is_radial { centre } else { 1.0 };
        let exact = whole + width * measure * at_centre;
        let tent = format!("1 + max(0, 1 - abs(x - {centre})/{width})");
        let (found, top, stated) = solve(&tent, "spectral");
        let (_, own_top, own) = solve(&tent, "sinc");
        println!("{kernel}: {found} {exact} {stated:?}; {top} {own_top} {own:?}");
        assert!((found - exact).abs() <= stated.integral + 1e-13 * exact.abs(), "{found} {exact}");
        assert!((found - exact).abs() < 1e-3 * (exact - whole).abs(), "{found} {exact} {whole}");
        assert!((top - own_top).abs() <= stated.solution + own.solution, "{top} {own_top}");
    }
}

/// The inverse of a kernel like `|x - s|^-gamma` takes `|x - k|^q` to `|x - k|^(q - 1 + gamma)` (S. G. Samko, A. A. Kilbas, O. I. Marichev, Fractional Integrals and Derivatives, 1993): infinite at `k` for `q <= 1 - gamma`, however
/// small it is.
#[test]
fn the_first_kind_is_infinite_where_the_inverse_is() {
    let sizes = [0.7, 3e-4, -2e-7, 4e-9];
    for (case, (gamma, q)) in [0.0, 0.1, 0.3, 0.9]
        .into_iter()
        .flat_map(|gamma| [0.1, 0.5, 0.7, 0.9, 1.0, 1.3, 3.0].map(|q| (gamma, q)))
        .enumerate()
    {
        let kernel = match gamma {
            0.0 => "name = \"log\"".to_owned(),
            _ => format!("name = \"power\"\nmu = {gamma}"),
        };
        let at = [-0.37, 0.0, 0.123_456_789, 0.9][case % 4];
        let side = ["max(0, x - {})", "abs(x - {})", "max(0, {} - x)"][case % 3];
        let size = sizes[(case + case / 8) % 4];
        let bend = format!("({})^{q}", side.replace("{}", &format!("({at})")));
        for rhs in [format!("cos(2*x) + {size:e}*{bend}"), format!("{bend} - 3")] {
            let text = format!(
                "[equation]\nkind = \"first\"\nrhs = \"{rhs}\"\n[kernel]\n{kernel}\na = 1.1\n"
            );
            let file = EquationFile::parse(&text, "e.toml").unwrap();
            let found = match file.equation().solve() {
                Err(Error::InfiniteSolution { at, .. }) => Some(at),
                _ => None,
            };
            assert_eq!(
                found.is_some(),
                q + gamma <= 1.0 + f64::EPSILON,
                "{gamma}: {rhs}: {found:?}"
            );
            assert!(found.is_none_or(|found| (found - at).abs() < 1e-15), "{rhs}: {found:?}");
        }
    }
}

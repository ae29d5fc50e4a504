//! `equation`: the first kind on every kernel against its closed forms.

use std::f64::consts::PI;

use crate::cli::equation::{answer, file};
use crate::cli::support::number;

/// The complete elliptic integral `K` of the complementary modulus, by the arithmetic-geometric mean.
fn elliptic(complementary_modulus: f64) -> f64 {
    let (mut one, mut other) = (1.0, complementary_modulus);
    for _ in 0..40 {
        (one, other) = (0.5 * (one + other), (one * other).sqrt());
    }
    PI / (2.0 * one)
}

/// Kernel, right-hand side, the solution and its integral.
type Closed = (&'static str, &'static str, Box<dyn Fn(f64) -> f64>, f64);

fn closed_forms() -> Vec<Closed> {
    let (a, b) = (1.5f64, 0.4f64);
    let (outer, inner) = (elliptic(b / a), elliptic((1.0 - (b / a).powi(2)).sqrt()));
    let alpha = 2.0f64;
    let constant = (1.0 / (0.5 * alpha).sin()).ln();
    let mu = 0.3f64;
    let euler = 0.577_215_664_901_532_9;
    let thin = (2.0 / a).ln() + (2.0 / 1e-7f64).ln() - euler;
    let screened = PI * PI - 2.0 * PI * 1e-7;
    vec![
        (
            "name = \"log\"\na = 1.5",
            "1",
            Box::new(move |x| 1.0 / (PI * (2.0 / a).ln() * (a * a - x * x).sqrt())),
            1.0 / (2.0 / a).ln(),
        ),
        ("name = \"log\"\na = 1.5", "x", Box::new(move |x| x / (PI * (a * a - x * x).sqrt())), 0.0),
        (
            "name = \"log-ratio\"\na = 1.5\nb = 0.4",
            "1",
            Box::new(move |x| a / (PI * inner) / ((a * a - x * x) * (x * x - b * b)).sqrt()),
            outer / (PI * inner),
        ),
        (
            "name = \"log-ratio-limit\"\na = 1.5",
            "x",
            Box::new(move |x| x / (PI * (a * a - x * x).sqrt())),
            a / PI,
        ),
        (
            "name = \"log-square\"\na = 1.5\nb = 0.4",
            "1",
            Box::new(move |x| {
                2.0 * x
                    / ((a * a - x * x) * (x * x - b * b)).sqrt()
                    / (PI * (4.0 / (a * a - b * b)).ln())
            }),
            1.0 / (4.0 / (a * a - b * b)).ln(),
        ),
        (
            "name = \"log-sine\"\nalpha = 2.0",
            "1",
            Box::new(move |x| {
                (0.5 * x).cos() / (2.0 * (x.cos() - alpha.cos())).sqrt() / (PI * constant)
            }),
            1.0 / constant,
        ),
        (
            "name = \"power\"\na = 1.5\nmu = 0.3",
            "1",
            Box::new(move |x| (0.5 * PI * mu).cos() / PI * (a * a - x * x).powf(0.5 * (mu - 1.0))),
            // cos(pi mu/2)/pi a^mu B(1/2, (1 + mu)/2), with B(1/2, 0.65) by mpmath.
            (0.5 * PI * mu).cos() / PI * a.powf(mu) * 2.630_629_942_877_865,
        ),
        (
            // K_0(z) = ln(2/z) - gamma + O(z^2 ln z).
            "name = \"macdonald\"\na = 1.5\nmu = 0.0\nkappa = 1e-7",
            "1",
            Box::new(move |x| 1.0 / (PI * thin * (a * a - x * x).sqrt())),
            1.0 / thin,
        ),
        (
            // exp(-kappa x) is the first eigenfunction, with lambda_0 = sqrt(pi/(2 kappa)) pi/cos(pi mu).
            "name = \"macdonald\"\ninterval = \"half-line\"\nmu = 0.0\nkappa = 2.0",
            "exp(-2*x)",
            Box::new(move |x: f64| (-2.0 * x).exp() / x.sqrt() / (PI * (0.25 * PI).sqrt())),
            (0.5 * PI).sqrt() / (PI * (0.25 * PI).sqrt()),
        ),
        (
            // Boussinesq's flat punch.
            "name = \"weber-sonine\"\na = 1.5\nmu = 0.0\ngamma = 0.0",
            "1",
            Box::new(move |x| 2.0 / (PI * (a * a - x * x).sqrt())),
            2.0 / PI * a,
        ),
        (
            // The same with 2 pi, and the first correction of the screening.
            "name = \"yukawa\"\na = 1.0\nchi0 = 1e-7\nm = 0",
            "1",
            Box::new(move |x| 1.0 / (screened * (1.0 - x * x).sqrt())),
            1.0 / screened,
        ),
    ]
}

#[test]
fn the_first_kind_has_closed_forms() {
    for (kernel, rhs, exact, integral) in closed_forms() {
        let text = file(None, rhs, kernel);
        let is_half_line = kernel.contains("half-line");
        let end = match kernel {
            _ if kernel.contains("alpha") => 2.0,
            _ if kernel.contains("a = 1.0") => 1.0,
            _ => 1.5,
        };
        let left = if kernel.contains("b = ") { 0.4 } else { 0.0 };
        let x = [left + 0.01, 0.5 * (left + end), 0.999 * end, end];
        let json = answer(&text, &x, &[]);
        assert_eq!(json["error"]["of"], "phi/w");
        assert!(json["lambda"].is_null());
        let phi = json["solution"]["phi"].as_array().unwrap();
        for (x, phi) in x.iter().zip(phi).take(3) {
            let (phi, exact) = (phi.as_f64().unwrap(), exact(*x));
            let error = (phi - exact).abs() / exact.abs();
            assert!(error < 1e-11, "{text}phi({x}) = {phi} for {exact}: {error:.1e}");
        }
        assert_eq!(phi[3].is_null(), !is_half_line, "{text}: infinite at its end");
        let error = (number(&json, "/integral") - integral).abs();
        assert!(error < 1e-11 * integral.max(1.0), "{text}integral: {error:.1e}");
    }
}

//! How far a function leaves its tangent.

use crate::expression::{Expression, Line};

fn rise(text: &str, c: f64, t: f64) -> f64 {
    Expression::parse(text, &["x"]).unwrap().rise_along(&Line::identity(), c, t)
}

#[test]
fn small_rises_are_half_the_curvature() {
    // f'' by hand.
    let curved: [(&str, f64, f64); 14] = [
        ("3*x^2 - 5*x + 1e9", 0.3, 6.0),
        ("(x - 1)*(x + 2)", 0.3, 2.0),
        ("x^5", 0.5, 20.0 * 0.125),
        ("x^-2", 0.5, 6.0 / 0.0625),
        ("x^2.5", 0.25, 3.75 * 0.5),
        ("exp(2*x)", 0.1, 4.0 * 0.2f64.exp()),
        ("sin(3*x)", 0.2, -9.0 * 0.6f64.sin()),
        ("7 + cos(3*x)", 0.2, -9.0 * 0.6f64.cos()),
        ("ln(x)", 0.5, -4.0),
        ("1/x", 0.5, 16.0),
        ("sqrt(1 - x^2)", 0.6, -1.0 / 0.512),
        ("abs(x - 1)^3", 0.5, 3.0),
        ("hypot(x, 1)", 0.75, 1.0 / 1.25f64.powi(3)),
        ("where(x > 0, max(x^2, -1), 5)", 0.5, 2.0),
    ];
    for (text, c, second) in curved {
        for t in [1e-9, -1e-9] {
            let value = rise(text, c, t);
            assert!((value / (0.5 * second * t * t) - 1.0).abs() < 1e-7, "{text}: {value:e}");
        }
    }
}

#[test]
fn large_rises_are_differences() {
    for text in [
        "3*x^2 - 5*x",
        "x^5",
        "exp(2*x)",
        "sin(9*x)*cos(x)",
        "ln(2 + x)",
        "1/(3 + x)",
        "sqrt(2 - x^2)",
        "abs(x - 0.2)",
        "max(x, 0.1)^2",
        "tanh(4*x)",
        "where(x < 0.1, x^2, 1 + x)",
        "hypot(x, 0.3)",
        "atan2(x, 2)",
        "2^x",
        "log1p(x + 0.5)",
        "expm1(x)",
        "cosh(x)/(1 + x^2)",
        "(1.5 + x)^(1 + x)",
        "floor(3*x)",
        "x^0",
        "min(x, 0.3, x^2)",
    ] {
        let expression = Expression::parse(text, &["x"]).unwrap();
        for (c, t) in [(0.05, 0.6), (0.3, -0.7), (-0.4, 0.3), (0.25, 0.0)] {
            let (value, slope) = expression.evaluate_with_derivative(&[c], 0);
            let plain = expression.evaluate(&[c + t]) - value - slope * t;
            let found = rise(text, c, t);
            assert!((found - plain).abs() < 1e-13, "{text} {c} {t}: {found} {plain}");
        }
    }
}

#[test]
fn undefined_values_leave_no_tangent() {
    assert!(rise("sqrt(x)", 0.5, -1.0).is_nan());
    assert!(rise("ln(x)", 0.5, -1.0).is_nan());
}

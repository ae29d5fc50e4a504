//! Derivatives against closed forms and difference quotients.

use approx::assert_relative_eq;

use super::super::Line;
use super::parsed;

/// Functions of `x` and their derivatives, both as texts.
const CLOSED_FORMS: &[(&str, &str)] = &[
    ("3", "0"),
    ("x", "1"),
    ("-x", "-1"),
    ("x^2", "2*x"),
    ("x^3 - 2*x", "3*x^2 - 2"),
    ("1/x", "-1/x^2"),
    ("(1+x)/(2-x)", "3/(2-x)^2"),
    ("sqrt(x)", "1/(2*sqrt(x))"),
    ("cbrt(x)", "1/(3*cbrt(x)^2)"),
    ("exp(2*x)", "2*exp(2*x)"),
    ("expm1(x)", "exp(x)"),
    ("ln(x)", "1/x"),
    ("log10(x)", "1/(x*ln(10))"),
    ("log2(x)", "1/(x*ln(2))"),
    ("log1p(x)", "1/(1+x)"),
    ("sin(x)", "cos(x)"),
    ("cos(400*x)", "-400*sin(400*x)"),
    ("tan(x)", "1/cos(x)^2"),
    ("asin(x)", "1/sqrt(1-x^2)"),
    ("acos(x)", "-1/sqrt(1-x^2)"),
    ("atan(x)", "1/(1+x^2)"),
    ("sinh(x)", "cosh(x)"),
    ("cosh(x)", "sinh(x)"),
    ("tanh(x)", "1/cosh(x)^2"),
    ("asinh(x)", "1/sqrt(1+x^2)"),
    ("acosh(1+x)", "1/sqrt((1+x)^2-1)"),
    ("atanh(x)", "1/(1-x^2)"),
    ("abs(x-1)", "sign(x-1)"),
    ("x^x", "x^x*(ln(x)+1)"),
    ("2^x", "2^x*ln(2)"),
    ("max(0, x-0.002)^1.5", "1.5*sqrt(x-0.002)"),
    ("min(x, 7)", "1"),
    ("hypot(x, 2)", "x/hypot(x, 2)"),
    ("atan2(x, 2)", "2/(4+x^2)"),
    ("atan2(2, x)", "-2/(4+x^2)"),
    ("where(x < 0.5, x^2, 1)", "where(x < 0.5, 2*x, 0)"),
    ("floor(x) + step(x) + sign(x)", "0"),
];

#[test]
fn derivatives_are_those_of_calculus() {
    for (text, slope) in CLOSED_FORMS {
        for x in [0.1, 0.37, 0.8] {
            let (value, found) = parsed(text).evaluate_with_derivative(&[x], 0);
            assert_eq!(value, parsed(text).evaluate(&[x]), "{text}");
            let expected = parsed(slope).evaluate(&[x]);
            assert_relative_eq!(found, expected, max_relative = 1e-13, epsilon = 1e-15);
        }
    }
}

#[test]
fn derivatives_agree_with_difference_quotients() {
    for (text, _) in CLOSED_FORMS {
        let (expression, x, step) = (parsed(text), 0.37, 1e-6);
        let difference =
            (expression.evaluate(&[x + step]) - expression.evaluate(&[x - step])) / (2.0 * step);
        let (_, found) = expression.evaluate_with_derivative(&[x], 0);
        assert_relative_eq!(found, difference, max_relative = 1e-6, epsilon = 1e-6);
    }
}

#[test]
fn derivatives_at_kinks_are_those_to_the_right() {
    let table = [
        ("abs(x)", 0.0, 1.0),
        ("abs(-2*x)", 0.0, 2.0),
        ("max(0, x)", 0.0, 1.0),
        ("max(0, -x)", 0.0, 0.0),
        ("min(0, x)", 0.0, 0.0),
        ("min(0, -3*x)", 0.0, -3.0),
        ("hypot(3*x, 4*x)", 0.0, 5.0),
        ("max(0, x)^1.5", 0.0, 0.0),
        ("sqrt(x)", 0.0, f64::INFINITY),
        ("cbrt(x)", 0.0, f64::INFINITY),
        ("x^0", 0.0, 0.0),
        ("x^1", 0.0, 1.0),
        ("sqrt(a - 2)*x", 5.0, 0.0),
    ];
    for (text, x, expected) in table {
        let (_, found) = parsed(text).evaluate_with_derivative(&[x, 0.0, 2.0], 0);
        assert_eq!(found, expected, "{text}");
    }
    for text in ["ln(x)", "sqrt(x)", "1/0*x - 1/0*x"] {
        let (value, slope) = parsed(text).evaluate_with_derivative(&[-1.0], 0);
        assert!(value.is_nan() && slope.is_nan(), "{text}");
    }
}

#[test]
fn derivatives_pick_their_variable_and_follow_a_line() {
    let expression = parsed("x^2*xi + a");
    let at = [3.0, 5.0, 7.0];
    assert_eq!(expression.evaluate_with_derivative(&at, 0), (52.0, 30.0));
    assert_eq!(expression.evaluate_with_derivative(&at, 1), (52.0, 9.0));
    assert_eq!(expression.evaluate_with_derivative(&at, 2), (52.0, 1.0));
    // x = 2 t, xi = t, a = 2: 4 t^3 + 2.
    let line = Line::new(&[(0.0, 2.0), (0.0, 1.0), (2.0, 0.0)]);
    assert_eq!(expression.derivative_along(&line, 0.5), (2.5, 3.0));
    assert_eq!([0.0, 0.5, 1.0].map(|t| expression.evaluate_at(&line, t)), [2.0, 2.5, 6.0]);
}

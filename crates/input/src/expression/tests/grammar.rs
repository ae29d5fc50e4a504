//! Precedence, functions and error messages.

use approx::assert_relative_eq;

use super::super::{Arity, ErrorReason, Expression};
use super::{parsed, refused, value};

#[test]
fn operators_bind_as_in_mathematics() {
    let table = [
        ("-2^2", -4.0),
        ("(-2)^2", 4.0),
        ("2^-3", 0.125),
        ("2^-3*4", 0.5),
        ("2^3^2", 512.0),
        ("2**3**2", 512.0),
        ("2^-1^2", 0.5),
        ("-2^-2", -0.25),
        ("1-2-3", -4.0),
        ("1-(2-3)", 2.0),
        ("24/4/3", 2.0),
        ("24/4*3", 18.0),
        ("2+3*4^2", 50.0),
        ("(2+3)*4", 20.0),
        ("--2", 2.0),
        ("-+-2", 2.0),
        ("2*-3", -6.0),
        ("2--3", 5.0),
        ("-2*3", -6.0),
        ("1+2 < 4", 1.0),
        ("1+2 < 3", 0.0),
        ("3 <= 3", 1.0),
        ("3 >= 4", 0.0),
        ("4 > 3", 1.0),
        ("(1 < 2) < 2", 1.0),
        ("(1 < 2)*(3 > 2)", 1.0),
        ("1e-3", 0.001),
        (".5", 0.5),
        ("5.", 5.0),
        ("5.e1", 50.0),
        ("1E+2", 100.0),
        ("\t1 +\n 2 ", 3.0),
        ("x", 0.3),
        ("xi", -0.5),
        ("a", 2.0),
        ("a*xi", -1.0),
        ("x*x", 0.09),
        ("xi^2/(2*0.8)", 0.15625),
    ];
    for (text, expected) in table {
        assert_eq!(value(text), expected, "{text}");
    }
}

#[test]
fn functions_have_the_values_of_tables() {
    // Abramowitz and Stegun, and exact values.
    let table = [
        ("sqrt(2)", std::f64::consts::SQRT_2),
        ("cbrt(-27)", -3.0),
        ("exp(1) - e", 0.0),
        ("log(10)", std::f64::consts::LN_10),
        ("ln(10)", std::f64::consts::LN_10),
        ("log10(1000)", 3.0),
        ("log2(1024)", 10.0),
        ("expm1(1e-10)", 1.000_000_000_05e-10),
        ("log1p(1e-10)", 9.999_999_999_5e-11),
        ("ln_1p(1)", std::f64::consts::LN_2),
        ("sin(pi/6)", 0.5),
        ("cos(pi/3)", 0.5),
        ("tan(pi/4)", 1.0),
        ("asin(0.5)*6", std::f64::consts::PI),
        ("acos(0.5)*3", std::f64::consts::PI),
        ("atan(1)*8", std::f64::consts::TAU),
        ("tau - 2*pi", 0.0),
        ("sinh(1)", 1.175_201_193_643_801_4),
        ("cosh(1)", 1.543_080_634_815_243_7),
        ("tanh(1)", 0.761_594_155_955_764_9),
        ("asinh(1)", 0.881_373_587_019_543),
        ("asinh(-1e-12)", -1e-12),
        ("asinh(1e200)", 461.210_165_779_369_1),
        ("acosh(2)", 1.316_957_896_924_816_6),
        ("atanh(0.5)", 0.549_306_144_334_054_8),
        ("atanh(-0.5)", -0.549_306_144_334_054_8),
        ("abs(-3)", 3.0),
        ("sign(-3) + sign(0)", -1.0),
        ("min(3, 1, 2)", 1.0),
        ("max(3, 1, 2, 5)", 5.0),
        ("hypot(3, 4)", 5.0),
        ("atan2(1, -1)", 3.0 * std::f64::consts::FRAC_PI_4),
        ("pow(9, 1.5)", 27.0),
        ("floor(-1.5)", -2.0),
        ("ceil(-1.5)", -1.0),
        ("step(0) + heaviside(-1e-300)", 1.0),
        ("clamp(7, -1, 1)", 1.0),
        ("clamp(-7, -1, 1)", -1.0),
        ("clamp(xi, -1, 1)", -0.5),
        ("where(xi < 0, 10, 20)", 10.0),
        ("where(xi > 0, ln(xi), 20)", 20.0),
        ("1e-3*max(0, x-0.1)^1.5", 8.944_271_909_999_159e-5),
    ];
    for (text, expected) in table {
        assert_relative_eq!(value(text), expected, max_relative = 1e-14, epsilon = 1e-300);
    }
}

#[test]
fn acosh_near_one_keeps_its_digits() {
    // acosh(1 + d) = sqrt(2 d) (1 - d/12 + ...), d exactly as represented.
    let d = (1.0_f64 + 1e-10) - 1.0;
    let series = (2.0 * d).sqrt() * (1.0 - d / 12.0);
    assert_relative_eq!(value("acosh(1 + 1e-10)"), series, max_relative = 1e-15);
}

#[test]
fn what_is_undefined_stays_undefined() {
    for text in [
        "min(0, sqrt(-1))",
        "max(sqrt(-1), 0)",
        "pow(0/0, 0)",
        "hypot(1/0, 0/0)",
        "step(0/0)",
        "0/0 < 1",
        "where(0/0, 1, 1)",
        "acosh(-1e10)",
        "acosh(0.5)",
        "sign(0/0)",
    ] {
        assert!(value(text).is_nan(), "{text}");
    }
    assert_eq!(value("where(1, 2, 0/0)"), 2.0);
    assert_eq!(value("1/(-0)"), f64::INFINITY);
    assert_eq!(value("(-0)^-3"), f64::INFINITY);
}

#[test]
fn variables_take_precedence_over_constants() {
    let expression = Expression::parse("e + pi*0", &["e"]).unwrap();
    assert_eq!(expression.evaluate(&[5.0]), 5.0);
    assert!(expression.uses(0));
    assert!(expression.evaluate(&[]).is_nan());
}

#[test]
fn constant_parts_are_folded() {
    assert_eq!(parsed("x/(2*0.8)").operations.len(), 3);
    assert_eq!(parsed("2*3 - sqrt(4)").operations.len(), 1);
    assert_eq!(parsed("x*x").operations, parsed("x^2").operations);
    assert_eq!(parsed("x*x").operations.len(), 2);
    assert_ne!(parsed("x*xi").operations.len(), 2);
}

/// Text, expected bytes to point at, words of the message, words of the help.
const FAULTS: &[(&str, std::ops::Range<usize>, &str, &str)] = &[
    ("", 0..0, "empty", "flat base"),
    ("  ", 0..2, "empty", ""),
    ("2x", 0..2, "missing between `2` and `x`", "write 2*x"),
    ("2 x", 0..3, "missing", "write 2*x"),
    ("x xi", 0..4, "missing", "write x*xi"),
    ("2(x+1)", 0..2, "missing", "write 2*(...)"),
    ("(x)(xi)", 2..4, "missing", "write (...)*(...)"),
    ("xi(2)", 0..3, "missing", "write xi*(...)"),
    ("2e", 0..2, "missing", "write 2*e"),
    ("1.2.3", 0..5, "missing", "one decimal point"),
    ("10 000", 0..6, "missing", "without spaces"),
    ("x^2/(2*20 mm)", 7..12, "missing", "20 mm is 0.02"),
    ("1 +", 2..3, "missing after `+`", ""),
    ("* 2", 0..1, "missing before `*`", ""),
    ("2 * / 3", 2..3, "missing after `*`", ""),
    ("()", 0..1, "missing after `(`", ""),
    ("max(1,)", 5..6, "missing after `,`", ""),
    ("(1 + (2*x)", 0..1, "never closed", "`)`"),
    ("sin(x", 3..4, "never closed", ""),
    ("1 + x)", 5..6, "closes nothing", ""),
    ("0,5*x", 1..2, "comma", "0.5"),
    ("(1, 2)", 2..3, "comma", ""),
    ("x # 2", 2..3, "`#`", ""),
    ("x \u{2212} 2", 2..5, "\u{2212}", "write `-`"),
    ("x\u{b2}", 1..3, "\u{b2}", "x^2"),
    ("[x]", 0..1, "`[`", "round brackets"),
    ("x == 2", 2..3, "`=`", "comparisons"),
    ("1e999", 0..5, "too large", ""),
    ("1e-999*x", 0..6, "too small", ""),
    ("inf", 0..3, "neither", "cannot be written"),
    ("NaN", 0..3, "neither", "cannot be written"),
    ("y + 1", 0..1, "`y` is neither", "x, xi, a, pi, e, tau"),
    ("x1", 0..2, "`x1` is neither", "did you mean `xi`"),
    ("x2", 0..2, "`x2` is neither", "did you mean `x^2`"),
    ("XI", 0..2, "`XI`", "did you mean `xi`"),
    ("\u{3be}^2", 0..2, "\u{3be}", "did you mean `xi`"),
    ("2*sqr(x)", 2..5, "no function `sqr`", "did you mean `sqrt`"),
    ("arcsin(x)", 0..6, "no function", "did you mean `asin`"),
    ("Sin(x)", 0..3, "no function", "did you mean `sin`"),
    ("zzzzzz(x)", 0..6, "no function", ""),
    ("abs x", 0..3, "needs its arguments", "abs(...)"),
    ("min(1)", 0..6, "takes 2 or more arguments, but 1 was given", ""),
    ("sin()", 0..5, "takes 1 argument, but 0 were given", ""),
    ("1+atan2(1,2,3)", 2..14, "takes 2 arguments, but 3 were given", ""),
    ("where(1,2)", 0..10, "takes 3 arguments", ""),
    ("0 < x < 1", 6..7, "chained", "(a < b)*(b < c)"),
];

#[test]
fn faults_are_named_and_pointed_at() {
    for (text, span, message, help) in FAULTS {
        let error = refused(text);
        assert_eq!(&error.span, span, "{text}: {error}");
        assert!(error.to_string().contains(message), "{text}: {error}");
        let given = error.help().unwrap_or_default();
        assert!(given.contains(help), "{text}: {given}");
    }
}

#[test]
fn errors_carry_their_values() {
    let expected =
        ErrorReason::ArgumentCount { name: "min".into(), arity: Arity::AtLeast(2), found: 1 };
    assert_eq!(refused("min(x)").reason, expected);
}

#[test]
fn the_caret_stands_below_the_fault() {
    let text = "1 +\nx\u{b7}y";
    assert_eq!(refused(text).pointed_at(text), "x\u{b7}y\n ^");
    let long = format!("{}q{}", "x + ".repeat(1000), " + x".repeat(1000));
    let shown = refused(&long).pointed_at(&long);
    let (line, carets) = shown.split_once('\n').unwrap();
    assert_eq!(line.chars().nth(carets.len() - 1), Some('q'));
    assert!(line.len() < 100);
    assert_eq!(refused("").pointed_at(""), "\n^");
}

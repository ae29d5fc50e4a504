//! Enclosures contain the values and are not much wider than need be.

use proptest::prelude::*;

use super::super::{Expression, Interval};
use super::trees::tree;
use super::{parsed, tied};

fn interval(lower: f64, upper: f64) -> Interval {
    Interval::new(lower, upper).unwrap()
}

fn check_contains(expression: &Expression, x: Interval, xi: Interval, at: (f64, f64)) {
    let pick = |range: Interval, fraction: f64| {
        (range.lower() + fraction * (range.upper() - range.lower()))
            .clamp(range.lower(), range.upper())
    };
    let enclosure = expression.enclose(&[x, xi]);
    let (u, v) = (pick(x, at.0), pick(xi, at.1));
    let value = expression.evaluate(&[u, v]);
    let is_allowed = if value.is_nan() {
        enclosure.may_be_undefined
    } else {
        enclosure.interval.contains(value)
    };
    assert!(is_allowed, "{expression} at {u:e}, {v:e} is {value:e}, outside {enclosure:?}");
}

/// Ends as they occur: also special values and huge ranges.
fn range() -> impl Strategy<Value = Interval> {
    let end = || {
        prop_oneof![
            4 => -2.0..2.0_f64,
            2 => prop::sample::select(vec![-2.0, -1.0, -0.5, -0.0, 0.0, 0.5, 1.0, 2.0, 3.0]),
            1 => -1e3..1e3_f64,
            1 => prop::sample::select(vec![-1e300, -1e-310, 1e-310, 1e300]),
        ]
    };
    let wide = (end(), end()).prop_map(|(u, v)| interval(u.min(v), u.max(v)));
    let narrow = (end(), 0.0..1e-3_f64).prop_map(|(u, width)| interval(u, u + width));
    prop_oneof![wide, narrow]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn enclosures_contain_the_values(
        tree in tree(), x in range(), xi in range(), at in (0.0..=1.0_f64, 0.0..=1.0_f64),
    ) {
        let expression = parsed(&tree.text());
        for at in [at, (0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)] {
            check_contains(&expression, x, xi, at);
        }
    }

    #[test]
    fn every_function_is_enclosed(
        x in range(), xi in range(), at in (0.0..=1.0_f64, 0.0..=1.0_f64),
    ) {
        for text in [
            "sqrt(x)", "cbrt(x)", "exp(x)", "expm1(x)", "ln(x)", "log10(x)", "log2(x)", "log1p(x)",
            "sin(x)", "cos(x)", "tan(x)", "asin(x)", "acos(x)", "atan(x)", "sinh(x)", "cosh(x)",
            "tanh(x)", "asinh(x)", "acosh(x)", "atanh(x)", "abs(x)", "sign(x)", "floor(x)",
            "ceil(x)", "step(x)", "x+xi", "x-xi", "x*xi", "x/xi", "x^xi", "x^2", "x^3", "x^4",
            "x^-1", "x^-2", "x^0.5", "x^-1.5", "x^0", "2^x", "(-2)^x", "min(x,xi)", "max(x,xi)",
            "hypot(x,xi)", "atan2(x,xi)", "x<xi", "x<=xi", "x>xi", "x>=xi", "1/(1/x)", "xi^(1/x)",
            "clamp(x,xi,1)", "where(x<xi,x,sqrt(xi))", "exp(-1/x^2)", "atan2(1/x, exp(400*xi))",
        ] {
            let expression = parsed(text);
            for at in [at, (0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)] {
                check_contains(&expression, x, xi, at);
            }
        }
    }

    #[test]
    fn a_tied_enclosure_contains_the_values(tree in tree(), range in range(), at in 0.0..=1.0_f64) {
        let expression = parsed(&tree.text());
        let place = (range.lower() + at * (range.upper() - range.lower()))
            .clamp(range.lower(), range.upper());
        let value = expression.evaluate_at(&tied(), place);
        let enclosure = expression.enclose_along(&tied(), range);
        let is_allowed = enclosure.interval.contains(value)
            || (value.is_nan() && enclosure.may_be_undefined);
        prop_assert!(is_allowed, "{}", expression);
    }
}

/// Closed forms of the range of a function of `x` on an interval.
#[test]
fn ranges_of_single_functions_are_sharp() {
    let half = 0.5_f64;
    let table = [
        ("x^2", -1.0, 2.0, 0.0, 4.0),
        ("x^3", -1.0, 2.0, -1.0, 8.0),
        ("x^4", -1.0, 2.0, 0.0, 16.0),
        ("sin(x)", 0.0, 2.0, 0.0, 1.0),
        ("sin(x)", -2.0, 0.5, -1.0, half.sin()),
        ("cos(x)", -0.5, 0.25, half.cos(), 1.0),
        ("cos(x)", 3.0, 7.0, -1.0, 1.0),
        ("cosh(x)", -1.0, 0.5, 1.0, 1.0_f64.cosh()),
        ("abs(x)", -1.0, 0.5, 0.0, 1.0),
        ("exp(x)", -1.0, 1.0, (-1.0_f64).exp(), 1.0_f64.exp()),
        ("1/x", 0.5, 4.0, 0.25, 2.0),
        ("1/x^2", -1.0, 1.0, 1.0, f64::INFINITY),
        ("acos(x)", -1.0, 1.0, 0.0, std::f64::consts::PI),
        ("floor(x)", -1.5, 1.5, -2.0, 1.0),
        ("max(0, x)", -1.0, -0.5, 0.0, 0.0),
        ("atan2(1, x)", -1.0, 1.0, std::f64::consts::FRAC_PI_4, 3.0 * std::f64::consts::FRAC_PI_4),
        ("hypot(x, 3)", -4.0, 1.0, 3.0, 5.0),
    ];
    for (text, lower, upper, least, most) in table {
        let found = parsed(text).enclose(&[interval(lower, upper)]).interval;
        let near = |u: f64, v: f64| u == v || (u - v).abs() <= 1e-14 * v.abs().max(1.0);
        assert!(near(found.lower(), least) && near(found.upper(), most), "{text}: {found:?}");
    }
}

#[test]
fn extremes_and_poles_close_to_an_end_are_not_missed() {
    let [sine, cosine, tangent] = ["sin(x)", "cos(x)", "tan(x)"].map(parsed);
    for quarter in -40..=40 {
        let place = f64::from(quarter) * std::f64::consts::FRAC_PI_2;
        let rounding = place.abs().max(1.0) * f64::EPSILON;
        for (left, right) in [(1e-3, 1e-5), (1e-8, 0.1), (rounding, 1e-4), (1e-4, rounding)] {
            let range = [interval(place - left, place + right)];
            for wave in [&sine, &cosine] {
                let found = wave.enclose(&range).interval;
                assert!(found.contains(wave.evaluate(&[place])), "{wave} at {quarter}");
                // At a quarter turn it is -1, 0 or 1 but for the rounding of the place.
                let exact = wave.evaluate(&[place]).round();
                assert!(exact == 0.0 || found.contains(exact), "{wave} at {quarter}: {found:?}");
            }
            let is_pole = quarter % 2 != 0;
            assert!(!is_pole || !tangent.enclose(&range).is_finite(), "pole at {quarter}");
        }
    }
}

#[test]
fn left_domains_are_noticed() {
    let undefined = [
        ("sqrt(x)", -0.1, 1.0),
        ("ln(x)", -0.1, 1.0),
        ("asin(x)", 0.5, 1.1),
        ("acosh(x)", 0.5, 2.0),
        ("x^0.5", -1.0, 1.0),
        ("x/x", -1.0, 1.0),
        ("sqrt(x)", -2.0, -1.0),
        ("sin(1/x)", -1.0, 1.0),
    ];
    for (text, lower, upper) in undefined {
        assert!(parsed(text).enclose(&[interval(lower, upper)]).may_be_undefined, "{text}");
    }
    let defined = [("sqrt(x)", 0.0, 1.0), ("asin(x)", -1.0, 1.0), ("x^-2", -1.0, 1.0)];
    for (text, lower, upper) in defined {
        assert!(!parsed(text).enclose(&[interval(lower, upper)]).may_be_undefined, "{text}");
    }
}

#[test]
fn exact_arithmetic_is_not_widened() {
    let found = parsed("1 - x^2").enclose(&[interval(-1.0, 1.0)]).interval;
    assert_eq!((found.lower(), found.upper()), (0.0, 1.0));
    let inexact = parsed("x*0.1").enclose(&[interval(0.3, 0.3)]).interval;
    assert!(inexact.lower() < inexact.upper());
    assert!(inexact.upper() - inexact.lower() <= 2.0 * f64::EPSILON * 0.03);
}

#[test]
fn intervals_refuse_wrong_ends() {
    assert_eq!(Interval::new(1.0, 0.0), None);
    assert_eq!(Interval::new(f64::NAN, 0.0), None);
    assert_eq!(Interval::point(f64::NAN), None);
    assert!(Interval::WHOLE.contains(f64::MAX));
}

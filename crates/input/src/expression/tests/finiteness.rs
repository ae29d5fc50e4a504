//! Which formulas are finite on a whole range.

use proptest::prelude::*;

use super::super::{Defect, Interval, Line, Verdict};
use super::trees::tree;
use super::{parsed, tied, unit_range};

fn verdict(text: &str) -> Verdict {
    parsed(text).finiteness(&tied(), unit_range())
}

#[test]
fn finite_formulas_are_proved_finite() {
    for text in [
        "0",
        "x^2 / (2*0.8)",
        "xi^4 - xi/2",
        "abs(xi)",
        "cos(400*xi)",
        "1e-3*max(0, x-0.002)^1.5",
        "1/(xi^2+1e-12)",
        "1/(xi^2+1e-300)",
        "sqrt(1-xi^2)",
        "sqrt(1-xi*xi)",
        "sqrt(a^2-x^2)",
        "sqrt(0.1+0.2-0.3*xi^2)",
        "sqrt(1-xi^4)",
        "(1-xi^2)^1.5",
        "sqrt(abs(xi-0.3))",
        "sqrt(xi+1)*sqrt(1-xi)",
        "acos(xi) + asin(xi)",
        "asin(x/a)",
        "(1-xi)*log1p(xi+1)",
        "1/(1.0001+sin(400*xi))",
        "exp(700*xi)",
        "exp(-1/xi^2)",
        "atan(1/xi)",
        "where(abs(xi) < 1e-8, 1, sin(xi)/xi)",
        "where(xi <= 0, 0, xi*ln(xi))",
        "where(xi > 0.3, sqrt(xi-0.3), 0)",
        "(xi^2-0.5)/(xi^2-0.5)*0 + tanh(1e6*xi)",
        "xi^3/(1e-9+abs(xi))",
        "floor(1e6*xi)",
        "hypot(xi, 0)",
        "abs(xi)^0.001",
        "(xi^2-0.5)*ln(abs(xi^2-0.5))",
        "sin(xi^2-0.5)/(xi^2-0.5)",
        "1/ln(abs(xi^2-0.5)/2)",
    ] {
        assert_eq!(verdict(text), Verdict::ProvedFinite, "{text}");
    }
}

#[test]
fn faults_are_found_where_they_are() {
    use Defect::*;
    let quarter = std::f64::consts::FRAC_PI_4;
    let table = [
        ("1/xi", 0.0, Infinite),
        ("1/(xi-0.3)", 0.3, Infinite),
        ("1/(xi-0.3)^2", 0.3, Infinite),
        ("1/(x-0.6)", 0.3, Infinite),
        ("1/(3*xi-1)", 1.0 / 3.0, Infinite),
        ("1/(xi^2-0.5)", -0.5_f64.sqrt(), Unbounded),
        ("1/(xi^3+0.2)", -0.2_f64.cbrt(), Unbounded),
        ("ln(xi)", -1.0, Undefined),
        ("ln(abs(xi-0.3))", 0.3, Infinite),
        ("ln(abs(xi^2-0.5))", -0.5_f64.sqrt(), Unbounded),
        ("100 + 0.1*ln(abs(exp(xi)-1.5))", 1.5_f64.ln(), Unbounded),
        ("sqrt(xi-2)", -1.0, Undefined),
        ("tan(2*xi)", -quarter, Unbounded),
        ("x/x", 0.0, Undefined),
        ("sin(x)/x", 0.0, Undefined),
        ("sin(1/xi)", 0.0, Undefined),
        ("abs(xi)^-0.5", 0.0, Infinite),
        ("abs(xi^2-0.5)^-0.5", -0.5_f64.sqrt(), Unbounded),
        ("where(xi <= 0.1, 0, 1/(xi - 0.1))", 0.1, Unbounded),
        ("1/0", -1.0, Infinite),
        ("atanh(xi)", -1.0, Infinite),
        ("xi*ln(abs(xi))", 0.0, Undefined),
    ];
    for (text, place, expected) in table {
        match verdict(text) {
            Verdict::NotFinite { at, defect } => {
                assert!((at - place).abs() < 5e-16, "{text}: {at} instead of {place}");
                assert_eq!(defect, expected, "{text}");
            }
            other => panic!("{text}: {other:?}"),
        }
    }
}

#[test]
fn overflow_is_found() {
    let found = verdict("exp(800*xi)");
    let Verdict::NotFinite { at, defect: Defect::Infinite } = found else { panic!("{found:?}") };
    assert!(at > f64::MAX.ln() / 800.0);
}

#[test]
fn a_pole_hides_from_every_grid() {
    // Poles at places no grid of samples meets.
    for place in ["0.123456789", "-0.987654321", "1e-7", "0.9999999"] {
        let text = format!("1e-9/(xi-({place}))");
        let Verdict::NotFinite { at, .. } = verdict(&text) else { panic!("{text}") };
        assert!((at - place.parse::<f64>().unwrap()).abs() < 1e-15, "{text}: {at}");
    }
    let range = Interval::new(1.0, 2.0).unwrap();
    let found = parsed("1e-12*tan(x)").finiteness(&Line::new(&[(0.0, 1.0)]), range);
    let Verdict::NotFinite { at, defect: Defect::Unbounded } = found else { panic!("{found:?}") };
    assert!((at - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
}

#[test]
fn cancellation_beyond_the_work_allowed_is_left_undecided() {
    // Finite, but enclosures do not see it within 1e-14 of a double zero of 1e7 roundings' width.
    assert_eq!(verdict("1/(xi^2 - 0.6*xi + 0.09 + 1e-13)"), Verdict::Undecided);
}

#[test]
fn odd_ranges_are_answered() {
    let whole = parsed("exp(-xi^2)").finiteness(&tied(), Interval::WHOLE);
    assert_eq!(whole, Verdict::ProvedFinite);
    let point = Interval::point(0.3).unwrap();
    let at_pole = parsed("1/(xi-0.3)").finiteness(&tied(), point);
    assert_eq!(at_pole, Verdict::NotFinite { at: 0.3, defect: Defect::Infinite });
    let missing = parsed("a").finiteness(&Line::identity(), unit_range());
    assert_eq!(missing, Verdict::NotFinite { at: -1.0, defect: Defect::Undefined });
    for end in [f64::MAX, 1e-310, 5e-324] {
        let range = Interval::new(-end, end).unwrap();
        let verdict = parsed("1/xi").finiteness(&tied(), range);
        assert!(matches!(verdict, Verdict::NotFinite { .. }), "{end:e}: {verdict:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn verdicts_agree_with_values(tree in tree(), samples in prop::collection::vec(-1.0..=1.0_f64, 50)) {
        let expression = parsed(&tree.text());
        match expression.finiteness(&tied(), unit_range()) {
            Verdict::ProvedFinite => {
                for t in samples {
                    prop_assert!(expression.evaluate_at(&tied(), t).is_finite(), "{expression} at {t:e}");
                }
            }
            Verdict::NotFinite { at, defect: Defect::Undefined } => {
                prop_assert!(tree.at(2.0 * at, at).is_nan(), "{expression} at {at:e}");
            }
            Verdict::NotFinite { at, defect: Defect::Infinite } => {
                prop_assert!(tree.at(2.0 * at, at).is_infinite(), "{expression} at {at:e}");
            }
            Verdict::NotFinite { .. } | Verdict::Undecided => {}
        }
    }
}

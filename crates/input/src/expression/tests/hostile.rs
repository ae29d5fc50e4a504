//! Texts that are meant to break the parser.

use std::time::{Duration, Instant};

use proptest::prelude::*;

use super::super::{
    DEPTH_LIMIT, Defect, ErrorReason, Expression, Interval, Line, TEXT_LIMIT, Verdict,
};
use super::{NAMES, parsed, refused, tied, unit_range};

#[test]
fn a_hundred_megabytes_are_refused_unread() {
    let text = "(".repeat(100_000_000);
    let begin = Instant::now();
    let reason = ErrorReason::TooLong { bytes: 100_000_000, limit: TEXT_LIMIT };
    assert_eq!(refused(&text).reason, reason);
    assert!(begin.elapsed() < Duration::from_millis(100));
}

#[test]
fn depth_is_limited_on_a_small_stack() {
    let check = || {
        for unit in ["(", "-", "1^", "abs(", "1<1+1*(", "where(1,1,1<1+1*-2^(", "max(1,1+1*("] {
            let text = unit.repeat(TEXT_LIMIT / unit.len());
            let error = refused(&text);
            assert_eq!(error.reason, ErrorReason::TooDeep { limit: DEPTH_LIMIT }, "{unit}");
        }
    };
    let small = std::thread::Builder::new().stack_size(512 * 1024);
    small.spawn(check).unwrap().join().unwrap();
}

#[test]
fn depth_up_to_the_limit_is_read() {
    let brackets = |depth: usize| format!("{}x{}", "(".repeat(depth), ")".repeat(depth));
    assert_eq!(parsed(&brackets(DEPTH_LIMIT)).evaluate(&[2.0]), 2.0);
    refused(&brackets(DEPTH_LIMIT + 1));
    // Brackets side by side are not nested.
    assert_eq!(parsed(&vec!["(-x^2)"; 5000].join("+")).evaluate(&[1.0]), -5000.0);
    // The deepest stack: five pending values a level.
    let depth = DEPTH_LIMIT / 2;
    let text = format!("{}x{}", "where(1,1,0<x+x*where(1,1,".repeat(depth), "))".repeat(depth));
    assert_eq!(parsed(&text).evaluate(&[1.0]), 1.0);
}

#[test]
fn long_programs_are_checked_in_bounded_time() {
    let begin = Instant::now();
    let terms = vec!["1/abs(x-2*xi+3)"; 4000].join("+");
    let arguments = (0..6000).map(|i| format!("x-{i}")).collect::<Vec<_>>().join(",");
    for text in [terms, format!("max({arguments})")] {
        let expression = parsed(&text);
        expression.finiteness(&tied(), unit_range());
        expression.breakpoints(&tied(), unit_range());
    }
    assert!(begin.elapsed() < Duration::from_secs(60), "{:?}", begin.elapsed());
}

#[test]
fn hostile_ranges_and_lines_are_answered() {
    const INFINITY: f64 = f64::INFINITY;
    let ends = [(INFINITY, INFINITY), (-INFINITY, -INFINITY), (0.0, INFINITY), (-5e-324, 5e-324)];
    let lines = [
        Line::new(&[]),
        Line::new(&[(f64::NAN, 1.0), (INFINITY, -1.0), (0.0, INFINITY)]),
        Line::new(&[(1e308, 1e308), (0.0, 1.0), (0.0, f64::NAN)]),
    ];
    for (lower, upper) in ends {
        let range = Interval::new(lower, upper).unwrap();
        for line in &lines {
            for text in ["abs(x)/floor(xi)", "max(x, xi, a)", "where(x < xi, sqrt(a), tan(xi))"] {
                let expression = parsed(text);
                let verdict = expression.finiteness(line, range);
                let Verdict::NotFinite { at, .. } = verdict else { continue };
                assert!(range.contains(at) || range.lower() == range.upper(), "{text}: {at}");
                assert!(at.is_finite(), "{text}: {at}");
                assert!(expression.breakpoints(line, range).places.is_sorted());
            }
        }
    }
    // Nothing is known of a variable that is not given.
    assert!(matches!(
        parsed("a").finiteness(&lines[0], Interval::WHOLE),
        Verdict::NotFinite { defect: Defect::Undefined, .. }
    ));
}

/// Uses everything there is; the values do not matter.
fn exercise(text: &str) {
    match Expression::parse(text, &NAMES) {
        Ok(expression) => {
            expression.evaluate(&[0.5, f64::NAN]);
            expression.evaluate_with_derivative(&[0.5, f64::INFINITY, -0.0], 1);
            expression.enclose_along(&tied(), unit_range());
        }
        Err(error) => {
            assert!(text.get(error.span.clone()).is_some(), "{text:?}: {:?}", error.span);
            assert!(!error.to_string().is_empty());
            error.help();
            assert!(error.pointed_at(text).contains('^'));
        }
    }
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused(text in any::<String>()) {
        exercise(&text);
    }

    #[test]
    fn any_tokens_are_read_or_refused(
        tokens in prop::collection::vec(
            prop::sample::select(vec![
                "(", ")", ",", "+", "-", "*", "/", "^", "**", "<", ">=", "x", "xi", "2", "1e-3",
                ".5", "1e9", "sin", "max(", "where(", "abs(", "floor(", "pi", " ", "\u{3be}", "@",
            ]),
            0..40,
        ),
    ) {
        exercise(&tokens.concat());
    }
}

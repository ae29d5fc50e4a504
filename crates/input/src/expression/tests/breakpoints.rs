//! Kinks and jumps are found where they are.

use super::super::{Breakpoints, Interval, Line, MOST_BREAKPOINTS};
use super::{parsed, tied, unit_range};

fn found(text: &str) -> Breakpoints {
    parsed(text).breakpoints(&tied(), unit_range())
}

#[test]
fn kinks_and_jumps_are_located_to_rounding() {
    let root = 0.5_f64.sqrt();
    let table: &[(&str, &[f64])] = &[
        ("xi^2", &[]),
        ("abs(xi)", &[0.0]),
        ("abs(xi - 0.3)", &[0.3]),
        ("abs(x - 0.3)", &[0.15]),
        ("abs(a - 2)", &[]),
        ("abs(xi - 1)", &[]),
        ("abs(xi^2 - 0.5)", &[-root, root]),
        ("1e-3*max(0, x-0.002)^1.5", &[0.001]),
        ("min(xi + 0.5, 0.25, 0.5 - xi)", &[-0.25, 0.25]),
        ("max(0, max(0, xi))", &[0.0]),
        ("clamp(xi, -0.1, 0.7)", &[-0.1, 0.7]),
        ("sign(sin(2*pi*xi))", &[-0.5, 0.0, 0.5]),
        ("floor(4*xi)", &[-0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75]),
        ("ceil(2*xi)", &[-0.5, 0.0, 0.5]),
        ("ceil(-2*xi)", &[-0.5, 0.0, 0.5]),
        ("floor(-2*xi)", &[-0.5, 0.0, 0.5]),
        ("where(xi < 0.1, 1, 2)", &[0.1]),
        ("where((xi > -0.2)*(xi <= 0.4), 1, 2)", &[-0.2, 0.4]),
        ("step(exp(xi) - 2)", &[std::f64::consts::LN_2]),
        ("cbrt(xi - 1e-9)", &[1e-9]),
        ("abs(xi - 0.3) + sign(xi - 0.3) + abs(3*xi - 0.9)", &[0.3]),
    ];
    for (text, places) in table {
        let found = found(text);
        assert!(!found.is_cut_short, "{text}");
        assert_eq!(found.places.len(), places.len(), "{text}: {found:?}");
        for (place, expected) in found.places.iter().zip(*places) {
            assert!((place - expected).abs() <= 4e-16, "{text}: {place:e} for {expected:e}");
        }
    }
}

#[test]
fn steps_are_at_the_integer_itself() {
    for text in ["floor(4*xi)", "floor(-4*xi)", "ceil(4*xi)", "ceil(-4*xi)"] {
        assert_eq!(found(text).places, [-0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75], "{text}");
    }
    // Half of the smallest number is zero, of which the ceiling is no step.
    for text in ["ceil(0.5*xi)", "ceil(0.3*xi)", "floor(-0.5*xi)"] {
        assert_eq!(found(text).places, [0.0], "{text}");
    }
}

#[test]
fn a_place_close_to_zero_keeps_its_digits() {
    let place = found("abs(xi - 1e-20)").places[0];
    assert_eq!(place, 1e-20);
}

#[test]
fn many_places_are_all_found_or_the_list_says_so() {
    // sin(k pi (xi + 0.123)) changes sign at xi = j/k - 0.123.
    let found = found("abs(sin(400*pi*(xi + 0.123)))");
    let expected: Vec<f64> = (-400..800)
        .map(|j| f64::from(j) / 400.0 - 0.123)
        .filter(|place| place.abs() < 1.0)
        .collect();
    assert_eq!(found.places.len(), expected.len());
    assert!(found.places.iter().zip(&expected).all(|(u, v)| (u - v).abs() < 1e-14));
    let many = parsed("floor(1e6*xi)").breakpoints(&tied(), unit_range());
    assert!(many.is_cut_short && many.places.len() == MOST_BREAKPOINTS);
    assert!(many.places.is_sorted());
}

#[test]
fn odd_ranges_are_answered() {
    let expression = parsed("abs(xi)");
    let line = Line::new(&[(0.0, 1.0), (0.0, 1.0)]);
    let whole = expression.breakpoints(&line, Interval::WHOLE);
    assert!(whole.places.len() == 1 && whole.places[0] == 0.0, "{whole:?}");
    let point = Interval::point(0.0).unwrap();
    assert_eq!(expression.breakpoints(&line, point), Breakpoints::default());
    assert_eq!(parsed("abs(a)").breakpoints(&line, unit_range()).places, Vec::<f64>::new());
}

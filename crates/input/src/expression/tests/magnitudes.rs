//! Names for magnitudes of variables.

use crate::expression::Expression;

fn radial(text: &str) -> Expression {
    Expression::parse_with_magnitudes(text, &["x", "xi"], &[("r", 0), ("rho", 1)]).unwrap()
}

#[test]
fn a_magnitude_is_the_absolute_value_of_its_variable() {
    for x in [-2.0, -0.3, 0.0, 0.7] {
        let values = [x, 3.0 * x];
        let written = Expression::parse("abs(x)^3 + exp(abs(xi))", &["x", "xi"]).unwrap();
        assert_eq!(radial("r^3 + exp(rho)").evaluate(&values), written.evaluate(&values));
    }
}

#[test]
fn its_square_has_no_kink() {
    use crate::expression::{Interval, Line};
    let line = Line::new(&[(0.0, 1.0), (0.0, 1.0)]);
    let base = Interval::new(-1.0, 1.0).unwrap();
    assert!(radial("r^2 / 2").breakpoints(&line, base).places.is_empty());
    assert_eq!(radial("r / 2").breakpoints(&line, base).places, [0.0]);
}

#[test]
fn it_is_not_known_elsewhere_and_not_a_function() {
    let error = Expression::parse("r^2", &["x"]).unwrap_err();
    assert!(error.to_string().contains("`r` is neither"), "{error}");
    let error = Expression::parse_with_magnitudes("r(2)", &["x"], &[("r", 0)]).unwrap_err();
    assert!(error.to_string().contains("operator"), "{error}");
    let error = Expression::parse_with_magnitudes("q", &["x"], &[("r", 0)]).unwrap_err();
    assert!(error.help().is_some_and(|help| help.contains("x, r,")), "{error}");
}

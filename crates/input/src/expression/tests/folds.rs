//! Inverses of waves applied to those waves: zigzags and saws, by hand.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{parsed, unit_range, value};
use crate::expression::Line;
#[test]
fn folded_waves_are_exact_beside_their_kinks() {
    for offset in [0.0, 1e-15, 1e-9, 1e-3, 1.0] {
        let cases = [
            (format!("asin(sin(pi/2 + {offset}))"), FRAC_PI_2 - offset),
            (format!("asin(sin(-pi/2 - {offset}))"), offset - FRAC_PI_2),
            (format!("asin(sin(5*pi/2 - {offset}))"), FRAC_PI_2 - offset),
            (format!("acos(cos({offset} - 2*pi))"), offset),
            (format!("acos(cos(pi + {offset}))"), PI - offset),
            (format!("atan(tan({offset} + 3*pi))"), offset),
        ];
        for (text, exact) in cases {
            // With a variable: constants are folded as they are written.
            let text = text.replacen("pi", "(pi + 0*x)", 1);
            let found = value(&text);
            assert!((found - exact).abs() < 4e-15, "{text}: {found} {exact}");
        }
    }
}

#[test]
fn slopes_are_those_of_the_zigzag() {
    let zigzag = parsed("asin(sin(3*xi))");
    let line = Line::new(&[(0.0, 1.0), (0.0, 1.0), (0.0, 0.0)]);
    for (xi, slope) in [(0.1, 3.0), (PI / 6.0 + 1e-12, -3.0), (PI / 6.0 - 1e-12, 3.0), (-0.6, -3.0)]
    {
        let (_, found) = zigzag.derivative_along(&line, xi);
        assert_eq!(found, slope, "{xi}");
    }
    let found = zigzag.breakpoints(&line, unit_range());
    assert_eq!(found.places.len(), 2);
    for (place, exact) in found.places.iter().zip([-PI / 6.0, PI / 6.0]) {
        assert!((place - exact).abs() < 1e-15, "{place}");
    }
}

#[test]
fn nested_folds_do_not_explode() {
    let text = format!("{}x{}", "asin(sin(".repeat(30), "))".repeat(30));
    assert!((parsed(&text).evaluate(&[0.3, 0.0, 0.0]) - 0.3).abs() < 1e-14);
}

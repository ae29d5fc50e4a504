//! Values of random expressions are those of the definition.

use proptest::prelude::*;

use super::parsed;
use super::trees::tree;
use crate::expression::Interval;

/// Equal, with one zero and one NaN.
fn same(u: f64, v: f64) -> bool {
    u == v || (u.is_nan() && v.is_nan())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn values_are_those_of_the_definition(tree in tree(), x in -3.0..3.0_f64, xi in -1.0..1.0_f64) {
        prop_assume!(!tree.is_folded());
        let expected = tree.at(x, xi);
        for text in [tree.text(), tree.full_text()] {
            let expression = parsed(&text);
            let found = expression.evaluate(&[x, xi]);
            // Waves of the system may end in another digit: such a value lies within what is enclosed at the place.
            let enclosed = || {
                let place = [x, xi].map(|at| Interval::point(at).unwrap());
                expression.enclose(&place).interval.contains(expected)
            };
            let mut words = text.split(|letter: char| !letter.is_alphanumeric());
            let has_waves = words.any(|word| word == "sin" || word == "cos");
            let is_same = same(found, expected) || has_waves && enclosed();
            prop_assert!(is_same, "{text}: {found} instead of {expected}");
        }
    }
}

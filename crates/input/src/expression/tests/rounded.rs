//! Numbers computed from numbers keep what rounding took from them.

use super::{parsed, unit_range};

/// Formulas of numbers and their exact values, from the numbers of the machine next to what is written, as the sum of two: `fractions` of Python 3.12.
const VALUES: [(&str, f64, f64); 9] = [
    ("1e6 + 0.1", 1_000_000.1, 2.328_306_991_650_208_6e-11),
    ("1e8 + 0.1 - 1e8", 0.1, 0.0),
    ("1/3", 0.333_333_333_333_333_3, 1.850_371_707_708_594e-17),
    ("0.1*0.3", 0.03, 1.665_334_536_937_734_8e-18),
    ("2*0.8", 1.6, 0.0),
    ("(1e8 + 0.1 - 1e8)*3 - 0.3", 2.775_557_561_562_891_4e-17, 0.0),
    ("0.7/(0.1 + 0.2)", 2.333_333_333_333_333, 1.850_371_707_708_595_7e-17),
    ("-(1e6 - 0.3)/7", -142_857.1, 5.820_764_505_313_849e-12),
    ("2^10 - 1024", 0.0, 0.0),
];

#[test]
fn enclosures_contain_exact_values() {
    for (text, value, rest) in VALUES {
        for text in [text.to_owned(), format!("{text} + 0*x"), format!("0*x - (-({text}))")] {
            let range = parsed(&text).enclose(&[unit_range(); 3]).interval;
            let [below, above] = [range.lower() - value, range.upper() - value];
            assert!(below <= rest && rest <= above, "{text}: {range:?}");
        }
    }
    // What is exact stays a number.
    for text in ["2*20", "2^3 + 1", "sqrt(4)", "floor(2.5)", "3/4", "max(1, 2) - 0.5"] {
        assert!(parsed(text).enclose(&[]).interval.is_point(), "{text}");
    }
}

#[test]
fn a_constant_taken_out_leaves_its_rounding() {
    for (text, value, rest) in VALUES {
        // Of the formula with a variable that is 0, and of the same under factors.
        for (text, factor) in [(format!("x^2 + {text}"), 1.0), (format!("4*(({text}) - x^2)"), 4.0)]
        {
            let (left, [sum, _]) = parsed(&text).without_constant();
            let zero = unit_range().times(super::Interval::ZERO).0;
            let range = left.enclose(&[zero; 3]).interval;
            let [below, above] =
                [range.lower(), range.upper()].map(|end| end + (sum - factor * value));
            assert!(below <= factor * rest && factor * rest <= above, "{text}: {sum} {range:?}");
        }
    }
    // Quotients that come out even leave nothing.
    let (left, [sum, _]) = parsed("-(3 - (x^2 + 40)/40)").without_constant();
    assert_eq!(
        (sum, left.operations.len()),
        (-2.0, parsed("-(3 - (x^2 + 40)/40)").operations.len())
    );
    let (left, [sum, _]) = parsed("1e6 + x^2 + 0.1").without_constant();
    assert_eq!((sum, left.evaluate(&[0.0])), (1_000_000.1, 2.328_306_991_650_208_6e-11));
}

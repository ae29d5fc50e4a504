//! What is proved even or odd is so, and what is put together from mirror images is proved.

use proptest::prelude::*;

use super::super::{Expression, Line, Reflection};
use super::trees::{Tree, tree};
use super::{parsed, tied};

const EVEN: Reflection = Reflection { is_even: true, is_odd: false };
const ODD: Reflection = Reflection { is_even: false, is_odd: true };
const NEITHER: Reflection = Reflection { is_even: false, is_odd: false };

#[test]
fn the_form_shows_it() {
    for (text, expected) in [
        ("0", Reflection::OF_ZERO),
        ("x - x", Reflection::OF_ZERO),
        ("2.5*a", EVEN),
        ("x^2/(2*20)", EVEN),
        ("x*xi + cos(3*x)", EVEN),
        ("(x - 1)^2 + (x + 1)^2", EVEN),
        ("exp(x) + 1 + exp(-x)", EVEN),
        ("(1 - x)*(1 + x)", EVEN),
        ("max(x, -x)", EVEN),
        ("min(0, x - 0.5) + min(0, -x - 0.5)", EVEN),
        ("max(x - 0.5, min(0.1, 0.2), -0.5 - x)", EVEN),
        ("where(x < 0, -x, x)", EVEN),
        ("where(abs(x) <= 0.3, x^2, 0.09 + abs(x - 0.3) + abs(0.3 + x))", EVEN),
        ("where(x^2 + 1 > 0, 1, x)", EVEN),
        ("sign(x)*x^3", EVEN),
        ("abs(sin(x))^1.5", EVEN),
        ("(-x)^4 + hypot(x, 1)", EVEN),
        ("1e-9*exp(-((x - 0.3)/1e-6)^2)", NEITHER),
        ("x^2 + 1e-9*exp(-((x - 0.3)/1e-6)^2)", NEITHER),
        ("x + abs(x)", NEITHER),
        ("floor(x)", NEITHER),
        ("step(x)", NEITHER),
        ("where(x > 0.3, 1, 0)", NEITHER),
        ("abs(x - 0.3) + abs(x + 0.31)", NEITHER),
        ("x", ODD),
        ("sin(x) + x*abs(x)^0.5 - x^5/3", ODD),
        ("1/x", ODD),
        ("max(x - 0.5, 0) + min(x + 0.5, 0)", ODD),
        ("exp(x) - exp(-x)", ODD),
        ("atan(x)/cosh(x)", ODD),
        ("x^2 + x", NEITHER),
        // Decided by values that round to nothing: not taken for what they are without rounding.
        ("where(exp(1e4*x) > 0, 1, 2)", NEITHER),
    ] {
        assert_eq!(parsed(text).reflection(&tied()), expected, "{text}");
    }
    let moved = Line::new(&[(0.1, 1.0)]);
    let square = Expression::parse("x^2", &["x"]).unwrap();
    assert_eq!(square.reflection(&moved), NEITHER);
    assert_eq!(square.reflection(&Line::new(&[(0.0, -3.0)])), EVEN);
}

#[test]
fn long_formulas_end() {
    let sum: String = (1..3000).map(|k| format!("cos({k}*x) + ")).collect();
    let found = parsed(&format!("{sum}1")).reflection(&tied());
    assert_eq!(found, NEITHER, "more than there is room for is not proved");
    let sum: String = (1..200).map(|k| format!("cos({k}*x) + ")).collect();
    assert_eq!(parsed(&format!("{sum}1")).reflection(&tied()), EVEN);
}

fn mirrored(tree: &Tree) -> Tree {
    let boxed = |u: &Tree| Box::new(mirrored(u));
    match tree {
        Tree::Number(value) => Tree::Number(*value),
        Tree::X => Tree::Negate(Box::new(Tree::X)),
        Tree::Xi => Tree::Negate(Box::new(Tree::Xi)),
        Tree::Negate(u) => Tree::Negate(boxed(u)),
        Tree::Call(call, u) => Tree::Call(*call, boxed(u)),
        Tree::Infix(name, u, v) => Tree::Infix(name, boxed(u), boxed(v)),
        Tree::Pair(name, u, v) => Tree::Pair(name, boxed(u), boxed(v)),
        Tree::Where(u, v, w) => Tree::Where(boxed(u), boxed(v), boxed(w)),
    }
}

proptest! {
    #[test]
    fn sums_with_the_mirror_image_are_even(tree in tree()) {
        let (one, other) = (tree.text(), mirrored(&tree).text());
        let even = parsed(&format!("({one}) + ({other})"));
        prop_assert!(even.reflection(&tied()).is_even, "{even}");
        let odd = parsed(&format!("({one}) - ({other})"));
        prop_assert!(odd.reflection(&tied()).is_odd, "{odd}");
    }

    #[test]
    fn what_is_proved_is_so(tree in tree(), t in 0.0..1.0f64) {
        let expression = parsed(&tree.text());
        let Reflection { is_even, is_odd } = expression.reflection(&tied());
        let (here, there) = (tree.at(2.0 * t, t), tree.at(-2.0 * t, -t));
        if here.is_finite() && there.is_finite() {
            let near = |value: f64| (there - value).abs() <= 1e-9 * (1.0 + here.abs());
            prop_assert!(!is_even || near(here), "{expression} at {t}: {here}, {there}");
            prop_assert!(!is_odd || near(-here), "{expression} at {t}: {here}, {there}");
        }
    }
}

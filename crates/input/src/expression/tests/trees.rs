//! Random expressions with an evaluator of their own, written without the code under test.

use proptest::prelude::*;

/// A random expression in `x` and `xi`.
#[derive(Debug, Clone)]
pub(super) enum Tree {
    Number(f64),
    X,
    Xi,
    Negate(Box<Tree>),
    Call(usize, Box<Tree>),
    Infix(&'static str, Box<Tree>, Box<Tree>),
    Pair(&'static str, Box<Tree>, Box<Tree>),
    Where(Box<Tree>, Box<Tree>, Box<Tree>),
}

type Named = (&'static str, fn(f64) -> f64);

const CALLS: &[Named] = &[
    ("sqrt", f64::sqrt),
    ("cbrt", f64::cbrt),
    ("exp", f64::exp),
    ("ln", f64::ln),
    ("log10", f64::log10),
    ("log1p", f64::ln_1p),
    ("expm1", f64::exp_m1),
    ("sin", f64::sin),
    ("cos", f64::cos),
    ("tan", f64::tan),
    ("asin", f64::asin),
    ("acos", f64::acos),
    ("atan", f64::atan),
    ("sinh", f64::sinh),
    ("cosh", f64::cosh),
    ("tanh", f64::tanh),
    ("abs", f64::abs),
    ("floor", f64::floor),
    ("ceil", f64::ceil),
];

const INFIX: &[&str] = &["+", "-", "*", "/", "^", "<", "<=", ">", ">="];
const PAIRS: &[&str] = &["min", "max", "hypot", "atan2", "pow"];

pub(super) fn tree() -> impl Strategy<Value = Tree> {
    let numbers = prop::sample::select(vec![0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 1e-3, 0.3, 700.0]);
    let leaf = prop_oneof![numbers.prop_map(Tree::Number), Just(Tree::X), Just(Tree::Xi)];
    leaf.prop_recursive(6, 40, 3, |inner| {
        let boxed = inner.prop_map(Box::new).boxed();
        let (b, c) = (boxed.clone(), boxed.clone());
        prop_oneof![
            1 => b.clone().prop_map(Tree::Negate),
            3 => (0..CALLS.len(), b.clone()).prop_map(|(call, u)| Tree::Call(call, u)),
            5 => (prop::sample::select(INFIX), b.clone(), c.clone())
                .prop_map(|(sign, u, v)| Tree::Infix(sign, u, v)),
            2 => (prop::sample::select(PAIRS), b.clone(), c.clone())
                .prop_map(|(name, u, v)| Tree::Pair(name, u, v)),
            1 => (b, c, boxed).prop_map(|(u, v, w)| Tree::Where(u, v, w)),
        ]
    })
}

impl Tree {
    fn is_constant(&self) -> bool {
        match self {
            Tree::Number(_) => true,
            Tree::X | Tree::Xi => false,
            Tree::Negate(u) | Tree::Call(_, u) => u.is_constant() && self.at(0.0, 0.0).is_finite(),
            Tree::Infix(_, u, v) | Tree::Pair(_, u, v) => {
                u.is_constant() && v.is_constant() && self.at(0.0, 0.0).is_finite()
            }
            Tree::Where(..) => false,
        }
    }

    /// Whether an inverse is applied to its wave anywhere: that is a zigzag or a saw without the digits that the definition loses, see the tests of folds.
    pub(super) fn is_folded(&self) -> bool {
        let inverse = |call: usize| match CALLS[call].0 {
            "asin" => "sin",
            "acos" => "cos",
            "atan" => "tan",
            _ => "",
        };
        match self {
            Tree::Number(_) | Tree::X | Tree::Xi => false,
            Tree::Call(call, u) => {
                matches!(&**u, Tree::Call(inner, _) if CALLS[*inner].0 == inverse(*call))
                    || u.is_folded()
            }
            Tree::Negate(u) => u.is_folded(),
            Tree::Where(u, v, w) => u.is_folded() || v.is_folded() || w.is_folded(),
            Tree::Infix(_, u, v) | Tree::Pair(_, u, v) => u.is_folded() || v.is_folded(),
        }
    }

    /// The value, straight from the definition.
    pub(super) fn at(&self, x: f64, xi: f64) -> f64 {
        match self {
            Tree::Number(value) => *value,
            Tree::X => x,
            Tree::Xi => xi,
            Tree::Negate(u) => -u.at(x, xi),
            Tree::Call(call, u) => CALLS[*call].1(u.at(x, xi)),
            Tree::Where(u, v, w) => match u.at(x, xi) {
                condition if condition.is_nan() => f64::NAN,
                0.0 => w.at(x, xi),
                _ => v.at(x, xi),
            },
            Tree::Infix(name, u, v) | Tree::Pair(name, u, v) => {
                let is_square = v.is_constant() && v.at(x, xi) == 2.0;
                let (u, v) = (u.at(x, xi), v.at(x, xi));
                if u.is_nan() || v.is_nan() {
                    return f64::NAN;
                }
                match *name {
                    "+" => u + v,
                    "-" => u - v,
                    "*" => u * v,
                    "/" if v == 0.0 => u / v.abs(),
                    "/" => u / v,
                    "^" | "pow" if is_square => u * u,
                    "^" | "pow" if u == 0.0 => u.abs().powf(v),
                    "^" | "pow" => u.powf(v),
                    "<" => f64::from(u8::from(u < v)),
                    "<=" => f64::from(u8::from(u <= v)),
                    ">" => f64::from(u8::from(u > v)),
                    ">=" => f64::from(u8::from(u >= v)),
                    "min" => {
                        if v < u {
                            v
                        } else {
                            u
                        }
                    }
                    "max" => {
                        if v > u {
                            v
                        } else {
                            u
                        }
                    }
                    "hypot" => u.hypot(v),
                    _ => u.atan2(v),
                }
            }
        }
    }

    fn level(&self) -> u8 {
        match self {
            Tree::Infix("<" | "<=" | ">" | ">=", ..) => 1,
            Tree::Infix("+" | "-", ..) => 2,
            Tree::Infix("*" | "/", ..) => 3,
            Tree::Negate(_) => 4,
            Tree::Infix(..) => 5,
            _ => 6,
        }
    }

    fn bracketed(&self, least: u8) -> String {
        let text = self.text();
        if self.level() < least { format!("({text})") } else { text }
    }

    /// The text with no more brackets than needed.
    pub(super) fn text(&self) -> String {
        match self {
            Tree::Number(value) => format!("{value:?}"),
            Tree::X => "x".into(),
            Tree::Xi => "xi".into(),
            Tree::Negate(u) => format!("-{}", u.bracketed(4)),
            Tree::Call(call, u) => format!("{}({})", CALLS[*call].0, u.text()),
            Tree::Pair(name, u, v) => format!("{name}({}, {})", u.text(), v.text()),
            Tree::Where(u, v, w) => format!("where({},{},{})", u.text(), v.text(), w.text()),
            Tree::Infix("^", u, v) => format!("{}^{}", u.bracketed(6), v.bracketed(4)),
            Tree::Infix(sign, u, v) => {
                let level = self.level();
                let left = if level == 1 { 2 } else { level };
                format!("{} {sign} {}", u.bracketed(left), v.bracketed(level + 1))
            }
        }
    }

    /// The text with brackets around everything.
    pub(super) fn full_text(&self) -> String {
        match self {
            Tree::Negate(u) => format!("(-({}))", u.full_text()),
            Tree::Infix(sign, u, v) => format!("(({}){sign}({}))", u.full_text(), v.full_text()),
            Tree::Pair(name, u, v) => format!("{name}(({}),({}))", u.full_text(), v.full_text()),
            Tree::Call(call, u) => format!("{}(({}))", CALLS[*call].0, u.full_text()),
            _ => self.text(),
        }
    }
}

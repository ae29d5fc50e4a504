//! The functions and operators an expression can hold, and their values.

use super::error::Arity;
use super::waves::{cosine, sine};

/// One argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Unary {
    Negate,
    Square,
    Sqrt,
    Cbrt,
    Exp,
    Expm1,
    Ln,
    Log10,
    Log2,
    Log1p,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
    Abs,
    Sign,
    Floor,
    Ceil,
    Step,
}

/// Two arguments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Minimum,
    Maximum,
    Hypot,
    Atan2,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
}

/// What a name before a bracket stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Function {
    One(Unary),
    Two(Binary),
    /// A function of two arguments taken from left to right over two or more.
    Many(Binary),
    Clamp,
    Where,
}

impl Function {
    pub(super) fn arity(self) -> Arity {
        match self {
            Function::One(_) => Arity::Exactly(1),
            Function::Two(_) => Arity::Exactly(2),
            Function::Many(_) => Arity::AtLeast(2),
            Function::Clamp | Function::Where => Arity::Exactly(3),
        }
    }

    pub(super) fn named(name: &str) -> Option<Function> {
        FUNCTIONS.iter().find(|(known, _)| *known == name).map(|(_, function)| *function)
    }
}

pub(super) const FUNCTIONS: &[(&str, Function)] = &[
    ("sqrt", Function::One(Unary::Sqrt)),
    ("cbrt", Function::One(Unary::Cbrt)),
    ("exp", Function::One(Unary::Exp)),
    ("expm1", Function::One(Unary::Expm1)),
    ("ln", Function::One(Unary::Ln)),
    ("log", Function::One(Unary::Ln)),
    ("log10", Function::One(Unary::Log10)),
    ("log2", Function::One(Unary::Log2)),
    ("log1p", Function::One(Unary::Log1p)),
    ("ln_1p", Function::One(Unary::Log1p)),
    ("sin", Function::One(Unary::Sin)),
    ("cos", Function::One(Unary::Cos)),
    ("tan", Function::One(Unary::Tan)),
    ("asin", Function::One(Unary::Asin)),
    ("acos", Function::One(Unary::Acos)),
    ("atan", Function::One(Unary::Atan)),
    ("sinh", Function::One(Unary::Sinh)),
    ("cosh", Function::One(Unary::Cosh)),
    ("tanh", Function::One(Unary::Tanh)),
    ("asinh", Function::One(Unary::Asinh)),
    ("acosh", Function::One(Unary::Acosh)),
    ("atanh", Function::One(Unary::Atanh)),
    ("abs", Function::One(Unary::Abs)),
    ("sign", Function::One(Unary::Sign)),
    ("floor", Function::One(Unary::Floor)),
    ("ceil", Function::One(Unary::Ceil)),
    ("step", Function::One(Unary::Step)),
    ("heaviside", Function::One(Unary::Step)),
    ("hypot", Function::Two(Binary::Hypot)),
    ("atan2", Function::Two(Binary::Atan2)),
    ("pow", Function::Two(Binary::Power)),
    ("min", Function::Many(Binary::Minimum)),
    ("max", Function::Many(Binary::Maximum)),
    ("clamp", Function::Clamp),
    ("where", Function::Where),
];

pub(super) const CONSTANTS: &[(&str, f64)] =
    &[("pi", std::f64::consts::PI), ("e", std::f64::consts::E), ("tau", std::f64::consts::TAU)];

impl Unary {
    pub(super) fn value(self, u: f64) -> f64 {
        match self {
            Unary::Negate => -u,
            Unary::Square => u * u,
            Unary::Sqrt => u.sqrt(),
            Unary::Cbrt => u.cbrt(),
            Unary::Exp => u.exp(),
            Unary::Expm1 => u.exp_m1(),
            Unary::Ln => u.ln(),
            Unary::Log10 => u.log10(),
            Unary::Log2 => u.log2(),
            Unary::Log1p => u.ln_1p(),
            Unary::Sin => sine(u),
            Unary::Cos => cosine(u),
            Unary::Tan => u.tan(),
            Unary::Asin => u.asin(),
            Unary::Acos => u.acos(),
            Unary::Atan => u.atan(),
            Unary::Sinh => u.sinh(),
            Unary::Cosh => u.cosh(),
            Unary::Tanh => u.tanh(),
            Unary::Asinh => inverse_hyperbolic_sine(u),
            Unary::Acosh => inverse_hyperbolic_cosine(u),
            Unary::Atanh => inverse_hyperbolic_tangent(u),
            Unary::Abs => u.abs(),
            Unary::Sign => sign(u),
            Unary::Floor => u.floor(),
            Unary::Ceil => u.ceil(),
            Unary::Step if u.is_nan() => u,
            Unary::Step => f64::from(u >= 0.0),
        }
    }
}

impl Binary {
    /// Whether it goes from one value to another where its arguments are equal.
    pub(super) fn is_switch(self) -> bool {
        use Binary::*;
        matches!(self, Minimum | Maximum | Less | LessEqual | Greater | GreaterEqual)
    }

    /// The value; NaN whenever an argument is, unlike the IEEE minimum, maximum, power and
    /// hypotenuse, so that nothing undefined is ever hidden.
    pub(super) fn value(self, u: f64, v: f64) -> f64 {
        match self {
            // Of these IEEE arithmetic makes it.
            Binary::Add => u + v,
            Binary::Subtract => u - v,
            Binary::Multiply => u * v,
            // There is one zero: -0 is made +0 where the sign would choose between infinities.
            Binary::Divide => u / (v + 0.0),
            _ if u.is_nan() || v.is_nan() => f64::NAN,
            Binary::Power => (u + 0.0).powf(v),
            Binary::Minimum => u.min(v),
            Binary::Maximum => u.max(v),
            Binary::Hypot => u.hypot(v),
            Binary::Atan2 => u.atan2(v),
            Binary::Less => f64::from(u < v),
            Binary::LessEqual => f64::from(u <= v),
            Binary::Greater => f64::from(u > v),
            Binary::GreaterEqual => f64::from(u >= v),
        }
    }
}

fn sign(u: f64) -> f64 {
    if u == 0.0 || u.is_nan() { u } else { u.signum() }
}

// The standard library's inverse hyperbolic functions lose digits near their zeros or poles on
// some versions; these forms keep all but the last few bits everywhere.

fn inverse_hyperbolic_sine(u: f64) -> f64 {
    let size = u.abs();
    if size > 1e150 {
        return (size.ln() + std::f64::consts::LN_2).copysign(u);
    }
    let square = size * size;
    (size + square / (1.0 + (1.0 + square).sqrt())).ln_1p().copysign(u)
}

fn inverse_hyperbolic_cosine(u: f64) -> f64 {
    if u < 1.0 {
        return f64::NAN;
    }
    if u > 1e150 {
        return u.ln() + std::f64::consts::LN_2;
    }
    let excess = u - 1.0;
    (excess + (excess * (u + 1.0)).sqrt()).ln_1p()
}

fn inverse_hyperbolic_tangent(u: f64) -> f64 {
    let size = u.abs();
    (0.5 * (2.0 * size / (1.0 - size)).ln_1p()).copysign(u)
}

/// The names of all functions that an expression can call.
pub fn function_names() -> impl Iterator<Item = &'static str> {
    FUNCTIONS.iter().map(|(name, _)| *name)
}

//! Profile expressions: formulas for the base of a punch, such as `x^2/(2*0.8)` or `abs(xi)`.
//!
//! A text is compiled once ([`Expression::parse`]) to a flat program, which is then evaluated
//! without allocation (but for one of more than 15 intermediate values), with its derivative, over whole intervals, and checked to be finite and
//! searched for kinks before it is put into an equation.
//!
//! ```
//! use shtaerman_input::expression::{Expression, Interval, Line, Verdict};
//!
//! // A parabola with a flat of half-width 2 mm: x (m), base (m).
//! let base = Expression::parse("max(0, abs(x) - 0.002)^2 / (2*0.8)", &["x"])?;
//! assert_eq!(base.evaluate(&[0.001]), 0.0);
//! assert!((base.evaluate(&[0.012]) - 6.25e-5).abs() < 1e-18);
//! assert!((base.evaluate_with_derivative(&[0.012], 0).1 - 0.0125).abs() < 1e-15);
//!
//! // On a punch of half-width 20 mm the parameter is xi = x/a.
//! let line = Line::new(&[(0.0, 0.02)]);
//! let range = Interval::new(-1.0, 1.0).unwrap();
//! assert_eq!(base.finiteness(&line, range), Verdict::ProvedFinite);
//! let kinks = base.breakpoints(&line, range).places;
//! assert!(kinks.iter().zip([-0.1, 0.0, 0.1]).all(|(kink, place)| (kink - place).abs() < 1e-15));
//!
//! let error = Expression::parse("2x", &["x"]).unwrap_err();
//! assert_eq!(error.help().as_deref(), Some("write 2*x"));
//! # Ok::<(), shtaerman_input::expression::ExpressionError>(())
//! ```
//!
//! # The language
//!
//! From loosest to tightest:
//!
//! | written | meaning |
//! |---|---|
//! | `a < b`, `<=`, `>`, `>=` | 1 where it holds, 0 elsewhere; not chained |
//! | `a + b`, `a - b` | from left to right |
//! | `a * b`, `a / b` | from left to right; products must be written out: `2*x`, not `2x` |
//! | `-a`, `+a` | `-2^2` is -4 |
//! | `a ^ b`, `a ** b` | from right to left; `2^-3` is 1/8 |
//!
//! Numbers are `12`, `1.5`, `.5`, `5.`, `1e-3`; constants `pi`, `e`, `tau` (a variable of the same
//! name takes precedence). The functions:
//!
//! | functions | |
//! |---|---|
//! | `sqrt cbrt hypot(a,b) pow(a,b)` | roots and powers |
//! | `exp expm1 ln log log10 log2 log1p ln_1p` | `log` is the natural logarithm, as `ln` |
//! | `sin cos tan asin acos atan atan2(y,x)` | angles in radians |
//! | `sinh cosh tanh asinh acosh atanh` | |
//! | `abs sign floor ceil` | `sign(0)` is 0 |
//! | `step heaviside` | the same: 1 for arguments >= 0, else 0 |
//! | `min(a,b,...) max(a,b,...)` | two or more arguments |
//! | `clamp(x,low,high)` | `min(max(x,low),high)` |
//! | `where(condition,a,b)` | `a` where the condition is not 0, else `b` |
//!
//! Values follow IEEE arithmetic (`1/0` is `inf`) with two exceptions that keep faults visible: an
//! undefined argument (NaN) makes any function undefined, also `min`, `max` and powers, and only
//! the branch of `where` that is not taken is ignored; and there is one zero only, so that `1/x`
//! is `+inf` at 0 whatever the sign bit.

mod breakpoint;
mod compiled;
mod constant;
mod derivative;
mod duals;
mod enclose;
mod enclosures;
mod error;
mod evaluate;
mod finite;
mod float;
mod folding;
mod formula;
mod function;
mod interval;
mod intervals;
mod limits;
mod line;
mod parse;
mod periodic;
mod program;
mod reflection;
mod rise;
mod taylor;
mod terms;
mod token;
mod value;
mod waves;

#[cfg(test)]
mod tests;

pub use breakpoint::{Breakpoints, MOST_BREAKPOINTS};
pub use constant::decimal_rounding;
pub use enclose::Enclosure;
pub use error::{Arity, ErrorReason, ExpressionError};
pub use finite::{Defect, SAMPLES, Verdict};
pub use folding::remainder_of_sum;
pub use formula::Expression;
pub use function::function_names;
pub use interval::Interval;
pub use limits::{DEPTH_LIMIT, TEXT_LIMIT};
pub use line::Line;
pub use reflection::Reflection;
pub use taylor::{Scale, Series, Taylor};

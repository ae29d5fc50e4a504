//! Sinc collocation on panels between the bends of the base: few zones, on any ground.

mod ends;
mod equation;
mod field;
mod nodes;
mod whole;

pub(super) use equation::{Collocation, Effort};
pub(super) use field::SincField;

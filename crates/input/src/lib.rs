//! What a user writes, read with care: quantities with units, formulas, documents and columns of numbers.
//!
//! The crate knows no problem, no method and no answer. It turns text into values, and a fault into a message that says where the fault is, what is wrong and
//! what would be right.
//!
//! | module | reads | example |
//! |---|---|---|
//! | [`quantity`] | a number with its unit, into SI | `5 mm`, `0.1 µm/MPa` |
//! | [`expression`] | a formula, with its derivative, its enclosure over an interval and its kinks | `x^2 / (2*0.8)` |
//! | [`document`] | a TOML file whose values know their lines, and overrides of it | `--set load.force="1 MN/m"` |
//! | [`columns`] | two columns of numbers, as instruments write them | a stylus trace |
//!
//! [`nearest`] finds the known name that a misspelt one was meant to be, [`legible`] shows what a user wrote in a message.

pub mod columns;
pub mod document;
pub mod expression;
mod legible;
mod nearest;
pub mod quantity;

pub use legible::{legible, shortened};
pub use nearest::nearest;

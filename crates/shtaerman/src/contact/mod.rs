//! The answer: settlement, tilt, force, moment, pressure.

mod balance;
mod bilateral;
mod extremes;
mod solved;
mod surface;
mod warning;

pub use solved::{Contact, Method, Stiffness};
pub use warning::{Warning, WarningCode};

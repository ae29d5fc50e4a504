//! The answer: settlement, tilt, force, moment, pressure.

mod bilateral;
mod contact;
mod extremes;
mod surface;
mod warning;

pub use contact::{Contact, Method, Stiffness};
pub use warning::{Warning, WarningCode};

//! The base of the punch.

mod base;
pub(crate) mod beside;
mod cubic;
mod enclosure;
mod evenness;
mod function;
mod level;
mod measured;
mod resolution;
mod resolved;
mod side_by_side;
mod spline;
mod trace;
mod waiting;

#[cfg(test)]
mod tests;

pub use base::{Profile, VARIABLES};
pub use measured::{CsvOptions, read_csv};
pub use resolved::Resolution;
pub use shtaerman_input::columns::{Column, Dialect, HeaderUnit};
pub use trace::{Place, Trace, TraceOptions};

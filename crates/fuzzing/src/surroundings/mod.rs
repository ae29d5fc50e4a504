//! The program as a process: signals at any moment, and surroundings in which nothing goes well.

mod faults;
mod program;
mod signals;

pub(crate) use faults::case as fault;
pub use program::{RUN_AS_PROGRAM, set_program};
pub(crate) use signals::case as signal;

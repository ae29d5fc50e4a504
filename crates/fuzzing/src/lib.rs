//! Random and broken input of every kind, put through the readers, the arguments and the solvers.
//!
//! Each case depends on its seed and number alone. It is made by a generator that knows how such input is built, and half of the texts are then broken.
//! A case fails where the code panics, an answer holds what is not a number or does not match the schema, a message is not one printable line, or an
//! identity of the target (an enclosure holds the value, what was written is read back) is broken.
//!
//! ```text
//! cargo run --release -p fuzzing -- expressions 1 100000
//! ```

mod broken;
mod check;
mod files;
mod page;
mod run;
mod surroundings;
mod targets;
mod written;

pub use page::page;
use shtaerman_random::Random;

pub use run::{Fault, Report, forget_memory, memory, run};
pub use surroundings::{RUN_AS_PROGRAM, set_program};
pub use targets::Target;

//! The inverse way round: which force, roughness, crown or profile gives what is wanted.
//!
//! Each value is bracketed first and then narrowed, every trial a complete [`Problem::solve`](crate::Problem::solve); where no value gives what
//! is wanted, the error says what can be had. The one direct case is the [`profile`](prescribed_pressure) under a prescribed pressure, which
//! the equation gives without a solve.

mod bracket;
mod crown;
mod force;
mod goal;
mod prescribed;
mod roughness;
mod search;

pub use crown::{Crown, Crowned, crown};
pub use force::force;
pub use goal::Goal;
pub use prescribed::{Normalisation, Shaped, prescribed_pressure};
pub use roughness::roughness;
pub use search::Found;

pub use crate::error::InverseError;

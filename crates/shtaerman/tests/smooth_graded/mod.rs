//! Smooth punches on graded ground against closed forms, the kernel itself, limits, and the rough problem.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

mod disk;
mod kinks;
mod limits;
mod narrow;
mod plane;
mod refusals;
mod sensitivities;
mod stated;
mod support;
mod traces;
mod zones;

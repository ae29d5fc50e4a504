//! Smooth contact of a circular punch against closed forms, with independent quadratures, and invariants.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

mod closed_forms;
mod invariants;
mod refusals;
mod rings;
mod support;
mod tilted;

//! Stresses below the surface against closed forms, invariants and independent sums.
#![expect(clippy::unwrap_used, reason = "helpers outside of test functions fail by panicking")]

mod closed_forms;
mod contacts;
mod invariants;
mod peaks;
mod periodic;
mod refusals;
mod support;

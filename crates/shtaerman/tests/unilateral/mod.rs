//! Unilateral contact against closed forms, golden numbers, invariants and its own conditions.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

mod closed_forms;
mod conditions;
mod hidden;
mod many_zones;
mod random;
mod refusals;
mod small_zones;
mod steps;
mod support;
mod survey;
mod traces;

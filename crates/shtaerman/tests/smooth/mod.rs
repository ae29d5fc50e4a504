//! Smooth contact against closed forms, an independent quadrature of its equation, and invariants.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

mod accuracy;
mod bent;
mod born;
mod conditions;
mod hidden;
mod light;
mod one_punch;
mod pair;
mod periodic;
mod powers;
mod refusals;
mod stated;
mod support;
mod survey;
mod waves;

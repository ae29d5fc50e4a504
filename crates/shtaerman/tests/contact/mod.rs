//! Solved contacts against closed forms, invariants and an independent quadrature.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

mod support;

mod closures;
mod equilibrium;
mod heights;
mod hostile;
mod invariance;
mod layer_limit;
mod many_panels;
mod measured;
mod pairs;
mod random;
mod references;
mod resolutions;
mod smooth_limit;
mod surface;
mod sweep;
mod symmetry;
mod time_limit;
#[path = "../../../input/src/expression/tests/trees.rs"]
#[allow(dead_code, reason = "the tests of expressions use the rest")]
mod trees;
mod units;
mod views;

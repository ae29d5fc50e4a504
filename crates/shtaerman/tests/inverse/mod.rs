//! Inverse problems, sensitivities and relative settlements against closed forms, golden numbers and invariants.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

mod crown;
mod datum;
mod force_and_roughness;
mod geometries;
mod graded_widths;
mod hostile;
mod long_traces;
mod prescribed;
mod sensitivities;
mod support;
mod tangent;

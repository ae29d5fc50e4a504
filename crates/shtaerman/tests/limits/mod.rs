//! The limits of small and large roughness: continuous, monotone, and the known forms.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

mod corners;
mod edges;
mod interior;
mod monotone;
mod support;

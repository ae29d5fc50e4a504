//! Kernels 2 and 3, the limit of kernel 2 and its companion: relations and solutions against mpmath and against each other.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]
#![allow(clippy::approx_constant, reason = "angles near pi, not pi")]
#![allow(unreachable_pub, reason = "modules of a test")]

mod expansions;
mod limits;
mod reference;
mod relations;
mod solutions;

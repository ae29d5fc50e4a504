//! All tests of the crate but those within it, in one program: `cargo test -p fredholm --test all power::` runs those of one file.

mod audit;
mod bounds;
mod collocation_invariants;
mod collocation_limits;
mod collocation_references;
mod common;
mod computed_relation;
mod conformance;
mod conjugate;
mod first_kind;
mod kernels_logarithmic;
mod logarithm;
mod macdonald;
mod macdonald_half_line;
mod methods;
mod own_kernel;
mod panels;
mod power;
mod regularity;
mod structured;
mod transfer;
mod weber_sonine;
mod wrappers;
mod yukawa;

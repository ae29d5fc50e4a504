//! Pairs, rows and disks, and layers that bend, against closed forms, other methods and invariants.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

mod bent;
mod crests;
mod disk;
mod disk_panels;
mod graded;
mod graded_panels;
mod influence;
mod layered;
mod layered_audit;
mod pair;
mod power;
mod random;
mod reached;
mod row;
mod support;

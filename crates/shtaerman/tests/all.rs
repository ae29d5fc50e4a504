//! All tests of the crate but those within it and those of its structure, in one program: `cargo test -p shtaerman --test all geometries::` runs those of one folder.

mod audit;
mod contact;
mod finite_elements;
mod geometries;
mod invariants;
mod inverse;
mod limits;
mod smooth;
mod smooth_disk;
mod smooth_graded;
mod stress;
mod unilateral;

//! All tests of the program and of its library but those within it, in one program: `cargo test -p shtaerman-cli --test all explore::` runs those of one folder.

mod cli;
mod explore;
mod pictures;
mod plots;

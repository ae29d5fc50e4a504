//! Command line of Shtaerman.

fn main() {}

//! How much of a text is read.

/// The longest text that [`parse`](super::parse) reads, in bytes.
pub const MAXIMUM_LENGTH: usize = 256;

/// The greatest power of a unit, up or down.
pub const MAXIMUM_POWER: u8 = 9;

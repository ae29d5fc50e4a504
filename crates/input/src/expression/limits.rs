//! How much of a text is read.

/// Longest text that is read, in bytes.
pub const TEXT_LIMIT: usize = 64 * 1024;

/// Deepest nesting of brackets, powers and signs that is read.
pub const DEPTH_LIMIT: usize = 200;

/// Most intermediate values; the nesting limit allows no more than five a level.
pub(super) const STACK_LIMIT: usize = 1023;

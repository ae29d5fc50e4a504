//! `shtaerman explore`: who is answered, what is answered, and that nothing hangs it.
#![expect(clippy::unwrap_used, reason = "helpers outside of test functions fail by panicking")]

mod answers;
#[cfg(target_os = "linux")]
mod browser;
mod client;
mod limits;
mod load;
mod security;

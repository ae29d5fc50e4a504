//! `shtaerman explore`.

mod asked;
mod contact;
mod engine;
mod kernel;
mod map;
mod paper;
mod start;
mod study;

pub use engine::PageEngine;

#[cfg(not(target_family = "wasm"))]
mod serve;
#[cfg(not(target_family = "wasm"))]
pub(super) use serve::run;

/// In a browser there is nothing to be served.
#[cfg(target_family = "wasm")]
pub(super) fn run(_: &crate::arguments::ExploreArguments) -> Result<(), crate::Failure> {
    Err(crate::Failure::Usage("there is no server in a browser".to_owned()))
}

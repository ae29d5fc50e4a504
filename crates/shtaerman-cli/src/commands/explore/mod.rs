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

//! The local page: the files it is made of, a server that hands them out, and processes that compute for it.
//!
//! ```text
//! browser --HTTP, 127.0.0.1 only--> server --pipes--> worker processes, each with an Engine
//! ```
//!
//! The server knows no mechanics. It hands out the files that are part of the program and no others, and passes what is posted to `/api/` on to a worker, which answers by an [`Engine`]. A worker that
//! takes longer than [`Limits::computation`] is ended and replaced, so that no question can hang the page. Who may ask is in [`guard`]: the page itself and no other site.
//!
//! Files in `assets/` are written by hand for this program: HTML, CSS and modules of `JavaScript`, without a library and without a build step. They load nothing from elsewhere.

mod assets;
mod frame;
mod work;

#[cfg(not(target_family = "wasm"))]
pub mod guard;
#[cfg(not(target_family = "wasm"))]
mod lane;
#[cfg(not(target_family = "wasm"))]
mod pool;
#[cfg(not(target_family = "wasm"))]
mod server;

pub use assets::{ASSETS, Asset};
#[cfg(not(target_family = "wasm"))]
pub use server::{DEFAULT_PORT, Limits, Server, bind, show};
pub use work::{Engine, work};

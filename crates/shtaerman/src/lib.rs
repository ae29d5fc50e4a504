//! Placeholder front page, replaced as the rooms are built.

pub mod document;
mod nearest;
pub mod quantity;

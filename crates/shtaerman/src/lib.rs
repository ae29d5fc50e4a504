//! Placeholder front page, replaced as the rooms are built.

pub mod expression;

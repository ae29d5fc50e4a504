//! Unilateral contact against closed forms, golden numbers, invariants and its own conditions.

mod closed_forms;
mod conditions;
mod random;
mod refusals;
mod support;
mod survey;

//! The program as a user runs it: files in, answers, messages and exit codes out.
#![expect(clippy::unwrap_used, reason = "helpers outside of test functions fail by panicking")]

mod arguments;
mod bad_input;
mod bad_values;
mod book;
#[cfg(unix)]
mod chapters;
mod commands;
mod contacts;
mod equation;
mod equation_closed_forms;
mod equation_input;
mod examples;
mod export;
mod extras;
mod files;
mod find;
mod graded;
mod hostile;
mod layered;
mod memory;
mod messages;
mod outputs;
mod overrides;
mod pages;
mod pictures;
mod places;
mod references;
mod report;
mod roughness;
mod schemas;
mod sense;
mod shells;
mod sizes;
mod spectrum;
mod stress;
mod studies;
mod support;
mod sweep;
mod time_limit;
mod traces;
mod units;

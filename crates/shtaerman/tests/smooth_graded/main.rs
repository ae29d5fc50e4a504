//! Smooth punches on graded ground against closed forms, the kernel itself, limits, and the rough problem.

mod disk;
mod limits;
mod plane;
mod refusals;
mod stated;
mod support;

//! Both methods on random equations of every kernel: the difference is within the reported errors, always. `examples/methods_survey.rs` does it for as many as one likes.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

mod grids;
mod survey;

/// Equations for each kernel.
const COUNT: u64 = 50;
/// Not that of the example: what was mended there is not all that there is.
const SEED: u64 = 1_931;

#[test]
fn spectral_and_collocation_agree_within_their_errors() {
    for (index, (name, _)) in survey::KERNELS.iter().enumerate() {
        for number in 0..COUNT {
            match survey::solve(index, SEED, number) {
                Ok(outcome) => assert!(
                    outcome.comparison.agrees(),
                    "seed {SEED}, {number}: {}\n{:?}",
                    outcome.description,
                    outcome.comparison
                ),
                Err((description, error)) => {
                    panic!("seed {SEED}, {number}: {name}: {description}: {error}")
                }
            }
        }
    }
}

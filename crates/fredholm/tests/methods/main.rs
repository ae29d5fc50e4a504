//! Both methods on random equations of every kernel: the difference is within the reported errors, always. `examples/methods_survey.rs` does it for as many as one likes.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

mod survey;

/// Equations for each kernel.
const COUNT: u64 = 50;

#[test]
fn spectral_and_collocation_agree_within_their_errors() {
    for (index, (name, _)) in survey::KERNELS.iter().enumerate() {
        for number in 0..COUNT {
            match survey::solve(index, 1, number) {
                Ok(outcome) => assert!(
                    outcome.comparison.agrees(),
                    "{}\n{:?}",
                    outcome.description,
                    outcome.comparison
                ),
                Err((description, error)) => panic!("{name}: {description}: {error}"),
            }
        }
    }
}

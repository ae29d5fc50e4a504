//! Collocation against the degenerate kernel on random equations of every kernel.
//!
//! ```text
//! cargo run --release -p fredholm --example methods_survey -- 1000 [kernel [seed]]
//! ```
//!
//! For each kernel: the number of equations, of those whose difference exceeds the sum of the reported errors, the largest quotient of the two, the median and the largest reported error
//! relative to the solution. Equations that both methods refuse are counted apart, with the reason.

#![allow(clippy::unwrap_used, reason = "an example may fail by panicking")]

#[path = "../tests/methods/survey.rs"]
mod survey;

use std::process::ExitCode;

use survey::{KERNELS, Outcome};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let count: u64 = arguments.first().and_then(|text| text.parse().ok()).unwrap_or(50);
    let chosen = arguments.get(1).map(String::as_str);
    let seed: u64 = arguments.get(2).and_then(|text| text.parse().ok()).unwrap_or(1);
    println!("{count} equations a kernel, seed {seed}");
    println!(
        "{:<18}{:>7}{:>8}{:>9}{:>12}{:>14}{:>14}",
        "kernel", "solved", "refused", "broken", "worst ratio", "median error", "largest error"
    );
    let mut broken = 0;
    for (index, (name, _)) in KERNELS.iter().enumerate() {
        if chosen.is_none_or(|chosen| chosen == *name || chosen == "all") {
            broken += survey_kernel(index, name, count, seed);
        }
    }
    if broken == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn survey_kernel(index: usize, name: &str, count: u64, seed: u64) -> usize {
    let threads = std::thread::available_parallelism().map_or(1, usize::from) as u64;
    let results: Vec<_> = std::thread::scope(|scope| {
        let share = move |first: u64| {
            (first..count)
                .step_by(threads as usize)
                .map(|number| survey::solve(index, seed, number))
                .collect::<Vec<_>>()
        };
        let workers: Vec<_> = (0..threads).map(|first| scope.spawn(move || share(first))).collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap()).collect()
    });
    let mut outcomes: Vec<Outcome> = Vec::new();
    for result in results {
        match result {
            Ok(outcome) => outcomes.push(outcome),
            Err((description, error)) => println!("  refused: {description}: {error}"),
        }
    }
    let broken: Vec<&Outcome> =
        outcomes.iter().filter(|outcome| !outcome.comparison.agrees()).collect();
    for outcome in &broken {
        println!("  broken: {}: {:?}", outcome.description, outcome.comparison);
    }
    let ratio = outcomes
        .iter()
        .map(|outcome| outcome.comparison)
        .map(|c| (c.difference / c.allowed).max(c.integral_difference / c.integral_allowed))
        .fold(0.0, f64::max);
    let mut errors: Vec<f64> = outcomes
        .iter()
        .map(|outcome| outcome.comparison.allowed / outcome.comparison.largest)
        .collect();
    errors.sort_by(f64::total_cmp);
    let median = errors.get(errors.len() / 2).copied().unwrap_or(f64::NAN);
    let largest = errors.last().copied().unwrap_or(f64::NAN);
    println!(
        "{name:<18}{:>7}{:>8}{:>9}{ratio:>12.2}{median:>14.1e}{largest:>14.1e}",
        outcomes.len(),
        count as usize - outcomes.len(),
        broken.len()
    );
    broken.len()
}

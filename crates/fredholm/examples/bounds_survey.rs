//! Guaranteed bounds of random problems against sinc collocation, by decade of `theta`.
//!
//! ```text
//! cargo run --release -p fredholm --example bounds_survey -- 10000 [resolution [seed]]
//! ```
//!
//! The degree is `max(64, resolution * theta)`, `resolution` 4 unless given. All figures are relative to the size of what is added up
//! in the quantity. `margin` is the least `bound - error`; a bound counts as broken where it is below minus the rounding of the reference: 1e-11
//! and what cancellation adds to it. Errors below that are not counted in the ratios bound/error.

#![allow(clippy::unwrap_used, reason = "an example may fail by panicking")]

#[path = "../tests/bounds/survey.rs"]
mod survey;

use std::collections::BTreeMap;

use fredholm::SincOperator;
use shtaerman_random::Random;
use survey::{Observation, Problem, Reference, observe, operator, points};

fn main() {
    let arguments: Vec<f64> =
        std::env::args().skip(1).filter_map(|argument| argument.parse().ok()).collect();
    let count = arguments.first().map_or(200, |&count| count as u64);
    let resolution = arguments.get(1).copied().unwrap_or(4.0);
    let seed = arguments.get(2).map_or(1, |&seed| seed as u64);
    let threads = std::thread::available_parallelism().map_or(1, usize::from) as u64;
    let operator = &operator();
    let observations: Vec<Observation> = std::thread::scope(|scope| {
        let share = |first: u64| {
            let numbers = (first..count).step_by(threads as usize);
            numbers.flat_map(|number| run(operator, seed, number, resolution)).collect::<Vec<_>>()
        };
        let workers: Vec<_> = (0..threads).map(|first| scope.spawn(move || share(first))).collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap()).collect()
    });
    let mut tables: BTreeMap<&str, BTreeMap<i32, Vec<Observation>>> = BTreeMap::new();
    for observation in observations {
        let decade = observation.theta.log10().floor() as i32;
        let table = tables.entry(observation.quantity).or_default();
        table.entry(decade).or_default().push(observation);
    }
    println!("{count} problems, degree max(64, {resolution} theta), seed {seed}");
    for (quantity, decades) in tables {
        println!(
            "\n{quantity}\ntheta from      count  counted   broken     margin   median     99 %  largest error"
        );
        for (decade, observations) in &decades {
            line(&format!("1e{decade}"), observations);
        }
        line("all", &decades.into_values().flatten().collect::<Vec<_>>());
    }
}

fn run(operator: &SincOperator, seed: u64, number: u64, resolution: f64) -> Vec<Observation> {
    let mut random = Random::new(seed.wrapping_mul(1_000_000_007).wrapping_add(number));
    let problem = Problem::random(&mut random, resolution);
    let (responses, influence) = problem.responses(problem.degree);
    let combination = responses.combine(problem.given);
    let reference = Reference::new(operator, &problem);
    let points = points(&mut random, problem.degree);
    let found = observe(&problem, &combination, &influence, &reference, &points);
    for observation in found.iter().filter(|observation| observation.is_broken()) {
        eprintln!("{number}: {observation:?} of {problem:?}");
    }
    found
}

fn line(name: &str, observations: &[Observation]) {
    let margin = observations.iter().map(|o| o.bound - o.error).fold(f64::INFINITY, f64::min);
    let broken = observations.iter().filter(|o| o.is_broken()).count();
    let largest = observations.iter().map(|o| o.error).fold(0.0, f64::max);
    let mut ratios: Vec<f64> =
        observations.iter().filter(|o| o.counts()).map(|o| o.bound / o.error).collect();
    ratios.sort_by(f64::total_cmp);
    let quantile = |share: f64| {
        let last = ratios.len().saturating_sub(1) as f64;
        ratios.get((share * last).round() as usize).copied().unwrap_or(f64::NAN)
    };
    println!(
        "{name:<12} {:>8} {:>8} {broken:>8} {margin:>10.1e} {:>8.3} {:>8.2} {largest:>14.1e}",
        observations.len(),
        ratios.len(),
        quantile(0.5),
        quantile(0.99)
    );
}

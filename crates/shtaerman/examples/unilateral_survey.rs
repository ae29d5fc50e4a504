//! Solves random unilateral problems and says what became of them:
//! `cargo run --release --workspace --example unilateral_survey -- [COUNT] [SEED] [NUMBER ..]`: all, or those with the numbers given.

#[path = "../tests/unilateral/random.rs"]
mod random;

use std::time::Instant;

use random::{Ending, Random, judge, problem};

fn main() {
    let mut arguments = std::env::args().skip(1).map(|text| text.parse::<u64>().ok());
    let count = arguments.next().flatten().unwrap_or(10_000);
    let seed = arguments.next().flatten().unwrap_or(20);
    println!("seed {seed}");
    let mut random = Random::new(seed);
    let numbers: Vec<u64> = arguments.flatten().collect();
    let (mut solved, mut refused, mut failed, mut several) = (0, 0, 0, 0);
    let (mut largest_residual, mut over, mut loose) = (0.0f64, 0, 0);
    let (mut times, mut slowest) = (Vec::new(), String::new());
    for index in 0..count {
        let (words, problem) = problem(&mut random);
        if !numbers.is_empty() && !numbers.contains(&index) {
            continue;
        }
        let began = Instant::now();
        let ending = problem.map_or_else(|error| Ending::Failed(error.to_string()), |p| judge(&p));
        let time = began.elapsed().as_secs_f64();
        match ending {
            Ending::Solved { residual, error, zones } => {
                if times.iter().all(|known| *known < time) {
                    slowest = format!("{time:.3} s: {zones} zones, {words}");
                }
                times.push(time);
                solved += 1;
                several += usize::from(zones > 1);
                loose += usize::from(error > 1e-9);
                if residual > 1e-9 {
                    over += 1;
                    println!("{index}: residual {residual:.1e}: {words}");
                }
                largest_residual = largest_residual.max(residual);
            }
            Ending::Refused => refused += 1,
            Ending::Failed(reason) => {
                failed += 1;
                println!("{index}: {reason}: {words}");
            }
        }
    }
    times.sort_by(f64::total_cmp);
    let quantile =
        |share: f64| times.get((share * times.len() as f64) as usize).copied().unwrap_or(0.0);
    println!(
        "{count} problems: {solved} solved ({several} with several zones), {refused} refused with reason, {failed} failed"
    );
    println!(
        "largest residual {largest_residual:.1e}, {over} above 1e-9; {loose} with an estimated error above 1e-9"
    );
    println!(
        "time: median {:.2e} s, 90 % {:.2e} s, 99 % {:.2e} s; slowest {slowest}",
        quantile(0.5),
        quantile(0.9),
        quantile(0.99)
    );
}

//! What `python/benches/beside_rust.py` holds the Python package against: seconds of the same work in Rust alone, one line for each time that it was done.
//!
//!     cargo run --release -p shtaerman --example beside_python -- sweep COUNT THREADS REPEATS       numbers alone
//!     cargo run --release -p shtaerman --example beside_python -- errors COUNT THREADS REPEATS      numbers, each with its stated error, as Python has them
//!     cargo run --release -p shtaerman --example beside_python -- solve FILE.toml REPEATS

use std::error::Error;
use std::time::Instant;

use shtaerman::{Foundation, Load, Problem, Profile, Punch, Solver, Swept};

/// `theta0` that a thread does at once.
const BLOCK: usize = 1 << 14;

/// What is kept of a case.
type Keep<const N: usize> = fn(&Swept, f64) -> [f64; N];

/// Settlement and pressure at the right edge.
fn numbers(swept: &Swept, _relative_error: f64) -> [f64; 2] {
    [swept.settlement, swept.pressure_right]
}

/// The same with their errors, and the relative error.
fn with_errors(swept: &Swept, relative_error: f64) -> [f64; 5] {
    let [displacement, pressure, _] = swept.sizes();
    [
        swept.settlement,
        relative_error * displacement,
        swept.pressure_right,
        relative_error * pressure,
        relative_error,
    ]
}

/// A parabola for so many `theta0` from 0.01 to 100, what is kept of all of them.
fn sweep<const N: usize>(
    count: usize,
    threads: usize,
    keep: Keep<N>,
) -> Result<f64, Box<dyn Error>> {
    let punch = Punch::new(1.0)?.with_profile(Profile::expression("xi^2")?);
    let problem = Problem::new(Foundation::dimensionless(1.0)?, punch, Load::force(2.0)?)?;
    let problem = problem.with_solver(Solver::bilateral());
    let step = (1e4f64).ln() / (count - 1) as f64;
    let theta0: Vec<f64> = (0..count).map(|i| 0.01 * (step * i as f64).exp()).collect();
    let start = Instant::now();
    let sweep = problem.theta0_sweep([theta0[0], theta0[count - 1]])?.ok_or("no sweep")?;
    let mut kept = vec![[0.0f64; N]; count];
    let share = count.div_ceil(threads).next_multiple_of(BLOCK);
    std::thread::scope(|scope| {
        for (theta0, kept) in theta0.chunks(share).zip(kept.chunks_mut(share)) {
            let sweep = &sweep;
            scope.spawn(move || {
                let mut swept = vec![Swept::default(); BLOCK];
                for (theta0, kept) in theta0.chunks(BLOCK).zip(kept.chunks_mut(BLOCK)) {
                    sweep.run(theta0, &mut swept);
                    for (kept, swept) in kept.iter_mut().zip(&swept) {
                        *kept = keep(swept, sweep.relative_error());
                    }
                }
            });
        }
    });
    let seconds = start.elapsed().as_secs_f64();
    let sum: f64 = kept.iter().map(|kept| kept[0]).sum();
    assert!(sum.is_finite());
    Ok(seconds)
}

/// Reads, solves and audits a problem file that is in memory.
fn solve(text: &str) -> Result<f64, Box<dyn Error>> {
    let start = Instant::now();
    let contact = shtaerman::file::parse(text, "problem.toml")?.solve()?.audited()?;
    let seconds = start.elapsed().as_secs_f64();
    assert!(contact.settlement().is_finite());
    Ok(seconds)
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match words[..] {
        ["sweep", count, threads, repeats] => {
            for _ in 0..repeats.parse()? {
                println!("{}", sweep(count.parse()?, threads.parse()?, numbers)?);
            }
        }
        ["errors", count, threads, repeats] => {
            for _ in 0..repeats.parse()? {
                println!("{}", sweep(count.parse()?, threads.parse()?, with_errors)?);
            }
        }
        ["solve", file, repeats] => {
            let text = std::fs::read_to_string(file)?;
            for _ in 0..repeats.parse()? {
                println!("{}", solve(&text)?);
            }
        }
        _ => return Err("sweep or errors COUNT THREADS REPEATS, or solve FILE.toml REPEATS".into()),
    }
    Ok(())
}

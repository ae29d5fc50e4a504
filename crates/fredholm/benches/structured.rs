//! The structured solve at a million unknowns: time, memory, scaling with the degree, iterations over the parameter.
//!
//! ```text
//! cargo bench -p fredholm --bench structured                   the tables
//! cargo bench -p fredholm --bench structured -- yardstick      one line, as peers/spectral_fft.py prints it
//! ```

#![allow(clippy::unwrap_used, reason = "a benchmark may fail by panicking")]

use std::f64::consts::PI;
use std::time::Instant;

use fredholm::kernel::{Logarithm, SpectralRelation};
use fredholm::{Convergence, StructuredOperator};

/// Degree of the yardstick.
const DEGREE: usize = 1 << 20;

/// One run: the flat punch and the parabola `f0 = lambda0 xi^2` at `nu = 0.25`, `P0 = 0.001`.
struct Run {
    convergence: [Convergence; 2],
    seconds: f64,
    settlement: f64,
    end: f64,
    middle: f64,
}

fn main() {
    let has = |name: &str| std::env::args().any(|argument| argument == name);
    if has("yardstick") {
        yardstick(DEGREE);
    } else if has("--bench") {
        yardstick(DEGREE);
        scaling(12..=20);
        parameters(DEGREE);
    } else {
        // `cargo test --all-targets` only sees that it runs.
        yardstick(1 << 10);
        scaling(9..=10);
        parameters(1 << 10);
    }
}

fn run(degree: usize, lambda0: f64, tolerance: f64) -> Run {
    let start = Instant::now();
    let kernel = Logarithm::unit();
    let operator = StructuredOperator::new(&kernel, degree).unwrap();
    let system = operator.system(15.0 / (8.0 * PI) * lambda0).unwrap();
    let solve = |f: &dyn Fn(f64) -> f64| {
        let moments = kernel.moments(f, degree + 1).unwrap();
        system.solve(&moments.values, tolerance).unwrap()
    };
    let (one, first) = solve(&|_| 1.0);
    let (square, second) = solve(&|x| lambda0 * x * x);
    let settlement = (0.001 + square.projections()[0]) / one.projections()[0];
    let pressure = |x: f64| settlement * one.evaluate(x, 1.0) - square.evaluate(x, lambda0 * x * x);
    let (end, middle) = (pressure(1.0), pressure(0.0));
    let seconds = start.elapsed().as_secs_f64();
    Run { convergence: [first, second], seconds, settlement, end, middle }
}

fn yardstick(degree: usize) {
    let run = run(degree, 100.0, 1e-12);
    let [first, second] = run.convergence;
    println!(
        "n={degree} lambda0=100 iterations={}+{} seconds={:.3} peak_MB={:.0} delta0={:.13} p0_end={:.12} p0_mid={:.12}",
        first.iterations,
        second.iterations,
        run.seconds,
        peak_memory(),
        run.settlement,
        run.end,
        run.middle,
    );
}

/// Best of three runs at each degree, and the exponent of a straight line through the logarithms.
fn scaling(powers: std::ops::RangeInclusive<u32>) {
    println!("\n{:>9} {:>10} {:>12}", "degree", "seconds", "us/degree");
    let points: Vec<[f64; 2]> = powers
        .map(|power| {
            let degree = 1usize << power;
            let seconds =
                (0..3).map(|_| run(degree, 100.0, 1e-12).seconds).fold(f64::INFINITY, f64::min);
            println!("{degree:>9} {seconds:>10.4} {:>12.4}", 1e6 * seconds / degree as f64);
            [(degree as f64).ln(), seconds.ln()]
        })
        .collect();
    println!("exponent {:.3}", slope(&points));
}

fn parameters(degree: usize) {
    println!(
        "\n{:>9} {:>10} {:>10} {:>10} {:>10}",
        "lambda0", "tolerance", "iterations", "residual", "seconds"
    );
    for lambda0 in [1.0, 100.0, 1e4, 1e5] {
        for tolerance in [1e-12, 1e-14] {
            let run = run(degree, lambda0, tolerance);
            let [first, second] = run.convergence;
            println!(
                "{lambda0:>9e} {tolerance:>10e} {:>10} {:>10.2e} {:>10.3}{}",
                format!("{}+{}", first.iterations, second.iterations),
                first.residual.max(second.residual),
                run.seconds,
                if first.limited_by_rounding || second.limited_by_rounding {
                    " (rounding)"
                } else {
                    ""
                },
            );
        }
    }
}

fn slope(points: &[[f64; 2]]) -> f64 {
    let count = points.len() as f64;
    let mean = |i: usize| points.iter().map(|point| point[i]).sum::<f64>() / count;
    let (x, y) = (mean(0), mean(1));
    let covariance: f64 = points.iter().map(|point| (point[0] - x) * (point[1] - y)).sum();
    covariance / points.iter().map(|point| (point[0] - x).powi(2)).sum::<f64>()
}

/// Largest resident memory of this process so far, in MiB; NaN where the system does not tell.
fn peak_memory() -> f64 {
    std::fs::read_to_string("/proc/self/status")
        .ok()
        .and_then(|text| {
            let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
            line.trim().strip_suffix("kB")?.trim().parse::<f64>().ok()
        })
        .map_or(f64::NAN, |kib| kib / 1024.0)
}

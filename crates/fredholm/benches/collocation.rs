//! Times of sinc collocation on one thread, and the rate of a sweep: `cargo bench -p fredholm`.

#![allow(clippy::unwrap_used, reason = "a benchmark may fail by panicking")]
#![allow(missing_docs, reason = "a benchmark has no readers")]

mod clock;

use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

use fredholm::Interval;
use fredholm::SincOperator;
use fredholm::collocation::{Estimate, PointSet, SincGrid, SweepValue, solve_adaptive};
use fredholm::kernel::{Logarithm, Power};

fn main() {
    println!("{:<58} {:>12}", "one thread, log kernel, mean processor time", "microseconds");
    cold_solve();
    stages();
    ready_operator();
    adaptive();
    sweep_rate();
}

/// Mean processor time of one call, in microseconds.
fn time(name: &str, work: impl FnMut()) {
    let (seconds, ()) = clock::mean(work);
    println!("{name:<58} {:>12.2}", seconds * 1e6);
}

fn points() -> Vec<f64> {
    (0..101).map(|i| f64::from(i - 50) / 50.0).collect()
}

fn cold_solve() {
    let kernel = Logarithm::unit();
    let points = points();
    let right = vec![1.0; points.len()];
    let mut values = vec![0.0; points.len()];
    time("cold, theta = 60: 101 + 71 nodes, estimate, 101 points", || {
        let solutions = [35, 50].map(|half_count| {
            let operator = SincOperator::new(&kernel, half_count).unwrap();
            let f = operator.sample(|_| 1.0).unwrap();
            operator.factor(60.0).unwrap().solve(&f).unwrap()
        });
        black_box(Estimate::between(&solutions[0], &solutions[1]).unwrap());
        solutions[1].evaluate_into(&points, &right, &mut values);
        black_box(&values);
    });
    time("cold, theta = 60: chosen nodes, estimate, 101 points", || {
        let found = solve_adaptive(&kernel, 60.0, |_| 1.0, 1e-11).unwrap();
        found.solution.evaluate_into(&points, &right, &mut values);
        black_box(&values);
    });
}

fn stages() {
    let kernel = Logarithm::unit();
    time("  grid, 101 nodes", || {
        black_box(SincGrid::new(&kernel, 50).unwrap());
    });
    let grid = Arc::new(SincGrid::new(&kernel, 50).unwrap());
    time("  operator on the grid", || {
        black_box(SincOperator::on_grid(&kernel, Arc::clone(&grid), &[]).unwrap());
    });
    let power = Power::new(Interval::unit(), 0.3).unwrap();
    time("  operator on the grid, power kernel", || {
        black_box(SincOperator::on_grid(&power, Arc::clone(&grid), &[]).unwrap());
    });
    let operator = SincOperator::on_grid(&kernel, grid, &[]).unwrap();
    let f = operator.sample(f64::exp).unwrap();
    time("  factor", || {
        black_box(operator.factor(60.0).unwrap());
    });
    let factor = operator.factor(60.0).unwrap();
    time("  solve", || {
        black_box(factor.solve(&f).unwrap());
    });
    let fine = factor.solve(&f).unwrap();
    let coarse = SincOperator::new(&kernel, 35).unwrap();
    let coarse = coarse.factor(60.0).unwrap().solve(&coarse.sample(f64::exp).unwrap()).unwrap();
    time("  estimate, 71 against 101 nodes", || {
        black_box(Estimate::between(&coarse, &fine).unwrap());
    });
    let (points, right, mut values) = (points(), vec![1.0; 101], vec![0.0; 101]);
    time("  evaluate at 101 points", || {
        fine.evaluate_into(&points, &right, &mut values);
        black_box(&values);
    });
}

fn ready_operator() {
    let kernel = Logarithm::unit();
    for (theta, half_count) in [(1.0, 31), (60.0, 50), (1e4, 100), (1e5, 130), (1e5, 260)] {
        let operator = SincOperator::new(&kernel, half_count).unwrap();
        let f = operator.sample(f64::exp).unwrap();
        let set = PointSet::new(&operator, &points()).unwrap();
        let right: Vec<f64> = points().iter().map(|x| x.exp()).collect();
        let mut values = vec![0.0; 101];
        let count = operator.count();
        time(&format!("operator ready, theta = {theta}: {count} nodes, 101 fixed points"), || {
            let solution = operator.factor(theta).unwrap().solve(&f).unwrap();
            set.evaluate_into(&solution, &right, &mut values).unwrap();
            black_box(&values);
        });
        time(&format!("eigendecomposition, {count} nodes"), || {
            black_box(operator.spectrum().unwrap());
        });
    }
}

fn adaptive() {
    let kernel = Logarithm::unit();
    for theta in [1e-3, 1.0, 60.0, 1e4, 1e5] {
        time(&format!("adaptive to 1e-11, exp(x), theta = {theta}"), || {
            black_box(solve_adaptive(&kernel, theta, f64::exp, 1e-11).unwrap());
        });
    }
}

fn sweep_rate() {
    let kernel = Logarithm::unit();
    let count = 1 << 20;
    let thetas: Vec<f64> =
        (0..count).map(|i| 10f64.powf(7.0 * f64::from(i) / f64::from(count) - 3.0)).collect();
    let mut values = vec![SweepValue::default(); thetas.len()];
    for half_count in [50, 70, 90] {
        let operator = SincOperator::new(&kernel, half_count).unwrap();
        let f = operator.sample(|x| x * x + 0.1 * x).unwrap();
        let spectrum = operator.spectrum().unwrap();
        let sweep = spectrum.sweep(&f, [0.9, 1.1], 1e4).unwrap();
        for threads in [1, 2] {
            let best = if threads == 1 {
                clock::mean(|| sweep.run(&thetas, &mut values)).0
            } else {
                let elapsed = |_| {
                    let start = Instant::now();
                    sweep.run_on_threads(&thetas, &mut values, threads);
                    start.elapsed().as_secs_f64()
                };
                (0..7).map(elapsed).fold(f64::INFINITY, f64::min)
            };
            println!(
                "sweep, {} nodes, {} modes, {threads} threads: {:.1} million theta/s",
                operator.count(),
                sweep.mode_count(),
                f64::from(count) / best / 1e6
            );
        }
        let (mut worst, mut at) = (0.0, 0.0);
        for (theta, value) in thetas.iter().zip(&values).step_by(count as usize / 70) {
            let error = sweep_error(&kernel, *theta, value);
            if error > worst {
                (worst, at) = (error, *theta);
            }
        }
        println!("  largest relative error against 401 nodes: {worst:.1e} at theta = {at:.3e}");
    }
}

/// Against one Cholesky factorisation on many nodes.
fn sweep_error(kernel: &Logarithm, theta: f64, value: &SweepValue) -> f64 {
    let operator = SincOperator::new(kernel, 200).unwrap();
    let right = [
        operator.sample(|_| 1.0).unwrap(),
        operator.sample(|x| x).unwrap(),
        operator.sample(|x| x * x + 0.1 * x).unwrap(),
    ];
    let [one, x, f] = &operator.solve(theta, &right).unwrap()[..] else { unreachable!() };
    let pairs = [
        (value.one_one, one.integral(|_| 1.0)),
        (value.x_x, x.integral(|x| x)),
        (value.one_f, f.integral(|_| 1.0)),
        (value.x_f, f.integral(|x| x)),
        (value.ends_one[1], one.evaluate(1.0, 1.0)),
        (value.ends_x[1], x.evaluate(1.0, 1.0)),
        (value.ends_f[0], f.evaluate(-1.0, 0.9)),
        (value.ends_f[1], f.evaluate(1.0, 1.1)),
    ];
    pairs.iter().fold(0.0, |worst: f64, (a, b)| worst.max((a - b).abs() / b.abs()))
}

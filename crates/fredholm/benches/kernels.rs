//! Times of a cold solve on every kernel, its construction included: `cargo bench -p fredholm --bench kernels`.

#![allow(clippy::unwrap_used, reason = "a benchmark may fail by panicking")]
#![allow(missing_docs, reason = "a benchmark has no readers")]

mod clock;

use fredholm::equation::{collocate, degenerate};
use fredholm::kernel::{
    Kernel, Logarithm, LogarithmRatio, LogarithmSine, LogarithmSquare, Macdonald, Power,
    SpectralRelation, WeberSonine,
};
use fredholm::{Error, Interval};

/// Tolerance of the command line.
const TOLERANCE: f64 = 1e-12;
/// Degree of the degenerate kernel.
const DEGREE: usize = 200;
/// `lambda`.
const PARAMETER: f64 = 1.0;

/// Collocation with its estimate from nothing but the parameters.
fn cold<K: Kernel>(name: &str, make: impl Fn() -> Result<K, Error>) {
    let (time, (nodes, error)) = clock::mean(|| {
        let kernel = make().unwrap();
        let f = |x: f64| kernel.mass_function(x) * (1.0 + x * x);
        let solution = collocate(&kernel, PARAMETER, &f, &[], TOLERANCE).unwrap();
        (solution.count, solution.error.solution / solution.largest)
    });
    println!("{name:<44}{:>12.2}{nodes:>9}{error:>14.1e}", 1e3 * time);
}

/// The degenerate kernel with its estimate.
fn spectral<K: SpectralRelation>(name: &str, make: impl Fn() -> Result<K, Error>) {
    let (time, error) = clock::mean(|| {
        let kernel = make().unwrap();
        let f = |x: f64| kernel.mass_function(x) * (1.0 + x * x);
        let solution = degenerate(&kernel, PARAMETER, &f, DEGREE).unwrap();
        solution.error.solution / solution.largest
    });
    println!("{name:<44}{:>12.2}{DEGREE:>9}{error:>14.1e}", 1e3 * time);
}

fn main() {
    println!(
        "{:<44}{:>12}{:>9}{:>14}",
        "collocation, default tolerance", "ms", "nodes", "stated error"
    );
    cold("log, a = 1", || Logarithm::new(1.0));
    cold("log-ratio, b/a = 0.25", || LogarithmRatio::new(0.25, 1.0));
    cold("log-ratio, b/a = 1e-6", || LogarithmRatio::new(1e-6, 1.0));
    cold("log-square, b/a = 0.25", || LogarithmSquare::new(0.25, 1.0));
    cold("log-sine, alpha = 1.5", || LogarithmSine::new(1.5));
    cold("log-sine, alpha = 3.1", || LogarithmSine::new(3.1));
    for mu in [0.3, 0.5, 0.7, 0.9] {
        cold(&format!("power, mu = {mu}"), || Power::new(Interval::unit(), mu));
    }
    for (mu, kappa) in
        [(0.0, 1.0), (0.2, 1.0), (0.35, 1.0), (-0.3, 2.0), (0.45, 1.0), (0.0, 10.0), (0.0, 40.0)]
    {
        cold(&format!("macdonald, mu = {mu}, kappa a = {kappa}"), || {
            Macdonald::new(1.0, mu, kappa)
        });
    }
    for (mu, gamma) in [(0.0, 0.0), (1.0, 0.0), (0.5, -0.3), (0.0, 0.25), (0.0, 0.4), (5.0, 0.0)] {
        cold(&format!("weber-sonine, mu = {mu}, gamma = {gamma}"), || {
            WeberSonine::new(1.0, mu, gamma)
        });
    }
    println!("\n{:<44}{:>12}{:>9}{:>14}", "degenerate kernel", "ms", "degree", "stated error");
    spectral("log", || Logarithm::new(1.0));
    spectral("log-ratio, b/a = 0.25", || LogarithmRatio::new(0.25, 1.0));
    spectral("log-sine, alpha = 1.5", || LogarithmSine::new(1.5));
    spectral("power, mu = 0.3", || Power::new(Interval::unit(), 0.3));
    spectral("macdonald, mu = 0.2, kappa a = 1", || {
        Macdonald::new(1.0, 0.2, 1.0)?.relation(DEGREE + 1)
    });
    spectral("weber-sonine, mu = 0, gamma = 0", || WeberSonine::new(1.0, 0.0, 0.0));
}

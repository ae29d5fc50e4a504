//! A kernel of a user's own: a rough flat punch on an elastic layer of finite thickness.
//!
//! ```text
//! cargo run --release -p fredholm --example layer [-- thin]
//! ```
//!
//! `thin` adds layers down to a hundredth of the half-width: some seconds.

#[path = "kernel.rs"]
pub mod kernel;

use std::time::Instant;

use fredholm::Error;
use fredholm::equation::{collocate, degenerate};
use fredholm::kernel::ComputedRelation;
use kernel::{Base, LAMBDA, Layer, TOLERANCE, on_half_plane, on_springs};

/// Prints the tables of the chapter on kernels of one's own.
pub fn main() -> Result<(), Error> {
    let thin = std::env::args().skip(1).any(|argument| argument == "thin");
    constants()?;
    for base in [Base::Sliding, Base::Bonded { poisson: 0.3 }] {
        punch(base, thin)?;
    }
    by_degenerate_kernel()
}

fn constants() -> Result<(), Error> {
    println!("a_0, the constant of a thick layer");
    for (name, base) in [
        ("sliding", Base::Sliding),
        ("bonded, nu = 0.3", Base::Bonded { poisson: 0.3 }),
        ("bonded, nu = 0.5", Base::Bonded { poisson: 0.5 }),
    ] {
        println!("  {name:<17} {:.12}", Layer::new(base, 1.0)?.gauge_constant());
    }
    Ok(())
}

fn punch(base: Base, thin: bool) -> Result<(), Error> {
    println!("\n{base:?}, lambda = {LAMBDA}");
    println!(
        "h/a      int phi dx        phi(0)          phi(1)      estimate nodes      ms   half-plane     springs"
    );
    let thicknesses = [100.0, 10.0, 3.0, 1.0, 0.3, 0.1, 0.03, 0.01];
    for thickness in &thicknesses[..if thin { 8 } else { 6 }] {
        let start = Instant::now();
        let layer = Layer::new(base, *thickness)?;
        let phi = collocate(&layer, LAMBDA, &|_| 1.0, &[], TOLERANCE)?;
        let time = start.elapsed().as_secs_f64() * 1e3;
        let plane = match on_half_plane(&layer, LAMBDA)? {
            Some(integral) if *thickness >= 1.0 => format!("{integral:.7}"),
            _ => "-".to_owned(),
        };
        println!(
            "{thickness:<5} {:>15.12} {:>15.12} {:>15.12} {:>9.1e} {:>5} {time:>7.1} {plane:>12} {:>11.7}",
            phi.integral.unwrap_or(f64::NAN),
            phi.evaluate(0.0),
            phi.evaluate(1.0),
            phi.error.solution,
            phi.count,
            on_springs(base, *thickness, LAMBDA),
        );
    }
    Ok(())
}

/// The paper's method with computed eigenpairs.
fn by_degenerate_kernel() -> Result<(), Error> {
    let layer = Layer::new(Base::Sliding, 1.0)?;
    let exact = collocate(&layer, LAMBDA, &|_| 1.0, &[], TOLERANCE)?;
    println!(
        "\nDegenerate kernel, sliding base, h = a: differences from collocation, and the errors reported"
    );
    println!("pairs  nodes  defect  int phi dx  reported   phi(0)   phi(1)  reported");
    for count in [10, 20, 40, 80] {
        let relation = ComputedRelation::new(&layer, count)?;
        let phi = degenerate(&relation, LAMBDA, &|_| 1.0, count - 1)?;
        let gap = match (phi.integral, exact.integral) {
            (Some(one), Some(other)) => (one - other).abs(),
            _ => f64::NAN,
        };
        println!(
            "{count:>5}  {:>5}   {:.0e}     {gap:.1e}   {:.1e}  {:.1e}  {:.1e}   {:.1e}",
            relation.nodes(),
            relation.defect(),
            phi.error.integral,
            (phi.evaluate(0.0) - exact.evaluate(0.0)).abs(),
            (phi.evaluate(1.0) - exact.evaluate(1.0)).abs(),
            phi.error.solution,
        );
    }
    Ok(())
}

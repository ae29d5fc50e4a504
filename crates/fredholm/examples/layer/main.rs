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
use fredholm::kernel::ComputedRelation;
use kernel::{Base, LAMBDA, Layer, on_half_plane, on_layer, on_springs};

/// Prints the tables of the chapter on kernels of one's own.
pub fn main() -> Result<(), Error> {
    let thin = std::env::args().skip(1).any(|argument| argument == "thin");
    constants()?;
    for base in [Base::Sliding, Base::Bonded { poisson: 0.3 }] {
        punch(base, thin)?;
    }
    degenerate()
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
        let found = on_layer(&layer, LAMBDA)?;
        let time = start.elapsed().as_secs_f64() * 1e3;
        let phi = &found.solution;
        let plane = if *thickness < 1.0 {
            "-".to_owned()
        } else {
            format!("{:.7}", on_half_plane(&layer, LAMBDA)?)
        };
        println!(
            "{thickness:<5} {:>15.12} {:>15.12} {:>15.12} {:>9.1e} {:>5} {time:>7.1} {plane:>12} {:>11.7}",
            phi.integral(|_| 1.0),
            phi.evaluate(0.0, 1.0),
            phi.evaluate(1.0, 1.0),
            found.estimate.solution,
            2 * found.half_count + 1,
            on_springs(base, *thickness, LAMBDA),
        );
    }
    Ok(())
}

/// The paper's method with computed eigenpairs.
fn degenerate() -> Result<(), Error> {
    let layer = Layer::new(Base::Sliding, 1.0)?;
    let exact = on_layer(&layer, LAMBDA)?.solution;
    println!("\nDegenerate kernel, sliding base, h = a: errors");
    println!("pairs  nodes  defect  int phi dx   phi(0)   phi(1)");
    for count in [10, 20, 40, 80] {
        let relation = ComputedRelation::new(&layer, count)?;
        let (integral, phi) = kernel::by_degenerate_kernel(&relation, LAMBDA)?;
        println!(
            "{count:>5}  {:>5}   {:.0e}     {:.1e}  {:.1e}  {:.1e}",
            relation.nodes(),
            relation.defect(),
            (integral - exact.integral(|_| 1.0)).abs(),
            (phi.evaluate(0.0, 1.0) - exact.evaluate(0.0, 1.0)).abs(),
            (phi.evaluate(1.0, 1.0) - exact.evaluate(1.0, 1.0)).abs(),
        );
    }
    Ok(())
}
